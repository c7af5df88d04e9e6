#include "extensions/contact/nearest.h"

#include <queue>
#include <stdexcept>
#include <vector>

#include "extensions/contact/box_distance.h"
#include "extensions/contact/nearest_candidates.h"
#include "extensions/contact/root.h"

namespace strata::contact {
namespace {

/// Two nodes, the nearest first; of equally near ones, those found first.
struct NearNodes {
  double half_distance = 0;
  std::uint32_t a = 0, b = 0;

  friend bool operator<(const NearNodes& x, const NearNodes& y) { return x.half_distance > y.half_distance; }
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

Nearest nearest_of(const Parts& parts, std::uint32_t a, std::uint32_t b) {
  const PartTree &tree_a = parts.tree(a), &tree_b = parts.tree(b);
  if (tree_a.nodes().empty() || tree_b.nodes().empty())
    throw std::invalid_argument("an empty part has no distance from another");
  NearestCandidates candidates(parts.input());
  std::priority_queue<NearNodes> waiting;
  const auto add = [&](std::uint32_t i, std::uint32_t k) {
    const double distance = half_distance(tree_a.nodes()[i].box, tree_b.nodes()[k].box);
    if (distance <= candidates.half_bound()) waiting.push({distance, i, k});
  };
  add(0, 0);
  while (!waiting.empty() && waiting.top().half_distance <= candidates.half_bound()) {
    const NearNodes next = waiting.top();
    waiting.pop();
    const PartTree::Node &m = tree_a.nodes()[next.a], &n = tree_b.nodes()[next.b];
    if (m.is_leaf() && n.is_leaf()) {
      look_at_leaves(parts, a, b, tree_a.faces(m), tree_b.faces(n), candidates);
    } else if (n.is_leaf() || (!m.is_leaf() && m.count >= n.count)) {
      add(next.a + 1, next.b);
      add(m.right, next.b);
    } else {
      add(next.a, next.b + 1);
      add(next.a, n.right);
    }
  }
  Nearest nearest = candidates.best();
  nearest.distance = root(nearest.squared);
  make_local(nearest.feature_a, parts.input().first_vertex(a));
  make_local(nearest.feature_b, parts.input().first_vertex(b));
  return nearest;
}

}  // namespace strata::contact
