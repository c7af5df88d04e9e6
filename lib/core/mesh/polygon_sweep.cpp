#include "core/mesh/polygon_sweep.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace strata {
namespace {

constexpr const char* crosses = "has sides that cross or touch away from their ends";
constexpr const char* parts_nothing =
    "crosses itself, or has a hole outside: some side does not part its inside from its outside";

}  // namespace

bool PolygonSweep::Below::operator()(const Edge& a, const Edge& b) const {
  if (a.left == b.left) return (*orientation)(a.left, a.right, b.right) == Sign::positive;
  return a.left < b.left ? (*orientation)(a.left, a.right, b.left) == Sign::positive
                         : (*orientation)(b.left, b.right, a.left) == Sign::negative;
}

PolygonSweep::PolygonSweep(std::span<const PolygonSide> sides, Turn orientation)
    : orientation_(std::move(orientation)), status_(Below{&orientation_}) {
  for (const PolygonSide& s : sides) edges_.push_back({std::min(s.from, s.to), std::max(s.from, s.to), s.from < s.to});
  std::stable_sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.left < b.left; });
}

std::vector<Triangle> PolygonSweep::divide() {
  std::vector<std::uint32_t> places;
  for (const Edge& e : edges_) places.insert(places.end(), {e.left, e.right});
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::span<Edge> rest(edges_);
  for (const std::uint32_t p : places) {
    std::size_t starting = 0;
    while (starting < rest.size() && rest[starting].left == p) ++starting;
    pass(p, rest.first(starting));
    rest = rest.subspan(starting);
  }
  return std::exchange(triangles_, {});
}

/// Ends the edges that lead to the position, and starts those that leave it.
void PolygonSweep::pass(std::uint32_t place, std::span<Edge> starting) {
  const auto [first, above] = status_.equal_range(Place{place});
  for (auto e = first; e != above; ++e)
    if (e->first.right != place) throw NoRegion(crosses);
  const auto below = first == status_.begin() ? status_.end() : std::prev(first);
  const bool inside = below != status_.end() && below->first.bounds_above;
  Chain upper;
  if (first == above) {
    if (inside) upper = part(below->second);
  } else {
    for (auto e = first; std::next(e) != above; ++e)
      if (e->first.bounds_above) close(e->second, place);
    upper = std::prev(above)->second;
    status_.erase(first, above);
  }
  if (inside) append(below->second, place);
  if (upper.lowest != none) prepend(upper, place);
  open_between(below, above, place, starting, inside, upper);
}

/// Inserts the edges that start at the position between two others. `inside` says whether the area above the first of
/// these is inside; `upper` is the chain below the second one.
void PolygonSweep::open_between(At below, At above, std::uint32_t place, std::span<Edge> starting, bool inside,
                                const Chain& upper) {
  std::sort(starting.begin(), starting.end(), Below{&orientation_});
  auto highest = below;
  for (const Edge& e : starting) {
    if (e.bounds_above == inside) throw NoRegion(parts_nothing);
    inside = e.bounds_above;
    Chain chain;
    if (inside && &e == &starting.back()) {
      chain = upper;
    } else if (inside) {
      const std::uint32_t node = add_node(place);
      chain = {node, node, node};
    }
    const std::size_t before = status_.size();
    highest = status_.emplace_hint(above, e, chain);
    if (status_.size() == before) throw NoRegion(crosses);
    if (&e == &starting.front()) ensure_apart(below, highest);
  }
  if (starting.empty() && inside) join(below->second, upper);
  ensure_apart(highest, above);
}

/// Divides a chain at its last position, which both parts keep. Returns the upper part.
PolygonSweep::Chain PolygonSweep::part(Chain& chain) {
  const std::uint32_t last = chain.last, copy = add_node(nodes_[last].place);
  const Chain upper{copy, last == chain.highest ? copy : chain.highest, copy};
  const std::uint32_t behind = std::exchange(nodes_[last].behind, none);
  nodes_[copy].behind = behind;
  if (behind != none) nodes_[behind].before = copy;
  chain.highest = last;
  return upper;
}

std::uint32_t PolygonSweep::add_node(std::uint32_t place) {
  nodes_.push_back({place, none, none});
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

/// Does the position, to the right of two neighbours in a chain, see all of the segment between them?
bool PolygonSweep::sees(std::uint32_t lower, std::uint32_t place, std::uint32_t upper) const {
  return orientation_(nodes_[lower].place, place, nodes_[upper].place) == Sign::positive;
}

void PolygonSweep::append(Chain& chain, std::uint32_t place) {
  while (chain.highest != chain.lowest && sees(nodes_[chain.highest].before, place, chain.highest)) {
    const std::uint32_t before = nodes_[chain.highest].before;
    triangles_.push_back({nodes_[before].place, place, nodes_[chain.highest].place});
    chain.highest = before;
  }
  chain.last = add_node(place);
  nodes_[chain.highest].behind = chain.last;
  nodes_[chain.last].before = chain.highest;
  chain.highest = chain.last;
}

void PolygonSweep::prepend(Chain& chain, std::uint32_t place) {
  while (chain.lowest != chain.highest && sees(chain.lowest, place, nodes_[chain.lowest].behind)) {
    const std::uint32_t behind = nodes_[chain.lowest].behind;
    triangles_.push_back({nodes_[chain.lowest].place, place, nodes_[behind].place});
    chain.lowest = behind;
  }
  chain.last = add_node(place);
  nodes_[chain.lowest].before = chain.last;
  nodes_[chain.last].behind = chain.lowest;
  chain.lowest = chain.last;
}

/// Triangulates a part whose two edges end at the position. It sees all of the chain: a position that blocks the view
/// would be on an edge.
void PolygonSweep::close(const Chain& chain, std::uint32_t place) {
  for (std::uint32_t n = chain.lowest; n != chain.highest; n = nodes_[n].behind)
    triangles_.push_back({nodes_[n].place, place, nodes_[nodes_[n].behind].place});
}

/// Appends the upper chain, which starts where the lower one ends.
void PolygonSweep::join(Chain& lower, const Chain& upper) {
  const std::uint32_t second = nodes_[upper.lowest].behind;
  nodes_[lower.highest].behind = second;
  nodes_[second].before = lower.highest;
  lower.last = lower.highest;
  lower.highest = upper.highest;
}

/// Neighbours may end in one position. Otherwise the one that ends first ends on its own side of the other.
void PolygonSweep::ensure_apart(At below, At above) const {
  if (below == status_.end() || above == status_.end()) return;
  const Edge &a = below->first, &b = above->first;
  if (a.right == b.right) return;
  const bool apart = a.right < b.right ? orientation_(b.left, b.right, a.right) == Sign::negative
                                       : orientation_(a.left, a.right, b.right) == Sign::positive;
  if (!apart) throw NoRegion(crosses);
}

}  // namespace strata
