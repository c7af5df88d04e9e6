#include "strata/layers/painters_order.h"

#include <algorithm>
#include <deque>
#include <unordered_map>

#include "strata/layers/subordination.h"

namespace strata {
namespace {

/// Lists per piece in one array.
struct Lists {
  std::vector<std::uint32_t> first, items;

  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t p) const {
    if (p + 1 >= first.size()) return {};
    return std::span(items).subspan(first[p], first[p + 1] - first[p]);
  }
};

/// From pairs that are sorted by `key`, or from any with a stable counting sort.
template <class Key, class Item>
Lists make_lists(std::uint32_t count, const std::vector<Domination>& pairs, const Key& key, const Item& item) {
  Lists lists;
  lists.first.assign(count + 1, 0);
  for (const Domination& d : pairs) ++lists.first[key(d) + 1];
  for (std::uint32_t p = 0; p < count; ++p) lists.first[p + 1] += lists.first[p];
  lists.items.resize(pairs.size());
  std::vector<std::uint32_t> next(lists.first.begin(), lists.first.end() - 1);
  for (const Domination& d : pairs) lists.items[next[key(d)]++] = item(d);
  return lists;
}

Lists dominators_of(std::uint32_t count, const std::vector<Domination>& pairs) {
  return make_lists(
      count, pairs, [](const Domination& d) { return d.s; }, [](const Domination& d) { return d.t; });
}

Lists dominated_by(std::uint32_t count, const std::vector<Domination>& pairs) {
  return make_lists(
      count, pairs, [](const Domination& d) { return d.t; }, [](const Domination& d) { return d.s; });
}

/// The relation while pieces are cut.
class Relation {
 public:
  Relation(Pieces& pieces, const Origin& origin, Dominance dominance, std::vector<Sign>& turns)
      : pieces_(pieces),
        sight_(pieces.carriers(), origin),
        turns_(turns),
        pairs_(std::move(dominance.dominations)),
        dominators_(dominators_of(pieces.face_count(), pairs_)),
        dominated_(dominated_by(pieces.face_count(), pairs_)) {
    for (const Domination& d : dominance.crossings) add_crossing(d.s, d.t);
  }

  [[nodiscard]] std::vector<std::uint32_t> dominators(std::uint32_t p) const {
    return live(dominators_.of(p), later_dominators_, p);
  }
  [[nodiscard]] std::vector<std::uint32_t> dominated(std::uint32_t p) const {
    return live(dominated_.of(p), later_dominated_, p);
  }
  [[nodiscard]] TetrahedraOverlap overlap(std::uint32_t s, std::uint32_t t) const {
    return overlap_of(sight_, seen(s), seen(t));
  }

  /// Cuts p and relates the parts to what p was related to. False if the plane does not cut p.
  bool cut(std::uint32_t p, const RationalPlane& plane) {
    const std::uint32_t before = pieces_.count();
    const auto above = dominators(p), below = dominated(p), across = crossing(p);
    if (!pieces_.cut(p, plane)) return false;
    for (std::uint32_t part = before; part < pieces_.count(); ++part) {
      turns_.push_back(turns_[p]);
      for (const auto& list : {above, below, across})
        for (const std::uint32_t q : list) relate(part, q);
    }
    return true;
  }

  /// Would a cut part p's rays to t from those that come from s? Undone in any case.
  [[nodiscard]] bool would_part(std::uint32_t p, const RationalPlane& plane, std::uint32_t s, std::uint32_t t) {
    const Pieces::Mark mark = pieces_.mark();
    const std::uint32_t before = pieces_.count();
    if (!pieces_.cut(p, plane)) return false;
    bool parted = true;
    for (std::uint32_t part = before; part < pieces_.count(); ++part) {
      turns_.push_back(turns_[p]);
      parted =
          parted && !(overlap(part, t) == TetrahedraOverlap::before && overlap(part, s) == TetrahedraOverlap::behind);
    }
    turns_.resize(before);
    pieces_.undo(p, mark);
    return parted;
  }

  [[nodiscard]] std::vector<std::uint32_t> crossing(std::uint32_t p) const { return live({}, crossing_, p); }
  [[nodiscard]] const std::deque<Domination>& open_crossings() const { return open_crossings_; }
  [[nodiscard]] Domination next_crossing() {
    const Domination d = open_crossings_.front();
    open_crossings_.pop_front();
    return d;
  }

  /// All pairs that are left, those of whole faces sorted.
  [[nodiscard]] const std::vector<Domination>& pairs() {
    std::erase_if(pairs_, [&](const Domination& d) { return pieces_.is_replaced(d.s) || pieces_.is_replaced(d.t); });
    return pairs_;
  }

 private:
  using Later = std::unordered_map<std::uint32_t, std::vector<std::uint32_t>>;

  [[nodiscard]] SeenTriangle seen(std::uint32_t p) const { return {pieces_.corners(p), turns_[p]}; }

  void relate(std::uint32_t p, std::uint32_t q) {
    switch (overlap(p, q)) {
      case TetrahedraOverlap::before:
        add_pair(p, q);
        return;
      case TetrahedraOverlap::behind:
        add_pair(q, p);
        return;
      case TetrahedraOverlap::crossing:
        add_crossing(p, q);
        return;
      case TetrahedraOverlap::apart:
      case TetrahedraOverlap::touching:
      case TetrahedraOverlap::coplanar:
        return;
    }
  }
  void add_pair(std::uint32_t s, std::uint32_t t) {
    pairs_.push_back({s, t});
    later_dominators_[s].push_back(t);
    later_dominated_[t].push_back(s);
  }
  void add_crossing(std::uint32_t s, std::uint32_t t) {
    open_crossings_.push_back({s, t});
    crossing_[s].push_back(t);
    crossing_[t].push_back(s);
  }
  [[nodiscard]] std::vector<std::uint32_t> live(std::span<const std::uint32_t> from_start, const Later& later,
                                                std::uint32_t p) const {
    std::vector<std::uint32_t> list(from_start.begin(), from_start.end());
    if (const auto more = later.find(p); more != later.end())
      list.insert(list.end(), more->second.begin(), more->second.end());
    std::erase_if(list, [&](std::uint32_t q) { return pieces_.is_replaced(q); });
    return list;
  }

  Pieces& pieces_;
  Sight sight_;
  std::vector<Sign>& turns_;
  std::vector<Domination> pairs_;
  Lists dominators_, dominated_;  ///< among whole faces
  Later later_dominators_, later_dominated_, crossing_;
  std::deque<Domination> open_crossings_;
};

void cut_crossings(Pieces& pieces, Relation& relation, const Monitor& monitor) {
  while (!relation.open_crossings().empty()) {
    monitor.check();
    const auto [s, t] = relation.next_crossing();
    if (pieces.is_replaced(s) || pieces.is_replaced(t)) continue;
    if (!relation.cut(s, pieces.plane_of(t)))
      fail("a face that crosses another is not cut by its plane", pieces.face_of(s));
  }
}

/// The pieces that dominate one another in rings, and what lies between rings; no others.
class RingBreaker {
 public:
  RingBreaker(Pieces& pieces, Relation& relation, const Origin& origin, const std::vector<std::uint32_t>& remaining)
      : pieces_(pieces), relation_(relation), origin_(origin), nodes_(remaining) {}

  /// Cuts pieces until no ring is left.
  void run(const Monitor& monitor) {
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

 private:
  using Ring = std::vector<std::uint32_t>;  ///< each dominated by the next, the last by the first

  void list_neighbours() {
    index_.clear();
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) index_[nodes_[i]] = i;
    beyond_.assign(nodes_.size(), {});
    for (std::uint32_t i = 0; i < nodes_.size(); ++i)
      for (const std::uint32_t q : relation_.dominators(nodes_[i]))
        if (const auto at = index_.find(q); at != index_.end()) beyond_[i].push_back(at->second);
  }

  /// One ring without shortcuts per strongly connected component.
  [[nodiscard]] std::vector<Ring> find_rings() const {
    std::vector<Ring> rings;
    const std::vector<std::uint32_t> component = strongly_connected_components(beyond_);
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

  /// Through node `start`, which is in one. Breadth first.
  [[nodiscard]] Ring shortest_ring(std::uint32_t start) const {
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

  /// Takes a shortcut between two that are not neighbours in the ring.
  bool shorten(Ring& ring) const {
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

  /// Cuts one piece of a ring so that no part is both beyond its predecessor and before its successor; theory.md,
  /// "Cycles", shows that an edge of one of these two does it.
  void cut(const Ring& ring) {
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

  /// Tarjan 1972, without recursion. The number of its component for each node.
  [[nodiscard]] static std::vector<std::uint32_t> strongly_connected_components(
      const std::vector<std::vector<std::uint32_t>>& next) {
    constexpr std::uint32_t unseen = 0xffffffffu;
    const auto n = static_cast<std::uint32_t>(next.size());
    std::vector<std::uint32_t> component(n, unseen), order(n, unseen), low(n), stack;
    std::vector<std::pair<std::uint32_t, std::size_t>> path;
    std::uint32_t seen = 0, components = 0;
    for (std::uint32_t root = 0; root < n; ++root) {
      if (order[root] != unseen) continue;
      path.emplace_back(root, 0);
      while (!path.empty()) {
        const std::uint32_t v = path.back().first;
        if (path.back().second == 0) {
          order[v] = low[v] = seen++;
          stack.push_back(v);
        }
        if (path.back().second < next[v].size()) {
          const std::uint32_t w = next[v][path.back().second++];
          if (order[w] == unseen) {
            path.emplace_back(w, 0);
          } else if (component[w] == unseen) {
            low[v] = std::min(low[v], order[w]);
          }
          continue;
        }
        path.pop_back();
        if (!path.empty()) low[path.back().first] = std::min(low[path.back().first], low[v]);
        if (low[v] != order[v]) continue;
        for (std::uint32_t w = unseen; w != v;) {
          w = stack.back();
          stack.pop_back();
          component[w] = components;
        }
        ++components;
      }
    }
    return component;
  }

  Pieces& pieces_;
  Relation& relation_;
  const Origin& origin_;
  std::vector<std::uint32_t> nodes_;
  std::unordered_map<std::uint32_t, std::uint32_t> index_;
  std::vector<std::vector<std::uint32_t>> beyond_;  ///< among the nodes, by index
};

/// Layers of all pieces that are in no ring and before none. `pairs` in any order.
LayerOrder peel(const Pieces& pieces, const std::vector<Sign>& turns, const std::vector<Domination>& pairs,
                std::vector<std::uint32_t>& remaining) {
  const std::uint32_t count = pieces.count();
  Lists beyond = dominators_of(count, pairs);
  const Lists before = dominated_by(count, pairs);
  LayerOrder order;
  order.layer.assign(count, 0);
  std::vector<std::uint32_t> left(count), wave, next;
  for (std::uint32_t p = 0; p < count; ++p) {
    left[p] = beyond.first[p + 1] - beyond.first[p];
    if (left[p] == 0 && turns[p] != Sign::zero && !pieces.is_replaced(p)) wave.push_back(p);
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

LayerOrder order_in_layers(Pieces& pieces, const Origin& origin, Dominance dominance, std::vector<Sign>& turns,
                           const Monitor& monitor) {
  std::vector<std::uint32_t> remaining;
  if (dominance.crossings.empty()) {
    LayerOrder order = peel(pieces, turns, dominance.dominations, remaining);
    if (remaining.empty()) return order;
  }
  Relation relation(pieces, origin, std::move(dominance), turns);
  cut_crossings(pieces, relation, monitor);
  const std::uint32_t at_crossings = pieces.cuts();
  (void)peel(pieces, turns, relation.pairs(), remaining);
  RingBreaker(pieces, relation, origin, remaining).run(monitor);
  LayerOrder order = peel(pieces, turns, relation.pairs(), remaining);
  if (!remaining.empty()) fail("a ring of faces was not broken", pieces.face_of(remaining[0]));
  order.cuts_at_crossings = at_crossings;
  order.cuts_of_cycles = pieces.cuts() - at_crossings;
  return order;
}

}  // namespace strata
