#include "strata/planar/subdivision.h"

#include "strata/planar/chains.h"
#include "strata/planar/predicates.h"

namespace strata::plane {
namespace {

std::vector<std::uint32_t> segments_of_pieces(const Arrangement& a) {
  std::vector<std::uint32_t> segment(a.pieces.size());
  for (std::uint32_t s = 0; s < a.ends.size(); ++s)
    for (std::uint32_t k = a.first_piece[s]; k < a.first_piece[s + 1]; ++k) segment[k] = s;
  return segment;
}

/// A piece that a ray to the left meets, seen as going up.
struct Crossed {
  std::uint32_t piece = none, segment = 0, low = 0, high = 0;
  bool upward = false;
};

/// True when q lies to the right of p at the ray's height. Pieces do not cross; from a common lower end they part or
/// coincide.
bool is_right_of(const Arrangement& a, const Crossed& p, const Crossed& q) {
  const auto side_of = [&](std::uint32_t v, const Crossed& c) {
    const Sign s = side(a.places, v, c.segment);
    return c.upward ? s : -s;
  };
  if (p.low != q.low) {
    if (compare(a.places, p.low, q.low, 1) != Sign::positive) {
      if (const Sign s = side_of(q.low, p); s != Sign::zero) return s == Sign::negative;
    } else if (const Sign s = side_of(p.low, q); s != Sign::zero) {
      return s == Sign::positive;
    }
  }
  const Sign turn = cross(a.places, p.segment, q.segment);
  return (p.upward == q.upward ? turn : -turn) == Sign::negative;
}

/// Looks from a component's least vertex to the left, along a ray from (x - e^2, y + e). Segments of the vertex's own
/// component have no point to the left of it and are not met; others do not hold the vertex.
class LeftwardRay {
 public:
  LeftwardRay(const Arrangement& a, std::uint32_t vertex) : a_(a), vertex_(vertex) {}

  /// The first piece that the ray meets.
  [[nodiscard]] Crossed nearest() {
    const Bounded y = a_.places.bounded(vertex_, 1);
    const std::uint32_t first = a_.strips->strip_of(y.lower()), last = a_.strips->strip_of(y.upper());
    for (std::uint32_t k = first; k <= last; ++k) look_through(k);
    return nearest_;
  }

 private:
  /// From the right to the left, as long as something may be nearer.
  void look_through(std::uint32_t strip) {
    const auto runs = a_.strips->segments(strip);
    const auto lefts = a_.strips->lefts(strip);
    const double widest = a_.strips->widest(strip) * (1 + 0x1p-50);
    const double x = a_.places.bounded(vertex_, 0).upper();
    double bound = -HUGE_VAL;  // what ends to the left of it is not nearest
    for (std::size_t i = static_cast<std::size_t>(std::upper_bound(lefts.begin(), lefts.end(), x) - lefts.begin());
         i-- > 0;) {
      if (lefts[i] + widest < bound) return;
      const std::uint32_t run = runs[i];
      if (a_.strips->box(run).right < bound) continue;
      for (std::uint32_t s = a_.first_of_run[run]; s < a_.first_of_run[run + 1]; ++s)
        if (meet(s)) bound = lefts[i];
    }
  }
  /// Whether a segment is the nearest one now.
  bool meet(std::uint32_t segment) {
    const bool starts_below = is_below(a_.ends[segment][0]);
    if (starts_below == is_below(a_.ends[segment][1])) return false;
    if (side(a_.places, vertex_, segment) != (starts_below ? Sign::negative : Sign::positive)) return false;
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
};

/// Chains by their pieces.
class ChainOfPiece {
 public:
  std::uint32_t operator()(const Arrangement& a, const Subdivision& s, std::uint32_t piece) {
    if (chain_.empty()) {
      chain_.resize(a.pieces.size());
      for (std::uint32_t c = 0; c < s.chains.size(); ++c) s.for_each_piece(c, [&](std::uint32_t k) { chain_[k] = c; });
    }
    return chain_[piece];
  }

 private:
  std::vector<std::uint32_t> chain_;
};

void number_cycles(Subdivision& s) {
  s.cycle_of.assign(s.next.size(), none);
  for (std::uint32_t start = 0; start < s.next.size(); ++start) {
    if (s.next[start] == none || s.cycle_of[start] != none) continue;
    for (std::uint32_t h = start; s.cycle_of[h] == none; h = s.next[h]) s.cycle_of[h] = s.cycles;
    ++s.cycles;
  }
}

/// The half-edge whose face a component's least vertex looks at to its left.
std::uint32_t container_of(const Arrangement& a, std::uint32_t vertex, ChainOfPiece& chain_of, const Subdivision& s) {
  const Crossed nearest = LeftwardRay(a, vertex).nearest();
  if (nearest.piece == none) return none;
  const std::uint32_t chain = chain_of(a, s, nearest.piece);
  const bool is_edge_upward = nearest.upward != (s.is_opposite[chain] != 0);
  return 2 * s.edge_of[chain] + (is_edge_upward ? 1 : 0);  // to the right of what goes up
}

}  // namespace

void find_components(const Arrangement& a, std::vector<std::uint32_t> least, Subdivision& s) {
  std::erase(least, none);
  std::sort(least.begin(), least.end(), [&](auto p, auto q) { return compare_xy(a.places, p, q) == Sign::negative; });
  least.erase(std::unique(least.begin(), least.end()), least.end());
  std::vector<std::uint8_t> is_reached(s.chains.size());
  std::vector<std::uint32_t> open;
  ChainOfPiece chain_of;
  for (const std::uint32_t vertex : least) {
    const std::uint32_t start =
        s.around_vertex(vertex).back();  // left of the last direction before straight up: outside
    if (is_reached[start >> 1]) continue;
    is_reached[start >> 1] = 1;
    open.push_back(start);
    while (!open.empty()) {
      const std::uint32_t h = open.back();
      open.pop_back();
      for (const std::uint32_t other : {s.next[h], s.next[h ^ 1]})
        if (!is_reached[other >> 1]) {
          is_reached[other >> 1] = 1;
          open.push_back(other);
        }
    }
    s.components.push_back({start, container_of(a, vertex, chain_of, s)});
  }
}

Subdivision subdivide(const Arrangement& a, std::span<const std::uint32_t> first_segment, ChainEnds ends) {
  Subdivision s;
  std::vector<std::uint32_t> least = cut_into_chains(a, first_segment, ends, s);
  sort_around_nodes(a, segments_of_pieces(a), s);
  number_cycles(s);
  find_components(a, std::move(least), s);
  return s;
}

}  // namespace strata::plane
