#include "extensions/scene/strong_components.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace strata {

std::vector<std::uint32_t> strong_components(const std::vector<std::vector<std::uint32_t>>& next) {
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

}  // namespace strata
