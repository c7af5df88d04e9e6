#include "core/select/subdivide.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <utility>

#include "core/containers/costly_first.h"
#include "core/exact/invariants.h"
#include "core/overlap/validate.h"
#include "core/select/face_splitter.h"
#include "core/select/validate.h"

namespace strata {
namespace {

/// Where the constraints of each face start; the last entry is their number.
std::vector<std::size_t> starts_of_faces(std::span<const Constraint> constraints) {
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < constraints.size(); ++i)
    if (i == 0 || constraints[i].face != constraints[i - 1].face) first.push_back(i);
  first.push_back(constraints.size());
  return first;
}

/// Replaces every point of the faces.
template <class Replace>
void replace_points(std::vector<SubdividedFace>& faces, const Replace& replace) {
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t f) {
    for (PointId& p : faces[f].points) p = replace(f, p);
  });
}

/// Adds the points constructed in faces to the table, where faces numbered them from its end, and returns the pairs of
/// points with equal names.
std::vector<std::pair<PointId, PointId>> add_points(Subdivision& subdivision, std::span<const NewPoints> found,
                                                    const Monitor& monitor) {
  const PointId end = subdivision.points.end();
  std::vector<SymbolicPoint> names;
  std::vector<std::size_t> first;
  for (const NewPoints& f : found) {
    first.push_back(names.size());
    names.insert(names.end(), f.constructed.begin(), f.constructed.end());
  }
  const std::size_t constructed = names.size();
  for (const NewPoints& f : found)
    for (const auto& [a, b] : f.equal) names.insert(names.end(), {a, b});
  std::vector<std::pair<PointId, PointId>> same;
  if (names.empty()) return same;
  const std::vector<PointId> numbers = subdivision.points.add(names, monitor);
  for (std::size_t i = constructed; i < names.size(); i += 2) same.emplace_back(numbers[i], numbers[i + 1]);
  replace_points(subdivision.faces,
                 [&](std::size_t f, PointId p) { return p < end ? p : numbers[first[f] + (p - end)]; });
  return same;
}

/// True when a face of which nothing is kept may be the only one that knows two names of a point.
bool needs_positions(const InputComplex& input, const Rule& rule) {
  return !rule.looks_around() || input.may_self_intersect() || input.operand_count() > 2;
}

std::vector<PointId> used_points(const std::vector<SubdividedFace>& faces) {
  std::vector<PointId> used;
  for (const SubdividedFace& f : faces) used.insert(used.end(), f.points.begin(), f.points.end());
  return used;
}

}  // namespace

Subdivision subdivide(const InputComplex& input, Intersections intersections, const Classifier& classifier,
                      const Monitor& monitor) {
  const std::span<const Constraint> constraints = intersections.constraints;
  const std::vector<std::size_t> first = starts_of_faces(constraints);
  Subdivision result{std::vector<SubdividedFace>(first.size() - 1), {}, std::move(intersections.points)};
  std::vector<NewPoints> found(result.faces.size());
  tbb::enumerable_thread_specific<FaceSplitter> splitters(
      [&] { return FaceSplitter(input, classifier, result.points); });
  for_costly_first(
      result.faces.size(), [&](std::size_t i) { return first[i + 1] - first[i]; },
      [&](std::size_t i) {
        monitor.check();
        result.faces[i] = splitters.local().split(constraints.subspan(first[i], first[i + 1] - first[i]), found[i],
                                                  result.pools.local());
      });
  std::vector<std::pair<PointId, PointId>> same = add_points(result, found, monitor);
  for (const EqualVertices& e : intersections.equal) same.emplace_back(e.a, e.b);
  if (needs_positions(input, classifier.rule)) {
    const auto more = result.points.equal_positions(used_points(result.faces), monitor);
    same.insert(same.end(), more.begin(), more.end());
  }
  result.points.identify(same);
  if (result.points.has_identified())
    replace_points(result.faces, [&](std::size_t, PointId p) { return result.points.representative(p); });
  ensure("subdivide", [&] { return validate(input, result.points); });
  ensure("subdivide", [&] { return validate(input, result); });
  return result;
}

}  // namespace strata
