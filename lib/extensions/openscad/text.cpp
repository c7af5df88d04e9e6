#include "extensions/openscad/text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "extensions/openscad/arguments.h"
#include "extensions/openscad/tessellation.h"

namespace strata::openscad {
namespace {

/// Bytes of the character that a text begins with; 0 if it is no UTF-8, or a zero.
std::size_t length_of_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (first == 0 || length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  const bool is_longer_than_needed = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool is_surrogate = first == 0xED && byte(1) >= 0xA0, is_too_large = first == 0xF4 && byte(1) >= 0x90;
  return is_longer_than_needed || is_surrogate || is_too_large ? 0 : length;
}

void check_characters(const Arguments& arguments, const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = length_of_character(std::string_view(text).substr(i));
    if (length == 0)
      arguments.fail("text", "has a byte that is no character in UTF-8, at number " + std::to_string(i + 1));
    i += length;
  }
}

TextStyle style_of(const Arguments& arguments) {
  TextStyle style;
  style.text = arguments.text("text", {});
  check_characters(arguments, style.text);
  style.font = arguments.text("font", {});
  style.direction = arguments.text("direction", {});
  style.language = arguments.text("language", "en");
  style.script = arguments.text("script", {});
  style.halign = arguments.text("halign", "left");
  style.valign = arguments.text("valign", "baseline");
  style.size = arguments.number("size", style.size);
  style.spacing = arguments.number("spacing", style.spacing);
  style.curve_lines = std::max(sides_of_circle(style.size, resolution_of(arguments)) / 8 + 1, std::uint32_t{2});
  return style;
}

bool is_finite(const TextOutlines& outlines) {
  for (const auto& polygon : outlines.polygons)
    for (const planar::PlanePoint& p : polygon)
      if (!std::isfinite(p[0]) || !std::isfinite(p[1])) return false;
  return true;
}

}  // namespace

Part text(const SyntaxNode& node, Fonts& fonts, Report& report) {
  const Arguments arguments(
      node, {"text", "size", "font", "direction", "language", "script", "halign", "valign", "spacing"}, report);
  const TextStyle style = style_of(arguments);
  if (!std::isfinite(style.size) || !std::isfinite(style.spacing)) {
    arguments.note("that is not finite makes nothing");
    return {};
  }
  TextOutlines outlines;
  try {
    outlines = fonts.outlines(style);
  } catch (const FontError& error) {
    report.fail(node.place, "text " + std::string(error.what()));
  }
  for (const std::string& note : outlines.notes) arguments.note(note);
  if (!is_finite(outlines)) arguments.fail("size", "is too large");
  Part part = Part::of(planar::fill({planar::loops_of(outlines.polygons), planar::FillRule::nonzero}));
  if (part.is_empty()) arguments.note("without area makes nothing");
  return part;
}

}  // namespace strata::openscad
