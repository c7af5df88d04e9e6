#include "extensions/planar/subdivision.h"

#include "extensions/planar/chains.h"
#include "extensions/planar/nesting.h"
#include "extensions/planar/predicates.h"

namespace strata::planar {
namespace {

std::vector<std::uint32_t> segments_of_pieces(const Arrangement& a) {
  std::vector<std::uint32_t> segment(a.pieces.size());
  for (std::uint32_t s = 0; s < a.ends.size(); ++s)
    for (std::uint32_t k = a.first_piece[s]; k < a.first_piece[s + 1]; ++k) segment[k] = s;
  return segment;
}

void number_cycles(Subdivision& s) {
  s.cycle_of.assign(s.next.size(), none);
  for (std::uint32_t start = 0; start < s.next.size(); ++start) {
    if (s.next[start] == none || s.cycle_of[start] != none) continue;
    for (std::uint32_t h = start; s.cycle_of[h] == none; h = s.next[h]) s.cycle_of[h] = s.cycles;
    ++s.cycles;
  }
}

}  // namespace

void find_components(const Arrangement& a, std::vector<std::uint32_t> least, std::size_t patience, Subdivision& s) {
  std::erase(least, none);
  std::sort(least.begin(), least.end(), [&](auto p, auto q) { return compare_xy(a.places, p, q) == Sign::negative; });
  least.erase(std::unique(least.begin(), least.end()), least.end());
  std::vector<std::uint8_t> is_reached(s.chains.size());
  std::vector<std::uint32_t> open;
  Nesting nesting(a, s, patience);
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
    s.components.push_back({start, nesting.container_of(vertex)});
  }
}

Subdivision subdivide(const Arrangement& a, std::span<const std::uint32_t> first_segment, ChainEnds ends,
                      std::size_t patience) {
  Subdivision s;
  std::vector<std::uint32_t> least = cut_into_chains(a, first_segment, ends, s);
  sort_around_nodes(a, segments_of_pieces(a), s);
  number_cycles(s);
  find_components(a, std::move(least), patience, s);
  return s;
}

}  // namespace strata::planar
