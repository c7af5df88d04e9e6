#include "core/arrange/validate.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/arrange/triangle_index.h"
#include "core/exact/invariants.h"

namespace strata {
namespace {

using triangle_index::at;

class TriangulationCheck {
 public:
  TriangulationCheck(const TriangulationParts& t, std::span<const Constraint> constraints)
      : points_(t.points), triangles_(t.triangles), notes_(t.notes), constraints_(constraints) {}

  [[nodiscard]] std::vector<std::string> list() && {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto& v = triangles_[t].v;
      if (points_.orientation(v[0], v[1], v[2]) != Sign::positive) add("triangle ", t, " does not turn left");
      for (std::size_t i = 0; i < 3; ++i) check_neighbour(t, i);
    }
    check_border();
    check_constraints();
    return std::move(violations_).list();
  }

 private:
  template <class... Parts>
  void add(const Parts&... parts) {
    violations_.add("face ", points_.face(), ": ", parts...);
  }
  [[nodiscard]] std::pair<std::int32_t, std::int32_t> side(std::size_t t, std::size_t i) const {
    return {triangles_[t].v[i], triangles_[t].v[(i + 1) % 3]};
  }

  void check_neighbour(std::size_t t, std::size_t i) {
    const std::int32_t n = triangles_[t].n[i];
    const auto [a, b] = side(t, i);
    if (n < 0) {
      border_.emplace_back(a, b);
      return;
    }
    int shared = 0;
    for (std::size_t k = 0; at(n) < triangles_.size() && k < 3; ++k)
      shared +=
          static_cast<int>(triangles_[at(n)].n[k] == static_cast<std::int32_t>(t) && side(at(n), k) == std::pair(b, a));
    if (shared != 1) add("triangles ", t, " and ", n, " are neighbours and share no side");
  }

  /// Sides on the border lie on edges of the face, one way, and lead from corner to corner.
  void check_border() {
    std::map<std::int32_t, int> balance;
    for (const auto& [a, b] : border_) {
      ++balance[a];
      --balance[b];
      if (!is_on_some_edge(a, b)) add("the side from ", a, " to ", b, " has one triangle and is not on the border");
    }
    for (const auto& [v, count] : balance)
      if (count != 0) add("the border is open in vertex ", v);
    std::sort(border_.begin(), border_.end());
    for (std::size_t i = 1; i < border_.size(); ++i)
      if (border_[i].first == border_[i - 1].first) add("the border leaves vertex ", border_[i].first, " twice");
    for (std::int32_t corner = 0; corner < 3; ++corner)
      if (!balance.contains(corner)) add("corner ", corner, " is not covered");
  }

  [[nodiscard]] bool is_on_some_edge(std::int32_t a, std::int32_t b) const {
    for (std::int32_t k = 0; k < 3; ++k) {
      const std::int32_t next = triangle_index::next(k);
      if (points_.orientation(k, next, a) == Sign::zero && points_.orientation(k, next, b) == Sign::zero) return true;
    }
    return false;
  }

  void check_constraints() {
    std::vector<std::map<std::int32_t, int>> balance(constraints_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::int32_t n = triangles_[t].n[i];
        if (n >= 0 && at(n) < t) continue;
        for (std::int32_t k = triangles_[t].c[i]; k >= 0; k = notes_[at(k)].next)
          follow(notes_[at(k)], side(t, i), balance);
      }
    for (std::size_t c = 0; c < constraints_.size(); ++c) check_ends(c, balance[c]);
  }

  void follow(const Triangulation::Note& note, std::pair<std::int32_t, std::int32_t> side,
              std::vector<std::map<std::int32_t, int>>& balance) {
    if (note.constraint < 0 || at(note.constraint) >= constraints_.size()) {
      add("a side carries constraint ", note.constraint, ", which does not exist");
      return;
    }
    if (!note.forward) std::swap(side.first, side.second);
    ++balance[at(note.constraint)][side.first];
    --balance[at(note.constraint)][side.second];
  }

  void check_ends(std::size_t c, const std::map<std::int32_t, int>& balance) {
    const Constraint& constraint = constraints_[c];
    if (constraint.kind == ConstraintKind::coplanar) return;
    const std::int32_t tail = points_.find(constraint.tail), head = points_.find(constraint.head);
    if (tail < 0 || head < 0) {
      add("constraint ", c, " ends in no vertex");
      return;
    }
    const auto expected = [&](std::int32_t v) { return static_cast<int>(v == tail) - static_cast<int>(v == head); };
    for (const auto& [v, count] : balance) {
      if (count != expected(v)) add("the sides of constraint ", c, " end in vertex ", v);
      if (points_.orientation(tail, head, v) != Sign::zero) add("constraint ", c, " leads off its line to vertex ", v);
    }
    if (tail != head && !balance.contains(tail)) add("no sides carry constraint ", c);
  }

  const FacePoints& points_;
  std::span<const Triangulation::Triangle> triangles_;
  std::span<const Triangulation::Note> notes_;
  std::span<const Constraint> constraints_;
  std::vector<std::pair<std::int32_t, std::int32_t>> border_;
  Violations violations_;
};

}  // namespace

std::vector<std::string> validate(const TriangulationParts& triangulation, std::span<const Constraint> constraints) {
  return TriangulationCheck(triangulation, constraints).list();
}

}  // namespace strata
