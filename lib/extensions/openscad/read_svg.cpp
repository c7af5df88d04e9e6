#include "extensions/openscad/read_svg.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <utility>

#include "core/system/decimal.h"
#include "extensions/openscad/svg_path.h"
#include "strata/errors.h"

namespace strata::openscad {
namespace {

using planar::PlanePoint;
using Loop = std::vector<PlanePoint>;

/// (x, y) -> (a x + c y + e, b x + d y + f).
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  [[nodiscard]] PlanePoint operator()(const PlanePoint& p) const {
    return {a * p[0] + c * p[1] + e, b * p[0] + d * p[1] + f};
  }
  friend Affine operator*(const Affine& s, const Affine& t) {
    return {s.a * t.a + s.c * t.b, s.b * t.a + s.d * t.b,       s.a * t.c + s.c * t.d,
            s.b * t.c + s.d * t.d, s.a * t.e + s.c * t.f + s.e, s.b * t.e + s.d * t.f + s.f};
  }
};

Affine rotation(double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
  return {c, s, -s, c, 0, 0};
}

Affine affine_named(std::string_view name, const std::vector<double>& n) {
  const auto at = [&](std::size_t i, double otherwise) { return i < n.size() ? n[i] : otherwise; };
  if (name == "matrix" && n.size() == 6) return {n[0], n[1], n[2], n[3], n[4], n[5]};
  if (name == "translate") return {1, 0, 0, 1, at(0, 0), at(1, 0)};
  if (name == "scale") return {at(0, 1), 0, 0, at(1, at(0, 1)), 0, 0};
  if (name == "rotate")
    return Affine{1, 0, 0, 1, at(1, 0), at(2, 0)} * rotation(at(0, 0)) * Affine{1, 0, 0, 1, -at(1, 0), -at(2, 0)};
  if (name == "skewX") return {1, 0, std::tan(at(0, 0) * std::numbers::pi / 180), 1, 0, 0};
  if (name == "skewY") return {1, std::tan(at(0, 0) * std::numbers::pi / 180), 0, 1, 0, 0};
  throw IoError("SVG", {}, "'" + std::string(name.substr(0, 32)) + "' is no transformation");
}

Affine affine_of(std::string_view text) {
  Affine map;
  while (true) {
    const std::size_t start = text.find_first_not_of(" \t\r\n,");
    if (start == std::string_view::npos) return map;
    const std::size_t open = text.find('(', start), close = text.find(')', start);
    if (open == std::string_view::npos || close < open || close == std::string_view::npos)
      throw IoError("SVG", {}, "a transformation breaks off");
    std::string_view name = text.substr(start, open - start);
    name = name.substr(0, name.find_last_not_of(" \t\r\n") + 1);
    map = map * affine_named(name, svg_numbers(text.substr(open + 1, close - open - 1)));
    text.remove_prefix(close + 1);
  }
}

std::string_view local_name(const pugi::xml_node& element) {
  const std::string_view whole = element.name();
  return whole.substr(whole.find(':') + 1);  // all of it, if there is none
}

/// An attribute, or the property of that name in the attribute `style`.
std::string_view property(const pugi::xml_node& element, const char* name) {
  if (const auto own = element.attribute(name)) return own.value();
  std::string_view style = element.attribute("style").value();
  while (!style.empty()) {
    const std::string_view item = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(item.size() + 1, style.size()));
    const std::size_t first = item.find_first_not_of(" \t\r\n"), colon = item.find(':');
    if (colon == std::string_view::npos || item.substr(first, colon - first) != name) continue;
    const std::string_view value = item.substr(colon + 1);
    return value.substr(std::min(value.find_first_not_of(" \t"), value.size()));
  }
  return {};
}

/// A number with a unit.
struct Length {
  double number = 0;
  std::string_view unit;
};

std::optional<Length> length_of(const pugi::xml_node& element, const char* attribute) {
  std::string_view text = element.attribute(attribute).value();
  Length length;
  const auto [end, error] = system::from_chars(text.data(), text.data() + text.size(), length.number);
  if (error != std::errc{} || !std::isfinite(length.number)) return std::nullopt;
  length.unit = text.substr(static_cast<std::size_t>(end - text.data()));
  return length;
}

/// In millimetres; none for a part of something unknown.
std::optional<double> millimetres(const Length& length, double dots_per_inch) {
  if (length.unit == "mm") return length.number;
  if (length.unit == "cm") return length.number * 10;
  if (length.unit == "in") return length.number * 25.4;
  if (length.unit == "pt") return length.number * 25.4 / 72;
  if (length.unit == "pc") return length.number * 25.4 / 6;
  if (length.unit.empty() || length.unit == "px") return length.number * 25.4 / dots_per_inch;
  return std::nullopt;
}

class PictureReader {
 public:
  PictureReader(const SvgPlacement& placement, const Resolution& resolution) : placement_(placement) {
    if (resolution.fn > 0) parts_ = {std::max(resolution.fn, 3.0), std::max(resolution.fn, 1.0)};
  }

  SvgShapes read(const pugi::xml_node& document) {
    const pugi::xml_node picture =
        document.find_child([](const pugi::xml_node& n) { return n.type() == pugi::node_element; });
    if (local_name(picture) != "svg") throw IoError("SVG", {}, "there is no element svg");
    const Affine page = page_of(picture);
    visit(picture, page);
    SvgShapes shapes{united(), {}};
    for (const std::string& name : left_out_) shapes.notes.push_back(name + " is left out");
    return shapes;
  }

 private:
  /// From user units to millimetres, y upwards.
  [[nodiscard]] Affine page_of(const pugi::xml_node& picture) const {
    const std::vector<double> box = svg_numbers(picture.attribute("viewBox").value());
    const double unit = 25.4 / placement_.dots_per_inch;
    const auto side = [&](const char* name) -> std::optional<double> {
      const auto length = length_of(picture, name);
      return length ? millimetres(*length, placement_.dots_per_inch) : std::nullopt;
    };
    const std::optional<double> width = side("width"), height = side("height");
    if (box.size() != 4 || box[2] <= 0 || box[3] <= 0) return {unit, 0, 0, -unit, 0, height.value_or(0)};
    double sx = width ? *width / box[2] : unit, sy = height ? *height / box[3] : unit;
    if (width && !height) sy = sx;
    if (height && !width) sx = sy;
    const double scale = std::min(sx, sy);  // as preserveAspectRatio does unless told
    return {scale, 0, 0, -scale, -scale * box[0], scale * (box[1] + box[3])};
  }

  /// In the order of the document; without recursion.
  void visit(const pugi::xml_node& root, const Affine& page) {
    struct Open {
      pugi::xml_node node;
      Affine map;
      bool counts;
    };
    std::vector<Open> open{{root, page, placement_.id.empty() && placement_.layer.empty()}};
    while (!open.empty()) {
      Open at = open.back();
      open.pop_back();
      const std::string_view name = local_name(at.node);
      if (name == "defs" || name == "symbol" || name == "clipPath" || name == "mask" || name == "marker" ||
          name == "pattern" || property(at.node, "display") == "none")
        continue;
      if (const std::string_view map = at.node.attribute("transform").value(); !map.empty())
        at.map = at.map * affine_of(map);
      const std::string_view id = at.node.attribute("id").value(), label = at.node.attribute("inkscape:label").value();
      at.counts = at.counts || (!placement_.id.empty() && id == placement_.id) ||
                  (!placement_.layer.empty() && (label == placement_.layer || id == placement_.layer));
      if (at.counts) shape(at.node, name, at.map);
      const std::size_t first = open.size();
      for (const pugi::xml_node child : at.node.children())
        if (child.type() == pugi::node_element) open.push_back({child, at.map, at.counts});
      std::reverse(open.begin() + static_cast<std::ptrdiff_t>(first), open.end());
    }
  }

  void shape(const pugi::xml_node& element, std::string_view name, const Affine& map) {
    std::vector<Loop> loops;
    if (name == "path") {
      loops = svg_subpaths(element.attribute("d").value(), parts_);
    } else if (name == "rect") {
      loops = {rectangle(element)};
    } else if (name == "circle") {
      loops = {oval(number(element, "cx"), number(element, "cy"), number(element, "r"), number(element, "r"))};
    } else if (name == "ellipse") {
      loops = {oval(number(element, "cx"), number(element, "cy"), number(element, "rx"), number(element, "ry"))};
    } else if (name == "polygon" || name == "polyline") {
      const std::vector<double> n = svg_numbers(element.attribute("points").value());
      for (std::size_t i = 1; i < n.size(); i += 2) loops.resize(1), loops[0].push_back({n[i - 1], n[i]});
    } else {
      if (name == "text" || name == "image" || name == "use" || name == "line") left_out_.insert(std::string(name));
      return;
    }
    if (property(element, "fill") == "none") {
      left_out_.insert("a shape that is not filled (strokes are not drawn)");
      return;
    }
    add(loops, map, property(element, "fill-rule") == "evenodd");
  }

  void add(const std::vector<Loop>& loops, const Affine& map, bool is_even_odd) {
    planar::Loops placed;
    for (const Loop& loop : loops) {
      Loop points;
      for (const PlanePoint& p : loop) points.push_back(map(p));
      if (points.size() >= 3) placed.add(points);
    }
    regions_.push_back(planar::fill({placed, is_even_odd ? planar::FillRule::even_odd : planar::FillRule::nonzero}));
  }

  static double number(const pugi::xml_node& element, const char* attribute) {
    const auto length = length_of(element, attribute);
    return length ? length->number : 0;
  }
  [[nodiscard]] Loop oval(double cx, double cy, double rx, double ry) const {
    Loop loop;
    for (double k = 0; rx > 0 && ry > 0 && k < parts_.of_turn; ++k) {
      const double angle = 2 * std::numbers::pi * k / parts_.of_turn;
      loop.push_back({cx + rx * std::cos(angle), cy + ry * std::sin(angle)});
    }
    return loop;
  }
  [[nodiscard]] Loop rectangle(const pugi::xml_node& element) const {
    const double x = number(element, "x"), y = number(element, "y");
    const double w = number(element, "width"), h = number(element, "height");
    const auto given = [&](const char* name) { return length_of(element, name).has_value(); };
    double rx = given("rx") ? number(element, "rx") : number(element, "ry");
    double ry = given("ry") ? number(element, "ry") : rx;
    if (w <= 0 || h <= 0) return {};
    rx = std::clamp(rx, 0.0, w / 2);
    ry = std::clamp(ry, 0.0, h / 2);
    if (rx == 0 || ry == 0) return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
    Loop loop;
    const double steps = std::max(std::ceil(parts_.of_turn / 4), 1.0);
    const PlanePoint centres[4] = {
        {x + w - rx, y + h - ry}, {x + rx, y + h - ry}, {x + rx, y + ry}, {x + w - rx, y + ry}};
    for (std::size_t q = 0; q < 4; ++q)
      for (double k = 0; k <= steps; ++k) {
        const double angle = (static_cast<double>(q) + k / steps) * std::numbers::pi / 2;
        loop.push_back({centres[q][0] + rx * std::cos(angle), centres[q][1] + ry * std::sin(angle)});
      }
    return loop;
  }

  [[nodiscard]] planar::Region united() const {
    std::vector<planar::Operand> operands(regions_.begin(), regions_.end());
    planar::Region all = operands.empty() ? planar::Region() : planar::combine(operands, Operation::union_);
    if (!placement_.is_centred || all.empty()) return all;
    PlanePoint lower = all.loops.places.place[all.loops.vertices.front()], upper = lower;
    for (const std::uint32_t v : all.loops.vertices)
      for (std::size_t i = 0; i < 2; ++i) {
        lower[i] = std::min(lower[i], all.loops.places.place[v][i]);
        upper[i] = std::max(upper[i], all.loops.places.place[v][i]);
      }
    planar::Loops moved;
    for (std::uint32_t l = 0; l < all.loops.size(); ++l) {
      Loop loop;
      for (const std::uint32_t v : all.loops.loop(l)) {
        const PlanePoint& p = all.loops.places.place[v];
        loop.push_back({p[0] - (lower[0] + upper[0]) / 2, p[1] - (lower[1] + upper[1]) / 2});
      }
      moved.add(loop);
    }
    return planar::fill(moved);
  }

  const SvgPlacement& placement_;
  CurveParts parts_;
  std::vector<planar::Region> regions_;
  std::set<std::string> left_out_;
};

}  // namespace

SvgShapes read_svg(const std::string& text, const SvgPlacement& placement, const Resolution& resolution) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result) {
    const auto end = text.begin() + std::min<std::ptrdiff_t>(std::max<std::ptrdiff_t>(result.offset, 0),
                                                             static_cast<std::ptrdiff_t>(text.size()));
    const auto line = static_cast<std::size_t>(std::count(text.begin(), end, '\n')) + 1;
    throw IoError("SVG", {line, {}}, std::string("no XML: ") + result.description());
  }
  return PictureReader(placement, resolution).read(document);
}

}  // namespace strata::openscad
