#include "extensions/planar/extract.h"

#include <algorithm>
#include <numeric>

#include "extensions/planar/boundary.h"
#include "extensions/planar/predicates.h"

namespace strata::planar {
namespace {

/// A corner of a loop in the arrangement's numbers: a vertex, and the segment of the edge that leaves it, along the
/// segment or against it. (The segment's line has the same number.) If the segment represents an isolated chain, the
/// chain leaves the vertex.
struct Corner {
  std::uint32_t vertex = 0, line = 0;
  bool against = false;
};

/// Requires that neither is an isolated chain.
Sign orientation_at(const Places& places, const Corner& in, const Corner& out) {
  const Sign s = cross(places, in.line, out.line);
  return in.against == out.against ? s : -s;
}

/// Loops of corners, each from its least vertex.
struct CornerLoops {
  std::vector<Corner> corners;
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint8_t> is_outer;  ///< of every loop: counter-clockwise
};

class CornerFinder {
 public:
  CornerFinder(const Arrangement& a, const Subdivision& s)
      : a_(a), s_(s), is_visited_(a.places.size()), is_shared_(a.places.size()) {}

  CornerLoops find(const BoundaryLoops& loops) {
    std::size_t pieces = 0;
    for (const std::uint32_t h : loops.half_edges) pieces += s_.pieces_of(h >> 1);
    result_.corners.reserve(pieces);
    loop_.reserve(pieces);
    for (const std::uint32_t h : loops.half_edges) {
      const std::uint32_t node = origin(a_, s_, h);
      is_shared_[node] |= is_visited_[node];
      is_visited_[node] = 1;
    }
    for (std::size_t l = 0; l + 1 < loops.first.size(); ++l) {
      loop_.clear();
      for (std::uint32_t i = loops.first[l]; i < loops.first[l + 1]; ++i) add_chain(loops.half_edges[i]);
      add_loop();
    }
    return std::move(result_);
  }

 private:
  void add_chain(std::uint32_t half_edge) {
    const std::size_t begin = loop_.size();
    const bool against = (half_edge & 1) != 0;
    s_.for_each_piece(half_edge >> 1, [&](std::uint32_t k) {
      loop_.push_back({a_.pieces[k][against ? 1 : 0], a_.segment_of[k], against});
    });
    if (against) std::reverse(loop_.begin() + static_cast<std::ptrdiff_t>(begin), loop_.end());
  }
  /// Omits vertices where the loop goes straight on and which no other loop has; begins at the least vertex.
  void add_loop() {
    std::vector<Corner>& all = result_.corners;
    const std::size_t begin = all.size();
    const Corner* before = &loop_.back();
    for (const Corner& corner : loop_) {
      if (is_corner(*before, corner)) all.push_back(corner);
      before = &corner;
    }
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto least = std::min_element(first, all.end(), [&](const Corner& p, const Corner& q) {
      return compare_xy(a_.places, p.vertex, q.vertex) == Sign::negative;
    });
    std::rotate(first, least, all.end());
    result_.is_outer.push_back(orientation_at(a_.places, all.back(), *first) == Sign::positive);
    result_.first.push_back(static_cast<std::uint32_t>(all.size()));
  }
  /// Isolated chains have corners at both ends.
  [[nodiscard]] bool is_corner(const Corner& before, const Corner& corner) const {
    return is_shared_[corner.vertex] || a_.chains.holds(before.line) || a_.chains.holds(corner.line) ||
           orientation_at(a_.places, before, corner) != Sign::zero;
  }

  const Arrangement& a_;
  const Subdivision& s_;
  std::vector<std::uint8_t> is_visited_, is_shared_;  ///< of every vertex: by the boundary once, more than once
  std::vector<Corner> loop_;
  CornerLoops result_;
};

/// Loops by polygon, outer loop first. Polygons and holes are sorted by their least vertices, and by the next vertices
/// where these are equal: no two loops have an edge in common.
std::vector<std::uint32_t> order_loops(const Places& places, const BoundaryLoops& loops, const CornerLoops& corners,
                                       std::vector<std::uint32_t>& first_loop) {
  const auto count = static_cast<std::uint32_t>(loops.component.size());
  const auto is_before = [&](std::uint32_t l, std::uint32_t m) {
    const Corner *p = &corners.corners[corners.first[l]], *q = &corners.corners[corners.first[m]];
    const Sign s = compare_xy(places, p[0].vertex, q[0].vertex);
    return (s != Sign::zero ? s : compare_xy(places, p[1].vertex, q[1].vertex)) == Sign::negative;
  };
  std::vector<std::uint32_t> outer_of(
      loops.component.empty() ? 0 : *std::max_element(loops.component.begin(), loops.component.end()) + 1, none);
  for (std::uint32_t l = 0; l < count; ++l)
    if (corners.is_outer[l]) outer_of[loops.component[l]] = l;
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t l, std::uint32_t m) {
    const std::uint32_t p = outer_of[loops.component[l]], q = outer_of[loops.component[m]];
    if (p != q) return is_before(p, q);
    if (corners.is_outer[l] != corners.is_outer[m]) return corners.is_outer[l] > corners.is_outer[m];
    return is_before(l, m);
  });
  for (std::uint32_t i = 0; i < count; ++i)
    if (i > 0 && corners.is_outer[order[i]]) first_loop.push_back(i);
  if (count > 0) first_loop.push_back(count);
  return order;
}

/// Copies the points and lines that a region needs into its own numbering.
class PlacesCopy {
 public:
  PlacesCopy(const Places& from, Places& to)
      : from_(from), to_(to), point_(from.size(), none), line_(from.lines.size(), none) {}

  void need_point(std::uint32_t p) {
    if (std::exchange(point_[p], 0) != none || !from_.is_meet(p)) return;
    need_line(from_.meet(p).first);
    need_line(from_.meet(p).second);
  }
  void need_line(std::uint32_t l) {
    if (std::exchange(line_[l], 0) != none) return;
    need_point(from_.lines[l].from);
    need_point(from_.lines[l].to);
  }
  /// The number of points of the copy.
  [[nodiscard]] std::size_t points() const {
    return static_cast<std::size_t>(
        std::count_if(point_.begin(), point_.end(), [](std::uint32_t number) { return number != none; }));
  }
  void copy() {
    for (std::uint32_t p = 0; p < from_.given(); ++p)
      if (point_[p] != none) point_[p] = add_given(p);
    for (std::uint32_t l = 0; l < from_.lines.size(); ++l) {
      if (line_[l] == none) continue;
      line_[l] = static_cast<std::uint32_t>(to_.lines.size());
      to_.lines.push_back({point_[from_.lines[l].from], point_[from_.lines[l].to]});
    }
    for (std::uint32_t p = from_.given(); p < from_.size(); ++p)
      if (point_[p] != none) point_[p] = add_meet(p);
  }
  [[nodiscard]] std::uint32_t point(std::uint32_t p) const { return point_[p]; }
  [[nodiscard]] std::uint32_t line(std::uint32_t l) const { return line_[l]; }

 private:
  std::uint32_t add_given(std::uint32_t p) {
    to_.place.push_back(from_.place[p]);
    if (from_.is_double(p)) return to_.size() - 1;
    to_.error.push_back(from_.error[p - from_.doubles()]);
    to_.rationals.push_back(from_.rational(p));
    return to_.size() - 1;
  }
  /// Adds a meet with its nearest doubles, which are at most half a unit in the last place off.
  std::uint32_t add_meet(std::uint32_t p) {
    const PlanePoint known = from_.error[p - from_.doubles()], nearest = nearest_place(from_, p);
    PlanePoint error;
    for (std::size_t i = 0; i < 2; ++i)
      error[i] = known[i] == 0 ? 0 : std::abs(nearest[i]) * Bounded::rounding + Bounded::underflow;
    to_.place.push_back(nearest);
    to_.error.push_back(error);
    const Meet& m = from_.meet(p);
    to_.meets.push_back({line_[m.first], line_[m.second]});
    return to_.size() - 1;
  }

  const Places& from_;
  Places& to_;
  std::vector<std::uint32_t> point_, line_;
};

/// Writes loops of corners as loops of a region, isolated chains with all their inner vertices.
class LoopWriter {
 public:
  LoopWriter(const Arrangement& a, const CornerLoops& corners, Loops& to)
      : a_(a), corners_(corners), to_(to), copy_(a.places, to.places) {}

  void write(const std::vector<std::uint32_t>& order) {
    std::size_t inside = 0;
    for_each_corner(order, [&](const Corner& c, const Corner& next) {
      copy_.need_point(c.vertex);
      if (needs_line(c, next)) copy_.need_line(c.line);
      if (a_.chains.holds(c.line)) inside += a_.chains.of(c.line).last - a_.chains.of(c.line).first - 1;
    });
    to_.places.place.reserve(inside + copy_.points());
    for_each_corner(order, [&](const Corner& c, const Corner&) {
      if (a_.chains.holds(c.line)) add_inside(c);
    });
    to_.vertices.reserve(corners_.corners.size() + to_.places.size());
    to_.edge_line.reserve(corners_.corners.size() + to_.places.size());
    copy_.copy();
    add_loops(order);
  }

 private:
  /// visit(corner, next corner), in the order of the result.
  template <class Visit>
  void for_each_corner(std::span<const std::uint32_t> order, const Visit& visit) const {
    for (const std::uint32_t l : order)
      for (std::uint32_t i = corners_.first[l], end = corners_.first[l + 1]; i < end; ++i)
        visit(corners_.corners[i], corners_.corners[i + 1 < end ? i + 1 : corners_.first[l]]);
  }
  [[nodiscard]] bool needs_line(const Corner& from, const Corner& to) const {
    return a_.places.is_meet(from.vertex) || a_.places.is_meet(to.vertex);
  }
  /// Adds the inner vertices of an isolated chain that are corners, in the order of the loop: the first points of the
  /// result.
  void add_inside(const Corner& corner) {
    const MonotoneChain& s = a_.chains.of(corner.line);
    std::vector<PlanePoint>& place = to_.places.place;
    const std::size_t begin = place.size();
    PlanePoint before = s.point(s.first), at = s.point(s.first + 1);
    for (std::uint32_t i = s.first + 2; i <= s.last; ++i) {
      const PlanePoint after = s.point(i);
      if (orientation(before, at, after) != Sign::zero) place.push_back(at);
      before = at;
      at = after;
    }
    if (corner.against) std::reverse(place.begin() + static_cast<std::ptrdiff_t>(begin), place.end());
    inside_.push_back(static_cast<std::uint32_t>(place.size() - begin));
  }
  void add_loops(const std::vector<std::uint32_t>& order) {
    std::uint32_t next_inside = 0;
    auto count = inside_.begin();
    for (const std::uint32_t l : order) {
      for_each_corner({&l, 1}, [&](const Corner& c, const Corner& next) {
        to_.vertices.push_back(copy_.point(c.vertex));
        to_.edge_line.push_back(needs_line(c, next) ? copy_.line(c.line) : none);
        if (!a_.chains.holds(c.line)) return;
        for (const std::uint32_t end = next_inside + *count++; next_inside < end;)
          to_.vertices.push_back(next_inside++);
        to_.edge_line.resize(to_.vertices.size(), none);
      });
      to_.first_vertex.push_back(static_cast<std::uint32_t>(to_.vertices.size()));
    }
  }

  const Arrangement& a_;
  const CornerLoops& corners_;
  Loops& to_;
  PlacesCopy copy_;
  std::vector<std::uint32_t> inside_;  ///< of every isolated chain, in the order of the result: its number of vertices
};

}  // namespace

Region extract(const Arrangement& a, const Subdivision& s, const std::vector<std::uint8_t>& label) {
  const BoundaryLoops boundary = boundary_loops(a, s, label);
  const CornerLoops corners = CornerFinder(a, s).find(boundary);
  Region region;
  const std::vector<std::uint32_t> order = order_loops(a.places, boundary, corners, region.first_loop);
  LoopWriter(a, corners, region.loops).write(order);
  return region;
}

}  // namespace strata::planar
