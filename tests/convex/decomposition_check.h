#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "strata/convex.h"
#include "strata/measure.h"
#include "strata/solid.h"

/// Says what is wrong with a decomposition, by rationals and by code that made none of it.
namespace strata::test {

using Positions = std::vector<RationalPoint>;

inline Positions positions_of(const std::vector<Vertex>& points, const std::vector<ExactVertex>& exact) {
  Positions at;
  for (const Vertex& v : points) at.push_back({to_rational(v[0]), to_rational(v[1]), to_rational(v[2])});
  for (const ExactVertex& e : exact) at[e.vertex] = e.position;
  return at;
}

/// Twice the area of a polygon as a vector.
inline RationalPoint area_vector(const Positions& at, const std::vector<std::uint32_t>& loop) {
  RationalPoint sum{0, 0, 0};
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const RationalPoint &p = at[loop[k]], &q = at[loop[(k + 1) % loop.size()]];
    for (std::size_t i = 0; i < 3; ++i) sum[i] += p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];
  }
  return sum;
}

inline Rational dot(const RationalPoint& u, const RationalPoint& p) { return u[0] * p[0] + u[1] * p[1] + u[2] * p[2]; }

/// Every vertex of the piece is behind the plane of every facet, or on it for the facet's own; facets close.
inline bool is_convex(const Positions& at, const std::vector<std::vector<std::uint32_t>>& facets) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const auto& facet : facets) {
    const RationalPoint normal = area_vector(at, facet);
    const Rational level = dot(normal, at[facet[0]]);
    for (const auto& other : facets)
      for (const std::uint32_t p : other)
        if (dot(normal, at[p]) > level) return false;
    for (std::size_t k = 0; k < facet.size(); ++k) {
      if (dot(normal, at[facet[k]]) != level) return false;
      ++sides[{facet[k], facet[(k + 1) % facet.size()]}];
    }
  }
  for (const auto& [side, count] : sides)
    if (count != 1 || !sides.contains({side.second, side.first})) return false;
  return facets.size() > 3;
}

/// Sums of |twice the area| seen along the three axes.
class AreaSums {
 public:
  void add(const RationalPoint& area, int times) {
    for (std::size_t i = 0; i < 3; ++i) sums_[i] += times * abs(area[i]);
  }
  friend bool operator==(const AreaSums&, const AreaSums&) = default;

 private:
  std::array<Rational, 3> sums_;
};

inline AreaSums boundary_areas(const ExactMesh& mesh) {
  Positions at;
  for (std::uint32_t v = 0; v < mesh.mesh.vertices.size(); ++v) at.push_back(mesh.position(v));
  AreaSums sums;
  for (const Triangle& t : mesh.mesh.triangles) sums.add(area_vector(at, {t[0], t[1], t[2]}), 1);
  return sums;
}

/// Every piece convex, volumes add up, boundaries cancel to that of the solid (so pieces are apart and fill it), and
/// walls are all that is left of their facets. Empty: all is right.
inline std::string fault_of(const convex::Decomposition& d, const Solid& solid) {
  const Positions at = positions_of(d.points, d.exact());
  Rational volume = 0;
  std::vector<ExactFacet> facets;
  AreaSums areas;
  for (std::size_t p = 0; p < d.pieces.size(); ++p) {
    if (!is_convex(at, d.pieces[p])) return "piece " + std::to_string(p) + " is not convex";
    for (const auto& loop : d.pieces[p]) {
      const RationalPoint area = area_vector(at, loop);
      volume += dot(area, at[loop[0]]) / 6;
      areas.add(area, 1);
      std::vector<RationalPoint> corners;
      for (const std::uint32_t v : loop) corners.push_back(at[v]);
      facets.push_back({std::move(corners)});
    }
  }
  if (volume != solid.volume()) return "volumes do not add up";
  if (canonical_form(facets) != solid.canonical()) return "the boundary of all pieces is not that of the solid";
  for (const convex::Wall& wall : d.walls) {
    if (wall.pieces[0] >= wall.pieces[1] || wall.pieces[1] >= d.pieces.size()) return "a wall is between no two pieces";
    const RationalPoint area = area_vector(at, wall.polygon);
    for (const auto& loop : d.pieces[wall.pieces[0]])  // the first piece is behind it
      for (const std::uint32_t v : loop)
        if (dot(area, at[v]) > dot(area, at[wall.polygon[0]])) return "a wall faces the wrong piece";
    areas.add(area, -2);
  }
  if (!(areas == boundary_areas(solid.exact_mesh()))) return "walls are missing or too many";
  Positions corners;
  for (std::uint32_t v = 0; v < solid.mesh().vertices.size(); ++v) corners.push_back(solid.exact_mesh().position(v));
  std::vector<RationalPoint> uncovered;
  for (const Triangle& t : solid.mesh().triangles) uncovered.push_back(area_vector(corners, {t[0], t[1], t[2]}));
  for (const convex::BoundaryPart& part : d.boundary) {
    const RationalPoint area = area_vector(at, part.polygon);
    for (std::size_t i = 0; i < 3; ++i) uncovered[part.triangle][i] -= area[i];
  }
  for (const RationalPoint& area : uncovered)
    if (area != RationalPoint{0, 0, 0}) return "a triangle is not covered once";
  return {};
}

}  // namespace strata::test
