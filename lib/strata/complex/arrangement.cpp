#include "strata/complex/arrangement.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "strata/arrange/triangulation.h"
#include "strata/cells/cell_tree.h"
#include "strata/exact/failure.h"
#include "strata/kernel/predicates.h"
#include "strata/overlap/pairs.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// A vertex by its place. Doubles differ, or are equal for two places that only differ beyond them.
struct Place {
  Vertex doubles;
  const RationalPoint* rational = nullptr;

  friend bool operator<(const Place& a, const Place& b) {
    if (a.doubles != b.doubles) return a.doubles < b.doubles;
    if (a.rational == nullptr || b.rational == nullptr) return a.rational == nullptr && b.rational != nullptr;
    return *a.rational < *b.rational;
  }
};

/// Cuts faces, and collects what they are cut into, under numbers that are provisional until all are cut.
class Cutter {
 public:
  Cutter(const Carriers& carriers, const PointTable& points, const std::vector<std::uint8_t>& is_turned)
      : carriers_(carriers), points_(points), is_turned_(is_turned), triangulation_(carriers, points) {}

  void keep_whole(Index face) {
    const auto v = carriers_.face(face);
    for (std::size_t i = 0; i < 3; ++i) add_side_part(face, static_cast<int>(i), v[i], v[(i + 1) % 3]);
    add_piece(face, v, {});
  }

  void cut(std::span<const Constraint> constraints) {
    face_ = constraints.front().face;
    constraints_ = constraints;
    triangulate();
    number_.assign(at(triangulation_.points().size()), none);
    list_coplanar();
    spread();
    add_border();
  }

  std::vector<Piece> pieces;
  std::vector<Index> covers;
  std::vector<SidePart> side_parts;
  std::vector<PointName> constructed;
  std::vector<std::pair<Index, Index>> coplanar;

 private:
  void triangulate() {
    triangulation_.start(face_, Triangulation::Names::lowest);
    ends_.clear();
    for (const Constraint& c : constraints_) {
      const std::int32_t tail = triangulation_.add_point(c.tail);
      ends_.emplace_back(tail, triangulation_.add_point(c.head));
    }
    for (std::size_t i = 0; i < constraints_.size(); ++i)
      if (ends_[i].first != ends_[i].second)
        triangulation_.add_segment(ends_[i].first, ends_[i].second, static_cast<std::int32_t>(i), constraints_[i].line);
  }

  void list_coplanar() {
    coplanar_here_.clear();
    for (const Constraint& c : constraints_)
      if (c.kind == ConstraintKind::coplanar) coplanar_here_.push_back(c.other);
    std::sort(coplanar_here_.begin(), coplanar_here_.end());
    coplanar_here_.erase(std::unique(coplanar_here_.begin(), coplanar_here_.end()), coplanar_here_.end());
    for (const Index g : coplanar_here_) coplanar.emplace_back(face_, g);
  }

  /// Floods the triangles from one that is known; other coplanar faces cover it or not, and across each of their edges
  /// one of them begins or ends.
  void spread() {
    const auto triangles = triangulation_.triangles();
    done_.assign(triangles.size(), false);
    const auto [start, covers_there] = place_inside();
    stack_.assign(1, {start, covers_there});
    done_[at(start)] = true;
    while (!stack_.empty()) {
      const auto [t, covered] = std::move(stack_.back());
      stack_.pop_back();
      const auto& triangle = triangles[at(t)];
      if (covered.empty() || covered.front() > face_)
        add_piece(face_, {number_of(triangle.v[0]), number_of(triangle.v[1]), number_of(triangle.v[2])}, covered);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::int32_t n = triangle.n[i];
        if (n < 0 || done_[at(n)]) continue;
        done_[at(n)] = true;
        stack_.emplace_back(n, across(covered, triangle.c[i]));
      }
    }
  }

  /// A place off all constraints: on the conic of weighted points each constraint has at most two.
  std::pair<std::int32_t, std::vector<Index>> place_inside() {
    for (Index t = 1; t <= PointName::weight_limit; ++t) {
      const Point q = make_point(carriers_, PointName::weighted(face_, t));
      const auto place = triangulation_.locate(q);
      using On = Triangulation::Location::On;
      if (place.on == On::vertex) continue;
      if (place.on == On::side && triangulation_.triangles()[at(place.triangle)].c[at(place.index)] >= 0) continue;
      std::vector<Index> covered;
      for (const Index g : coplanar_here_)
        if (holds(g, q)) covered.push_back(g);
      return {place.triangle, covered};
    }
    fail("no point inside a face off its constraints", face_);
  }

  [[nodiscard]] bool holds(Index g, const Point& q) const {
    const Projection seen = projection_of(carriers_, g);
    const auto v = carriers_.face(g);
    for (std::size_t i = 0; i < 3; ++i) {
      const Point a = make_point(carriers_, PointName::input(v[i]));
      const Point b = make_point(carriers_, PointName::input(v[(i + 1) % 3]));
      if (orient2d(carriers_, seen, a, b, q) != Sign::positive) return false;
    }
    return true;
  }

  [[nodiscard]] std::vector<Index> across(std::vector<Index> covered, std::int32_t first_note) const {
    for (std::int32_t n = first_note; n >= 0; n = triangulation_.note(n).next) {
      const auto& note = triangulation_.note(n);
      const Constraint& c = constraints_[at(note.constraint)];
      if (c.kind != ConstraintKind::cover_left && c.kind != ConstraintKind::cover_right) continue;
      const bool enters = (c.kind == ConstraintKind::cover_left) != note.forward;
      const auto where = std::lower_bound(covered.begin(), covered.end(), c.other);
      const bool there = where != covered.end() && *where == c.other;
      if (enters && !there) covered.insert(where, c.other);
      if (!enters && there) covered.erase(where);
    }
    return covered;
  }

  /// From corner to corner along the border.
  void add_border() {
    const auto triangles = triangulation_.triangles();
    next_.assign(number_.size(), -1);
    for (const auto& t : triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (t.n[i] < 0) next_[at(t.v[i])] = t.v[(i + 1) % 3];
    for (int side = 0; side < 3; ++side)
      for (std::int32_t v = side; v != (side + 1) % 3; v = next_[at(v)])
        add_side_part(face_, side, number_of(v), number_of(next_[at(v)]));
  }

  void add_side_part(Index face, int side, Index a, Index b) { side_parts.push_back({{a, b}, face, side}); }

  void add_piece(Index face, std::array<Index, 3> v, const std::vector<Index>& covered) {
    if (is_turned_[face] != 0) std::swap(v[1], v[2]);
    pieces.push_back({v, face, static_cast<Index>(covers.size()), static_cast<Index>(covered.size())});
    covers.insert(covers.end(), covered.begin(), covered.end());
  }

  [[nodiscard]] PointId number_of(std::int32_t v) {
    Index& number = number_[at(v)];
    if (number != none) return number;
    number = triangulation_.points().id(v);
    if (number == FacePoints::unnumbered) {
      number = points_.end() + static_cast<Index>(constructed.size());
      constructed.push_back(triangulation_.points()[v].name);
    }
    return number;
  }

  const Carriers& carriers_;
  const PointTable& points_;
  const std::vector<std::uint8_t>& is_turned_;
  Triangulation triangulation_;

  Index face_ = 0;
  std::span<const Constraint> constraints_;
  std::vector<std::pair<std::int32_t, std::int32_t>> ends_;
  std::vector<std::int32_t> next_;
  std::vector<Index> number_, coplanar_here_;
  std::vector<bool> done_;
  std::vector<std::pair<std::int32_t, std::vector<Index>>> stack_;
};

std::vector<std::uint8_t> turned_faces(const Carriers& carriers) {
  std::vector<std::uint8_t> turned(carriers.face_count());
  for (Index f = 0; f < carriers.face_count(); ++f)
    for (int axis = 0; axis < 3; ++axis)
      if (const Sign s = normal_component(carriers, f, axis); s != Sign::zero) {
        turned[f] = s == Sign::negative;
        break;
      }
  return turned;
}

/// Points by number in lexicographic order, with those at one place next to each other.
std::vector<std::pair<PointId, Index>> by_place(const Carriers& carriers, const PointTable& table,
                                                std::vector<PointId> ids) {
  std::vector<std::pair<Point, PointId>> points;
  for (const PointId id : ids) points.emplace_back(table.point(id), id);
  const auto order = [&](const Point& p, const Point& q) {
    for (int axis = 0; axis < 3; ++axis)
      if (const Sign s = p.name == q.name ? Sign::zero : compare(carriers, axis, p, q); s != Sign::zero) return s;
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

Arrangement::Arrangement(const GivenFaces& faces, const Monitor& monitor) : points(carriers) {
  carriers.add(faces.mesh.mesh.vertices, faces.mesh.mesh.triangles, faces.mesh.exact);
  is_turned = turned_faces(carriers);
  const CellTree cells(carriers, {.self = true, .monitor = monitor});
  const Meetings meetings = find_meetings(carriers, cells, true, points, monitor);
  Cutter cutter(carriers, points, is_turned);
  const std::span<const Constraint> constraints = meetings.constraints;
  std::size_t first = 0;
  for (Index f = 0; f < carriers.face_count(); ++f) {
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
  for (const auto& [id, n] : by_place(carriers, points, used)) {
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
  vertex_of.assign(number.begin(), number.begin() + carriers.vertex_count());
}

}  // namespace strata::complex
