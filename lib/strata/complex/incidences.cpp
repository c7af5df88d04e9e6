#include "strata/complex/incidences.h"

#include <algorithm>
#include <utility>

namespace strata::complex {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

void sort_unique(Pairs& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// Every incidence that follows from one with a cell in between: (low, middle) and (middle, high) give (low, high).
Pairs closed_over(const Pairs& direct, std::uint32_t count) {
  const Lists up(count, direct);
  Pairs all = direct;
  for (const auto& [low, middle] : direct)
    for (const std::uint32_t high : up[middle]) {
      all.emplace_back(low, high);
      for (const std::uint32_t top : up[high]) all.emplace_back(low, top);
    }
  sort_unique(all);
  return all;
}

}  // namespace

Lists::Lists(std::uint32_t lists, std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs)
    : first_(std::size_t{lists} + 1) {
  entries_.reserve(pairs.size());
  for (const auto& [list, entry] : pairs) {
    ++first_[list + 1];
    entries_.push_back(entry);
  }
  for (std::size_t i = 0; i < lists; ++i) first_[i + 1] += first_[i];
}

Incidences::Incidences(const Cells& cells) {
  for (int d = 0; d < 4; ++d) {
    const auto i = static_cast<std::size_t>(d);
    first_[i + 1] = first_[i] + cells.count(d);
  }
  Pairs direct;
  const auto add = [&](int d, std::uint32_t low, int e, std::uint32_t high) {
    direct.emplace_back(number({d, low}), number({e, high}));
  };
  for (std::uint32_t e = 0; e < cells.edges.size(); ++e)
    for (const std::uint32_t v : cells.edges[e]) add(0, v, 1, e);
  for (const Wing& w : cells.wings) add(1, w.edge, 2, w.face);
  for (const Isolated& i : cells.vertices_in_faces) add(0, i.cell, 2, i.in);
  for (const Isolated& i : cells.vertices_in_volumes) add(0, i.cell, 3, i.in);
  for (const Isolated& i : cells.edges_in_volumes) add(1, i.cell, 3, i.in);
  for (std::uint32_t f = 0; f < cells.sides.size(); ++f)
    for (const std::uint32_t v : cells.sides[f]) add(2, f, 3, v);
  sort_unique(direct);
  Pairs all = closed_over(direct, count());
  star_ = Lists(count(), all);
  for (auto& [low, high] : all) std::swap(low, high);
  std::sort(all.begin(), all.end());
  boundary_ = Lists(count(), all);
}

Cell Incidences::cell(std::uint32_t number) const {
  int d = 0;
  while (number >= first_[static_cast<std::size_t>(d) + 1]) ++d;
  return {d, number - first_[static_cast<std::size_t>(d)]};
}

}  // namespace strata::complex
