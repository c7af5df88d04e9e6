#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "extensions/scene/dominance.h"

namespace strata {

/// One list per piece, in one array.
struct Lists {
  std::vector<std::uint32_t> first, items;

  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t p) const {
    if (p + 1 >= first.size()) return {};
    return std::span(items).subspan(first[p], first[p + 1] - first[p]);
  }
};

/// From pairs that are sorted by `key`, or from any with a stable counting sort.
template <class Key, class Item>
[[nodiscard]] Lists make_lists(std::uint32_t count, const std::vector<Domination>& pairs, const Key& key,
                               const Item& item) {
  Lists lists;
  lists.first.assign(count + 1, 0);
  for (const Domination& d : pairs) ++lists.first[key(d) + 1];
  for (std::uint32_t p = 0; p < count; ++p) lists.first[p + 1] += lists.first[p];
  lists.items.resize(pairs.size());
  std::vector<std::uint32_t> next(lists.first.begin(), lists.first.end() - 1);
  for (const Domination& d : pairs) lists.items[next[key(d)]++] = item(d);
  return lists;
}

[[nodiscard]] inline Lists dominators_of(std::uint32_t count, const std::vector<Domination>& pairs) {
  return make_lists(
      count, pairs, [](const Domination& d) { return d.s; }, [](const Domination& d) { return d.t; });
}

[[nodiscard]] inline Lists dominated_by(std::uint32_t count, const std::vector<Domination>& pairs) {
  return make_lists(
      count, pairs, [](const Domination& d) { return d.t; }, [](const Domination& d) { return d.s; });
}

}  // namespace strata
