#include "core/select/split_faces.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "core/select/face_splitter.h"

namespace strata {
namespace {

/// Takes the points that were constructed in faces into the table, and identifies points that were found equal.
void complete(PointTable& points, std::vector<SplitFace>& faces, std::span<const EqualVertices> equal_vertices,
              const EqualNames& equal, bool by_places, const Monitor& monitor) {
  const PointId end = points.end();
  std::vector<SymbolicPoint> names;
  std::vector<std::size_t> first;
  for (const SplitFace& f : faces) {
    first.push_back(names.size());
    names.insert(names.end(), f.constructed.begin(), f.constructed.end());
  }
  const std::size_t constructed = names.size();
  for (const auto& [a, b] : equal) names.insert(names.end(), {a, b});
  std::vector<std::pair<PointId, PointId>> same;
  for (const EqualVertices& e : equal_vertices) same.emplace_back(e.a, e.b);
  if (!names.empty()) {
    const std::vector<PointId> numbers = points.add(names, monitor);
    for (std::size_t i = constructed; i < names.size(); i += 2) same.emplace_back(numbers[i], numbers[i + 1]);
    tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t f) {
      for (PointId& p : faces[f].points)
        if (p >= end) p = numbers[first[f] + (p - end)];
    });
  }
  if (by_places) {
    std::vector<PointId> used;
    for (const SplitFace& f : faces) used.insert(used.end(), f.points.begin(), f.points.end());
    for (const auto& pair : points.equal_positions(std::move(used), monitor)) same.push_back(pair);
  }
  points.identify(same);
  if (!points.has_identified()) return;
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t f) {
    for (PointId& p : faces[f].points) p = points.representative(p);
  });
}

}  // namespace

std::vector<SplitFace> split_faces(const InputComplex& input, const WindingOracle& oracle, const Rule& rule,
                                   const Intersections& intersections, bool self, PointTable& points, Pools& pools,
                                   const Monitor& monitor) {
  const std::span<const Constraint> constraints = intersections.constraints;
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < constraints.size(); ++i)
    if (i == 0 || constraints[i].face != constraints[i - 1].face) first.push_back(i);
  std::vector<SplitFace> faces(first.size());
  first.push_back(constraints.size());

  std::vector<EqualNames> equal(faces.size());
  tbb::enumerable_thread_specific<FaceSplitter> splitters(
      [&] { return FaceSplitter(input, oracle, rule, self, points); });
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t i) {
    monitor.check();
    splitters.local().split(constraints.subspan(first[i], first[i + 1] - first[i]), faces[i], equal[i], pools.local());
  });
  EqualNames all_equal;
  for (const auto& e : equal) all_equal.insert(all_equal.end(), e.begin(), e.end());
  complete(points, faces, intersections.equal, all_equal, !rule.looks_around(), monitor);
  return faces;
}

}  // namespace strata
