#include "extensions/openscad/primitives.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "core/mesh/circle.h"
#include "core/primitives/stack.h"
#include "extensions/openscad/arguments.h"
#include "extensions/openscad/tessellation.h"

namespace strata::openscad {
namespace {

/// From one corner to the opposite one; both in doubles.
struct Extent {
  double lower = 0;
  double upper = 0;
};

Extent extent(double length, bool centred) { return centred ? Extent{-length / 2, length / 2} : Extent{0, length}; }

/// Corner 4 a + 2 b + c is on the upper side along x, y, z for a, b, c = 1.
Mesh box(const std::array<Extent, 3>& sides) {
  Mesh mesh;
  for (const double x : {sides[0].lower, sides[0].upper})
    for (const double y : {sides[1].lower, sides[1].upper})
      for (const double z : {sides[2].lower, sides[2].upper}) mesh.vertices.push_back({x, y, z});
  for (const auto& [a, b, c, d] : {std::array<std::uint32_t, 4>{0, 1, 3, 2},
                                   {4, 6, 7, 5},
                                   {0, 4, 5, 1},
                                   {2, 3, 7, 6},
                                   {0, 2, 6, 4},
                                   {1, 5, 7, 3}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

std::array<double, 3> size_of(const Arguments& arguments) {
  const Value* const size = arguments.find("size");
  if (size == nullptr) return {1, 1, 1};
  if (size->kind == Value::Kind::number) return {size->number, size->number, size->number};
  const bool are_numbers =
      size->kind == Value::Kind::vector && size->items.size() == 3 &&
      std::all_of(size->items.begin(), size->items.end(), [](const Value& v) { return v.kind == Value::Kind::number; });
  if (!are_numbers) arguments.fail("size", "is neither a number nor three");
  return {size->items[0].number, size->items[1].number, size->items[2].number};
}

bool is_too_small(double radius) { return radius != 0 && radius < least_radius; }

std::string too_small() {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), least_radius).ptr;
  return "a radius below " + std::string(digits.data(), end) + " is too small for doubles";
}

}  // namespace

std::optional<Solid> Primitives::nothing(const SyntaxNode& node, const char* because) {
  report_.note(node.place, "a " + std::string(node.name) + " " + because + " makes nothing");
  return std::nullopt;
}

void Primitives::require_corners(const SyntaxNode& node, std::size_t sides, std::size_t rings) const {
  if (sides > most_corners / rings)
    report_.fail(node.place, "a " + std::string(node.name) + " of " + std::to_string(sides) +
                                 " sides has too many corners: at most " + std::to_string(most_corners));
}

template <class Make>
Solid Primitives::shared(std::vector<double> key, const Make& make) {
  const auto known = solids_.find(key);
  return known != solids_.end() ? known->second
                                : solids_.emplace(std::move(key), Solid(make(), InputClass::solid)).first->second;
}

std::optional<Solid> Primitives::cube(const SyntaxNode& node) {
  const Arguments arguments(node, {"size", "center"}, report_);
  const bool centred = arguments.truth("center", false);
  std::array<Extent, 3> sides;
  std::vector<double> key{0};
  for (std::size_t i = 0; const double length : size_of(arguments)) {
    if (!std::isfinite(length)) return nothing(node, "that is not finite");
    sides[i] = extent(length, centred);
    if (!(sides[i].lower < sides[i].upper)) return nothing(node, "without volume");
    key.insert(key.end(), {sides[i].lower, sides[i].upper});
    ++i;
  }
  return shared(std::move(key), [&] { return box(sides); });
}

std::optional<Solid> Primitives::sphere(const SyntaxNode& node) {
  const Arguments arguments(node, {"r", "d"}, report_);
  const double radius = radius_of(arguments, "d", "r", 1);
  const Resolution resolution = resolution_of(arguments);
  if (!std::isfinite(radius)) return nothing(node, "that is not finite");
  if (radius <= 0) return nothing(node, "without volume");
  if (is_too_small(radius)) report_.fail(node.place, too_small());
  const std::uint32_t sides = sides_of_circle(radius, resolution), count = (sides + 1) / 2;
  require_corners(node, sides, count);
  return shared({1, radius, static_cast<double>(sides)}, [&] {
    std::vector<Ring> rings;
    for (std::uint32_t i = count; i-- > 0;) {
      const CosineSine d = cosine_sine(180.0 * (i + 0.5) / count);
      rings.push_back({radius * d.sine, radius * d.cosine});
    }
    return stack(rings, sides);
  });
}

std::optional<Solid> Primitives::cylinder(const SyntaxNode& node) {
  const Arguments arguments(node, {"h", "r1", "r2", "center", "r", "d", "d1", "d2"}, report_);
  const double height = arguments.number("h", 1), both = radius_of(arguments, "d", "r", 1);
  const Extent along = extent(height, arguments.truth("center", false));
  const Ring lower{radius_of(arguments, "d1", "r1", both), along.lower};
  const Ring upper{radius_of(arguments, "d2", "r2", both), along.upper};
  const Resolution resolution = resolution_of(arguments);
  if (!std::isfinite(height) || !std::isfinite(lower.radius) || !std::isfinite(upper.radius))
    return nothing(node, "that is not finite");
  if (lower.radius < 0 || upper.radius < 0) return nothing(node, "of a negative radius");
  const double widest = std::max(lower.radius, upper.radius);
  if (!(lower.z < upper.z) || widest == 0) return nothing(node, "without volume");
  if (is_too_small(lower.radius) || is_too_small(upper.radius)) report_.fail(node.place, too_small());
  const std::uint32_t sides = sides_of_circle(widest, resolution);
  require_corners(node, sides, 2);
  return shared({2, lower.radius, upper.radius, lower.z, upper.z, static_cast<double>(sides)}, [&] {
    return stack(std::array{lower, upper}, sides);
  });
}

}  // namespace strata::openscad
