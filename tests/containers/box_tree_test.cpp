#include "core/containers/box_tree.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

using namespace strata;

// Seen to fail: a node without its right child's box; a pair of which the larger branch is not divided.

namespace {

/// Boxes that touch often, as their corners are on a grid; some are points.
std::vector<Box> random_boxes(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const int cells = seed % 4 == 0 ? 1 : 40;  // 1: nearly all alike
  std::vector<Box> boxes(count);
  for (Box& b : boxes)
    for (std::size_t i = 0; i < 3; ++i) {
      b.lower[i] = static_cast<double>(random() % static_cast<unsigned>(cells + 1));
      b.upper[i] = b.lower[i] + static_cast<double>(random() % 4);
    }
  return boxes;
}

BoxTree tree_of(const std::vector<Box>& boxes, bool by_order) {
  const auto box_of = [&](std::span<const std::uint32_t> some) {
    Box box;
    for (const std::uint32_t i : some) box.include(boxes[i]);
    return box;
  };
  if (!by_order) return BoxTree::by_surface_area(static_cast<std::uint32_t>(boxes.size()), box_of);
  std::vector<std::uint32_t> items(boxes.size());
  std::iota(items.rbegin(), items.rend(), 0u);
  return BoxTree::by_order(std::move(items), box_of);
}

using Numbers = std::vector<std::uint32_t>;

Numbers sorted(Numbers n) {
  std::sort(n.begin(), n.end());
  return n;
}

Numbers near(const BoxTree& tree, const std::vector<Box>& boxes, const Box& range) {
  Numbers found;
  tree.for_each_near(range, [&](std::uint32_t i) {
    if (boxes[i].overlaps(range)) found.push_back(i);
    return true;
  });
  return sorted(found);
}

Numbers all_of(const BoxTree& tree) {
  Numbers found;
  tree.for_each_in([](const Box&) { return true; },
                   [&](std::uint32_t i) {
                     found.push_back(i);
                     return true;
                   });
  return found;
}

}  // namespace

TEST_CASE("a tree finds the boxes that overlap another one", "[containers][property]") {
  const unsigned seed = GENERATE(range(0u, 24u));
  const bool by_order = GENERATE(false, true);
  const std::size_t count = std::array<std::size_t, 6>{0, 1, 5, 9, 100, 1500}[seed % 6];
  const auto boxes = random_boxes(count, seed);
  const BoxTree tree = tree_of(boxes, by_order);
  CHECK(tree.empty() == boxes.empty());
  Numbers expected(count);
  std::iota(expected.begin(), expected.end(), 0u);
  CHECK(sorted(all_of(tree)) == expected);
  Box all;
  for (const Box& b : boxes) all.include(b);
  CHECK(tree.bounds().lower == all.lower);
  CHECK(tree.bounds().upper == all.upper);
  for (const Box& range : random_boxes(50, seed + 1000)) {
    Numbers overlapping;
    for (std::uint32_t i = 0; i < count; ++i)
      if (boxes[i].overlaps(range)) overlapping.push_back(i);
    REQUIRE(near(tree, boxes, range) == overlapping);
  }
}

TEST_CASE("a search ends when it is told to", "[containers]") {
  const auto boxes = random_boxes(200, 1);
  const BoxTree tree = tree_of(boxes, true);
  int seen = 0;
  CHECK_FALSE(tree.for_each_in([](const Box&) { return true; }, [&](std::uint32_t) { return ++seen < 3; }));
  CHECK(seen == 3);
  CHECK(tree.for_each_near(Box{{99, 99, 99}, {100, 100, 100}}, [](std::uint32_t) { return false; }));
}

TEST_CASE("two trees find all pairs of leaves that meet, each once", "[containers][property]") {
  const unsigned seed = GENERATE(range(0u, 16u));
  const auto of_a = random_boxes(seed % 5 == 0 ? 0 : 20 * seed + 1, seed), of_b = random_boxes(150, seed + 100);
  const BoxTree a = tree_of(of_a, seed % 2 == 0), b = tree_of(of_b, seed % 3 == 0);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found, expected;
  for_each_near_leaves(a, b, [&](BoxTree::Branch m, BoxTree::Branch n) {
    for (const std::uint32_t i : a.items(m))
      for (const std::uint32_t k : b.items(n))
        if (of_a[i].overlaps(of_b[k])) found.emplace_back(i, k);
    return true;
  });
  for (std::uint32_t i = 0; i < of_a.size(); ++i)
    for (std::uint32_t k = 0; k < of_b.size(); ++k)
      if (of_a[i].overlaps(of_b[k])) expected.emplace_back(i, k);
  std::sort(found.begin(), found.end());
  CHECK(found == expected);
}

TEST_CASE("branches know how much they hold", "[containers]") {
  const auto boxes = random_boxes(777, 3);
  for (const bool by_order : {false, true}) {
    const BoxTree tree = tree_of(boxes, by_order);
    const auto check = [&](auto&& self, BoxTree::Branch b) -> std::uint32_t {
      if (tree.is_leaf(b)) {
        CHECK(tree.items(b).size() == tree.count(b));
        CHECK(tree.count(b) <= BoxTree::leaf_size);
        return tree.count(b);
      }
      const auto [left, right] = tree.children(b);
      const std::uint32_t count = self(self, left) + self(self, right);
      CHECK(tree.count(b) == count);
      return count;
    };
    CHECK(check(check, tree.root()) == 777);
  }
}

TEST_CASE("boxes without an end, and far from all others, are found, too", "[containers]") {
  auto boxes = random_boxes(100, 5);
  boxes[7].upper[2] = Box::infinity;
  boxes[8].lower[0] = -Box::infinity;
  boxes[9] = Box{{-1e308, -1e308, -1e308}, {1e308, 1e308, 1e308}};
  const BoxTree tree = tree_of(boxes, false);
  const Box far{{5, 5, 1e300}, {1e300, 1e300, 1e301}};
  Numbers expected;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].overlaps(far)) expected.push_back(i);
  CHECK(near(tree, boxes, far) == expected);
}

TEST_CASE("a tree is the same for any number of threads", "[containers][threads]") {
  const auto boxes = random_boxes(100'000, 6);
  std::array<Numbers, 2> order;
  for (const std::size_t threads : {1u, 4u}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    order[threads == 1 ? 0 : 1] = all_of(tree_of(boxes, false));
  }
  CHECK(order[0] == order[1]);
}
