#include "strata/select/split_faces.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <optional>

#include "strata/arrange/triangulation.h"
#include "strata/exact/failure.h"
#include "strata/layers/corner_cache.h"

namespace strata {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

using EqualNames = std::vector<std::pair<PointName, PointName>>;

/// What is known about one region of a split face.
struct Region {
  Windings above;                     ///< winding numbers just above the face
  std::vector<std::uint32_t> covers;  ///< other coplanar faces that cover it, sorted
};

/// Splits and judges one face; kept for the next one, so that its memory is reused.
class FaceSplitter {
 public:
  FaceSplitter(const Carriers& carriers, const CellTree& cells, const Rule& rule, bool self, const PointTable& points)
      : carriers_(carriers),
        layers_(carriers, cells),
        known_corners_(carriers.vertex_count()),
        settling_(carriers.vertex_count()),
        rule_(rule),
        self_(self),
        points_(points),
        triangulation_(carriers, points) {}

  void split(std::span<const Constraint> constraints, SplitFace& result, EqualNames& equal, Pool& pool) {
    face_ = constraints.front().face;
    operand_ = carriers_.operand_of_face(face_);
    corners_ = carriers_.face(face_);
    constraints_ = constraints;
    kept_.clear();
    list_others();
    find_free_corners();
    if (is_one_of_the_same()) {
      collect_whole();
    } else if (!is_settled_at_corner()) {
      const std::optional<FreeCorner> corner = ask_free_corner();
      if (!corner || !is_settled(corner->windings)) collect_pieces(corner, equal);
    }
    result.face = face_;
    result.may_merge = self_ || carriers_.operand_count() > 2 ||
                       std::any_of(constraints.begin(), constraints.end(),
                                   [](const Constraint& c) { return c.kind != ConstraintKind::crossing; });
    result.points = pool.keep(kept_.points);
    result.triangles = pool.keep(kept_.triangles);
    result.constructed = pool.keep(kept_.constructed);
  }

 private:
  struct Start {
    std::int32_t triangle = 0;
    Region region;
  };
  /// What stays, while it is collected.
  struct Kept {
    std::vector<PointId> points;
    std::vector<PieceTriangle> triangles;
    std::vector<PointName> constructed;

    void clear() {
      points.clear();
      triangles.clear();
      constructed.clear();
    }
  };

  /// A corner on no other surface, with the winding numbers about the other operands there.
  struct FreeCorner {
    std::size_t index = 0;
    Windings windings;
  };

  void collect_pieces(const std::optional<FreeCorner>& corner, EqualNames& equal) {
    const bool simple = triangulate();
    if ((self_ || carriers_.operand_count() > 2) && !(simple && !self_ && !carriers_.has_identified()))
      triangulation_.connect_names(self_ || carriers_.has_identified());
    spread(corner ? Start{triangle_at_corner(corner->index), {corner->windings, {}}} : start_inside());
    remember_corners();
    judge();
    collect();
    equal.insert(equal.end(), triangulation_.equal_names().begin(), triangulation_.equal_names().end());
  }

  /// The operands that the face meets, in order: constraints are sorted by face.
  void list_others() {
    others_.clear();
    for (const Constraint& c : constraints_) {
      const std::uint32_t o = carriers_.operand_of_face(c.other);
      if (others_.empty() || others_.back() != o) others_.push_back(o);
    }
  }
  [[nodiscard]] bool meets(std::uint32_t operand) const {
    return operand == operand_ || std::binary_search(others_.begin(), others_.end(), operand);
  }

  /// An operand that the face does not meet is everywhere along the face what it is at one corner: deep inside a union
  /// of many, say. If this alone decides, nothing of the face stays.
  [[nodiscard]] bool is_settled_at_corner() {
    for (const std::uint32_t v : corners_)
      if (const std::uint32_t* operand = settling_.find(v); operand != nullptr && !meets(*operand))
        return settle(*operand);
    return false;
  }
  [[nodiscard]] bool is_settled(const Windings& windings) {
    for (const auto& [operand, w] : windings)
      if (rule_.settles(operand, w) && !meets(operand)) return settle(operand);
    std::uint32_t absent = 0;
    while (absent < rule_.operands() && (windings[absent] != 0 || meets(absent))) ++absent;
    return absent < rule_.operands() && rule_.settles(absent, 0) && settle(absent);
  }
  bool settle(std::uint32_t operand) {
    for (const std::uint32_t v : corners_)
      if (!carriers_.is_shared(v)) settling_.remember(v, operand);  // else it may lie on the operand
    return true;
  }

  /// True when the face meets nothing but faces with its own three vertices.
  [[nodiscard]] bool is_one_of_the_same() const {
    const auto same = [this](const Constraint& c) {
      if (c.kind != ConstraintKind::coplanar) return false;
      const auto& v = corners_;
      const auto w = carriers_.face(c.other);
      return std::all_of(w.begin(), w.end(), [&](std::uint32_t x) { return x == v[0] || x == v[1] || x == v[2]; });
    };
    return std::all_of(constraints_.begin(), constraints_.end(), same);
  }

  void collect_whole() {
    Region region;
    for (const Constraint& c : constraints_) region.covers.push_back(c.other);
    if (region.covers.front() < face_) return;  // sorted; that one speaks for all
    const Point q = make_point(carriers_, PointName::weighted(face_, 1));
    std::vector<std::uint32_t> covering = region.covers;
    covering.push_back(face_);
    region.above = self_ ? layers_.above(face_, q, covering) : above_others(q, covering);
    const Verdict verdict = verdict_on(region);
    if (verdict == Verdict::drop) return;
    PieceTriangle piece;
    piece.turned = verdict == Verdict::keep_turned;
    piece.outline = 7;
    for (const std::uint32_t v : corners_) kept_.points.push_back(v);
    piece.v = piece.turned ? std::array<std::uint32_t, 3>{2, 1, 0} : std::array<std::uint32_t, 3>{0, 1, 2};
    kept_.triangles.push_back(piece);
  }

  /// True when the constraints are simple paths.
  bool triangulate() {
    triangulation_.start(face_, Triangulation::Names::lowest);
    if (triangulation_.add_paths(constraints_)) return true;
    ends_.clear();
    for (const Constraint& c : constraints_) {
      const std::int32_t tail = triangulation_.add_point(c.tail);
      ends_.emplace_back(tail, triangulation_.add_point(c.head));
    }
    for (std::size_t i = 0; i < constraints_.size(); ++i)
      if (ends_[i].first != ends_[i].second)
        triangulation_.add_segment(ends_[i].first, ends_[i].second, static_cast<std::int32_t>(i), constraints_[i].line);
    return false;
  }

  /// Corners on no other surface: constraints that end in a corner name it. There, winding numbers are the same for all
  /// faces of the corner.
  void find_free_corners() {
    coplanar_.clear();
    for (const Constraint& c : constraints_)
      if (c.kind == ConstraintKind::coplanar) coplanar_.push_back(c.other);
    free_corners_.clear();
    if (self_ || !coplanar_.empty()) return;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto ends_here = [&](const Constraint& c) { return c.tail == corners_[i] || c.head == corners_[i]; };
      if (!carriers_.is_shared(corners_[i]) && std::none_of(constraints_.begin(), constraints_.end(), ends_here))
        free_corners_.push_back(i);
    }
  }
  [[nodiscard]] std::int32_t triangle_at_corner(std::size_t i) const {
    return triangulation_.triangle_at(static_cast<std::int32_t>(i));
  }

  /// A free corner, if there is one, best one that a neighbour has told of.
  [[nodiscard]] std::optional<FreeCorner> ask_free_corner() const {
    for (const std::size_t i : free_corners_)
      if (const Windings* known = known_corners_.find(corners_[i])) return FreeCorner{i, *known};
    if (free_corners_.empty()) return std::nullopt;
    const std::size_t i = free_corners_.front();
    return FreeCorner{i, layers_.around(make_point(carriers_, PointName::input(corners_[i])), operand_)};
  }

  void remember_corners() {
    for (const std::size_t i : free_corners_) {
      const Windings& w = regions_[at(region_of_[at(triangle_at_corner(i))])].above;
      known_corners_.remember(corners_[i], w);
      for (const auto& [operand, winding] : w)
        if (rule_.settles(operand, winding)) settling_.remember(corners_[i], operand);
    }
  }

  /// The points with weights (1, t, t^2) lie on a conic, which a line meets in at most two points. So at most two of
  /// them lie on each constraint and one on each isolated point, and the search ends.
  [[nodiscard]] Start start_inside() {
    for (std::uint32_t t = 1; t <= PointName::weight_limit; ++t) {
      const Point q = make_point(carriers_, PointName::weighted(face_, t));
      const auto l = triangulation_.locate(q);
      using On = Triangulation::Location::On;
      if (l.on == On::vertex) continue;
      if (l.on == On::side && triangulation_.triangles()[at(l.triangle)].c[at(l.index)] >= 0) continue;
      Region region;
      std::vector<std::uint32_t> covering{face_};
      for (const std::uint32_t g : coplanar_)
        if (covers(g, q)) {
          region.covers.push_back(g);
          covering.push_back(g);
        }
      std::sort(region.covers.begin(), region.covers.end());
      region.above = self_ ? layers_.above(face_, q, covering) : above_others(q, covering);
      return {l.triangle, region};
    }
    fail("no point inside a face off its constraints", face_);
  }

  /// Winding numbers of the other operands just above. `covering` are the faces through q, this one included.
  [[nodiscard]] Windings above_others(const Point& q, const std::vector<std::uint32_t>& covering) const {
    Windings w = layers_.above(face_, q, covering);
    w.set(operand_, 0);
    return w;
  }

  /// Is q, a point of this face's plane on no edge of g, inside g?
  [[nodiscard]] bool covers(std::uint32_t g, const Point& q) const {
    const auto v = carriers_.face(g);
    const Projection projection = projection_of(carriers_, face_);
    std::array<Point, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = make_point(carriers_, PointName::input(v[i]));
    const Sign a = orient2d(carriers_, projection, p[0], p[1], q);
    return a != Sign::zero && a == orient2d(carriers_, projection, p[1], p[2], q) &&
           a == orient2d(carriers_, projection, p[2], p[0], q);
  }

  /// Floods the triangles from a start: freely inside a region, with the changes noted on a side from one to the next.
  void spread(Start from) {
    const auto triangles = triangulation_.triangles();
    region_of_.assign(triangles.size(), -1);
    regions_.clear();
    crossings_.clear();
    const auto enter = [&](std::int32_t t, Region region) {
      regions_.push_back(std::move(region));
      const auto r = static_cast<std::int32_t>(regions_.size()) - 1;
      region_of_[at(t)] = r;
      inner_.assign(1, t);
      while (!inner_.empty()) {
        const std::int32_t x = inner_.back();
        inner_.pop_back();
        for (int i = 0; i < 3; ++i) {
          const std::int32_t n = triangles[at(x)].n[at(i)];
          if (n < 0 || region_of_[at(n)] >= 0) continue;
          if (triangles[at(x)].c[at(i)] >= 0) {
            crossings_.push_back({x, i});
          } else {
            region_of_[at(n)] = r;
            inner_.push_back(n);
          }
        }
      }
    };
    enter(from.triangle, std::move(from.region));
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
      const auto [t, side] = crossings_[i];
      const std::int32_t n = triangles[at(t)].n[at(side)];
      if (region_of_[at(n)] < 0) enter(n, across(regions_[at(region_of_[at(t)])], triangles[at(t)].c[at(side)]));
    }
  }

  /// The region on the right of a side from the one on its left.
  [[nodiscard]] Region across(Region region, std::int32_t first_note) const {
    for (std::int32_t n = first_note; n >= 0; n = triangulation_.note(n).next) {
      const auto& note = triangulation_.note(n);
      const Constraint& c = constraints_[at(note.constraint)];
      switch (c.kind) {
        case ConstraintKind::crossing:
          region.above.add(carriers_.operand_of_face(c.other), note.forward ? -1 : 1);
          break;
        case ConstraintKind::cover_left:
          cover(region, c.other, !note.forward);
          break;
        case ConstraintKind::cover_right:
          cover(region, c.other, note.forward);
          break;
        case ConstraintKind::point:
        case ConstraintKind::touch:
        case ConstraintKind::coplanar:
          break;
      }
    }
    return region;
  }

  static void cover(Region& region, std::uint32_t g, bool enters) {
    const auto where = std::lower_bound(region.covers.begin(), region.covers.end(), g);
    const bool there = where != region.covers.end() && *where == g;
    if (enters && !there) region.covers.insert(where, g);
    if (!enters && there) region.covers.erase(where);
  }

  void judge() {
    verdicts_.clear();
    for (const Region& r : regions_) verdicts_.push_back(verdict_on(r));
  }

  [[nodiscard]] Verdict verdict_on(const Region& r) const {
    if (!r.covers.empty() && r.covers.front() < face_) return Verdict::drop;  // that one speaks for all
    Windings below = r.above;
    below.add(operand_, 1);
    for (const std::uint32_t g : r.covers)
      below.add(carriers_.operand_of_face(g), to_int(same_orientation(carriers_, face_, g)));
    return verdict(rule_.inside(r.above), rule_.inside(below));
  }

  void collect() {
    const auto triangles = triangulation_.triangles();
    kept_index_.assign(at(triangulation_.points().size()), -1);
    const auto verdict_of = [&](std::int32_t t) { return t < 0 ? Verdict::drop : verdicts_[at(region_of_[at(t)])]; };
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const Verdict verdict = verdict_of(static_cast<std::int32_t>(t));
      if (verdict == Verdict::drop) continue;
      PieceTriangle piece;
      piece.turned = verdict == Verdict::keep_turned;
      for (std::size_t i = 0; i < 3; ++i) {
        // Turned triangles run c, b, a: side i of the result is side 1 - i (mod 3) of the triangle.
        const std::size_t vertex = piece.turned ? 2 - i : i, side = piece.turned ? (4 - i) % 3 : i;
        const std::int32_t v = triangles[t].v[vertex];
        if (kept_index_[at(v)] < 0) {
          kept_index_[at(v)] = static_cast<std::int32_t>(kept_.points.size());
          kept_.points.push_back(number_of(v));
        }
        piece.v[i] = static_cast<std::uint32_t>(kept_index_[at(v)]);
        const auto bit = static_cast<std::uint8_t>(1u << i);
        if (verdict_of(triangles[t].n[side]) != verdict) piece.outline |= bit;
        if (triangles[t].c[side] >= 0) piece.carried |= bit;
      }
      kept_.triangles.push_back(piece);
    }
  }

  [[nodiscard]] PointId number_of(std::int32_t v) {
    const FacePoints& points = triangulation_.points();
    if (points.id(v) != FacePoints::unnumbered) return points.id(v);
    kept_.constructed.push_back(points[v].name);
    return points_.end() + static_cast<PointId>(kept_.constructed.size() - 1);
  }

  const Carriers& carriers_;
  const LocalLayers layers_;
  CornerCache<Windings> known_corners_;
  CornerCache<std::uint32_t> settling_;  ///< an operand that settles all faces of the corner that do not meet it
  const Rule& rule_;
  bool self_;
  const PointTable& points_;
  Triangulation triangulation_;

  std::uint32_t face_ = 0, operand_ = 0;
  Carriers::Indices corners_{};
  std::span<const Constraint> constraints_;
  std::vector<std::pair<std::int32_t, std::int32_t>> ends_;
  std::vector<std::uint32_t> coplanar_;
  std::vector<std::uint32_t> others_;
  boost::container::static_vector<std::size_t, 3> free_corners_;
  std::vector<std::int32_t> region_of_;
  std::vector<Region> regions_;
  struct Crossing {
    std::int32_t triangle;
    int side;
  };
  std::vector<Crossing> crossings_;  ///< sides with constraints, in the order in which they were reached
  std::vector<std::int32_t> inner_;
  std::vector<Verdict> verdicts_;
  Kept kept_;
  std::vector<std::int32_t> kept_index_;  ///< per point of the triangulation
};

/// Takes the points that were constructed in faces into the table, and identifies points that were found equal.
void complete(PointTable& points, std::vector<SplitFace>& faces, std::span<const EqualVertices> equal_vertices,
              const EqualNames& equal, const Monitor& monitor) {
  const PointId end = points.end();
  std::vector<PointName> names;
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
  points.identify(same);
  if (!points.has_identified()) return;
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t f) {
    for (PointId& p : faces[f].points) p = points.representative(p);
  });
}

}  // namespace

std::vector<SplitFace> split_faces(const Carriers& carriers, const CellTree& cells, const Rule& rule,
                                   const Meetings& meetings, bool self, PointTable& points, Pools& pools,
                                   const Monitor& monitor) {
  const std::span<const Constraint> constraints = meetings.constraints;
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < constraints.size(); ++i)
    if (i == 0 || constraints[i].face != constraints[i - 1].face) first.push_back(i);
  std::vector<SplitFace> faces(first.size());
  first.push_back(constraints.size());

  std::vector<EqualNames> equal(faces.size());
  tbb::enumerable_thread_specific<FaceSplitter> splitters(
      [&] { return FaceSplitter(carriers, cells, rule, self, points); });
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t i) {
    monitor.check();
    splitters.local().split(constraints.subspan(first[i], first[i + 1] - first[i]), faces[i], equal[i], pools.local());
  });
  EqualNames all_equal;
  for (const auto& e : equal) all_equal.insert(all_equal.end(), e.begin(), e.end());
  complete(points, faces, meetings.equal, all_equal, monitor);
  return faces;
}

}  // namespace strata
