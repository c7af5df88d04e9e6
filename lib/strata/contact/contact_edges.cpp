#include "strata/contact/contact_edges.h"

#include <algorithm>
#include <map>

#include "strata/contact/line_intervals.h"
#include "strata/kernel/box.h"
#include "strata/kernel/filters.h"

namespace strata::contact {
namespace {

bool is_zero(const RationalPoint& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }

/// A line: its direction with first component 1 that is not 0, and the point in which that coordinate is 0. Equal for
/// equal lines. The coordinate is the line's parameter.
struct Line {
  std::size_t axis = 0;
  RationalPoint direction, base;

  Line(const RationalPoint& p, const RationalPoint& q) : direction(q - p) {
    while (direction[axis].is_zero()) ++axis;
    const Rational scale = direction[axis];
    for (Rational& x : direction) x /= scale;
    base = at(p, -p[axis]);
  }
  [[nodiscard]] RationalPoint at(const RationalPoint& from, const Rational& t) const {
    RationalPoint r;
    for (std::size_t i = 0; i < 3; ++i) r[i] = from[i] + t * direction[i];
    return r;
  }
  [[nodiscard]] RationalPoint at(const Rational& t) const { return at(base, t); }
  [[nodiscard]] Interval between(const RationalPoint& p, const RationalPoint& q) const {
    return std::minmax(p[axis], q[axis]);
  }
  friend bool operator<(const Line& a, const Line& b) {
    return a.direction != b.direction ? a.direction < b.direction : a.base < b.base;
  }
};

struct OnLine {
  Intervals all, taken;
};

/// A convex polygon with its box.
class ConvexPiece {
 public:
  ConvexPiece(const SharedPieces& pieces, const SharedPieces::Polygon& polygon) {
    for (const std::uint32_t n : polygon) {
      corners_.push_back(pieces.places[n]);
      box_.include(pieces.places.nearest(n));
    }
    normal_ = cross<Rational>(corners_[1] - corners_[0], corners_[2] - corners_[0]);
  }
  /// Of nearest doubles: rounding is monotone, so boxes of what meets meet.
  [[nodiscard]] const Box& box() const { return box_; }

  [[nodiscard]] bool has(const RationalPoint& p) const {
    if (!dot<Rational>(normal_, p - corners_[0]).is_zero()) return false;
    for (std::size_t i = 0; i < corners_.size(); ++i)
      if (dot<Rational>(inward(i), p - corners_[i]).sign() < 0) return false;
    return true;
  }

 private:
  [[nodiscard]] RationalPoint inward(std::size_t i) const {
    return cross<Rational>(normal_, corners_[(i + 1) % corners_.size()] - corners_[i]);
  }
  std::vector<RationalPoint> corners_;
  RationalPoint normal_;
  Box box_;
};

std::vector<ConvexPiece> convex_pieces(const SharedPieces& pieces) {
  std::vector<ConvexPiece> list;
  list.reserve(pieces.polygons.size());
  for (const auto& polygon : pieces.polygons) list.emplace_back(pieces, polygon);
  return list;
}

bool is_on(const RationalSegment& segment, const RationalPoint& p) {
  if (!is_zero(cross<Rational>(segment[1] - segment[0], p - segment[0]))) return false;
  return segment[0] <= p && p <= segment[1];
}

}  // namespace

std::vector<RationalSegment> contact_edges(const SharedPieces& pieces) {
  std::map<Line, OnLine> lines;
  const Places& places = pieces.places;
  for (const auto& [p, q] : pieces.segments) {
    const Line line(places[p], places[q]);
    lines[line].all.push_back(line.between(places[p], places[q]));
  }
  if (lines.empty()) return {};
  for (const auto& [p, q] : pieces.sides)
    if (const auto at = lines.find(Line(places[p], places[q])); at != lines.end())
      at->second.taken.push_back(at->first.between(places[p], places[q]));
  std::vector<RationalSegment> edges;
  for (const auto& [line, intervals] : lines)
    for (const auto& [from, to] : without(intervals.all, intervals.taken))
      edges.push_back({line.at(from), line.at(to)});
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<RationalPoint> isolated_points(const SharedPieces& pieces, const std::vector<RationalSegment>& edges) {
  std::vector<RationalPoint> isolated;
  if (pieces.points.empty()) return isolated;
  const std::vector<ConvexPiece> convex = convex_pieces(pieces);
  for (const std::uint32_t n : pieces.points) {
    const RationalPoint& p = pieces.places[n];
    Box box;
    box.include(pieces.places.nearest(n));
    const auto covers = [&](const ConvexPiece& piece) { return piece.box().overlaps(box) && piece.has(p); };
    if (std::any_of(edges.begin(), edges.end(), [&](const RationalSegment& e) { return is_on(e, p); })) continue;
    if (std::any_of(convex.begin(), convex.end(), covers)) continue;
    isolated.push_back(p);
  }
  std::sort(isolated.begin(), isolated.end());
  return isolated;
}

}  // namespace strata::contact
