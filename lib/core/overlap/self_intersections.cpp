#include "core/overlap/self_intersections.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/containers/packed_boxes.h"
#include "core/overlap/meeting.h"

namespace strata {
namespace {

/// Of a face; a vertex that is not a double is at most half the distance to the next double away.
Box box_of(const InputComplex& input, std::uint32_t face) {
  const auto points = input.points(0);
  const auto& t = input.faces(0)[face];
  Box box;
  for (const std::uint32_t v : t) box.include(points[v]);
  if (input.has_doubles(t)) return box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.lower[i] = std::nextafter(box.lower[i], -Box::infinity);
    box.upper[i] = std::nextafter(box.upper[i], Box::infinity);
  }
  return box;
}

/// Tests pairs of faces. One per thread.
class PairTest {
 public:
  PairTest(const InputComplex& input, const EmbeddedStars* stars) : input_(input), stars_(stars) {}

  void operator()(std::uint32_t a, std::uint32_t b, std::vector<SelfIntersection>& found) {
    if (are_side_by_side(a, b)) return;
    const std::uint32_t face = std::min(a, b), other = std::max(a, b);
    intersections_.constraints.clear();
    intersections_.constructed.clear();
    intersections_.equal.clear();
    if (!meet_faces(input_, FilteredFace(input_, 0, face), FilteredFace(input_, 0, other), intersections_)) return;
    found.push_back({face, other, false, input_.vertex(input_.face(face)[0])});
    if (intersections_.constraints.empty()) return;
    const Constraint& first = intersections_.constraints.front();
    found.back().is_coplanar = first.kind == ConstraintKind::coplanar;
    found.back().at = position(first.tail);
  }

 private:
  /// True for faces around one vertex that are known not to meet elsewhere.
  [[nodiscard]] bool are_side_by_side(std::uint32_t a, std::uint32_t b) const {
    if (stars_ == nullptr) return false;
    const auto& s = input_.faces(0)[a];
    const auto& t = input_.faces(0)[b];
    for (const std::uint32_t v : s)
      if ((v == t[0] || v == t[1] || v == t[2]) && stars_->at(v)) return true;
    return false;
  }

  [[nodiscard]] Vertex position(PointId id) const {
    const SymbolicPoint name =
        id < input_.vertex_count() ? SymbolicPoint::input(id) : intersections_.constructed[id - input_.vertex_count()];
    const Point p = make_point(input_, name);
    return {p.at[0].value, p.at[1].value, p.at[2].value};
  }

  const InputComplex& input_;
  const EmbeddedStars* stars_;
  PairIntersections intersections_;
};

}  // namespace

std::vector<SelfIntersection> find_self_intersections(const InputComplex& input, const EmbeddedStars* stars,
                                                      const Monitor& monitor, std::size_t enough) {
  const PackedBoxes boxes(input.face_count(0), [&](std::uint32_t face) { return box_of(input, face); });
  tbb::enumerable_thread_specific<PairTest> tests([&] { return PairTest(input, stars); });

  // Rounds of packs, so that the end does not depend on threads.
  constexpr std::size_t packs_per_task = 64, tasks_per_round = 256;
  std::vector<SelfIntersection> all;
  const std::size_t tasks = (boxes.pack_count() + packs_per_task - 1) / packs_per_task;
  for (std::size_t first = 0; first < tasks && all.size() < enough; first += tasks_per_round) {
    std::vector<std::vector<SelfIntersection>> found(std::min(tasks_per_round, tasks - first));
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t n) {
      monitor.check();
      PairTest& test = tests.local();
      const std::size_t begin = (first + n) * packs_per_task;
      for (std::size_t pack = begin; pack < std::min(begin + packs_per_task, boxes.pack_count()); ++pack)
        boxes.for_each_pair_of(pack, [&](std::uint32_t a, std::uint32_t b) { test(a, b, found[n]); });
    });
    for (const auto& f : found) all.insert(all.end(), f.begin(), f.end());
  }
  std::sort(all.begin(), all.end(), [](const SelfIntersection& a, const SelfIntersection& b) {
    return a.face < b.face || (a.face == b.face && a.other < b.other);
  });
  return all;
}

}  // namespace strata
