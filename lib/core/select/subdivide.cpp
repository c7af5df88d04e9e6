#include "core/select/subdivide.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <limits>
#include <utility>

#include "core/containers/costly_first.h"
#include "core/exact/invariants.h"
#include "core/overlap/validate.h"
#include "core/select/face_splitter.h"
#include "core/select/validate.h"

namespace strata {
namespace {

/// A face with all its constraints. A hidden face has none that matter.
struct MetFace {
  std::uint32_t face = 0;
  std::span<const Constraint> constraints;
};

/// The faces with constraints and the hidden faces, in order.
std::vector<MetFace> met_faces(std::span<const Constraint> constraints, std::span<const std::uint32_t> hidden) {
  std::vector<MetFace> faces;
  std::size_t next = 0;  // hidden face
  const auto add_hidden = [&](std::uint32_t up_to) {
    while (next < hidden.size() && hidden[next] <= up_to) faces.push_back({hidden[next++], {}});
  };
  for (std::size_t i = 0, end = 0; i < constraints.size(); i = end) {
    const std::uint32_t face = constraints[i].face;
    while (end < constraints.size() && constraints[end].face == face) ++end;
    add_hidden(face);
    if (faces.empty() || faces.back().face != face) faces.push_back({face, constraints.subspan(i, end - i)});
  }
  add_hidden(std::numeric_limits<std::uint32_t>::max());
  return faces;
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
  const std::span<const std::uint32_t> hidden =
      intersections.hidden ? std::span<const std::uint32_t>(*intersections.hidden) : std::span<const std::uint32_t>();
  const std::vector<MetFace> met = met_faces(intersections.constraints, hidden);
  Subdivision result{std::vector<SubdividedFace>(met.size()), {}, std::move(intersections.points)};
  std::vector<NewPoints> found(met.size());
  const bool seeks_hidden = !intersections.hidden.has_value();
  tbb::enumerable_thread_specific<FaceSplitter> splitters(
      [&] { return FaceSplitter(input, classifier, result.points, seeks_hidden); });
  for_costly_first(
      met.size(), [&](std::size_t i) { return met[i].constraints.size(); },
      [&](std::size_t i) {
        monitor.check();
        if (met[i].constraints.empty())
          result.faces[i].face = met[i].face;
        else
          result.faces[i] = splitters.local().split(met[i].constraints, found[i], result.pools.local());
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
