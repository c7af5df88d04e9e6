#include "core/io/ply_header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/io/binary.h"
#include "core/io/ply_names.h"
#include "core/io/text_cursor.h"

namespace strata::io {
namespace {

PlyScalar read_scalar_type(TextCursor& text) {
  using Name = std::pair<const char*, PlyScalar>;
  constexpr std::array<Name, 16> names{
      Name{"char", PlyScalar::int8},      Name{"int8", PlyScalar::int8},       Name{"uchar", PlyScalar::uint8},
      Name{"uint8", PlyScalar::uint8},    Name{"short", PlyScalar::int16},     Name{"int16", PlyScalar::int16},
      Name{"ushort", PlyScalar::uint16},  Name{"uint16", PlyScalar::uint16},   Name{"int", PlyScalar::int32},
      Name{"int32", PlyScalar::int32},    Name{"uint", PlyScalar::uint32},     Name{"uint32", PlyScalar::uint32},
      Name{"float", PlyScalar::float32},  Name{"float32", PlyScalar::float32}, Name{"double", PlyScalar::float64},
      Name{"float64", PlyScalar::float64}};
  for (const auto& [name, type] : names)
    if (text.accept(name)) return type;
  text.fail_expected("a scalar type such as 'float' or 'uchar'");
}

std::optional<std::endian> read_order(TextCursor& text) {
  std::optional<std::endian> order;
  if (text.accept("binary_little_endian"))
    order = std::endian::little;
  else if (text.accept("binary_big_endian"))
    order = std::endian::big;
  else if (!text.accept("ascii"))
    text.fail_expected("'ascii', 'binary_little_endian' or 'binary_big_endian'");
  if (!text.accept("1.0")) text.fail_expected("version 1.0");
  return order;
}

PlyProperty read_property(TextCursor& text) {
  PlyProperty property;
  if (text.accept("list")) {
    const std::size_t place = text.offset();
    property.list_count = read_scalar_type(text);
    if (!is_integer(*property.list_count)) fail_at_line(place, "expected an integer type for the length of a list");
  }
  property.type = read_scalar_type(text);
  property.name = text.word();
  if (property.name.empty()) text.fail_expected("the name of a property");
  return property;
}

PlyElement read_element(TextCursor& text) {
  PlyElement element;
  element.name = text.word();
  if (element.name.empty()) text.fail_expected("the name of an element");
  const std::int64_t count = text.integer("the number of elements");
  if (count < 0) text.fail_here("expected the number of elements, found " + std::to_string(count));
  element.count = static_cast<std::uint64_t>(count);
  return element;
}

/// Comments are free text: what is no announcement is nothing.
std::optional<PlyAnnouncement> read_announcement(TextCursor& text) {
  const std::string_view components = text.word(), word = text.word(), name = text.rest_of_line();
  const auto how = std::find_if(ply_interpolations.begin(), ply_interpolations.end(),
                                [&](const auto& known) { return known.first == word; });
  const bool is_count = components.size() == 1 && components[0] >= '1' && components[0] <= '4';
  if (!is_count || how == ply_interpolations.end() || name.size() < 2) return {};
  return PlyAnnouncement{.components = static_cast<std::uint32_t>(components[0] - '0'),
                         .interpolation = how->second,
                         .name = std::string(name.substr(1))};
}

void read_comment(TextCursor& text, PlyHeader& header) {
  if (text.accept("TextureFile")) {
    text.skip_blanks();
    std::string_view name = text.rest_of_line();
    while (!name.empty() && (name.back() == ' ' || name.back() == '\t')) name.remove_suffix(1);
    header.textures.emplace_back(name);
  } else if (!header.elements.empty() && text.accept("channel")) {
    PlyElement& element = header.elements.back();
    auto announcement = read_announcement(text);
    if (!announcement) return;
    announcement->property = element.properties.size();
    element.announcements.push_back(std::move(*announcement));
  }
}

/// The end of the header's last line, in the style of its first line end: binary data may start with any byte.
std::size_t data_offset(const Input& input, std::size_t end_of_word) {
  const std::size_t first_end = input.data.find_first_of("\r\n");
  const bool lone_return = first_end != std::string_view::npos && input.data[first_end] == '\r' &&
                           (first_end + 1 == input.data.size() || input.data[first_end + 1] != '\n');
  const std::size_t end = input.data.find(lone_return ? '\r' : '\n', end_of_word);
  return end == std::string_view::npos ? input.data.size() : end + 1;
}

}  // namespace

std::size_t size_of(PlyScalar type) {
  switch (type) {
    case PlyScalar::int8:
    case PlyScalar::uint8:
      return 1;
    case PlyScalar::int16:
    case PlyScalar::uint16:
      return 2;
    case PlyScalar::int32:
    case PlyScalar::uint32:
    case PlyScalar::float32:
      return 4;
    case PlyScalar::float64:
      return 8;
  }
  return 0;
}

bool has_number(PlyScalar type, double number) {
  const bool is_signed = type == PlyScalar::int8 || type == PlyScalar::int16 || type == PlyScalar::int32;
  const int bits = 8 * static_cast<int>(size_of(type)) - (is_signed ? 1 : 0);
  const double end = std::ldexp(1.0, bits);
  return number >= (is_signed ? -end : 0) && number < end && number == std::floor(number);
}

double load_scalar(const char* bytes, PlyScalar type, std::endian order) {
  switch (type) {
    case PlyScalar::int8:
      return load<std::int8_t>(bytes, order);
    case PlyScalar::uint8:
      return load<std::uint8_t>(bytes, order);
    case PlyScalar::int16:
      return load<std::int16_t>(bytes, order);
    case PlyScalar::uint16:
      return load<std::uint16_t>(bytes, order);
    case PlyScalar::int32:
      return load<std::int32_t>(bytes, order);
    case PlyScalar::uint32:
      return load<std::uint32_t>(bytes, order);
    case PlyScalar::float32:
      return load<float>(bytes, order);
    case PlyScalar::float64:
      return load<double>(bytes, order);
  }
  return 0;
}

bool PlyElement::has_lists() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.list_count.has_value(); });
}

std::size_t PlyElement::least_size() const {
  std::size_t size = 0;
  for (const PlyProperty& p : properties) size += size_of(p.list_count.value_or(p.type));
  return size;
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].name == property) return i;
  return std::nullopt;
}

PlyHeader read_ply_header(const Input& input) {
  TextCursor text(input.data, {});
  PlyHeader header;
  if (!text.accept("ply")) text.fail_expected("'ply'");
  bool has_format = false;
  while (true) {
    if (!text.next_word_anywhere()) text.fail_expected("'end_header'");
    if (text.accept("end_header")) break;
    if (text.accept("format")) {
      header.order = read_order(text);
      has_format = true;
    } else if (text.accept("element")) {
      header.elements.push_back(read_element(text));
    } else if (text.accept("property")) {
      if (header.elements.empty()) text.fail_here("a property stands before the first element");
      header.elements.back().properties.push_back(read_property(text));
    } else if (text.accept("comment")) {
      read_comment(text, header);
    } else if (!text.accept("obj_info")) {
      text.fail_expected("'format', 'element', 'property', 'comment' or 'end_header'");
    }
    text.skip_line();
  }
  if (!has_format) text.fail_here("expected a line 'format' in the header");
  header.data = data_offset(input, text.offset());
  return header;
}

}  // namespace strata::io
