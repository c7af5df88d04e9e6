#include "extensions/openscad/shapes.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/circle.h"
#include "extensions/openscad/arguments.h"
#include "extensions/openscad/primitives.h"
#include "extensions/openscad/tessellation.h"

namespace strata::openscad {
namespace {

Part filled(const planar::Loops& loops, const Arguments& arguments) {
  Part part = Part::of(planar::fill({loops, planar::FillRule::even_odd}));
  if (part.is_empty()) arguments.note("without area makes nothing");
  return part;
}

/// The corners that a path lists, or all of them.
std::vector<planar::PlanePoint> path_of(const Value& path, const std::vector<std::vector<double>>& points,
                                        const Arguments& arguments) {
  if (path.kind != Value::Kind::vector) arguments.fail("paths", "have a path that is no vector");
  std::vector<planar::PlanePoint> corners;
  for (const Value& v : path.items) {
    const bool is_index = v.kind == Value::Kind::number && v.number >= 0 &&
                          v.number < static_cast<double>(points.size()) && v.number == std::floor(v.number);
    if (!is_index)
      arguments.fail("paths", "have a corner that is no number of a point: there are " + std::to_string(points.size()));
    const auto& p = points[static_cast<std::size_t>(v.number)];
    corners.push_back({p[0], p[1]});
  }
  return corners;
}

std::vector<planar::PlanePoint> all_of(const std::vector<std::vector<double>>& points) {
  std::vector<planar::PlanePoint> corners;
  for (const auto& p : points) corners.push_back({p[0], p[1]});
  return corners;
}

/// Paths are a vector of vectors of numbers, or one vector of numbers.
std::vector<std::vector<planar::PlanePoint>> paths_of(const Arguments& arguments) {
  const auto points = arguments.points("points", 2);
  const Value* const paths = arguments.find("paths");
  if (paths == nullptr) return {all_of(points)};
  if (paths->kind != Value::Kind::vector) arguments.fail("paths", "are no vector");
  if (paths->items.empty()) return {all_of(points)};
  if (paths->items.front().kind == Value::Kind::number) return {path_of(*paths, points, arguments)};
  std::vector<std::vector<planar::PlanePoint>> all;
  for (const Value& path : paths->items) all.push_back(path_of(path, points, arguments));
  return all;
}

}  // namespace

Part square(const SyntaxNode& node, Report& report) {
  const Arguments arguments(node, {"size", "center"}, report);
  const std::vector<double> size = arguments.numbers("size", {1, 1});
  const bool is_centred = arguments.truth("center", false);
  planar::PlanePoint lower{}, upper{};
  for (std::size_t i = 0; i < 2; ++i) {
    if (!std::isfinite(size[i])) {
      arguments.note("that is not finite makes nothing");
      return {};
    }
    lower[i] = is_centred ? -size[i] / 2 : 0;
    upper[i] = is_centred ? size[i] / 2 : size[i];
    if (!(lower[i] < upper[i])) {
      arguments.note("without area makes nothing");
      return {};
    }
  }
  planar::Loops loops;
  loops.add(std::vector<planar::PlanePoint>{lower, {upper[0], lower[1]}, upper, {lower[0], upper[1]}});
  return filled(loops, arguments);
}

Part circle(const SyntaxNode& node, Report& report) {
  const Arguments arguments(node, {"r", "d"}, report);
  const double radius = radius_of(arguments, "d", "r", 1);
  const std::uint32_t sides = sides_of_circle(radius, resolution_of(arguments));
  if (!std::isfinite(radius) || radius <= 0) {
    arguments.note(std::isfinite(radius) ? "without area makes nothing" : "that is not finite makes nothing");
    return {};
  }
  if (sides > most_corners)
    report.fail(node.place, "a circle of " + std::to_string(sides) + " sides has too many corners: at most " +
                                std::to_string(most_corners));
  std::vector<planar::PlanePoint> corners;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const CosineSine d = cosine_sine(360.0 * i / sides);
    corners.push_back({radius * d.cosine, radius * d.sine});
  }
  planar::Loops loops;
  loops.add(corners);
  return filled(loops, arguments);
}

Part polygon(const SyntaxNode& node, Report& report) {
  const Arguments arguments(node, {"points", "paths", "convexity"}, report);
  planar::Loops loops;
  for (const auto& path : paths_of(arguments))
    if (path.size() >= 3) loops.add(path);
  return filled(loops, arguments);
}

}  // namespace strata::openscad
