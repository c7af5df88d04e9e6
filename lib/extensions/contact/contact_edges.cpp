#include "extensions/contact/contact_edges.h"

#include <algorithm>
#include <map>

#include "core/kernel/box.h"
#include "core/kernel/filters.h"
#include "extensions/contact/convex_polygon.h"
#include "extensions/contact/line_intervals.h"

namespace strata::contact {
namespace {

bool is_zero(const RationalPoint& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }

/// A line: its direction with first nonzero component 1, and the point in which that coordinate is 0. Equal for equal
/// lines. The coordinate is the line's parameter.
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

/// The polygons with their boxes, of nearest doubles: rounding is monotone, so objects that meet have boxes that meet.
class BoxedPolygons {
 public:
  explicit BoxedPolygons(const SharedPieces& pieces) : pieces_(pieces), boxes_(pieces.polygons.size()) {
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      for (const std::uint32_t n : pieces.polygons[i]) boxes_[i].include(pieces.places.nearest(n));
  }
  /// Calls `visit(polygon)` for those whose boxes meet a box; stops and returns false when `visit` does.
  template <class Visit>
  bool for_each_near(const Box& box, const Visit& visit) const {
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      if (boxes_[i].overlaps(box) && !visit(polygon(i))) return false;
    return true;
  }

 private:
  [[nodiscard]] ConvexPolygon polygon(std::size_t i) const {
    std::vector<RationalPoint> corners;
    for (const std::uint32_t n : pieces_.polygons[i]) corners.push_back(pieces_.places[n]);
    return ConvexPolygon(std::move(corners));
  }

  const SharedPieces& pieces_;
  std::vector<Box> boxes_;
};

Box box_of(const RationalPoint& p, const RationalPoint& q) {
  Box box;
  for (const RationalPoint* r : {&p, &q})
    box.include(Vertex{to_nearest_double((*r)[0]), to_nearest_double((*r)[1]), to_nearest_double((*r)[2])});
  return box;
}

bool is_on(const RationalSegment& segment, const RationalPoint& p) {
  if (!is_zero(cross<Rational>(segment[1] - segment[0], p - segment[0]))) return false;
  return segment[0] <= p && p <= segment[1];
}

/// The parts of intervals of a line that the interiors of polygons cover.
Intervals inside_polygons(const BoxedPolygons& polygons, const Line& line, const Intervals& intervals) {
  Intervals covered;
  for (const auto& [from, to] : intervals)
    polygons.for_each_near(box_of(line.at(from), line.at(to)), [&](const ConvexPolygon& polygon) {
      if (const auto part = polygon.part_of_line(line.base, line.direction)) covered.push_back(*part);
      return true;
    });
  return covered;
}

}  // namespace

std::vector<RationalSegment> contact_edges(const SharedPieces& pieces, const Monitor& monitor) {
  std::map<Line, OnLine> lines;
  const Places& places = pieces.places;
  for (const auto& [p, q] : pieces.segments) {
    monitor.check();
    const Line line(places[p], places[q]);
    lines[line].all.push_back(line.between(places[p], places[q]));
  }
  if (lines.empty()) return {};
  for (const auto& [p, q] : pieces.sides) {
    monitor.check();
    if (const auto at = lines.find(Line(places[p], places[q])); at != lines.end())
      at->second.taken.push_back(at->first.between(places[p], places[q]));
  }
  const BoxedPolygons polygons(pieces);
  std::vector<RationalSegment> edges;
  for (const auto& [line, intervals] : lines) {
    monitor.check();
    const Intervals beside_sides = without(intervals.all, intervals.taken);
    for (const auto& [from, to] : without(beside_sides, inside_polygons(polygons, line, beside_sides)))
      edges.push_back({line.at(from), line.at(to)});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<RationalPoint> isolated_points(const SharedPieces& pieces, const std::vector<RationalSegment>& edges,
                                           const Monitor& monitor) {
  std::vector<RationalPoint> isolated;
  if (pieces.points.empty()) return isolated;
  const BoxedPolygons polygons(pieces);
  for (const std::uint32_t n : pieces.points) {
    monitor.check();
    const RationalPoint& p = pieces.places[n];
    if (std::any_of(edges.begin(), edges.end(), [&](const RationalSegment& e) { return is_on(e, p); })) continue;
    const bool is_free = polygons.for_each_near(box_of(p, p), [&](const ConvexPolygon& q) { return !q.has(p); });
    if (is_free) isolated.push_back(p);
  }
  std::sort(isolated.begin(), isolated.end());
  return isolated;
}

}  // namespace strata::contact
