#include "core/overlap/self_intersections.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>
#include <utility>

#include "core/containers/point_bounds.h"
#include "core/kernel/face_box.h"
#include "core/overlap/meeting.h"
#include "core/overlap/separation.h"

namespace strata {
namespace {

/// Tests pairs of faces, quicker where the first face of a pair is that of the last one. One per thread.
class PairTest {
 public:
  explicit PairTest(const InputComplex& input) : input_(input) {}

  /// Appends what it finds.
  void operator()(std::uint32_t a, std::uint32_t b, std::vector<SelfIntersection>& found,
                  PairIntersections& intersections) {
    ++intersections.pairs_tested;
    if (!has_first_ || first_.face != a) first_ = FilteredFace(input_, 0, a);
    has_first_ = true;
    second_.set_corners(input_, 0, b);
    const Signs of_second = first_.sides_of(second_);
    if (first_.is_beside(second_, of_second)) return;
    second_.find_plane(input_);
    const Signs of_first = second_.sides_of(first_);
    if (second_.is_beside(first_, of_first)) return;
    const std::size_t known = intersections.constraints.size();
    if (!(a < b ? meet_faces(input_, first_, second_, of_first, of_second, intersections)
                : meet_faces(input_, second_, first_, of_second, of_first, intersections)))
      return;
    ++intersections.pairs_meeting;
    const std::uint32_t face = std::min(a, b), other = std::max(a, b);
    found.push_back({face, other, false, input_.vertex(input_.face(face)[0])});
    if (intersections.constraints.size() == known) return;
    const Constraint& first = intersections.constraints[known];
    found.back().is_coplanar = first.kind == ConstraintKind::coplanar;
    found.back().at = position(first.tail, intersections);
  }

 private:
  [[nodiscard]] Vertex position(PointId id, const PairIntersections& intersections) const {
    const SymbolicPoint name =
        id < input_.vertex_count() ? SymbolicPoint::input(id) : intersections.constructed[id - input_.vertex_count()];
    const Point p = make_point(input_, name);
    return {p.at[0].value, p.at[1].value, p.at[2].value};
  }

  const InputComplex& input_;
  FilteredFace first_, second_;
  bool has_first_ = false;
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

// Faces around a vertex where nothing crosses are no pairs; those around a fan are compared there.
SelfIntersectionSearch::SelfIntersectionSearch(const InputComplex& input, const EmbeddedStars* stars)
    : input_(input),
      fans_(input, stars),
      boxes_(
          input.face_count(0), bounds_of_finite(input.points(0)),
          [&](std::uint32_t face) { return face_box(input, face); },
          [&](std::uint32_t face) {
            PackedBoxes::Keys keys = input.faces(0)[face];
            for (std::uint32_t& v : keys)
              if (!((stars != nullptr && stars->at(v)) || fans_.at(v))) v = PackedBoxes::no_key;
            return keys;
          }) {}

void SelfIntersectionSearch::append_pairs_of(std::size_t part, std::vector<PackedBoxes::Pair>& pairs) const {
  const auto are_apart = [&](std::span<const std::uint32_t> some, std::span<const std::uint32_t> others) {
    return are_separated(corners_of(input_, some), corners_of(input_, others));
  };
  if (part < boxes_.group_count())
    boxes_.append_pairs_of(part, pairs, are_apart);
  else
    fans_.append_pairs_of(part - boxes_.group_count(), pairs);
}

// Rounds, and tasks that end by themselves, so that the end does not depend on threads. The first rounds are short:
// what has many pairs is known soon.
std::vector<SelfIntersection> SelfIntersectionSearch::find(const Monitor& monitor, std::size_t enough,
                                                           std::vector<PairIntersections>* met) {
  constexpr std::size_t least_tasks = 8, most_tasks = 256, tasks_to_share = 64, most_parts = 8;
  const std::size_t parts = boxes_.group_count() + fans_.part_count();
  const std::size_t parts_per_task = std::clamp(parts / tasks_to_share, std::size_t{1}, most_parts);
  const std::size_t tasks = (parts + parts_per_task - 1) / parts_per_task;
  finds_none_.resize(tasks);
  if (met != nullptr) *met = std::vector<PairIntersections>(tasks);
  tbb::enumerable_thread_specific<PairTest> tests([&] { return PairTest(input_); });
  std::vector<SelfIntersection> result;
  std::size_t first = 0, end = 0;
  for (; first < tasks && result.size() < enough; first = end) {
    end = std::min(tasks, first + std::clamp(first, least_tasks, most_tasks));
    std::vector<std::vector<SelfIntersection>> found(end - first);
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t n) {
      monitor.check();
      if (finds_none_[first + n] != 0) return;
      PairTest& test = tests.local();
      std::vector<PackedBoxes::Pair> pairs;
      PairIntersections here;
      const std::size_t begin = (first + n) * parts_per_task;
      for (std::size_t part = begin; part < std::min(begin + parts_per_task, parts); ++part) {
        pairs.clear();
        append_pairs_of(part, pairs);
        for (const auto& [a, b] : pairs) {
          test(a, b, found[n], here);
          if (met == nullptr) here.clear();
          if (found[n].size() >= enough) return;
        }
      }
      if (met != nullptr) (*met)[first + n] = std::move(here);
    });
    for (std::size_t n = 0; n < found.size(); ++n) {
      finds_none_[first + n] = static_cast<char>(found[n].empty());
      result.insert(result.end(), found[n].begin(), found[n].end());
    }
  }
  std::sort(result.begin(), result.end(), [](const SelfIntersection& a, const SelfIntersection& b) {
    return std::pair(a.face, a.other) < std::pair(b.face, b.other);
  });
  return result;
}

std::vector<SelfIntersection> find_self_intersections(const InputComplex& input, const EmbeddedStars* stars,
                                                      const Monitor& monitor, std::size_t enough,
                                                      std::vector<PairIntersections>* met) {
  return SelfIntersectionSearch(input, stars).find(monitor, enough, met);
}

}  // namespace strata
