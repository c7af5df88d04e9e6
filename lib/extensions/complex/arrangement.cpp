#include "extensions/complex/arrangement.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "core/kernel/predicates.h"
#include "core/overlap/intersect.h"
#include "extensions/complex/face_cutter.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// A vertex by its position. Equal doubles may belong to different positions.
struct Place {
  Vertex doubles;
  const RationalPoint* rational = nullptr;

  friend bool operator<(const Place& a, const Place& b) {
    if (a.doubles != b.doubles) return a.doubles < b.doubles;
    if (a.rational == nullptr || b.rational == nullptr) return a.rational == nullptr && b.rational != nullptr;
    return *a.rational < *b.rational;
  }
};

std::vector<std::uint8_t> reversed_faces(const InputComplex& input) {
  std::vector<std::uint8_t> reversed(input.face_count());
  for (Index f = 0; f < input.face_count(); ++f)
    for (int axis = 0; axis < 3; ++axis)
      if (const Sign s = normal_component(input, f, axis); s != Sign::zero) {
        reversed[f] = s == Sign::negative;
        break;
      }
  return reversed;
}

/// Points by number in lexicographic order, coincident points next to each other.
std::vector<std::pair<PointId, Index>> by_place(const InputComplex& input, const PointTable& table,
                                                std::vector<PointId> ids) {
  std::vector<std::pair<Point, PointId>> points;
  for (const PointId id : ids) points.emplace_back(table.point(id), id);
  const auto order = [&](const Point& p, const Point& q) {
    for (int axis = 0; axis < 3; ++axis)
      if (const Sign s = p.name == q.name ? Sign::zero : compare(input, axis, p, q); s != Sign::zero) return s;
    return Sign::zero;
  };
  std::sort(points.begin(), points.end(),
            [&](const auto& a, const auto& b) { return order(a.first, b.first) == Sign::negative; });
  std::vector<std::pair<PointId, Index>> result;
  Index number = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && order(points[i - 1].first, points[i].first) != Sign::zero) ++number;
    result.emplace_back(points[i].second, number);
  }
  return result;
}

InputComplex complex_of(const GivenFaces& faces) {
  InputComplex complex(SelfIntersections::possible);
  complex.add(faces.mesh.mesh.vertices, faces.mesh.mesh.triangles, faces.mesh.exact);
  return complex;
}

}  // namespace

GivenFaces::GivenFaces(std::span<const Soup> operands) : vertex_cell(operands.size()) {
  std::map<Place, Index> numbers;
  std::vector<std::array<Index, 3>> cells;  // vertex, operand, cell
  for (Index k = 0; k < operands.size(); ++k) {
    const Soup& soup = operands[k];
    std::vector<Index> number;
    auto rational = soup.mesh.exact.begin();
    for (Index v = 0; v < soup.mesh.mesh.vertices.size(); ++v) {
      Place place{soup.mesh.mesh.vertices[v]};
      for (double& x : place.doubles) x += 0.0;  // -0 is 0
      if (rational != soup.mesh.exact.end() && rational->vertex == v) place.rational = &rational++->position;
      const auto [found, is_new] = numbers.try_emplace(place, static_cast<Index>(mesh.mesh.vertices.size()));
      if (is_new) {
        mesh.mesh.vertices.push_back(place.doubles);
        if (place.rational != nullptr) mesh.exact.push_back({found->second, *place.rational});
      }
      number.push_back(found->second);
      if (soup.vertex_cell[v] != none) cells.push_back({found->second, k, soup.vertex_cell[v]});
    }
    first.push_back(static_cast<Index>(mesh.mesh.triangles.size()));
    for (const Triangle& t : soup.mesh.mesh.triangles) {
      mesh.mesh.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
      operand.push_back(k);
    }
  }
  for (auto& list : vertex_cell) list.assign(mesh.mesh.vertices.size(), none);
  for (const auto& [v, k, cell] : cells) vertex_cell[k][v] = cell;
}

Arrangement::Arrangement(const GivenFaces& faces, const Monitor& monitor)
    : candidates(find_candidates(complex_of(faces), monitor)), input(candidates.input()), points(input) {
  is_reversed = reversed_faces(input);
  Intersections intersections = intersect(candidates, monitor);
  points = std::move(intersections.points);
  FaceCutter cutter(input, points, is_reversed);
  const std::span<const Constraint> constraints = intersections.constraints;
  std::size_t first = 0;
  for (Index f = 0; f < input.face_count(); ++f) {
    std::size_t last = first;
    while (last < constraints.size() && constraints[last].face == f) ++last;
    monitor.check();
    if (first == last) cutter.keep_whole(f);
    if (first < last) cutter.cut(constraints.subspan(first, last - first));
    first = last;
  }
  const PointId provisional = points.end();
  const std::vector<PointId> numbers = points.add(cutter.constructed, monitor);
  const auto final_id = [&](PointId id) { return id < provisional ? id : numbers[id - provisional]; };

  std::vector<PointId> used;
  for (const SidePart& s : cutter.side_parts)
    for (const Index v : s.v) used.push_back(final_id(v));
  for (const Piece& p : cutter.pieces)
    for (const Index v : p.v) used.push_back(final_id(v));
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<Index> number(points.end(), none);
  for (const auto& [id, n] : by_place(input, points, used)) {
    number[id] = n;
    if (n == vertices.size()) vertices.push_back(id);
  }
  const auto vertex = [&](PointId id) { return number[final_id(id)]; };
  pieces = std::move(cutter.pieces);
  for (Piece& p : pieces)
    for (Index& v : p.v) v = vertex(v);
  side_parts = std::move(cutter.side_parts);
  for (SidePart& s : side_parts) {
    s.v = {vertex(s.v[0]), vertex(s.v[1])};
    if (s.v[0] > s.v[1]) std::swap(s.v[0], s.v[1]);
  }
  covers = std::move(cutter.covers);
  coplanar = std::move(cutter.coplanar);
  vertex_of.assign(number.begin(), number.begin() + input.vertex_count());
}

}  // namespace strata::complex
