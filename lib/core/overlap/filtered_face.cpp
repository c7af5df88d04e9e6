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
  level_axis = -1;
  if (is_exact) {
    plane = FilteredPlane(corners[0], corners[1], corners[2]);
    for (std::size_t k = 0; k < 3; ++k)
      if (corners[0][k] == corners[1][k] && corners[0][k] == corners[2][k]) level_axis = static_cast<int>(k);
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

/// Is all of a face on the other side of the line of an edge of another face, seen along an axis? `own`: the side on
/// which the edge's own face is. `side(e, i)`: the side of edge e on which vertex i of the other one is, or 0 where it
/// is not known. Ends that both have count as beyond. `is_in_line(i, end, far)`: is vertex i known to be on the edge's
/// line beyond an end? If the other face has this end and not the far one, vertex i counts as beyond, too.
template <class Side, class IsInLine>
bool is_beyond_an_edge(const FilteredFace& f, const FilteredFace& g, int own, const Side& side,
                       const IsInLine& is_in_line) {
  for (std::size_t from = 0; from < 3; ++from) {
    const std::size_t to = (from + 1) % 3;
    bool is_beyond = true;
    for (std::size_t i = 0; i < 3 && is_beyond; ++i) {
      const int on = side(from, i);
      if (on == -own) continue;
      const std::uint32_t w = g.vertices[i];
      if (w == f.vertices[from] || w == f.vertices[to]) continue;
      if (on == own) {
        is_beyond = false;
      } else {
        const bool has_from = g.has(f.vertices[from]), has_to = g.has(f.vertices[to]);
        is_beyond = has_from != has_to && is_in_line(i, has_from ? from : to, has_from ? to : from);
      }
    }
    if (is_beyond) return true;
  }
  return false;
}

/// The longest component of a normal.
std::size_t widest_axis(const BoundedPoint& normal) {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(normal[i].value) > std::abs(normal[axis].value)) axis = i;
  return axis;
}

/// Coordinates across an axis.
struct View {
  std::size_t u, v;

  explicit View(std::size_t axis) : u((axis + 1) % 3), v((axis + 2) % 3) {}
  [[nodiscard]] PlanePoint operator()(const InputComplex::Coordinates& p) const { return {p[u], p[v]}; }
};

bool is_off_in_doubles(const FilteredFace& f, const FilteredFace& g, const View& seen) {
  std::array<PlanePoint, 3> p, q;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = seen(f.corners[i]);
    q[i] = seen(g.corners[i]);
  }
  const int own = filtered_orientation(p[0], p[1], p[2]);
  if (own == 0) return false;
  const auto side = [&](std::size_t e, std::size_t i) { return filtered_orientation(p[e], p[(e + 1) % 3], q[i]); };
  const auto is_in_line = [&](std::size_t i, std::size_t end, std::size_t far) {
    const PlanePoint &w = q[i], &c = p[end], &d = p[far];
    if (orientation_by_differences(d, c, w) != Sign::zero) return false;
    const std::size_t k = c[0] != d[0] ? 0 : 1;
    return c[k] > d[k] ? w[k] > c[k] : w[k] < c[k];
  };
  return is_beyond_an_edge(f, g, own, side, is_in_line);
}

bool is_off_within_bounds(const FilteredFace& f, const FilteredFace& g, const View& seen) {
  const auto orientation = [&](std::size_t a, const BoundedPoint& p) {
    const auto sign =
        orientation_of(f.corner(a), f.corner((a + 1) % 3), p, static_cast<int>(seen.u), static_cast<int>(seen.v))
            .sign();
    return to_int(sign.value_or(Sign::zero));
  };
  const int own = orientation(0, f.corner(2));
  if (own == 0) return false;
  const auto side = [&](std::size_t e, std::size_t i) { return orientation(e, g.corner(i)); };
  return is_beyond_an_edge(f, g, own, side, [](std::size_t, std::size_t, std::size_t) { return false; });
}

}  // namespace

bool FilteredFace::is_off(const FilteredFace& other) const {
  const View seen(is_exact ? plane.widest_axis() : widest_axis(rational_plane.normal));
  return is_exact && other.is_exact ? is_off_in_doubles(*this, other, seen) : is_off_within_bounds(*this, other, seen);
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
