#include "extensions/planar/subdivision.h"

#include "extensions/planar/chains.h"
#include "extensions/planar/nesting.h"
#include "extensions/planar/predicates.h"

namespace strata::planar {
namespace {

void number_cycles(Subdivision& s) {
  s.cycle_of.assign(s.next.size(), none);
  for (std::uint32_t start = 0; start < s.next.size(); ++start) {
    if (s.next[start] == none || s.cycle_of[start] != none) continue;
    for (std::uint32_t h = start; s.cycle_of[h] == none; h = s.next[h]) s.cycle_of[h] = s.cycles;
    ++s.cycles;
  }
}

}  // namespace

void find_components(const Arrangement& a, std::span<const std::uint32_t> least_of_ring, std::size_t patience,
                     Subdivision& s) {
  const auto is_less = [&](auto p, auto q) { return compare_xy(a.places, p, q) == Sign::negative; };
  std::vector<std::uint32_t> component_of(s.chains.size(), none);  // of edges
  std::vector<std::uint32_t> least;                                // vertices of components
  std::vector<std::uint32_t> open;
  for (const std::uint32_t vertex : least_of_ring) {
    if (vertex == none) continue;
    const std::uint32_t start = s.around_vertex(vertex).back();
    if (const std::uint32_t component = component_of[start >> 1]; component != none) {
      if (is_less(vertex, least[component])) least[component] = vertex;
      continue;
    }
    const auto number = static_cast<std::uint32_t>(least.size());
    least.push_back(vertex);
    component_of[start >> 1] = number;
    open.push_back(start);
    while (!open.empty()) {
      const std::uint32_t h = open.back();
      open.pop_back();
      for (const std::uint32_t other : {s.next[h], s.next[h ^ 1]})
        if (component_of[other >> 1] == none) {
          component_of[other >> 1] = number;
          open.push_back(other);
        }
    }
  }
  std::sort(least.begin(), least.end(), is_less);
  Nesting nesting(a, s, patience);
  for (const std::uint32_t vertex : least)  // left of the last direction before straight up: outside
    s.components.push_back({s.around_vertex(vertex).back(), nesting.container_of(vertex)});
}

Subdivision subdivide(const Arrangement& a, std::span<const std::uint32_t> first_segment, ChainEnds ends,
                      std::size_t patience) {
  Subdivision s;
  const std::vector<std::uint32_t> least_of_ring = cut_into_chains(a, first_segment, ends, s);
  sort_around_nodes(a, s);
  number_cycles(s);
  find_components(a, least_of_ring, patience, s);
  return s;
}

}  // namespace strata::planar
