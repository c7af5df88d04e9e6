#include "extensions/planar/chains.h"

#include "extensions/planar/predicates.h"

namespace strata::planar {
namespace {

/// The number of pieces that end at every vertex; 3 means 3 or more.
std::vector<std::uint8_t> degrees(const Arrangement& a) {
  std::vector<std::uint8_t> degree(a.places.size());
  for (const auto& piece : a.pieces)
    for (const std::uint32_t v : piece) degree[v] = static_cast<std::uint8_t>(std::min(degree[v] + 1, 3));
  return degree;
}

std::uint32_t least_vertex(const Arrangement& a, std::uint32_t first, std::uint32_t end) {
  if (first == end) return none;
  std::uint32_t least = a.pieces[first][0];
  for (std::uint32_t k = first + 1; k < end; ++k)
    if (compare_xy(a.places, a.pieces[k][0], least) == Sign::negative) least = a.pieces[k][0];
  return least;
}

void cut_ring(const Arrangement& a, const std::vector<std::uint8_t>& is_node, std::uint32_t ring, Subdivision& s) {
  const std::uint32_t begin = s.first_piece_of_ring[ring], end = s.first_piece_of_ring[ring + 1];
  const auto starts = [&](std::uint32_t piece) { return is_node[a.pieces[piece][0]] != 0; };
  std::uint32_t first = begin;
  while (!starts(first)) ++first;  // a ring's least vertex is a node
  std::uint32_t last = first;
  for (std::uint32_t k = first + 1; k < end; last = k, ++k)
    if (starts(k)) {
      s.chains.push_back({first, last, ring});
      first = k;
    }
  last = end - 1;
  for (std::uint32_t k = begin; k < end && !starts(k); ++k) last = k;
  s.chains.push_back({first, last, ring});
}

/// A half-edge leaving a node: along its line or against it, into the right half of directions or the left one.
struct Direction {
  std::uint32_t half_edge = 0, line = 0;
  bool against = false;
  bool to_left = false;
};

class Fan {
 public:
  Fan(const Arrangement& a, Subdivision& s) : a_(a), s_(s) {}

  /// Sorts a node's half-edges, given as a range of `around`, and keeps one for each direction. Returns how many.
  std::uint32_t sort(std::span<std::uint32_t> half_edges) {
    directions_.clear();
    for (const std::uint32_t h : half_edges) directions_.push_back(direction(h));
    bool are_different = true;  // sorting compares what becomes neighbours
    std::sort(directions_.begin(), directions_.end(), [&](const Direction& p, const Direction& q) {
      const Sign order = compare_directions(p, q);
      if (order != Sign::zero) return order == Sign::negative;
      are_different = are_different && p.half_edge == q.half_edge;
      return p.half_edge < q.half_edge;
    });
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const bool is_new =
          are_different || i == 0 || compare_directions(directions_[i - 1], directions_[i]) != Sign::zero;
      if (is_new) {
        half_edges[count++] = directions_[i].half_edge;
      } else {
        unite(half_edges[count - 1], directions_[i].half_edge);
      }
    }
    return count;
  }

 private:
  Direction direction(std::uint32_t h) const {
    const Subdivision::Chain& c = s_.chains[h >> 1];
    const bool against = (h & 1) != 0;
    const std::uint32_t line = a_.segment_of[against ? c.last : c.first];
    return {h, line, against, (heading(a_.places, line) == Sign::positive) == against};
  }
  /// Negative when p comes before q, counter-clockwise from straight down, which itself is last.
  Sign compare_directions(const Direction& p, const Direction& q) const {
    if (p.to_left != q.to_left) return p.to_left ? Sign::positive : Sign::negative;
    const Sign orientation = cross(a_.places, p.line, q.line);
    return p.against == q.against ? -orientation : orientation;
  }
  /// Identifies half-edges of coinciding chains, in order of their numbers: `kept` is the lower one at both ends of an
  /// edge.
  void unite(std::uint32_t kept, std::uint32_t other) {
    s_.edge_of[other >> 1] = kept >> 1;
    s_.is_opposite[other >> 1] = static_cast<std::uint8_t>((kept ^ other) & 1);
  }

  const Arrangement& a_;
  Subdivision& s_;
  std::vector<Direction> directions_;
};

}  // namespace

std::vector<std::uint32_t> cut_into_chains(const Arrangement& a, std::span<const std::uint32_t> first_segment,
                                           ChainEnds ends, Subdivision& s) {
  for (const std::uint32_t segment : first_segment) s.first_piece_of_ring.push_back(a.first_piece[segment]);
  const auto rings = static_cast<std::uint32_t>(first_segment.size() - 1);
  std::vector<std::uint8_t> is_node = degrees(a);
  for (std::size_t v = 0; v < is_node.size(); ++v)
    is_node[v] = ends == ChainEnds::all_vertices || is_node[v] > 2 || a.is_fold[v] != 0;
  std::vector<std::uint32_t> least(rings);
  for (std::uint32_t r = 0; r < rings; ++r) {
    least[r] = least_vertex(a, s.first_piece_of_ring[r], s.first_piece_of_ring[r + 1]);
    if (least[r] != none) is_node[least[r]] = 1;
  }
  for (std::uint32_t r = 0; r < rings; ++r)
    if (least[r] != none) cut_ring(a, is_node, r, s);
  return least;
}

void sort_around_nodes(const Arrangement& a, Subdivision& s) {
  const auto chains = static_cast<std::uint32_t>(s.chains.size());
  s.edge_of.resize(chains);
  for (std::uint32_t c = 0; c < chains; ++c) s.edge_of[c] = c;
  s.is_opposite.assign(chains, 0);
  std::vector<std::uint32_t> first(a.places.size() + 1);
  for (std::uint32_t h = 0; h < 2 * chains; ++h) ++first[origin(a, s, h) + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  s.around.resize(2 * static_cast<std::size_t>(chains));
  s.end_around.assign(first.begin(), first.end() - 1);
  for (std::uint32_t h = 0; h < 2 * chains; ++h) s.around[s.end_around[origin(a, s, h)]++] = h;
  s.first_around = std::move(first);
  s.next.assign(2 * static_cast<std::size_t>(chains), none);
  Fan fan(a, s);
  for (std::uint32_t v = 0; v < a.places.size(); ++v) {
    if (s.first_around[v] == s.end_around[v]) continue;
    s.end_around[v] =
        s.first_around[v] + fan.sort({s.around.data() + s.first_around[v], s.around.data() + s.end_around[v]});
    // After arriving by a half-edge, the cycle continues with the one that precedes it, clockwise.
    std::uint32_t before = s.around[s.end_around[v] - 1];
    for (const std::uint32_t h : s.around_vertex(v)) {
      s.next[h ^ 1] = before;
      before = h;
    }
  }
}

}  // namespace strata::planar
