#include "core/overlap/filtered_face.h"

#include "core/kernel/filtered_orientation.h"
#include "core/kernel/predicates.h"

namespace strata {

FilteredFace::FilteredFace(const InputComplex& input, std::uint32_t f)
    : FilteredFace(input, input.operand_of_face(f), f) {}

FilteredFace::FilteredFace(const InputComplex& input, std::uint32_t operand, std::uint32_t f) {
  set_corners(input, operand, f);
  find_plane(input);
}

void FilteredFace::set_corners(const InputComplex& input, std::uint32_t operand, std::uint32_t f) {
  face = f;
  vertices = input.face(f);
  is_exact = input.has_doubles(vertices);
  const auto points = input.points(operand);
  const auto& t = input.faces(operand)[f - input.first_face(operand)];
  for (std::size_t i = 0; i < 3; ++i) corners[i] = points[t[i]];
}

void FilteredFace::find_plane(const InputComplex& input) {
  if (is_exact) {
    plane = FilteredPlane(corners[0], corners[1], corners[2]);
  } else {
    rational_plane = approximate_plane<Bounded>(input, face);
  }
}

Signs FilteredFace::sides_of(const FilteredFace& other) const {
  Signs sides;
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_exact) {
      sides[i] = static_cast<Sign>(other.is_exact ? plane.side(other.corners[i]) : plane.side_within(other.corner(i)));
    } else {
      const auto sign = dot<Bounded>(rational_plane.normal, other.corner(i) - rational_plane.at).sign();
      sides[i] = sign.value_or(Sign::zero);
    }
  }
  return sides;
}

BoundedPoint FilteredFace::corner(std::size_t i) const {
  BoundedPoint p;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = corners[i][k];
    p[k] = is_exact ? Bounded(x) : Bounded(x, std::abs(x) * Bounded::rounding + Bounded::underflow);
  }
  return p;
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

namespace {

/// Seen along an axis, is all of g strictly on the other side of the line of an edge of f than f? Ends that both have
/// count as beyond. `turn(a, b, c)` is the orientation, or 0 when it is not known. `is_in_line(w, end, other)`: is w
/// known to be on the edge's line beyond an end? If g has this end and not the other one, w counts as beyond, too.
template <class Turn, class IsInLine>
bool is_beyond_edge(const FilteredFace& f, const FilteredFace& g, std::size_t edge, const Turn& orientation,
                    const IsInLine& is_in_line) {
  const std::size_t from = edge, to = (edge + 1) % 3;
  const int own = orientation(f, from, to, f, (edge + 2) % 3);
  if (own == 0) return false;
  const bool has_from = g.has(f.vertices[from]), has_to = g.has(f.vertices[to]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t w = g.vertices[i];
    if (w == f.vertices[from] || w == f.vertices[to]) continue;
    const int side = orientation(f, from, to, g, i);
    if (side == -own) continue;
    if (side == own || has_from == has_to || !is_in_line(i, has_from ? from : to, has_from ? to : from)) return false;
  }
  return true;
}

/// The longest component of a normal.
std::size_t widest_axis(const BoundedPoint& normal) {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(normal[i].value) > std::abs(normal[axis].value)) axis = i;
  return axis;
}

}  // namespace

bool FilteredFace::is_off(const FilteredFace& other) const {
  const std::size_t axis = is_exact ? plane.widest_axis() : widest_axis(rational_plane.normal);
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto in_doubles = [&](const FilteredFace& f, std::size_t a, std::size_t b, const FilteredFace& g,
                              std::size_t c) {
    const auto seen = [&](const InputComplex::Coordinates& p) { return PlanePoint{p[u], p[v]}; };
    return filtered_orientation(seen(f.corners[a]), seen(f.corners[b]), seen(g.corners[c]));
  };
  const auto within_bounds = [&](const FilteredFace& f, std::size_t a, std::size_t b, const FilteredFace& g,
                                 std::size_t c) {
    const auto orientation =
        orientation_of(f.corner(a), f.corner(b), g.corner(c), static_cast<int>(u), static_cast<int>(v)).sign();
    return to_int(orientation.value_or(Sign::zero));
  };
  const auto is_in_line = [&](std::size_t i, std::size_t end, std::size_t far) {
    const auto &w = other.corners[i], &c = corners[end], &d = corners[far];
    if (orientation_by_differences({d[u], d[v]}, {c[u], c[v]}, {w[u], w[v]}) != Sign::zero) return false;
    const std::size_t k = c[u] != d[u] ? u : v;
    return c[k] > d[k] ? w[k] > c[k] : w[k] < c[k];
  };
  const auto is_unknown = [](std::size_t, std::size_t, std::size_t) { return false; };
  for (std::size_t e = 0; e < 3; ++e)
    if (is_exact && other.is_exact ? is_beyond_edge(*this, other, e, in_doubles, is_in_line)
                                   : is_beyond_edge(*this, other, e, within_bounds, is_unknown))
      return true;
  return false;
}

Sign orient_edges(const InputComplex& input, const FilteredFace& f, int i, const FilteredFace& g, int k) {
  const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(next(i)), c = static_cast<std::size_t>(k),
             d = static_cast<std::size_t>(next(k));
  if (f.is_exact && g.is_exact)
    if (const int side = FilteredPlane(f.corners[a], f.corners[b], g.corners[c]).side(g.corners[d]); side != 0)
      return static_cast<Sign>(side);
  return orient3d(input, f.vertices[a], f.vertices[b], g.vertices[c], g.vertices[d]);
}

}  // namespace strata
