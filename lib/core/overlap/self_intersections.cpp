#include "core/overlap/self_intersections.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>
#include <utility>

#include "core/containers/packed_boxes.h"
#include "core/containers/point_bounds.h"
#include "core/kernel/face_box.h"
#include "core/overlap/fans.h"
#include "core/overlap/meeting.h"
#include "core/overlap/separation.h"

namespace strata {
namespace {

/// Tests pairs of faces, quicker where the first face of a pair is that of the last one. One per thread.
class PairTest {
 public:
  explicit PairTest(const InputComplex& input) : input_(input) {}

  void operator()(std::uint32_t a, std::uint32_t b, std::vector<SelfIntersection>& found) {
    if (!has_first_ || first_.face != a) first_ = FilteredFace(input_, 0, a);
    has_first_ = true;
    second_.set_corners(input_, 0, b);
    if (first_.is_beside(second_, first_.sides_of(second_))) return;
    second_.find_plane(input_);
    const std::uint32_t face = std::min(a, b), other = std::max(a, b);
    intersections_.constraints.clear();
    intersections_.constructed.clear();
    intersections_.equal.clear();
    if (!(a < b ? meet_faces(input_, first_, second_, intersections_)
                : meet_faces(input_, second_, first_, intersections_)))
      return;
    found.push_back({face, other, false, input_.vertex(input_.face(face)[0])});
    if (intersections_.constraints.empty()) return;
    const Constraint& first = intersections_.constraints.front();
    found.back().is_coplanar = first.kind == ConstraintKind::coplanar;
    found.back().at = position(first.tail);
  }

 private:
  [[nodiscard]] Vertex position(PointId id) const {
    const SymbolicPoint name =
        id < input_.vertex_count() ? SymbolicPoint::input(id) : intersections_.constructed[id - input_.vertex_count()];
    const Point p = make_point(input_, name);
    return {p.at[0].value, p.at[1].value, p.at[2].value};
  }

  const InputComplex& input_;
  FilteredFace first_, second_;
  bool has_first_ = false;
  PairIntersections intersections_;
};

std::vector<Vertex> corners_of(const InputComplex& input, std::span<const std::uint32_t> faces) {
  std::vector<Vertex> corners;
  corners.reserve(3 * faces.size());
  for (const std::uint32_t f : faces)
    for (const std::uint32_t v : input.faces(0)[f]) corners.push_back(input.points(0)[v]);
  return corners;
}

}  // namespace

InputComplex complex_of(ExactMeshView mesh) {
  InputComplex complex(SelfIntersections::possible);
  complex.add(mesh.mesh.vertices, mesh.mesh.triangles, mesh.exact);
  return complex;
}

std::vector<SelfIntersection> find_self_intersections(const InputComplex& input, const EmbeddedStars* stars,
                                                      const Monitor& monitor, std::size_t enough) {
  // Faces around a vertex where nothing crosses are no pairs; those around a fan are compared there.
  const Fans fans(input, stars);
  const auto is_key = [&](std::uint32_t v) { return (stars != nullptr && stars->at(v)) || fans.at(v); };
  const auto keys_of = [&](std::uint32_t face) {
    PackedBoxes::Keys keys = input.faces(0)[face];
    for (std::uint32_t& v : keys)
      if (!is_key(v)) v = PackedBoxes::no_key;
    return keys;
  };
  const PackedBoxes boxes(
      input.face_count(0), bounds_of_finite(input.points(0)), [&](std::uint32_t face) { return face_box(input, face); },
      keys_of);
  tbb::enumerable_thread_specific<PairTest> tests([&] { return PairTest(input); });

  // Rounds, and tasks that end by themselves, so that the end does not depend on threads.
  std::vector<SelfIntersection> all;
  const auto test_pairs = [&](std::size_t count, const auto& append_pairs_of) {
    constexpr std::size_t groups_per_task = 8, tasks_per_round = 256;
    const std::size_t tasks = (count + groups_per_task - 1) / groups_per_task;
    for (std::size_t first = 0; first < tasks && all.size() < enough; first += tasks_per_round) {
      std::vector<std::vector<SelfIntersection>> found(std::min(tasks_per_round, tasks - first));
      tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t n) {
        monitor.check();
        PairTest& test = tests.local();
        std::vector<PackedBoxes::Pair> pairs;
        const std::size_t begin = (first + n) * groups_per_task;
        for (std::size_t group = begin; group < std::min(begin + groups_per_task, count); ++group) {
          pairs.clear();
          append_pairs_of(group, pairs);
          for (const auto& [a, b] : pairs) {
            test(a, b, found[n]);
            if (found[n].size() >= enough) return;
          }
        }
      });
      for (const auto& f : found) all.insert(all.end(), f.begin(), f.end());
    }
  };
  const auto are_apart = [&](std::span<const std::uint32_t> some, std::span<const std::uint32_t> others) {
    return are_separated(corners_of(input, some), corners_of(input, others));
  };
  test_pairs(boxes.group_count(),
             [&](std::size_t group, auto& pairs) { boxes.append_pairs_of(group, pairs, are_apart); });
  test_pairs(fans.part_count(), [&](std::size_t part, auto& pairs) { fans.append_pairs_of(part, pairs); });

  std::sort(all.begin(), all.end(), [](const SelfIntersection& a, const SelfIntersection& b) {
    return std::pair(a.face, a.other) < std::pair(b.face, b.other);
  });
  return all;
}

}  // namespace strata
