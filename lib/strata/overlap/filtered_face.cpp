#include "strata/overlap/filtered_face.h"

#include "strata/kernel/filtered_turn.h"
#include "strata/kernel/predicates.h"

namespace strata {

FilteredFace::FilteredFace(const Carriers& carriers, std::uint32_t f)
    : FilteredFace(carriers, carriers.operand_of_face(f), f) {}

FilteredFace::FilteredFace(const Carriers& carriers, std::uint32_t operand, std::uint32_t f)
    : face(f), vertices(carriers.face(f)), is_exact(!carriers.has_rationals()) {
  const auto points = carriers.points(operand);
  const auto& t = carriers.faces(operand)[f - carriers.first_face(operand)];
  for (std::size_t i = 0; i < 3; ++i) corners[i] = points[t[i]];
  if (is_exact) plane = FilteredPlane(corners[0], corners[1], corners[2]);
}

Signs FilteredFace::sides_of(const FilteredFace& other) const {
  Signs sides;
  for (std::size_t i = 0; i < 3; ++i) sides[i] = static_cast<Sign>(plane.side(other.corners[i]));
  return sides;
}

bool FilteredFace::is_beside(const FilteredFace& other, const Signs& sides) const {
  int above = 0, below = 0, common = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (has(other.vertices[i])) {
      ++common;
    } else {
      above += sides[i] == Sign::positive;
      below += sides[i] == Sign::negative;
    }
  }
  return common < 3 && (above + common == 3 || below + common == 3);
}

bool FilteredFace::is_off(const FilteredFace& other) const {
  if (!is_exact) return false;
  const std::size_t axis = plane.widest_axis(), u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto seen = [&](const Carriers::Coordinates& p) { return PlanePoint{p[u], p[v]}; };
  for (std::size_t e = 0; e < 3; ++e) {
    const std::size_t from = e, to = (e + 1) % 3;
    const PlanePoint a = seen(corners[from]), b = seen(corners[to]);
    const int own = filtered_turn(a, b, seen(corners[(e + 2) % 3]));
    bool off = own != 0;
    for (std::size_t i = 0; i < 3 && off; ++i) {
      const std::uint32_t w = other.vertices[i];
      off = w == vertices[from] || w == vertices[to] || filtered_turn(a, b, seen(other.corners[i])) == -own;
    }
    if (off) return true;
  }
  return false;
}

Sign orient_edges(const Carriers& carriers, const FilteredFace& f, int i, const FilteredFace& g, int k) {
  const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(next(i)), c = static_cast<std::size_t>(k),
             d = static_cast<std::size_t>(next(k));
  if (f.is_exact)
    if (const int side = FilteredPlane(f.corners[a], f.corners[b], g.corners[c]).side(g.corners[d]); side != 0)
      return static_cast<Sign>(side);
  return orient3d(carriers, f.vertices[a], f.vertices[b], g.vertices[c], g.vertices[d]);
}

}  // namespace strata
