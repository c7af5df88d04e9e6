#include "core/select/covering.h"

#include <algorithm>
#include <array>

namespace strata {

void Covering::start(std::span<const Constraint> constraints) {
  constraints_ = constraints;
  coplanar_.clear();
  for (const Constraint& c : constraints)
    if (c.kind == ConstraintKind::coplanar) coplanar_.push_back(c.other);
  if (!coplanar_.empty()) begin(constraints.front().face);
}

void Covering::begin(std::uint32_t face) {
  if (face == face_ && projection_) return;
  face_ = face;
  operand_ = input_.operand_of_face(face);
  projection_.reset();
}

std::optional<Windings> Covering::above(std::span<const std::uint32_t> covers) {
  find_sheets(covers);
  if (sheets_.size() + 1 < input_.operand_count()) return std::nullopt;
  Windings w;
  for (const Sheet& s : sheets_) {
    if (!s.is_decisive()) return std::nullopt;
    w.add(s.operand, s.above());
  }
  return w;
}

bool Covering::leaves_nothing(std::span<const std::uint32_t> covers) {
  find_sheets(covers);
  // Where several operands decide, they decide alike.
  std::optional<bool> above = rule_.settled(operand_, 0), below = rule_.settled(operand_, 1);
  for (const Sheet& s : sheets_) {
    if (!s.is_decisive()) continue;
    if (s.operand < operand_ && !rule_.asks_for_keepers()) return true;
    if (!above) above = rule_.settled(s.operand, s.above());
    if (!below) below = rule_.settled(s.operand, s.below());
  }
  return above && below && *above == *below;
}

bool Covering::hides_face() { return meets_coplanar_faces_only() && hides(face_, coplanar_); }

/// A point on an edge determines less, so another point is tried: the points with weights (1, t, t^2) lie on a conic,
/// and few of them on one edge.
bool Covering::hides(std::uint32_t face, std::span<const std::uint32_t> coplanar) {
  begin(face);
  constexpr std::uint32_t tries = 4;
  for (std::uint32_t t = 2; t < 2 + tries; ++t) {
    const Point q = make_point(input_, SymbolicPoint::weighted(face_, t));
    covers_.clear();
    bool on_edge = false;
    for (std::size_t i = 0; i < coplanar.size() && !on_edge; ++i) {
      const Place place = place_in(coplanar[i], q);
      on_edge = place == Place::border;
      if (place == Place::inside) covers_.push_back(coplanar[i]);
    }
    if (!on_edge) return leaves_nothing(covers_);
  }
  return false;
}

/// The constraints with one other face are consecutive, `coplanar` being the first.
bool Covering::meets_coplanar_faces_only() const {
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const bool coplanar = constraints_[i].kind == ConstraintKind::coplanar;
    if (!coplanar && (i == 0 || constraints_[i].other != constraints_[i - 1].other)) return false;
  }
  return true;
}

void Covering::find_sheets(std::span<const std::uint32_t> covers) {
  sheets_.clear();
  for (const std::uint32_t g : covers) {
    const std::uint32_t operand = input_.operand_of_face(g);
    if (sheets_.empty() || sheets_.back().operand != operand) sheets_.push_back({operand, 0});
    sheets_.back().net += to_int(same_orientation(input_, face_, g));
  }
}

Covering::Place Covering::place_in(std::uint32_t g, const Point& q) {
  if (!projection_) projection_ = projection_of(input_, face_);
  const auto v = input_.face(g);
  if (is_beyond_box(v, *projection_, q)) return Place::outside;
  std::array<Point, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = make_point(input_, SymbolicPoint::input(v[i]));
  const Sign a = orient2d(input_, *projection_, p[0], p[1], q), b = orient2d(input_, *projection_, p[1], p[2], q);
  if (a * b == Sign::negative) return Place::outside;
  const Sign c = orient2d(input_, *projection_, p[2], p[0], q);
  if (a * c == Sign::negative || b * c == Sign::negative) return Place::outside;
  return a * b * c == Sign::zero ? Place::border : Place::inside;
}

/// True when q is certainly beyond the box of a triangle, in a projection. A rational corner rounds to its doubles, so
/// what is beyond these is beyond the corner.
bool Covering::is_beyond_box(const InputComplex::Indices& triangle, Projection projection, const Point& q) const {
  const auto &a = input_.vertex(triangle[0]), &b = input_.vertex(triangle[1]), &c = input_.vertex(triangle[2]);
  for (const int axis : {projection.u, projection.v}) {
    const auto i = static_cast<std::size_t>(axis);
    if (q.at[i].upper() < std::min({a[i], b[i], c[i]}) || q.at[i].lower() > std::max({a[i], b[i], c[i]})) return true;
  }
  return false;
}

}  // namespace strata
