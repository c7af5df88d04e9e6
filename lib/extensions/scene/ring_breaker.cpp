#include "extensions/scene/ring_breaker.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "core/exact/failure.h"
#include "extensions/scene/strong_components.h"

namespace strata {

void RingBreaker::run(const Monitor& monitor) {
  while (true) {
    monitor.check();
    list_neighbours();
    const auto rings = find_rings();
    if (rings.empty()) return;
    for (const auto& ring : rings) {
      const std::uint32_t before = pieces_.count();
      cut(ring);
      for (std::uint32_t p = before; p < pieces_.count(); ++p) nodes_.push_back(p);
    }
    std::erase_if(nodes_, [&](std::uint32_t p) { return pieces_.is_replaced(p); });
  }
}

void RingBreaker::list_neighbours() {
  index_.clear();
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) index_[nodes_[i]] = i;
  beyond_.assign(nodes_.size(), {});
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    for (const std::uint32_t q : relation_.dominators(nodes_[i]))
      if (const auto at = index_.find(q); at != index_.end()) beyond_[i].push_back(at->second);
}

/// One cycle without shortcuts per strongly connected component.
std::vector<RingBreaker::Ring> RingBreaker::find_rings() const {
  std::vector<Ring> rings;
  const std::vector<std::uint32_t> component = strong_components(beyond_);
  std::vector<bool> done(nodes_.size(), false);
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    const bool in_ring = std::any_of(beyond_[i].begin(), beyond_[i].end(),
                                     [&](std::uint32_t j) { return component[j] == component[i]; });
    if (!in_ring || done[component[i]]) continue;
    done[component[i]] = true;
    Ring ring = shortest_ring(i);
    while (shorten(ring)) {
    }
    for (std::uint32_t& p : ring) p = nodes_[p];
    rings.push_back(std::move(ring));
  }
  return rings;
}

/// A shortest cycle through node `start`, which is in one. Breadth first.
RingBreaker::Ring RingBreaker::shortest_ring(std::uint32_t start) const {
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> from(nodes_.size(), none);
  std::deque<std::uint32_t> queue{start};
  while (true) {
    const std::uint32_t i = queue.front();
    queue.pop_front();
    for (const std::uint32_t j : beyond_[i]) {
      if (j == start) {
        Ring ring;
        for (std::uint32_t k = i; k != start; k = from[k]) ring.push_back(k);
        ring.push_back(start);
        std::reverse(ring.begin(), ring.end());
        return ring;
      }
      if (from[j] != none) continue;
      from[j] = i;
      queue.push_back(j);
    }
  }
}

/// Shortens the cycle by a dominance between two pieces that are not neighbours in it.
bool RingBreaker::shorten(Ring& ring) const {
  const auto n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t step = 2; step < n; ++step) {
      const std::size_t j = (i + step) % n;
      const auto& list = beyond_[ring[i]];
      if (std::find(list.begin(), list.end(), ring[j]) == list.end()) continue;
      Ring shorter;
      for (std::size_t k = j; k != i; k = (k + 1) % n) shorter.push_back(ring[k]);
      shorter.push_back(ring[i]);
      ring = std::move(shorter);
      return true;
    }
  return false;
}

/// Cuts one piece of a cycle so that no part is both beyond its predecessor and before its successor. theory.md,
/// "Cycles", proves that an edge of one of these two does it.
void RingBreaker::cut(const Ring& ring) {
  const std::size_t n = ring.size();
  for (const bool must_part : {true, false})
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t p = ring[i], s = ring[(i + n - 1) % n], t = ring[(i + 1) % n];
      if (pieces_.is_replaced(p) || pieces_.is_replaced(s) || pieces_.is_replaced(t)) return;
      for (const std::uint32_t q : {t, s})
        for (std::size_t e = 0; e < 3; ++e) {
          const Corners v = pieces_.corners(q);
          const RationalPlane plane = pieces_.plane_of_sight(origin_, v[e], v[(e + 1) % 3]);
          if (must_part && !relation_.would_part(p, plane, s, t)) continue;
          if (relation_.cut(p, plane)) return;
        }
    }
  fail("a ring of faces that no edge cuts", pieces_.face_of(ring[0]));
}

}  // namespace strata
