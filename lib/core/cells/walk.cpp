#include "core/cells/walk.h"

#include <algorithm>
#include <array>

#include "core/kernel/approximation.h"
#include "core/kernel/filtered_orientation.h"
#include "core/kernel/filtered_plane.h"

namespace strata {
namespace {

Point vertex(const InputComplex& input, std::uint32_t v) { return make_point(input, SymbolicPoint::input(v)); }

/// Sign of orient3d(O', q, a, b), q last in an even permutation; its gradient in O is minus the normal of (q, a, b).
Sign side_of_line(const InputComplex& input, const Point& origin, const Point& q, const Point& a, const Point& b) {
  const Sign s = orient3d(input, origin, a, b, q);
  if (s != Sign::zero) return s;
  for (int axis = 0; axis < 3; ++axis) {
    const Sign n = orient2d(input, {(axis + 1) % 3, (axis + 2) % 3}, q, a, b);
    if (n != Sign::zero) return -n;
  }
  return Sign::zero;
}

/// The sign of d' in a form that is linear in d; `gradient(axis)` is the sign of its derivative.
template <class Gradient>
Sign perturbed(Sign value, const Gradient& gradient) {
  for (int axis = 0; value == Sign::zero && axis < 3; ++axis) value = gradient(axis);
  return value;
}

/// Sign of ((a - q) x (b - q)) . d'.
Sign side_of_line_along(const InputComplex& input, const InputComplex::Coordinates& d, const Point& q, const Point& a,
                        const Point& b) {
  return perturbed(normal_along(input, q, a, b, d), [&](int axis) {
    return orient2d(input, {(axis + 1) % 3, (axis + 2) % 3}, q, a, b);
  });
}

/// Orientation of O', a, b seen along `axis`; a line parallel to the axis through O' never meets the line ab.
Sign turn_about_axis(const InputComplex& input, int axis, const Point& origin, const Point& a, const Point& b) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Sign s = orient2d(input, {i, j}, origin, a, b);
  if (s != Sign::zero) return s;
  const Sign along_i = -compare(input, j, b, a), along_j = compare(input, i, b, a);
  const Sign first = i < j ? along_i : along_j, second = i < j ? along_j : along_i;
  return first != Sign::zero ? first : second;
}

/// turn_about_axis for the edges of a face, where doubles with bounds tell it; else zero.
std::array<Sign, 3> filtered_turns(const InputComplex& input, int axis, const InputComplex::Coordinates& origin,
                                   const InputComplex::Indices& f) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  std::array<Sign, 3> turns;
  if (input.has_doubles(f)) {
    std::array<PlanePoint, 3> p;
    const auto seen = [&](const InputComplex::Coordinates& x) {
      return PlanePoint{x[static_cast<std::size_t>(i)], x[static_cast<std::size_t>(j)]};
    };
    for (std::size_t k = 0; k < 3; ++k) p[k] = seen(input.vertex(f[k]));
    for (std::size_t k = 0; k < 3; ++k)
      turns[k] = static_cast<Sign>(filtered_orientation(seen(origin), p[k], p[(k + 1) % 3]));
  } else {
    const BoundedPoint o{origin[0], origin[1], origin[2]};
    std::array<BoundedPoint, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = approximate_vertex<Bounded>(input, f[k]);
    for (std::size_t k = 0; k < 3; ++k)
      turns[k] = orientation_of(o, p[k], p[(k + 1) % 3], i, j).sign().value_or(Sign::zero);
  }
  return turns;
}

/// Does the line from O' to q cross the interior of a triangle? Requires that q is not in its plane; if it is, the
/// result may be false.
bool passes(const InputComplex& input, const InputComplex::Indices& f, const InputComplex::Coordinates& origin,
            const Point& q) {
  if (input.has_doubles(f)) {  // a first test in doubles
    const auto &a = input.vertex(f[0]), &b = input.vertex(f[1]), &c = input.vertex(f[2]);
    const int ab = FilteredPlane(origin, a, b).side_within(q.at), bc = FilteredPlane(origin, b, c).side_within(q.at);
    if (ab * bc < 0) return false;
    const int ca = FilteredPlane(origin, c, a).side_within(q.at);
    if (ab * ca < 0 || bc * ca < 0) return false;
    if (ab * bc * ca != 0) return true;
  }
  const Point o = Point::free(origin), a = vertex(input, f[0]), b = vertex(input, f[1]), c = vertex(input, f[2]);
  const Sign ab = side_of_line(input, o, q, a, b);
  return ab == side_of_line(input, o, q, b, c) && ab == side_of_line(input, o, q, c, a);
}

}  // namespace

Sign side_of_origin(const InputComplex& input, std::uint32_t face, const InputComplex::Coordinates& origin) {
  const Sign s = side_of_face(input, face, Point::free(origin));
  if (s != Sign::zero) return s;
  for (int axis = 0; axis < 3; ++axis) {
    const Sign n = normal_component(input, face, axis);
    if (n != Sign::zero) return n;
  }
  return Sign::zero;
}

int crossing(const InputComplex& input, std::uint32_t face, const InputComplex::Coordinates& origin, const Point& q) {
  const auto quick = filtered_side_of_face(input, face, q);
  if (quick == Sign::zero || (quick && *quick == side_of_origin(input, face, origin))) return 0;
  // This is reached for faces in q's own plane. The walk's line does not meet most of them.
  if (!passes(input, input.face(face), origin, q)) return 0;
  const Sign target = quick ? *quick : side_of_face(input, face, q), start = side_of_origin(input, face, origin);
  return target == Sign::zero || start == target ? 0 : to_int(start);
}

bool is_crossed_along_axis(const InputComplex& input, std::uint32_t face, const InputComplex::Coordinates& origin,
                           int axis) {
  const auto f = input.face(face);
  const std::array<Sign, 3> turns = filtered_turns(input, axis, origin, f);
  const auto has = [&](Sign s) { return std::find(turns.begin(), turns.end(), s) != turns.end(); };
  if (has(Sign::positive) && has(Sign::negative)) return false;
  if (!has(Sign::zero)) return true;
  const Point o = Point::free(origin), a = vertex(input, f[0]), b = vertex(input, f[1]), c = vertex(input, f[2]);
  const Sign ab = turn_about_axis(input, axis, o, a, b);
  return ab == turn_about_axis(input, axis, o, b, c) && ab == turn_about_axis(input, axis, o, c, a);
}

int crossing_along_axis(const InputComplex& input, std::uint32_t face, const InputComplex::Coordinates& from,
                        const InputComplex::Coordinates& to, int axis) {
  if (!is_crossed_along_axis(input, face, from, axis)) return 0;
  const Sign start = side_of_origin(input, face, from);
  return start == side_of_origin(input, face, to) ? 0 : to_int(start);
}

Sign side_of_infinity(const InputComplex& input, std::uint32_t face, const InputComplex::Coordinates& direction) {
  const auto f = input.face(face);
  const Sign along = normal_along(input, vertex(input, f[0]), vertex(input, f[1]), vertex(input, f[2]), direction);
  return -perturbed(along, [&](int axis) { return normal_component(input, face, axis); });
}

int crossing_from_infinity(const InputComplex& input, std::uint32_t face, const InputComplex::Coordinates& direction,
                           const Point& q) {
  const Sign start = side_of_infinity(input, face, direction);
  const auto quick = filtered_side_of_face(input, face, q);
  if (quick == Sign::zero || quick == start) return 0;
  const auto f = input.face(face);
  const Point a = vertex(input, f[0]), b = vertex(input, f[1]), c = vertex(input, f[2]);
  const Sign ab = side_of_line_along(input, direction, q, a, b);
  if (ab != side_of_line_along(input, direction, q, b, c) || ab != side_of_line_along(input, direction, q, c, a))
    return 0;
  const Sign target = quick ? *quick : side_of_face(input, face, q);
  return target == Sign::zero || start == target ? 0 : to_int(start);
}

}  // namespace strata
