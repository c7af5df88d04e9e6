#include "extensions/contact/nearest.h"

#include <queue>
#include <stdexcept>
#include <vector>

#include "extensions/contact/box_distance.h"
#include "extensions/contact/nearest_candidates.h"
#include "extensions/contact/root.h"

namespace strata::contact {
namespace {

/// Two branches, the nearest first; of equally near ones, those found first.
struct NearBranches {
  double half_distance = 0;
  BoxTree::Branch a, b;

  friend bool operator<(const NearBranches& x, const NearBranches& y) { return x.half_distance > y.half_distance; }
};

/// Processes the faces of two leaves, the pairs that may be as near as the best.
void look_at_leaves(const Parts& parts, std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> of_a,
                    std::span<const std::uint32_t> of_b, NearestCandidates& candidates) {
  std::vector<Box> boxes;
  for (const std::uint32_t g : of_b) boxes.push_back(box_of_face(parts.input(), b, g));
  for (const std::uint32_t f : of_a) {
    const Box box = box_of_face(parts.input(), a, f);
    for (std::size_t k = 0; k < of_b.size(); ++k)
      if (half_distance(box, boxes[k]) <= candidates.half_bound()) candidates.look_at(f, of_b[k]);
  }
}

void make_local(MeshFeature& feature, std::uint32_t first) {
  for (std::size_t i = 0; i <= static_cast<std::size_t>(feature.kind); ++i) feature.vertices[i] -= first;
}

}  // namespace

Nearest nearest_of(const Parts& parts, std::uint32_t a, std::uint32_t b, const Monitor& monitor) {
  const BoxTree &tree_a = parts.tree(a), &tree_b = parts.tree(b);
  if (tree_a.empty() || tree_b.empty()) throw std::invalid_argument("an empty part has no distance from another");
  NearestCandidates candidates(parts.input());
  std::priority_queue<NearBranches> waiting;
  const auto add = [&](BoxTree::Branch i, BoxTree::Branch k) {
    const double distance = half_distance(tree_a.box(i), tree_b.box(k));
    if (distance <= candidates.half_bound()) waiting.push({distance, i, k});
  };
  add(tree_a.root(), tree_b.root());
  while (!waiting.empty() && waiting.top().half_distance <= candidates.half_bound()) {
    monitor.check();
    const NearBranches next = waiting.top();
    waiting.pop();
    if (tree_a.is_leaf(next.a) && tree_b.is_leaf(next.b)) {
      look_at_leaves(parts, a, b, tree_a.items(next.a), tree_b.items(next.b), candidates);
    } else if (is_first_divided(tree_a, next.a, tree_b, next.b)) {
      for (const BoxTree::Branch part : tree_a.children(next.a)) add(part, next.b);
    } else {
      for (const BoxTree::Branch part : tree_b.children(next.b)) add(next.a, part);
    }
  }
  Nearest nearest = candidates.best();
  nearest.distance = root(nearest.squared);
  make_local(nearest.feature_a, parts.input().first_vertex(a));
  make_local(nearest.feature_b, parts.input().first_vertex(b));
  return nearest;
}

}  // namespace strata::contact
