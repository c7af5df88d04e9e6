#include "extensions/openscad/operations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "extensions/openscad/arguments.h"
#include "extensions/openscad/join.h"
#include "extensions/openscad/linear_extrude.h"
#include "extensions/openscad/offset.h"
#include "extensions/openscad/rotate_extrude.h"
#include "extensions/openscad/shape_operations.h"
#include "extensions/openscad/solid_operations.h"
#include "strata/attributes.h"
#include "strata/convex.h"
#include "strata/srgb.h"

namespace strata::openscad {
namespace {

Part solid_part(Solid solid, const std::string& name) {
  return solid.is_empty() ? Part() : Part::of(Expression(std::move(solid), name), true);
}

/// The union of the children that are shapes; others are left out, with a note.
Part shapes_of(std::vector<Part> children, const SyntaxNode& node, const Options& options, Report& report) {
  std::vector<Part> shapes;
  for (Part& p : children) {
    if (p.is_shape()) shapes.push_back(std::move(p));
    if (p.is_solid()) report.note(node.place, "a solid in a " + std::string(node.name) + " is passed over");
  }
  return union_of(std::move(shapes), Monitor(options.cancel));
}

/// The union of the children that are solids.
Part solids_of(std::vector<Part> children, const SyntaxNode& node, const Options& options, Report& report) {
  std::vector<Part> solids;
  for (Part& p : children) {
    if (p.is_solid()) solids.push_back(std::move(p));
    if (p.is_shape()) report.note(node.place, "a shape in a " + std::string(node.name) + " is passed over");
  }
  return union_of(std::move(solids), Monitor(options.cancel));
}

Part all_of(std::vector<Part> children, const SyntaxNode& node, const Options& options, Report& report) {
  return union_of(of_one_dimension(std::move(children), node.place, report), Monitor(options.cancel));
}

/// Missing rows and columns are those of the identity.
std::array<double, 16> matrix_of(const Arguments& arguments) {
  std::array<double, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const Value* const rows = arguments.find("m");
  if (rows == nullptr) return m;
  const auto is_short = [](const Value& v) { return v.kind == Value::Kind::vector && v.items.size() <= 4; };
  if (!is_short(*rows)) arguments.fail("m", "is no vector of up to four rows");
  for (std::size_t i = 0; i < rows->items.size(); ++i) {
    const Value& row = rows->items[i];
    if (!is_short(row)) arguments.fail("m", "has a row that is no vector of up to four numbers");
    for (std::size_t j = 0; j < row.items.size(); ++j) {
      if (row.items[j].kind != Value::Kind::number) arguments.fail("m", "has a coefficient that is no number");
      m[4 * i + j] = row.items[j].number;
    }
  }
  const bool is_finite = std::all_of(m.begin(), m.end(), [](double x) { return std::isfinite(x); });
  if (is_finite && (m[12] != 0 || m[13] != 0 || m[14] != 0)) arguments.fail("m", "has a last row that is not 0 0 0 1");
  return m;
}

/// What a matrix does in the plane; none where it has no inverse there.
std::optional<PlaneMap> plane_map(const std::array<double, 16>& m) {
  PlaneMap map;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::array<std::size_t, 3> columns{0, 1, 3};
    for (std::size_t j = 0; j < 3; ++j) map[i][j] = to_rational(m[4 * i + columns[j]]) / to_rational(m[15]);
  }
  if (map[0][0] * map[1][1] == map[0][1] * map[1][0]) return std::nullopt;
  return map;
}

bool is_identity(const PlaneMap& map) {
  return map[0][0] == 1 && map[0][1] == 0 && map[0][2] == 0 && map[1][0] == 0 && map[1][1] == 1 && map[1][2] == 0;
}

std::optional<Transform> space_map(const std::array<double, 16>& m) {
  try {
    return Transform::from_matrix(m);
  } catch (const std::invalid_argument&) {  // its other reasons cannot occur here
    return std::nullopt;
  }
}

Part moved(const Part& part, const std::array<double, 16>& m, Placement placement, const SyntaxNode& node,
           Report& report) {
  const bool is_finite = std::all_of(m.begin(), m.end(), [](double x) { return std::isfinite(x); });
  if (!is_finite) {
    report.note(node.place, "a multmatrix that is not finite makes nothing");
    return {};
  }
  if (m[15] != 0 && part.is_shape()) {
    if (const auto map = plane_map(m))
      return is_identity(*map) ? part : Part::of(transformed(part.shape(), *map, placement));
  } else if (m[15] != 0) {
    if (const auto map = space_map(m)) return map->is_identity() ? part : part.moved(*map, placement);
  }
  report.note(node.place, "a multmatrix without inverse makes nothing");
  return {};
}

NodeOperation multmatrix(const SyntaxNode& node, Placement placement, Report& report) {
  const std::array<double, 16> m = matrix_of(Arguments(node, {"m"}, report));
  return [m, placement, &node](std::vector<Part> children, const Options& options, Report& notes) {
    const Part part = all_of(std::move(children), node, options, notes);
    return part.is_empty() ? part : moved(part, m, placement, node, notes);
  };
}

Part hull_of(std::vector<Part> parts, const std::string& name, const Options& options) {
  std::erase_if(parts, [](const Part& p) { return p.is_empty(); });
  if (parts.empty()) return {};
  if (parts.front().is_solid()) return solid_part(hull(parts, options), name);
  std::vector<const planar::Region*> regions;
  for (const Part& p : parts) regions.push_back(&p.shape());
  return Part::of(hull(regions));
}

/// Of shapes empty if one is empty, of solids without the empty ones, as in OpenSCAD.
Part sum_of(std::vector<Part> parts, const std::string& name, const Options& options) {
  if (std::any_of(parts.begin(), parts.end(), [](const Part& p) { return p.is_shape(); })) {
    if (std::any_of(parts.begin(), parts.end(), [](const Part& p) { return p.is_empty(); })) return {};
    planar::Region sum = parts.front().shape();
    for (std::size_t i = 1; i < parts.size(); ++i) sum = minkowski_sum(sum, parts[i].shape());
    return Part::of(std::move(sum));
  }
  std::erase_if(parts, [](const Part& p) { return p.is_empty(); });
  if (parts.size() <= 1) return parts.empty() ? Part() : parts.front();
  std::vector<Solid> solids;
  for (const Part& p : parts)
    if (Solid solid = evaluated(p, options); !solid.is_empty()) solids.push_back(std::move(solid));
  if (solids.empty()) return {};
  Solid sum = std::move(solids.front());
  for (std::size_t i = 1; i < solids.size(); ++i) sum = convex::minkowski_sum(sum, solids[i], options);
  return solid_part(std::move(sum), name);
}

Part resized(const Part& part, const std::array<double, 3>& new_size, const std::array<bool, 3>& automatic,
             const std::string& name, Placement placement, const Options& options) {
  if (part.is_shape()) {
    const auto [lower, upper] = bounding_box(part.shape());
    const RationalPoint f =
        resize_factors({new_size[0], new_size[1], 0}, automatic, {upper[0] - lower[0], upper[1] - lower[1], 0});
    return Part::of(transformed(part.shape(), {{{f[0], 0, 0}, {0, f[1], 0}}}, placement));
  }
  Solid solid = evaluated(part, options);
  if (solid.is_empty()) return {};
  const auto [lower, upper] = bounding_box(solid);
  const RationalPoint size{upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]};
  const Transform map = Transform::scaling(resize_factors(new_size, automatic, size));
  return Part::of(Expression(std::move(solid), name).transformed(map, placement), true);
}

NodeOperation resize(const SyntaxNode& node, const std::string& name, Placement placement, Report& report) {
  const Arguments arguments(node, {"newsize", "auto", "convexity"}, report);
  const std::vector<double> size = arguments.numbers("newsize", {0, 0, 0});
  std::array<bool, 3> automatic{};
  if (const Value* const value = arguments.find("auto")) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Value* const item = value->kind != Value::Kind::vector ? value
                                : i < value->items.size()          ? &value->items[i]
                                                                   : nullptr;
      automatic[i] = item != nullptr && (item->truth || item->number != 0);
    }
  }
  if (!std::all_of(size.begin(), size.end(), [](double x) { return std::isfinite(x); }))
    arguments.fail("newsize", "is not finite");
  return [=, &node](std::vector<Part> children, const Options& options, Report& notes) {
    const Part part = all_of(std::move(children), node, options, notes);
    if (part.is_empty()) return part;
    return resized(part, {size[0], size[1], size[2]}, automatic, name, placement, options);
  };
}

NodeOperation offset(const SyntaxNode& node, Report& report) {
  const Arguments arguments(node, {"r", "delta", "chamfer", "join_type", "miter_limit", "arc_tolerance"}, report);
  const bool is_round = !arguments.is_given("delta");
  const double distance = is_round ? arguments.number("r", 1) : arguments.number("delta", 1);
  const bool is_chamfered = arguments.truth("chamfer", false);
  const OffsetJoin join = is_round ? OffsetJoin::round : is_chamfered ? OffsetJoin::chamfer : OffsetJoin::miter;
  const Resolution resolution = resolution_of(arguments);
  if (!std::isfinite(distance)) arguments.fail(is_round ? "r" : "delta", "is not finite");
  return [=, &node](std::vector<Part> children, const Options& options, Report& notes) {
    const Part part = shapes_of(std::move(children), node, options, notes);
    return part.is_empty() || distance == 0 ? part
                                            : Part::of(openscad::offset(part.shape(), distance, join, resolution));
  };
}

/// A shape that is made from the children's union, if this is a shape.
template <class Make>
NodeOperation from_shape(const SyntaxNode& node, const Make& make) {
  return [&node, make](std::vector<Part> children, const Options& options, Report& notes) {
    const Part part = shapes_of(std::move(children), node, options, notes);
    return part.is_empty() ? part : make(part.shape(), options, notes);
  };
}

NodeOperation fill(const SyntaxNode& node, Report& report) {
  (void)Arguments(node, {}, report);
  return from_shape(
      node, [](const planar::Region& shape, const Options&, Report&) { return Part::of(without_holes(shape)); });
}

NodeOperation projection(const SyntaxNode& node, Report& report) {
  const bool is_cut = Arguments(node, {"cut", "convexity"}, report).truth("cut", false);
  return [is_cut, &node](std::vector<Part> children, const Options& options, Report& notes) {
    const Part part = solids_of(std::move(children), node, options, notes);
    if (part.is_empty()) return part;
    const Solid solid = evaluated(part, options);
    return Part::of(is_cut ? section_at_zero(solid, options) : shadow(solid));
  };
}

std::optional<std::uint32_t> count_of(const Arguments& arguments, const char* parameter, double least) {
  if (!arguments.is_given(parameter)) return std::nullopt;
  constexpr double most = 1e6;
  const double count = arguments.number(parameter, 0);
  if (!(count <= most)) arguments.fail(parameter, "is above a million");
  return static_cast<std::uint32_t>(std::max(count, least));
}

LinearExtrusion linear_extrusion(const Arguments& arguments) {
  LinearExtrusion e;
  const bool has_direction = arguments.is_given("v");
  const std::vector<double> v = arguments.numbers("v", {0, 0, 1});
  const double length = std::hypot(v[0], v[1], v[2]);
  const double height = std::max(arguments.number("height", has_direction ? length : 100), 0.0);
  for (std::size_t i = 0; i < 3; ++i) e.along[i] = has_direction && length > 0 ? v[i] / length * height : 0;
  if (!has_direction) e.along[2] = height;
  e.is_centred = arguments.truth("center", false);
  e.twist = arguments.number("twist", 0);
  const std::vector<double> scale = arguments.numbers("scale", {1, 1});
  e.scale = {std::max(scale[0], 0.0), std::max(scale[1], 0.0)};
  e.slices = count_of(arguments, "slices", 1);
  e.segments = count_of(arguments, "segments", 0);
  e.resolution = resolution_of(arguments);
  for (const double x : {e.along[0], e.along[1], e.along[2], e.twist, e.scale[0], e.scale[1]})
    if (!std::isfinite(x)) e.along = {};
  return e;
}

NodeOperation linear_extrude(const SyntaxNode& node, const std::string& name, Report& report) {
  const Arguments arguments(
      node, {"height", "v", "scale", "center", "twist", "slices", "segments", "convexity", "file", "layer", "origin"},
      report);
  const LinearExtrusion extrusion = linear_extrusion(arguments);
  if (extrusion.along[2] == 0) arguments.note("without height makes nothing");
  return from_shape(node, [=](const planar::Region& shape, const Options& options, Report&) {
    if (extrusion.along[2] == 0) return Part();
    return solid_part(openscad::linear_extrude(shape, extrusion, options), name);
  });
}

NodeOperation rotate_extrude(const SyntaxNode& node, const std::string& name, Report& report) {
  const Arguments arguments(node, {"angle", "start", "convexity", "file", "layer", "origin", "scale"}, report);
  RotateExtrusion extrusion;
  extrusion.angle = arguments.number("angle", 360);
  if (!std::isfinite(extrusion.angle) || std::abs(extrusion.angle) > 360) extrusion.angle = 360;
  extrusion.start = arguments.number("start", extrusion.angle == 360 ? 180 : 0);
  if (!std::isfinite(extrusion.start)) arguments.fail("start", "is not finite");
  extrusion.resolution = resolution_of(arguments);
  return from_shape(node, [=, &node](const planar::Region& shape, const Options& options, Report& notes) {
    if (extrusion.angle == 0) return Part();
    if (crosses_axis(shape)) {
      notes.note(node.place, "a rotate_extrude of points on both sides of the axis makes nothing");
      return Part();
    }
    return solid_part(openscad::rotate_extrude(shape, extrusion, options), name);
  });
}

/// All faces of one material.
Solid painted(const Solid& solid, const std::array<double, 4>& color) {
  Attributes attributes;
  attributes.channels = {{std::string(channel_names::material), Element::face, Interpolation::nearest, 1,
                          std::vector<std::int32_t>(solid.mesh().triangles.size(), 0)}};
  attributes.materials.emplace_back().color = color;
  return solid.with_attributes(std::move(attributes));
}

/// A Boolean operation of all children.
template <class Join>
NodeOperation joined(const SyntaxNode& node, const Join& join) {
  return [&node, join](std::vector<Part> children, const Options& options, Report& notes) {
    return join(of_one_dimension(std::move(children), node.place, notes), options);
  };
}

}  // namespace

NodeOperation union_operation(const SyntaxNode& node) {
  return joined(
      node, [](std::vector<Part> parts, const Options& o) { return union_of(std::move(parts), Monitor(o.cancel)); });
}

std::optional<std::array<double, 4>> color_of(const SyntaxNode& node, Report& report) {
  const Arguments arguments(node, {"c", "alpha"}, report);
  const Value* const value = arguments.find("c");
  const bool is_vector = value != nullptr && value->kind == Value::Kind::vector;
  const std::vector<double> c = is_vector ? arguments.numbers("c", {0, 0, 0, 1}) : std::vector<double>{-1};
  if (std::all_of(c.begin(), c.end(), [](double x) { return x >= 0; }))
    return std::array{light_of_srgb(c[0]), light_of_srgb(c[1]), light_of_srgb(c[2]), std::min(c[3], 1.0)};
  report.note(node.place, "a color that is not given as numbers from 0 is passed over");
  return std::nullopt;
}

NodeOperation color_operation(const SyntaxNode& node, const std::array<double, 4>& color) {
  return [color, &node](std::vector<Part> children, const Options& options, Report& notes) {
    const Part part = all_of(std::move(children), node, options, notes);
    if (part.is_shape()) notes.note(node.place, "the color of a shape is passed over");
    if (!part.is_solid()) return part;
    return Part::of(part.solid().with_solids([&](const Solid& solid) { return painted(solid, color); }),
                    part.is_union());
  };
}

NodeOperation operation_of(NodeKind kind, const SyntaxNode& node, const std::string& name, Placement placement,
                           Report& report) {
  switch (kind) {
    case NodeKind::multmatrix:
      return multmatrix(node, placement, report);
    case NodeKind::render:
      report.note(node.place, "render is passed over");
      return union_operation(node);
    case NodeKind::union_:
      (void)Arguments(node, {}, report);  // there are none
      return union_operation(node);
    case NodeKind::difference:
      (void)Arguments(node, {}, report);
      return joined(node, [](std::vector<Part> parts, const Options& o) {
        return difference_of(std::move(parts), Monitor(o.cancel));
      });
    case NodeKind::intersection:
      (void)Arguments(node, {}, report);
      return joined(node, [](std::vector<Part> parts, const Options& o) {
        return intersection_of(std::move(parts), Monitor(o.cancel));
      });
    case NodeKind::hull:
      (void)Arguments(node, {}, report);
      return joined(node,
                    [name](std::vector<Part> parts, const Options& o) { return hull_of(std::move(parts), name, o); });
    case NodeKind::minkowski:
      (void)Arguments(node, {"convexity"}, report);
      return joined(node,
                    [name](std::vector<Part> parts, const Options& o) { return sum_of(std::move(parts), name, o); });
    case NodeKind::resize:
      return resize(node, name, placement, report);
    case NodeKind::offset:
      return offset(node, report);
    case NodeKind::fill:
      return fill(node, report);
    case NodeKind::projection:
      return projection(node, report);
    case NodeKind::linear_extrude:
      return linear_extrude(node, name, report);
    case NodeKind::rotate_extrude:
      return rotate_extrude(node, name, report);
    case NodeKind::color:
    case NodeKind::cube:
    case NodeKind::sphere:
    case NodeKind::cylinder:
    case NodeKind::polyhedron:
    case NodeKind::square:
    case NodeKind::circle:
    case NodeKind::polygon:
    case NodeKind::text:
    case NodeKind::import:
    case NodeKind::surface:
    case NodeKind::roof:
    case NodeKind::unknown:
      break;  // no operations, or those of other functions
  }
  throw std::logic_error("a node that is no operation");
}

}  // namespace strata::openscad
