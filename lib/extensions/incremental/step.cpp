#include "extensions/incremental/step.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "core/containers/for_each_index.h"
#include "core/exact/failure.h"
#include "core/kernel/nearest.h"
#include "core/mesh/equal_vertices.h"
#include "core/overlap/candidates.h"
#include "core/overlap/intersect.h"
#include "core/select/label.h"
#include "core/select/merge_pieces.h"
#include "core/select/subdivide.h"
#include "core/winding/local_windings.h"
#include "extensions/incremental/face_planes.h"
#include "extensions/incremental/patch.h"
#include "extensions/incremental/redundant_corners.h"

namespace strata {
namespace {

constexpr std::uint32_t incremental_operand = 0;

IncrementalVertexPointer given_corner(const Vertex& at, const RationalPoint* rational) {
  auto corner = std::make_shared<IncrementalVertex>();
  corner->at = at;
  if (rational != nullptr) corner->rational = *rational;
  return corner;
}

bool holds(const Box& box, const Vertex& p) {
  for (std::size_t i = 0; i < 3; ++i)
    if (p[i] < box.lower[i] || p[i] > box.upper[i]) return false;
  return true;
}

/// True if a surface is kept that has only the incremental solid on its inner side.
bool keeps_rest(const Rule& rule) {
  Windings in_incremental_solid;
  in_incremental_solid.add(incremental_operand, 1);
  return rule.inside(in_incremental_solid);
}

class Step {
 public:
  Step(const FaceTree& tree, Operation operation, const ToolGroup& group, const Monitor& monitor)
      : tree_(tree),
        region_(group.box),
        rule_(operation, static_cast<std::uint32_t>(group.tools.size() + 1)),
        patch_(tree, region_),
        candidates_(find_candidates(complex_of(patch_, group), monitor)),
        input_(candidates_.input()),
        windings_(input_, candidates_.cells()),
        subdivision_(subdivide(input_, intersect(candidates_, monitor), {rule_, windings_}, monitor)),
        verdicts_(label(input_, subdivision_, {rule_, windings_}, monitor)) {
    merge_pieces(input_, subdivision_, monitor);
    find_origins(group);
  }

  FaceChange change() {
    gather();
    FacePlanes planes(input_);
    for (std::uint32_t f = 0; f < patch_.face_count(); ++f)
      if (patch_.face(f).plane() != nullptr) planes.know(f, patch_.face(f).plane());
    const std::vector<PointId> candidates = find_changed_points();
    const std::vector<MeetingPlanes> intersections =
        remove_redundant_corners(input_, points(), planes, candidates, triangles_, origins_);
    corners_.resize(points().end());
    for_each_index(candidates.size(), 16, [&](std::size_t i) {
      if (intersections[i][0] != nullptr && !points().is_input(candidates[i]))
        corners_[candidates[i]] = constructed_corner(intersections[i]);
    });
    return assembled(planes);
  }

 private:
  [[nodiscard]] const PointTable& points() const { return subdivision_.points; }

  /// Equal vertices of a tool are one, also those away from the patch: a position has one corner.
  static InputComplex complex_of(const Patch& patch, const ToolGroup& group) {
    InputComplex complex;
    patch.add_to(complex);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> equal;
    for (const auto& [tool, painted] : group.tools) {
      const std::uint32_t first = complex.vertex_count();
      complex.add(tool.mesh().vertices, tool.mesh().triangles, tool.exact_mesh().exact);
      const std::vector<std::uint32_t> same = equal_vertices(tool.exact_mesh());
      for (std::uint32_t v = 0; v < same.size(); ++v)
        if (same[v] != v) equal.emplace_back(first + same[v], first + v);
    }
    complex.identify(equal);
    return complex;
  }

  /// Nothing if no solid has attributes.
  void find_origins(const ToolGroup& group) {
    std::vector<FaceOrigin> origins(input_.face_count());
    std::uint32_t f = 0;
    for (; f < patch_.face_count(); ++f) origins[f] = patch_.face(f).origin();
    for (const auto& [tool, painted] : group.tools)
      for (std::uint32_t i = 0; i < tool.mesh().triangles.size(); ++i, ++f)
        if (painted != nullptr) origins[f] = {painted, i, false};
    const auto is_known = [](const FaceOrigin& origin) { return origin.solid != nullptr; };
    if (std::any_of(origins.begin(), origins.end(), is_known)) origins_ = std::move(origins);
  }

  void gather() {
    for (std::uint32_t f = 0; f < input_.face_count(); ++f) {
      const Verdict verdict = verdicts_[f];
      if (verdict == Verdict::drop) continue;
      InputComplex::Indices v = input_.face(f);
      for (std::uint32_t& x : v) x = points().representative(x);
      const bool reversed = verdict == Verdict::keep_reversed;
      if (reversed) std::swap(v[0], v[2]);
      triangles_.push_back({v, f, reversed, f < patch_.face_count() && !reversed});
    }
    for (const SubdividedFace& face : subdivision_.faces)
      for (const PieceTriangle& t : face.triangles)
        triangles_.push_back(
            {{face.points[t.v[0]], face.points[t.v[1]], face.points[t.v[2]]}, face.face, t.reversed, false});
  }

  /// Corners that were constructed, now or before, where something has changed. Nothing changes outside the region.
  [[nodiscard]] std::vector<PointId> find_changed_points() const {
    std::vector<bool> is_touched(points().end());
    std::vector<bool> stays(patch_.face_count());
    for (const ResultTriangle& t : triangles_) {
      if (t.untouched) stays[t.face] = true;
      if (!t.untouched)
        for (const PointId v : t.v) is_touched[v] = true;
    }
    for (std::uint32_t f = 0; f < patch_.face_count(); ++f)
      if (!stays[f])
        for (const std::uint32_t v : input_.face(f)) is_touched[points().representative(v)] = true;
    std::vector<PointId> candidates;
    for (PointId v = 0; v < points().end(); ++v)
      if (is_touched[v] && is_candidate(v)) candidates.push_back(v);
    return candidates;
  }
  [[nodiscard]] bool is_candidate(PointId v) const {
    if (!points().is_input(v)) return true;
    if (v >= patch_.vertex_count()) return false;
    const IncrementalVertex& corner = *patch_.corner(v);
    return !corner.is_given && holds(region_, corner.at);
  }

  static IncrementalVertexPointer constructed_corner(const MeetingPlanes& planes) {
    auto corner = std::make_shared<IncrementalVertex>();
    corner->is_given = false;
    corner->meet = meet_of(*planes[0], *planes[1], *planes[2]);
    for (std::size_t i = 0; i < 3; ++i) corner->at[i] = corner->meet.at[i].value;
    if (exact_doubles(corner->meet)) {
      corner->meet = {};
    } else {
      corner->meet_planes = planes;
    }
    return corner;
  }

  /// A corner that no three planes of the result determine: where sheets touch without sharing their edges.
  [[nodiscard]] IncrementalVertexPointer corner_by_name(PointId v) const {
    auto corner = std::make_shared<IncrementalVertex>();
    const RationalPoint exact = exact_position(input_, points().point(v));
    bool has_doubles = true;
    for (std::size_t i = 0; i < 3; ++i) {
      corner->at[i] = to_nearest_double(exact[i]);
      has_doubles = has_doubles && to_rational(corner->at[i]) == exact[i];
    }
    corner->is_given = false;
    if (!has_doubles) corner->rational = exact;
    return corner;
  }

  [[nodiscard]] IncrementalVertexPointer made_corner(PointId v) const {
    if (v < patch_.vertex_count()) return patch_.corner(v);
    return points().is_input(v) ? given_corner(input_.vertex(v), input_.exact(v)) : corner_by_name(v);
  }

  /// Makes the corners of some triangles that are not known yet.
  void make_corners(const std::vector<std::uint32_t>& triangles) {
    std::vector<char> is_wanted(points().end());
    for (const std::uint32_t t : triangles)
      for (const PointId v : triangles_[t].v) is_wanted[v] = 1;
    for_each_index(is_wanted.size(), 64, [&](std::size_t v) {
      if (is_wanted[v] != 0 && corners_[v] == nullptr) corners_[v] = made_corner(static_cast<PointId>(v));
    });
  }

  FaceChange assembled(FacePlanes& planes) {
    FaceChange change;
    std::vector<bool> stays(patch_.face_count());
    std::vector<std::uint32_t> added;  ///< in triangles_
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      if (triangles_[i].untouched) {
        stays[triangles_[i].face] = true;
      } else {
        added.push_back(i);
      }
    }
    make_corners(added);
    std::vector<OrientedFace> faces;
    for (const std::uint32_t i : added)
      if (keeps_plane(triangles_[i])) faces.push_back({triangles_[i].face, triangles_[i].reversed});
    planes.compute(faces);
    change.added.resize(added.size());
    for_each_index(added.size(), 128, [&](std::size_t i) { change.added[i] = new_face(triangles_[added[i]], planes); });
    for (std::uint32_t f = 0; f < patch_.face_count(); ++f)
      if (!stays[f]) change.removed.push_back(&patch_.face(f));
    if (keeps_rest(rule_)) {
      ensure_same_boundary(change);
    } else {
      remove_rest(change);
    }
    return change;
  }

  /// All faces of the tree that are not in the patch.
  void remove_rest(FaceChange& change) const {
    std::vector<const WorkFace*> known;
    for (std::uint32_t f = 0; f < patch_.face_count(); ++f) known.push_back(&patch_.face(f));
    std::sort(known.begin(), known.end(), std::less<>());
    tree_.for_each([&](const WorkFace& f) {
      if (!std::binary_search(known.begin(), known.end(), &f, std::less<>())) change.removed.push_back(&f);
    });
  }

  [[nodiscard]] FaceOrigin origin_of(const ResultTriangle& t) const {
    FaceOrigin origin;
    if (!origins_.empty())
      origin = origins_[t.face];
    else if (t.face < patch_.face_count())
      origin = patch_.face(t.face).origin();
    origin.is_turned ^= t.reversed;
    return origin;
  }

  /// False if the plane of a triangle is the one through its corners, which are given doubles.
  [[nodiscard]] bool keeps_plane(const ResultTriangle& t) const {
    if (t.face < patch_.face_count() && patch_.face(t.face).plane() != nullptr) return true;
    return !std::all_of(t.v.begin(), t.v.end(),
                        [&](PointId v) { return corners_[v]->is_given && corners_[v]->has_doubles(); });
  }

  /// Requires that its corners are made.
  [[nodiscard]] WorkFace new_face(const ResultTriangle& t, FacePlanes& planes) const {
    return {{corners_[t.v[0]], corners_[t.v[1]], corners_[t.v[2]]},
            keeps_plane(t) ? planes.of({t.face, t.reversed}) : nullptr,
            origin_of(t)};
  }

  /// Checks that each side of the removed faces occurs in the new ones, equally often, or cancels with its opposite.
  static void ensure_same_boundary(const FaceChange& change) {
    std::vector<std::pair<std::pair<const IncrementalVertex*, const IncrementalVertex*>, int>> sides;
    sides.reserve(3 * (change.removed.size() + change.added.size()));
    const auto add = [&](const WorkFace& f, int times) {
      for (std::size_t i = 0; i < 3; ++i) {
        const IncrementalVertex *a = f.corners()[i].get(), *b = f.corners()[(i + 1) % 3].get();
        const bool forth = std::less<>()(a, b);
        sides.push_back({forth ? std::pair(a, b) : std::pair(b, a), forth ? times : -times});
      }
    };
    for (const WorkFace* f : change.removed) add(*f, -1);
    for (const WorkFace& f : change.added) add(f, 1);
    tbb::parallel_sort(sides.begin(), sides.end());
    int sum = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      sum += sides[i].second;
      if (i + 1 < sides.size() && sides[i + 1].first == sides[i].first) continue;
      if (sum != 0) throw LogicError("a step would leave the workpiece open");
    }
  }

  const FaceTree& tree_;
  const Box region_;
  const Rule rule_;
  const Patch patch_;
  const Candidates candidates_;
  const InputComplex& input_;
  const LocalWindings windings_;
  Subdivision subdivision_;
  const std::vector<Verdict> verdicts_;  ///< of the faces that meet no other
  std::vector<FaceOrigin> origins_;      ///< per face of the evaluation; empty: no solid has attributes
  std::vector<ResultTriangle> triangles_;
  std::vector<IncrementalVertexPointer> corners_;  ///< per point, once it is needed
};

}  // namespace

FaceChange change_by(const FaceTree& solid_in_steps, Operation operation, const ToolGroup& group,
                     const Monitor& monitor) {
  return Step(solid_in_steps, operation, group, monitor).change();
}

std::vector<WorkFace> faces_of(const Tool& tool) {
  const ExactMesh& mesh = tool.solid.exact_mesh();
  std::vector<IncrementalVertexPointer> corners;
  corners.reserve(mesh.mesh.vertices.size());
  for (const Vertex& v : mesh.mesh.vertices) corners.push_back(given_corner(v, nullptr));
  for (const ExactVertex& e : mesh.exact) corners[e.vertex] = given_corner(mesh.mesh.vertices[e.vertex], &e.position);
  const std::vector<std::uint32_t> same = equal_vertices(mesh);
  for (std::uint32_t v = 0; v < same.size(); ++v) corners[v] = corners[same[v]];
  InputComplex input;
  input.add(mesh.mesh.vertices, mesh.mesh.triangles, mesh.exact);
  FacePlanes planes(input);
  std::vector<OrientedFace> with_plane;
  for (std::uint32_t f = 0; f < input.face_count(); ++f)
    if (!input.has_doubles(mesh.mesh.triangles[f])) with_plane.push_back({f, false});
  planes.compute(with_plane);
  std::vector<WorkFace> faces(input.face_count());
  for_each_index(faces.size(), 256, [&](std::size_t i) {
    const auto f = static_cast<std::uint32_t>(i);
    const Triangle& t = mesh.mesh.triangles[f];
    faces[i] =
        WorkFace({corners[t[0]], corners[t[1]], corners[t[2]]}, input.has_doubles(t) ? nullptr : planes.of({f, false}),
                 tool.painted == nullptr ? FaceOrigin() : FaceOrigin{tool.painted, f, false});
  });
  return faces;
}

}  // namespace strata
