#include "extensions/scene/painters_order.h"

#include <utility>

#include "core/exact/failure.h"
#include "extensions/scene/lists.h"
#include "extensions/scene/relation.h"
#include "extensions/scene/ring_breaker.h"

namespace strata {
namespace {

void cut_crossings(Pieces& pieces, Relation& relation, const Monitor& monitor) {
  while (relation.has_open_crossings()) {
    monitor.check();
    const auto [s, t] = relation.next_crossing();
    if (pieces.is_replaced(s) || pieces.is_replaced(t)) continue;
    if (!relation.cut(s, pieces.plane_of(t)))
      fail("a face that crosses another is not cut by its plane", pieces.face_of(s));
  }
}

/// Layers of all pieces that are in no cycle and before none. `pairs` in any order.
LayerOrder peel(const Pieces& pieces, const std::vector<Sign>& orientations, const std::vector<Domination>& pairs,
                std::vector<std::uint32_t>& remaining) {
  const std::uint32_t count = pieces.count();
  Lists beyond = dominators_of(count, pairs);
  const Lists before = dominated_by(count, pairs);
  LayerOrder order;
  order.layer.assign(count, 0);
  std::vector<std::uint32_t> left(count), wave, next;
  for (std::uint32_t p = 0; p < count; ++p) {
    left[p] = beyond.first[p + 1] - beyond.first[p];
    if (left[p] == 0 && orientations[p] != Sign::zero && !pieces.is_replaced(p)) wave.push_back(p);
  }
  while (!wave.empty()) {
    ++order.layer_count;
    next.clear();
    for (const std::uint32_t t : wave) {
      order.layer[t] = order.layer_count;
      for (const std::uint32_t s : before.of(t))
        if (--left[s] == 0) next.push_back(s);
    }
    wave.swap(next);
  }
  remaining.clear();
  for (std::uint32_t p = 0; p < count; ++p)
    if (left[p] != 0) remaining.push_back(p);
  order.first = std::move(beyond.first);
  order.dominators = std::move(beyond.items);
  return order;
}

}  // namespace

LayerOrder order_in_layers(Pieces& pieces, const Origin& origin, Dominance dominance, std::vector<Sign>& orientations,
                           const Monitor& monitor) {
  std::vector<std::uint32_t> remaining;
  if (dominance.crossings.empty()) {
    LayerOrder order = peel(pieces, orientations, dominance.dominations, remaining);
    if (remaining.empty()) return order;
  }
  Relation relation(pieces, origin, std::move(dominance), orientations);
  cut_crossings(pieces, relation, monitor);
  const std::uint32_t at_crossings = pieces.cuts();
  (void)peel(pieces, orientations, relation.pairs(), remaining);
  RingBreaker(pieces, relation, origin, remaining).run(monitor);
  LayerOrder order = peel(pieces, orientations, relation.pairs(), remaining);
  if (!remaining.empty()) fail("a ring of faces was not broken", pieces.face_of(remaining[0]));
  order.cuts_at_crossings = at_crossings;
  order.cuts_of_cycles = pieces.cuts() - at_crossings;
  return order;
}

}  // namespace strata
