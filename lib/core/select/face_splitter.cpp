#include "core/select/face_splitter.h"

#include <algorithm>

#include "core/arrange/validate.h"
#include "core/exact/failure.h"
#include "core/exact/invariants.h"

namespace strata {
namespace {

/// Triangulations up to this size are validated in checked builds.
constexpr std::size_t most_validated = 256;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

FaceSplitter::FaceSplitter(const InputComplex& input, const Classifier& classifier, const PointTable& points,
                           bool seeks_hidden)
    : input_(input),
      oracle_(classifier.oracle),
      sheets_(classifier.sheets),
      known_corners_(input.vertex_count()),
      early_out_(input, classifier.rule),
      covering_(input, classifier.rule),
      rule_(classifier.rule),
      self_(input.may_self_intersect()),
      seeks_hidden_(seeks_hidden && !self_),
      points_(points),
      triangulation_(input, points) {}

SubdividedFace FaceSplitter::split(std::span<const Constraint> constraints, NewPoints& found, Pool& pool) {
  face_ = constraints.front().face;
  operand_ = input_.operand_of_face(face_);
  corners_ = input_.face(face_);
  constraints_ = constraints;
  kept_.clear();
  list_met();
  covering_.start(constraints);
  find_free_corners();
  early_out_.start(corners_, met_);
  const bool same = is_one_of_the_same();
  if (same) {
    collect_whole();
  } else if (!early_out_.is_settled() && (!seeks_hidden_ || !covering_.hides_face())) {
    const std::optional<FreeCorner> corner = ask_free_corner();
    if (!corner || !early_out_.is_settled(corner->windings)) collect_pieces(corner, found);
  }
  SubdividedFace result;
  result.face = face_;
  result.may_merge = !same && !rule_.keeps_covers() &&
                     (self_ || input_.operand_count() > 2 ||
                      std::any_of(constraints.begin(), constraints.end(),
                                  [](const Constraint& c) { return c.kind != ConstraintKind::crossing; }));
  result.points = pool.keep(kept_.points);
  result.triangles = pool.keep(kept_.triangles);
  result.covers = pool.keep(kept_.covers);
  found.constructed = pool.keep(kept_.constructed);
  return result;
}

void FaceSplitter::collect_pieces(const std::optional<FreeCorner>& corner, NewPoints& found) {
  triangulation_.start(face_, Triangulation::Names::lowest);
  const PathPolygons* polygons = triangulation_.find_paths(constraints_);
  bool are_paths = polygons != nullptr;
  if (!are_paths || !corner || !is_crossed_by_one_solid() || !fill_kept(*polygons, *corner)) {
    are_paths = triangulate(polygons);
    triangulation_.avoid_flat_angles();
    if (triangulation_.triangles().size() <= most_validated)
      ensure("subdivide", [&] { return validate(triangulation_, constraints_); });
    spread(corner ? Start{triangle_at_corner(corner->index), {corner->windings, {}}} : start_inside());
    judge();
  }
  remember_corners();
  collect();
  if (rule_.looks_around() && !kept_.triangles.empty()) connect_names(are_paths, found);
}

/// True when all constraints are of one other operand, which is a solid, so that they do not cross each other, and no
/// point has names that only a complete triangulation shows.
bool FaceSplitter::is_crossed_by_one_solid() const {
  return !self_ && met_.size() == 2 && rule_.looks_around() && !(input_.operand_count() > 2 && input_.has_identified());
}

/// Fills the polygons of the regions that are kept. False where that fails.
bool FaceSplitter::fill_kept(const PathPolygons& polygons, const FreeCorner& corner) {
  spread_over(polygons, corner);
  judge();
  region_of_.clear();
  for (std::size_t i = 0; i < polygons.count(); ++i) {
    const std::int32_t region = region_of_polygon_[i];
    if (verdicts_[at(region)] == Verdict::drop) continue;
    if (!triangulation_.fill(i)) return false;
    region_of_.resize(triangulation_.triangles().size(), region);
  }
  triangulation_.avoid_flat_angles();
  return true;
}

/// Traverses the polygons from that of a corner. Each is a region.
void FaceSplitter::spread_over(const PathPolygons& polygons, const FreeCorner& corner) {
  sides_.assign(constraints_.size(), {});
  region_of_polygon_.assign(polygons.count(), -1);
  regions_.clear();
  polygon_queue_.clear();
  std::array<std::size_t, 3> at_corner{};
  for (std::size_t i = 0; i < polygons.count(); ++i)
    for (const PathPolygons::Side& side : polygons[i]) {
      if (side.carrier >= 0) (side.forward ? sides_[at(side.carrier)].left : sides_[at(side.carrier)].right) = i;
      if (side.from < 3) at_corner[at(side.from)] = i;
    }
  const auto enter = [&](std::size_t polygon, Region region) {
    region_of_polygon_[polygon] = static_cast<std::int32_t>(regions_.size());
    regions_.push_back(std::move(region));
    polygon_queue_.push_back(polygon);
  };
  enter(at_corner[corner.index], {corner.windings, {}});
  for (std::size_t i = 0; i < polygon_queue_.size(); ++i)
    for (const PathPolygons::Side& side : polygons[polygon_queue_[i]]) {
      if (side.carrier < 0) continue;
      const auto c = at(side.carrier);
      const std::size_t other = side.forward ? sides_[c].right : sides_[c].left;
      if (region_of_polygon_[other] >= 0) continue;
      Region region = regions_[i];
      cross(region, c, side.forward);
      enter(other, std::move(region));
    }
  for (std::size_t i = 0; i < 3; ++i) region_at_corner_[i] = region_of_polygon_[at_corner[i]];
}

/// Lists other names of the points that bound the result. `simple`: the constraints are simple paths.
void FaceSplitter::connect_names(bool simple, NewPoints& found) {
  // Where lines of one operand may have different names for a point, simple paths may, too.
  const bool same_operand = self_ || input_.has_identified();
  if (self_ || (input_.operand_count() > 2 && (same_operand || !simple)))
    triangulation_.connect_names(same_operand, kept_index_);
  for (const auto& [vertex, name] : triangulation_.other_names())
    if (kept_index_[at(vertex)] >= 0) found.equal.emplace_back(name, triangulation_.points()[vertex].name);
}

/// Lists all operands that the face meets, its own included, in order.
void FaceSplitter::list_met() {
  met_.assign(1, operand_);
  for (const Constraint& c : constraints_) met_.push_back(input_.operand_of_face(c.other));
  std::sort(met_.begin(), met_.end());
  met_.erase(std::unique(met_.begin(), met_.end()), met_.end());
}

/// True when the face meets only faces with its own three vertices.
bool FaceSplitter::is_one_of_the_same() const {
  const auto same = [this](const Constraint& c) {
    if (c.kind != ConstraintKind::coplanar) return false;
    const auto& v = corners_;
    const auto w = input_.face(c.other);
    return std::all_of(w.begin(), w.end(), [&](std::uint32_t x) { return x == v[0] || x == v[1] || x == v[2]; });
  };
  return std::all_of(constraints_.begin(), constraints_.end(), same);
}

void FaceSplitter::collect_whole() {
  Region region;
  for (const Constraint& c : constraints_) region.covers.push_back(c.other);
  if (region.covers.front() < face_ && !rule_.asks_for_keepers()) return;  // sorted; that face represents all
  if (!self_ && covering_.leaves_nothing(region.covers)) return;
  region.above = above_at(SymbolicPoint::weighted(face_, 1), region.covers);
  const Verdict verdict = verdict_on(region);
  if (verdict == Verdict::drop) return;
  PieceTriangle piece;
  piece.reversed = verdict == Verdict::keep_reversed;
  piece.boundary = 7;
  for (const std::uint32_t v : corners_) kept_.points.push_back(v);
  piece.v = piece.reversed ? std::array<std::uint32_t, 3>{2, 1, 0} : std::array<std::uint32_t, 3>{0, 1, 2};
  keep_covers(region);
  kept_.triangles.push_back(piece);
}

/// Lists the faces that cover the next piece.
void FaceSplitter::keep_covers(const Region& region) {
  if (!rule_.keeps_covers()) return;
  for (const std::uint32_t g : region.covers)
    kept_.covers.push_back({static_cast<std::uint32_t>(kept_.triangles.size()), g});
}

/// Triangulates all of the face, after a search for polygons that may have been filled in part. True when these served.
bool FaceSplitter::triangulate(const PathPolygons* polygons) {
  if (polygons != nullptr) {
    bool is_filled = triangulation_.triangles().empty();
    for (std::size_t i = 0; is_filled && i < polygons->count(); ++i) is_filled = triangulation_.fill(i);
    if (is_filled) return true;
    triangulation_.start(face_, Triangulation::Names::lowest);
  }
  triangulation_.add_constraints(constraints_);
  return false;
}

/// Free corners: corners on no other surface. (A constraint that ends in a corner names it.) There, winding numbers are
/// the same for all faces of the corner.
void FaceSplitter::find_free_corners() {
  free_corners_.clear();
  if (sheets_ != nullptr)
    for (std::size_t i = 0; i < 3; ++i)
      if (sheets_->sheets().is_free(corners_[i])) free_corners_.push_back(i);
  if (self_ || !covering_.coplanar().empty()) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto ends_here = [&](const Constraint& c) { return c.tail == corners_[i] || c.head == corners_[i]; };
    if (!input_.is_shared(corners_[i]) && std::none_of(constraints_.begin(), constraints_.end(), ends_here))
      free_corners_.push_back(i);
  }
}

std::int32_t FaceSplitter::triangle_at_corner(std::size_t i) const {
  return triangulation_.triangle_at(static_cast<std::int32_t>(i));
}

/// A free corner whose winding numbers are known from a neighbour. If none are, any; on a sheet, none.
std::optional<FaceSplitter::FreeCorner> FaceSplitter::ask_free_corner() const {
  for (const std::size_t i : free_corners_)
    if (const Windings* known = known_corners_.find(corners_[i])) return FreeCorner{i, *known};
  if (sheets_ != nullptr) return ask_sheets();
  if (free_corners_.empty()) return std::nullopt;
  const std::size_t i = free_corners_.front();
  return FreeCorner{i, oracle_.around(make_point(input_, SymbolicPoint::input(corners_[i])), operand_)};
}

std::optional<FaceSplitter::FreeCorner> FaceSplitter::ask_sheets() const {
  for (const std::size_t i : free_corners_)
    if (const auto above = sheets_->above_vertex(corners_[i])) {
      FreeCorner corner{i, {}};
      corner.windings.add(operand_, *above);
      return corner;
    }
  return std::nullopt;
}

void FaceSplitter::remember_corners() {
  for (const std::size_t i : free_corners_) {
    const Windings& w = regions_[at(region_at_corner_[i])].above;
    known_corners_.remember(corners_[i], w);
    early_out_.tell(corners_[i], w);
  }
}

/// The points with weights (1, t, t^2) lie on a conic, which a line meets in at most two points. So at most two of
/// them lie on each constraint and one on each isolated point, and the search ends.
FaceSplitter::Start FaceSplitter::start_inside() {
  for (std::uint32_t t = 1; t <= SymbolicPoint::weight_limit; ++t) {
    const Point q = make_point(input_, SymbolicPoint::weighted(face_, t));
    const auto l = triangulation_.locate(q);
    using On = Triangulation::Location::On;
    if (l.on == On::vertex) continue;
    if (l.on == On::side && triangulation_.triangles()[at(l.triangle)].c[at(l.index)] >= 0) continue;
    Region region;
    for (const std::uint32_t g : covering_.coplanar())
      if (covering_.covers(g, q)) region.covers.push_back(g);
    region.above = above_at(q.name, region.covers);
    return {l.triangle, region};
  }
  fail("no point inside a face off its constraints", face_);
}

/// Winding numbers just above q, of the other operands where operands are solids. `covers`: the other faces through q.
Windings FaceSplitter::above_at(const SymbolicPoint& q, const std::vector<std::uint32_t>& covers) {
  if (!rule_.looks_around()) return {};
  if (!self_)
    if (auto known = covering_.above(covers)) return *std::move(known);
  std::vector<std::uint32_t> covering = covers;
  covering.push_back(face_);
  Windings w = oracle_.above(face_, make_point(input_, q), covering);
  if (!self_) w.set(operand_, 0);
  return w;
}

/// Traverses the triangles from a start: inside a region without change, and across a side with the changes recorded on
/// it.
void FaceSplitter::spread(Start from) {
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
    if (region_of_[at(n)] < 0) enter(n, across_notes(regions_[at(region_of_[at(t)])], triangles[at(t)].c[at(side)]));
  }
  for (std::size_t i = 0; i < 3; ++i) region_at_corner_[i] = region_of_[at(triangle_at_corner(i))];
}

/// The region on the right of a side from the one on its left.
FaceSplitter::Region FaceSplitter::across_notes(Region region, std::int32_t first_note) const {
  for (std::int32_t n = first_note; n >= 0; n = triangulation_.note(n).next)
    cross(region, at(triangulation_.note(n).constraint), triangulation_.note(n).forward);
  return region;
}

/// Moves from the left of a constraint, or of its reverse, to the right.
void FaceSplitter::cross(Region& region, std::size_t constraint, bool forward) const {
  const Constraint& c = constraints_[constraint];
  switch (c.kind) {
    case ConstraintKind::crossing:
      if (rule_.looks_around()) region.above.add(input_.operand_of_face(c.other), forward ? -1 : 1);
      break;
    case ConstraintKind::cover_left:
      cover(region, c.other, !forward);
      break;
    case ConstraintKind::cover_right:
      cover(region, c.other, forward);
      break;
    case ConstraintKind::point:
    case ConstraintKind::touch:
    case ConstraintKind::coplanar:
      break;
  }
}

void FaceSplitter::cover(Region& region, std::uint32_t g, bool enters) {
  const auto where = std::lower_bound(region.covers.begin(), region.covers.end(), g);
  const bool there = where != region.covers.end() && *where == g;
  if (enters && !there) region.covers.insert(where, g);
  if (!enters && there) region.covers.erase(where);
}

void FaceSplitter::judge() {
  verdicts_.clear();
  for (const Region& r : regions_) verdicts_.push_back(verdict_on(r));
}

Verdict FaceSplitter::verdict_on(const Region& r) const {
  const bool is_lowest = r.covers.empty() || r.covers.front() > face_;
  if (!is_lowest && !rule_.asks_for_keepers()) return Verdict::drop;  // that one speaks for all
  if (rule_.keeps_covers()) return Verdict::keep;
  if (!rule_.looks_around()) {
    const auto looks_back = [&](std::uint32_t g) { return same_orientation(input_, face_, g) == Sign::negative; };
    return std::any_of(r.covers.begin(), r.covers.end(), looks_back) ? Verdict::drop : Verdict::keep;
  }
  Windings below = r.above;
  below.add(operand_, 1);
  for (const std::uint32_t g : r.covers)
    below.add(input_.operand_of_face(g), to_int(same_orientation(input_, face_, g)));
  const Verdict found = verdict(rule_.inside(r.above), rule_.inside(below));
  const bool is_asked = found != Verdict::drop && !r.covers.empty() && rule_.asks_for_keepers();
  return is_asked && representative(r, below) != face_ ? Verdict::drop : found;
}

/// An operand keeps a piece where its own faces, crossed alone, change the rule's value: before the others are crossed,
/// or after them. Its lowest face with the orientation of all of them together represents the piece; if there is no
/// such operand, the lowest face of all. Seen from a face that is turned round, above and below are exchanged: the
/// same.
std::uint32_t FaceSplitter::representative(const Region& r, const Windings& below) const {
  std::vector<std::uint32_t> faces = r.covers;
  faces.insert(std::lower_bound(faces.begin(), faces.end(), face_), face_);
  const auto orientation = [&](std::uint32_t g) { return g == face_ ? 1 : to_int(same_orientation(input_, face_, g)); };
  const bool above_is_inside = rule_.inside(r.above), below_is_inside = rule_.inside(below);
  for (auto first = faces.begin(); first != faces.end();) {
    const std::uint32_t operand = input_.operand_of_face(*first);
    const auto last =
        std::find_if(first, faces.end(), [&](std::uint32_t g) { return input_.operand_of_face(g) != operand; });
    int net = 0;
    for (auto g = first; g != last; ++g) net += orientation(*g);
    Windings alone = r.above, all_others = below;
    alone.add(operand, net);
    all_others.add(operand, -net);
    if (net != 0 && (rule_.inside(alone) != above_is_inside || rule_.inside(all_others) != below_is_inside))
      return *std::find_if(first, last, [&](std::uint32_t g) { return (orientation(g) > 0) == (net > 0); });
    first = last;
  }
  return faces.front();
}

void FaceSplitter::collect() {
  const auto triangles = triangulation_.triangles();
  kept_index_.assign(at(triangulation_.points().size()), -1);
  const auto verdict_of = [&](std::int32_t t) { return t < 0 ? Verdict::drop : verdicts_[at(region_of_[at(t)])]; };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Verdict verdict = verdict_of(static_cast<std::int32_t>(t));
    if (verdict == Verdict::drop) continue;
    PieceTriangle piece;
    piece.reversed = verdict == Verdict::keep_reversed;
    for (std::size_t i = 0; i < 3; ++i) {
      // Reversed triangles run c, b, a: side i of the result is side 1 - i (mod 3) of the triangle.
      const std::size_t vertex = piece.reversed ? 2 - i : i, side = piece.reversed ? (4 - i) % 3 : i;
      const std::int32_t v = triangles[t].v[vertex];
      if (kept_index_[at(v)] < 0) {
        kept_index_[at(v)] = static_cast<std::int32_t>(kept_.points.size());
        kept_.points.push_back(number_of(v));
      }
      piece.v[i] = static_cast<std::uint32_t>(kept_index_[at(v)]);
      const auto bit = static_cast<std::uint8_t>(1u << i);
      if (verdict_of(triangles[t].n[side]) != verdict) piece.boundary |= bit;
      if (triangles[t].c[side] >= 0) piece.carried |= bit;
    }
    keep_covers(regions_[at(region_of_[t])]);
    kept_.triangles.push_back(piece);
  }
}

PointId FaceSplitter::number_of(std::int32_t v) {
  const FacePoints& points = triangulation_.points();
  if (points.id(v) != FacePoints::unnumbered) return points.id(v);
  kept_.constructed.push_back(points[v].name);
  return points_.end() + static_cast<PointId>(kept_.constructed.size() - 1);
}

}  // namespace strata
