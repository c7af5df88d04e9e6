#include "extensions/planar/nesting.h"

#include "extensions/planar/predicates.h"
#include "extensions/planar/sweep_line.h"

namespace strata::planar {
namespace {

/// A piece that a ray to the left meets, directed upwards.
struct Crossed {
  std::uint32_t piece = none, segment = 0, low = 0, high = 0;
  bool upward = false;
};

/// True when q lies to the right of p at the ray's height. Pieces do not cross; from a common lower end they separate
/// or coincide. (No two pieces with a common lower end are isolated chains: the edge next to a chain comes from below
/// it, or is horizontal.)
bool is_right_of(const Arrangement& a, const Crossed& p, const Crossed& q) {
  const auto side_of = [&](std::uint32_t v, const Crossed& c) {
    const Sign s = a.chains.side(a.places, v, c.segment);
    return c.upward ? s : -s;
  };
  if (p.low != q.low) {
    if (compare(a.places, p.low, q.low, 1) != Sign::positive) {
      if (const Sign s = side_of(q.low, p); s != Sign::zero) return s == Sign::negative;
    } else if (const Sign s = side_of(p.low, q); s != Sign::zero) {
      return s == Sign::positive;
    }
  }
  const Sign orientation = cross(a.places, p.segment, q.segment);
  return (p.upward == q.upward ? orientation : -orientation) == Sign::negative;
}

/// A ray to the left from a component's least vertex (x, y), starting at (x - e^2, y + e). Segments of the vertex's own
/// component have no point to the left of it and are not met; others do not contain the vertex.
class LeftwardRay {
 public:
  LeftwardRay(const Arrangement& a, std::uint32_t vertex) : a_(a), vertex_(vertex) {}

  /// The first piece that the ray meets. Adds the number of tested segments to `looked_at`.
  [[nodiscard]] Crossed nearest(std::size_t& looked_at) {
    const Bounded y = bounded(a_.places, vertex_, 1);
    const std::uint32_t first = a_.strips->strip_of(y.lower()), last = a_.strips->strip_of(y.upper());
    for (std::uint32_t k = first; k <= last; ++k) look_through(k);
    looked_at += looked_at_;
    return nearest_;
  }

 private:
  /// From right to left, while a nearer segment is possible.
  void look_through(std::uint32_t strip) {
    const auto runs = a_.strips->segments(strip);
    const auto lefts = a_.strips->lefts(strip);
    const double widest = a_.strips->widest(strip) * (1 + 0x1p-50);
    const double x = bounded(a_.places, vertex_, 0).upper();
    double bound = -HUGE_VAL;  // segments that end to the left of it are not nearest
    for (std::size_t i = static_cast<std::size_t>(std::upper_bound(lefts.begin(), lefts.end(), x) - lefts.begin());
         i-- > 0;) {
      if (lefts[i] + widest < bound) return;
      ++looked_at_;
      const std::uint32_t run = runs[i];
      if (a_.strips->box(run).right < bound) continue;
      for (std::uint32_t s = a_.runs[run].first; s < a_.runs[run].end; ++s)
        if (meet(s)) bound = lefts[i];
    }
  }
  /// True if a segment becomes the nearest one.
  bool meet(std::uint32_t segment) {
    const bool starts_below = is_below(a_.ends[segment][0]);
    if (starts_below == is_below(a_.ends[segment][1])) return false;
    if (a_.chains.side(a_.places, vertex_, segment) != (starts_below ? Sign::negative : Sign::positive)) return false;
    const std::uint32_t piece = piece_of(segment, starts_below);
    const auto [from, to] = a_.pieces[piece];
    const Crossed met{piece, segment, starts_below ? from : to, starts_below ? to : from, starts_below};
    if (nearest_.piece != none && !is_right_of(a_, nearest_, met)) return false;
    nearest_ = met;
    return true;
  }
  [[nodiscard]] std::uint32_t piece_of(std::uint32_t segment, bool upward) const {
    const std::uint32_t first = a_.first_piece[segment], end = a_.first_piece[segment + 1];
    const auto at = std::partition_point(a_.pieces.begin() + first, a_.pieces.begin() + end,
                                         [&](const auto& piece) { return is_below(piece[1]) == upward; });
    return static_cast<std::uint32_t>(at - a_.pieces.begin());
  }
  [[nodiscard]] bool is_below(std::uint32_t p) const { return compare(a_.places, p, vertex_, 1) != Sign::positive; }

  const Arrangement& a_;
  std::uint32_t vertex_;
  Crossed nearest_;
  std::size_t looked_at_ = 0;
};

}  // namespace

std::uint32_t Nesting::container_of(std::uint32_t vertex) {
  if (below_.empty() && looked_at_ >= patience_ * a_.pieces.size()) sweep();
  if (!below_.empty()) return below_[vertex];
  const Crossed nearest = LeftwardRay(a_, vertex).nearest(looked_at_);
  if (nearest.piece == none) return none;
  const std::uint32_t chain = chain_of(nearest.piece);
  const bool is_edge_upward = nearest.upward != (s_.is_opposite[chain] != 0);
  return 2 * s_.edge_of[chain] + (is_edge_upward ? 1 : 0);  // the face to the right of an upward edge
}

std::uint32_t Nesting::chain_of(std::uint32_t piece) {
  if (chain_.empty()) {
    chain_.resize(a_.pieces.size());
    for (std::uint32_t c = 0; c < s_.chains.size(); ++c) s_.for_each_piece(c, [&](std::uint32_t k) { chain_[k] = c; });
  }
  return chain_[piece];
}

/// Sweeps the pieces of all edges, each once. They meet in common ends only. The piece directly below a vertex at which
/// no piece arrives is below its component.
void Nesting::sweep() {
  std::vector<SweptSegment> pieces;
  std::vector<std::uint32_t> half_edge;  // of every piece, along it
  for (std::uint32_t c = 0; c < s_.chains.size(); ++c) {
    if (!s_.is_edge(c)) continue;
    s_.for_each_piece(c, [&](std::uint32_t k) {
      pieces.push_back({a_.segment_of[k], a_.pieces[k][0], a_.pieces[k][1]});
      half_edge.push_back(2 * c);
    });
  }
  SweepLine line(a_.places, pieces, &a_.chains);
  below_.assign(a_.places.size(), none);
  SweepLine::Event event;
  const std::vector<SweepLine::End> ends = line.ends_in_order();
  for (std::size_t i = 0; i < ends.size();) {
    event.point = ends[i].point;
    event.starting.clear();
    event.ending.clear();
    for (; i < ends.size() && ends[i].point == event.point; ++i)
      (ends[i].kind == SweepLine::End::Kind::start ? event.starting : event.ending).push_back(ends[i].segment);
    const std::uint32_t below = line.move_over(event).below;
    if (event.ending.empty() && below != none)
      below_[event.point] = half_edge[below] + (line.is_backwards(below) ? 1 : 0);  // its face is above
  }
}

}  // namespace strata::planar
