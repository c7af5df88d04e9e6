#include "core/overlap/validate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/exact/invariants.h"
#include "core/kernel/predicates.h"

namespace strata {
namespace {

constexpr std::size_t constraint_sample = 32, point_sample = 32, distinct_sample = 512;

/// In the plane of a face and on no outer side of its edges.
bool is_on_triangle(const InputComplex& input, std::uint32_t face, const Point& p) {
  if (side_of_face(input, face, p) != Sign::zero) return false;
  const Projection projection = projection_of(input, face);
  const auto v = input.face(face);
  const auto corner = [&](std::size_t i) { return make_point(input, SymbolicPoint::input(v[i % 3])); };
  for (std::size_t i = 0; i < 3; ++i)
    if (orient2d(input, projection, corner(i), corner(i + 1), p) == Sign::negative) return false;
  return true;
}

bool has_edge(const InputComplex::Indices& v, std::uint32_t a, std::uint32_t b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t p = v[i], q = v[(i + 1) % 3];
    if ((p == a && q == b) || (p == b && q == a)) return true;
  }
  return false;
}

class ConstraintCheck {
 public:
  ConstraintCheck(const InputComplex& input, const Intersections& all)
      : input_(input), all_(all), points_(all.points) {}

  [[nodiscard]] std::vector<std::string> list() && {
    const auto& constraints = all_.constraints;
    for (std::size_t i = 0; i < constraints.size(); ++i) {
      check_numbers(i);
      if (i > 0 && constraints[i - 1].face > constraints[i].face)
        violations_.add("constraint ", i, ": face ", constraints[i].face, " stands after face ",
                        constraints[i - 1].face);
    }
    if (!violations_.empty()) return std::move(violations_).list();
    check_counterparts();
    for_sample(constraints.size(), constraint_sample, [&](std::size_t i) { check_places(i); });
    for_sample(all_.equal.size(), constraint_sample, [&](std::size_t i) {
      const auto& [a, b] = all_.equal[i];
      if (!equal(input_, vertex(a), vertex(b))) violations_.add("vertices ", a, " and ", b, " are listed as equal");
    });
    return std::move(violations_).list();
  }

 private:
  [[nodiscard]] Point vertex(std::uint32_t v) const { return make_point(input_, SymbolicPoint::input(v)); }

  void check_numbers(std::size_t i) {
    const Constraint& c = all_.constraints[i];
    if (std::max(c.face, c.other) >= input_.face_count() || c.face == c.other) {
      violations_.add("constraint ", i, " is of face ", c.face, " and face ", c.other);
      return;
    }
    if (std::max(c.tail, c.head) >= points_.end())
      violations_.add("constraint ", i, " ends in a point without a number");
    const bool is_segment = c.kind != ConstraintKind::point && c.kind != ConstraintKind::coplanar;
    if ((c.tail != c.head) != is_segment)
      violations_.add("constraint ", i, is_segment ? " is a segment of no length" : " is no segment and has two ends");
    if (!is_segment) return;
    const bool is_own = c.line.edge ? has_edge(input_.face(c.face), c.line.a, c.line.b) ||
                                          has_edge(input_.face(c.other), c.line.a, c.line.b)
                                    : c.line.a == c.other && c.line.b == c.other;
    if (!is_own) violations_.add("constraint ", i, " is carried by a line of neither face");
  }

  void check_counterparts() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const Constraint& c : all_.constraints) pairs.emplace_back(c.face, c.other);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (const auto& [f, g] : pairs)
      if (!std::binary_search(pairs.begin(), pairs.end(), std::pair(g, f)))
        violations_.add("face ", f, " has a constraint by face ", g, ", which has none by it");
  }

  void check_places(std::size_t i) {
    const Constraint& c = all_.constraints[i];
    if (c.kind == ConstraintKind::coplanar) return;
    for (const PointId id : {c.tail, c.head})
      for (const std::uint32_t face : {c.face, c.other})
        if (!is_on_triangle(input_, face, points_.point(id)))
          violations_.add("constraint ", i, " ends in point ", id, ", which is not on face ", face);
  }

  const InputComplex& input_;
  const Intersections& all_;
  const PointTable& points_;
  Violations violations_;
};

void check_names(std::span<const Point> points, PointId first, Violations& violations) {
  std::vector<std::pair<SymbolicPoint, PointId>> names;
  for (std::size_t i = 0; i < points.size(); ++i) names.emplace_back(points[i].name, first + static_cast<PointId>(i));
  std::sort(names.begin(), names.end());
  for (std::size_t i = 1; i < names.size(); ++i)
    if (names[i].first == names[i - 1].first)
      violations.add("points ", names[i - 1].second, " and ", names[i].second, " have one name");
}

void check_bounds(const InputComplex& input, const Point& p, PointId id, Violations& violations) {
  const RationalPoint exact = exact_position(input, p);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double lower = p.at[axis].lower(), upper = p.at[axis].upper();
    const bool below = std::isfinite(lower) && exact[axis] < to_rational(lower);
    const bool above = std::isfinite(upper) && exact[axis] > to_rational(upper);
    if (below || above) violations.add("coordinate ", axis, " of point ", id, " is not within its bound");
  }
}

/// An operand may list a vertex twice, as where sheets touch: both stay.
bool are_listed_twice(const InputComplex& input, const PointTable& points, PointId a, PointId b) {
  return points.is_input(a) && points.is_input(b) && input.operand_of_vertex(a) == input.operand_of_vertex(b);
}

}  // namespace

std::vector<std::string> validate(const InputComplex& input, const Intersections& intersections) {
  return ConstraintCheck(input, intersections).list();
}

std::vector<std::string> validate(const InputComplex& input, std::span<const Point> constructed, PointId first) {
  Violations violations;
  check_names(constructed, first, violations);
  for_sample(constructed.size(), point_sample,
             [&](std::size_t i) { check_bounds(input, constructed[i], first + static_cast<PointId>(i), violations); });
  return std::move(violations).list();
}

std::vector<std::string> validate(const InputComplex& input, const PointTable& points) {
  Violations violations;
  for (const std::string& v : validate(input, points.constructed(), points.first())) violations.add(v);
  std::vector<PointId> others;
  for (PointId id = 0; points.has_identified() && id < points.end(); ++id)
    if (points.representative(id) != id) others.push_back(id);
  for_sample(others.size(), point_sample, [&](std::size_t i) {
    const PointId low = points.representative(others[i]);
    if (!equal(input, points.point(low), points.point(others[i])))
      violations.add("points ", low, " and ", others[i], " are identified and have different positions");
  });
  return std::move(violations).list();
}

std::vector<std::string> validate_distinct(const InputComplex& input, const PointTable& points,
                                           std::vector<PointId> ids) {
  Violations violations;
  std::erase_if(ids, [&](PointId id) { return points.representative(id) != id; });
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<PointId> some;
  for_sample(ids.size(), distinct_sample, [&](std::size_t i) { some.push_back(ids[i]); });
  for (const auto& [a, b] : points.equal_positions(std::move(some), {}))
    if (!are_listed_twice(input, points, a, b))
      violations.add("points ", a, " and ", b, " have one position and are not identified");
  return std::move(violations).list();
}

}  // namespace strata
