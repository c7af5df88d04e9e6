#include <algorithm>
#include <numeric>

#include "strata/complex.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

void keep_different(std::vector<Index>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

template <class Visit>
Lists::Lists(Index count, const Visit& visit) : first_(std::size_t{count} + 1) {
  visit([&](Index list, Index) { ++first_[list + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  entries_.resize(first_.back());
  std::vector<Index> next(first_.begin(), first_.end() - 1);
  visit([&](Index list, Index entry) { entries_[next[list]++] = entry; });
}

Lists Lists::followed() const {
  Lists result;
  result.first_.reserve(first_.size());
  std::vector<Index> all;
  for (Index list = 0; list + 1 < first_.size(); ++list) {
    all.assign((*this)[list].begin(), (*this)[list].end());
    for (std::size_t from = 0;
         from < all.size();) {  // each round increases the dimension by one at least: three at most
      const std::size_t end = all.size();
      for (; from < end; ++from) all.insert(all.end(), (*this)[all[from]].begin(), (*this)[all[from]].end());
      std::sort(all.begin() + static_cast<std::ptrdiff_t>(end), all.end());
      all.erase(std::unique(all.begin() + static_cast<std::ptrdiff_t>(end), all.end()), all.end());
    }
    keep_different(all);
    result.entries_.insert(result.entries_.end(), all.begin(), all.end());
    result.first_.push_back(static_cast<Index>(result.entries_.size()));
  }
  return result;
}

Incidences::Incidences(const Cells& cells) {
  for (std::size_t d = 0; d < 4; ++d) first_[d + 1] = first_[d] + cells.count(static_cast<int>(d));
  const Lists above(count(), [&](const auto& add) {
    for (Index e = 0; e < cells.edges.size(); ++e)
      for (const Index v : cells.edges[e]) add(v, first_[1] + e);
    for (const Wing& w : cells.wings) add(first_[1] + w.edge, first_[2] + w.face);
    for (const Isolated& i : cells.vertices_in_faces) add(i.cell, first_[2] + i.in);
    for (const Isolated& i : cells.vertices_in_volumes) add(i.cell, first_[3] + i.in);
    for (const Isolated& i : cells.edges_in_volumes) add(first_[1] + i.cell, first_[3] + i.in);
    for (Index f = 0; f < cells.sides.size(); ++f)
      for (const Index v : cells.sides[f]) add(first_[2] + f, first_[3] + v);
  });
  star_ = above.followed();
  boundary_ = Lists(count(), [&](const auto& add) {
    for (Index c = 0; c < count(); ++c)
      for (const Index high : star_[c]) add(high, c);
  });
}

Cell Incidences::cell(std::uint32_t number) const {
  int d = 0;
  while (number >= first_[static_cast<std::size_t>(d) + 1]) ++d;
  return {d, number - first_[static_cast<std::size_t>(d)]};
}

}  // namespace strata::complex
