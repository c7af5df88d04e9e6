#include "core/select/validate.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/exact/invariants.h"
#include "core/kernel/predicates.h"
#include "core/overlap/validate.h"

namespace strata {
namespace {

constexpr std::size_t piece_sample = 64, triangle_sample = 64;

bool are_three(const std::array<std::uint32_t, 3>& v) { return v[0] != v[1] && v[1] != v[2] && v[2] != v[0]; }

bool exist(const std::array<std::uint32_t, 3>& v, std::size_t count) {
  return std::all_of(v.begin(), v.end(), [&](std::uint32_t i) { return i < count; });
}

class PieceCheck {
 public:
  PieceCheck(const InputComplex& input, const PointTable& points) : input_(input), points_(points) {}

  /// False when the lists cannot be used.
  [[nodiscard]] bool check_numbers(const SubdividedFace& face) {
    if (face.face >= input_.face_count()) {
      violations_.add("face ", face.face, " does not exist");
      return false;
    }
    for (const PointId id : face.points)
      if (id >= points_.end() || points_.representative(id) != id) {
        violations_.add("face ", face.face, ": point ", id, " does not represent itself");
        return false;
      }
    for (const PieceTriangle& t : face.triangles)
      if (!exist(t.v, face.points.size()) || !are_three(t.v)) {
        violations_.add("face ", face.face, " has a piece without three corners");
        return false;
      }
    return true;
  }

  void check_boundary(const SubdividedFace& face) {
    using Side = std::pair<std::pair<std::uint32_t, std::uint32_t>, bool>;
    std::vector<Side> sides;
    for (const PieceTriangle& t : face.triangles)
      for (std::size_t i = 0; i < 3; ++i) sides.push_back({{t.v[i], t.v[(i + 1) % 3]}, t.reversed});
    std::sort(sides.begin(), sides.end());
    for (const PieceTriangle& t : face.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Side across{{t.v[(i + 1) % 3], t.v[i]}, t.reversed};
        const bool is_boundary = (t.boundary >> i & 1) != 0;
        if (std::binary_search(sides.begin(), sides.end(), across) == is_boundary)
          violations_.add("face ", face.face, ": the side from point ", face.points[t.v[i]], " is ",
                          is_boundary ? "marked as boundary and lies between pieces" : "boundary and not marked");
      }
  }

  void check_turn(const SubdividedFace& face) {
    const Projection projection = projection_of(input_, face.face);
    for_sample(face.triangles.size(), 4, [&](std::size_t n) {
      const PieceTriangle& t = face.triangles[n];
      const auto corner = [&](std::size_t i) { return points_.point(face.points[t.v[i]]); };
      const Sign turn = orient2d(input_, projection, corner(0), corner(1), corner(2));
      if (turn != (t.reversed ? Sign::negative : Sign::positive))
        violations_.add("face ", face.face, ": piece ", n,
                        turn == Sign::zero ? " has no area" : " turns the wrong way");
      for (std::size_t i = 0; i < 3; ++i)
        if (side_of_face(input_, face.face, corner(i)) != Sign::zero)
          violations_.add("face ", face.face, ": piece ", n, " leaves the plane in point ", face.points[t.v[i]]);
    });
  }

  Violations& violations() { return violations_; }

 private:
  const InputComplex& input_;
  const PointTable& points_;
  Violations violations_;
};

class BoundaryCheck {
 public:
  BoundaryCheck(const InputComplex& input, const Boundary& boundary)
      : input_(input), points_(boundary.points), boundary_(boundary) {}

  [[nodiscard]] std::vector<std::string> list() && {
    check_vertices();
    check_triangles();
    if (!violations_.empty()) return std::move(violations_).list();
    for_sample(boundary_.triangles.size(), triangle_sample, [&](std::size_t t) { check_triangle(t); });
    std::vector<PointId> ids = boundary_.constructed;
    for_sample(boundary_.inputs.size(), triangle_sample, [&](std::size_t i) { ids.push_back(boundary_.inputs[i]); });
    for (const std::string& v : validate_distinct(input_, points_, std::move(ids))) violations_.add(v);
    return std::move(violations_).list();
  }

 private:
  [[nodiscard]] PointId id(std::uint32_t vertex) const {
    const std::size_t inputs = boundary_.inputs.size();
    return vertex < inputs ? boundary_.inputs[vertex] : boundary_.constructed[vertex - inputs];
  }

  void check_vertices() {
    const auto ordered = [](const std::vector<PointId>& ids, PointId begin, PointId end) {
      if (std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) != ids.end()) return false;
      return ids.empty() || (ids.front() >= begin && ids.back() < end);
    };
    if (!ordered(boundary_.inputs, 0, points_.first()) ||
        !ordered(boundary_.constructed, points_.first(), points_.end())) {
      violations_.add("vertices are not listed by increasing number");
      return;
    }
    for (const auto* list : {&boundary_.inputs, &boundary_.constructed})
      for (const PointId p : *list)
        if (points_.representative(p) != p) violations_.add("vertex ", p, " does not represent itself");
  }

  void check_triangles() {
    const std::size_t vertices = boundary_.inputs.size() + boundary_.constructed.size();
    if (boundary_.sources.size() != boundary_.triangles.size()) {
      violations_.add(boundary_.triangles.size(), " triangles have ", boundary_.sources.size(), " sources");
      return;
    }
    for (std::size_t t = 0; t < boundary_.triangles.size(); ++t) {
      const Source& source = boundary_.sources[t];
      if (!exist(boundary_.triangles[t], vertices) || !are_three(boundary_.triangles[t]))
        violations_.add("triangle ", t, " has not three corners");
      if (source.operand >= input_.operand_count() || source.face >= input_.face_count(source.operand))
        violations_.add("triangle ", t, " comes from face ", source.face, " of operand ", source.operand,
                        ", which does not exist");
    }
  }

  void check_triangle(std::size_t t) {
    const std::uint32_t face = input_.first_face(boundary_.sources[t].operand) + boundary_.sources[t].face;
    const auto corner = [&](std::size_t i) { return points_.point(id(boundary_.triangles[t][i])); };
    if (orient2d(input_, projection_of(input_, face), corner(0), corner(1), corner(2)) == Sign::zero)
      violations_.add("triangle ", t, " has no area");
    for (std::size_t i = 0; i < 3; ++i)
      if (side_of_face(input_, face, corner(i)) != Sign::zero)
        violations_.add("triangle ", t, " leaves the plane of its source");
  }

  const InputComplex& input_;
  const PointTable& points_;
  const Boundary& boundary_;
  Violations violations_;
};

}  // namespace

std::vector<std::string> validate(const InputComplex& input, const Subdivision& subdivision) {
  const std::vector<SubdividedFace>& faces = subdivision.faces;
  PieceCheck check(input, subdivision.points);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i > 0 && faces[i - 1].face >= faces[i].face)
      check.violations().add("face ", faces[i].face, " is listed after face ", faces[i - 1].face);
    if (check.check_numbers(faces[i])) check.check_boundary(faces[i]);
  }
  if (check.violations().empty())
    for_sample(faces.size(), piece_sample, [&](std::size_t i) { check.check_turn(faces[i]); });
  return std::move(check.violations()).list();
}

std::vector<std::string> validate(const InputComplex& input, const std::vector<Verdict>& verdicts,
                                  const Subdivision& subdivision) {
  Violations violations;
  if (verdicts.size() != input.face_count()) {
    violations.add(input.face_count(), " faces have ", verdicts.size(), " verdicts");
    return std::move(violations).list();
  }
  for (const SubdividedFace& face : subdivision.faces)
    if (verdicts[face.face] != Verdict::drop) violations.add("face ", face.face, " stays whole and is subdivided");
  return std::move(violations).list();
}

std::vector<std::string> validate(const InputComplex& input, const Boundary& boundary) {
  return BoundaryCheck(input, boundary).list();
}

}  // namespace strata
