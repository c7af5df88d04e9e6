#include "core/containers/packed_boxes.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <utility>

using namespace strata;

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

using Keys = PackedBoxes::Keys;

constexpr Keys no_keys{PackedBoxes::no_key, PackedBoxes::no_key, PackedBoxes::no_key};

std::vector<PackedBoxes::Pair> pairs_of(const std::vector<Box>& boxes, const std::vector<Keys>& keys,
                                        const BoxPackTests& tests) {
  Box bounds;
  for (const Box& box : boxes) bounds.include(box);
  const PackedBoxes packed(
      static_cast<std::uint32_t>(boxes.size()), bounds, [&](std::uint32_t i) { return boxes[i]; },
      [&](std::uint32_t i) { return keys[i]; }, tests);
  std::vector<PackedBoxes::Pair> found;
  for (std::size_t group = 0; group < packed.group_count(); ++group) packed.append_pairs_of(group, found);
  return found;
}

/// With all instructions that this processor has, which find the same.
std::vector<Pair> pairs_of(const std::vector<Box>& boxes, const std::vector<Keys>& keys) {
  const std::vector<PackedBoxes::Pair> found = pairs_of(boxes, keys, BoxPackTests::available().front());
  for (const BoxPackTests& tests : BoxPackTests::available().subspan(1)) {
    const std::vector<PackedBoxes::Pair> again = pairs_of(boxes, keys, tests);
    REQUIRE(std::equal(found.begin(), found.end(), again.begin(), again.end(),
                       [](const auto& a, const auto& b) { return a.item == b.item && a.other == b.other; }));
  }
  std::vector<Pair> pairs;
  for (const auto& [a, b] : found) pairs.emplace_back(std::minmax(a, b));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<Pair> pairs_of(const std::vector<Box>& boxes) {
  return pairs_of(boxes, std::vector<Keys>(boxes.size(), no_keys));
}

bool have_common_key(const Keys& a, const Keys& b) {
  return std::any_of(a.begin(), a.end(), [&](std::uint32_t k) {
    return k != PackedBoxes::no_key && std::find(b.begin(), b.end(), k) != b.end();
  });
}

std::vector<Pair> pairs_by_comparison(const std::vector<Box>& boxes, const std::vector<Keys>& keys) {
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < boxes.size(); ++a)
    for (std::uint32_t b = a + 1; b < boxes.size(); ++b)
      if (boxes[a].overlaps(boxes[b]) && !have_common_key(keys[a], keys[b])) pairs.emplace_back(a, b);
  return pairs;
}

}  // namespace

// Seen to fail: children of a node skipped when their first node comes earlier; bits up to the own one kept in a pack.
TEST_CASE("packed boxes find every pair that overlaps once", "[containers][property]") {
  const unsigned seed = GENERATE(range(0u, 80u));
  std::mt19937 random(seed);
  const std::size_t count = seed < 20 ? seed : random() % 1500;
  const double scale = seed % 4 == 0 ? 1e300 : seed % 4 == 1 ? 1e-300 : 1;
  std::vector<Box> boxes(count);
  for (Box& b : boxes)
    for (std::size_t i = 0; i < 3; ++i) {
      // Crowds near the origin, within a few boxes far away.
      const double size = random() % 50 == 0 ? 1e6 : random() % 3 == 0 ? 1e-6 : 10;
      b.lower[i] = scale * size * (static_cast<double>(random() % 21) - 10);
      b.upper[i] = b.lower[i] + scale * (random() % 40 == 0 ? 50 : size / 10) * static_cast<double>(random() % 5);
    }
  std::vector<Keys> keys(count, no_keys);
  for (Keys& k : keys)
    for (std::uint32_t& key : k)
      if (random() % 3 != 0) key = static_cast<std::uint32_t>(random() % (1 + count / 2));
  CHECK(pairs_of(boxes, keys) == pairs_by_comparison(boxes, keys));
  CHECK(pairs_of(boxes) == pairs_by_comparison(boxes, std::vector<Keys>(count, no_keys)));
}

TEST_CASE("packed boxes that all overlap, in one point or as one box", "[containers]") {
  const std::vector<Box> points(300, Box{{1, 2, 3}, {1, 2, 3}});
  CHECK(pairs_of(points).size() == 300 * 299 / 2);
  CHECK(pairs_of({}).empty());
  CHECK(pairs_of({Box{{0, 0, 0}, {1, 1, 1}}}).empty());
  const double largest = std::numeric_limits<double>::max();
  const Box all{{-largest, -largest, -largest}, {largest, largest, largest}};
  CHECK(pairs_of({all, all, Box{{largest, largest, largest}, {largest, largest, largest}}}).size() == 3);
}

// Seen to fail: pairs of the pack that asks kept; two groups asked about twice.
TEST_CASE("packed boxes leave out the pairs of groups that are apart", "[containers]") {
  // Boxes that all overlap, and a last group that is said to be apart from all others.
  constexpr std::uint32_t count = 1000;
  const auto box_of = [](std::uint32_t i) {
    const double x = i % 2 == 0 ? 0 : 1, shift = 1e-3 * i;
    return Box{{x - 10 - shift, -shift, 0}, {x + 10, 1, 1}};
  };
  const PackedBoxes packed(count, Box{{-20, -2, 0}, {20, 1, 1}}, box_of, [](std::uint32_t) { return Keys{no_keys}; });
  using Items = std::span<const std::uint32_t>;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> asked;
  const auto are_apart = [&](Items items, Items others) {
    asked.emplace_back(items.front(), others.front());
    return others.size() < 64;
  };
  std::vector<PackedBoxes::Pair> all, found;
  for (std::size_t group = 0; group < packed.group_count(); ++group) packed.append_pairs_of(group, all);
  for (std::size_t group = 0; group < packed.group_count(); ++group) packed.append_pairs_of(group, found, are_apart);
  CHECK(all.size() == count * (count - 1) / 2);
  const std::size_t last = count % 64, before = count - last;  // the last group is apart from all others
  CHECK(found.size() == all.size() - last * before);
  std::sort(asked.begin(), asked.end());
  CHECK(std::adjacent_find(asked.begin(), asked.end()) == asked.end());
  CHECK(asked.size() == packed.group_count() * (packed.group_count() - 1) / 2);
}
