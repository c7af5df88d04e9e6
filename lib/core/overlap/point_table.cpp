#include "core/overlap/point_table.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <limits>

#include "core/containers/collect.h"
#include "core/containers/for_each_index.h"
#include "core/containers/hash_index.h"
#include "core/exact/failure.h"
#include "core/kernel/disjoint_sets.h"
#include "core/kernel/predicates.h"

namespace strata {
namespace {

using Index = std::uint32_t;
constexpr Index none = std::numeric_limits<Index>::max();

constexpr std::size_t names_at_once = 1 << 12;

std::uint64_t hash_of(const SymbolicPoint& name) {
  std::uint64_t h = static_cast<std::uint64_t>(name.kind) * 0x9e3779b97f4a7c15u;
  for (const std::uint32_t id : name.id) h = (h ^ id) * 0xff51afd7ed558ccdu + (h >> 29);
  return h ^ h >> 32;
}

/// Finds the first occurrence of every name in a list, in parallel.
template <class NameOf>
class FirstOccurrences {
 public:
  /// `name_of(i)` for i < count.
  FirstOccurrences(std::size_t count, const NameOf& name_of) : name_of_(name_of), table_(count) {
    for_each_index(count, names_at_once, [&](std::size_t i) {
      const SymbolicPoint& name = name_of_(i);
      table_.add_lowest(hash_of(name), static_cast<Index>(i), [&](Index k) { return name_of_(k) == name; });
    });
  }

  [[nodiscard]] Index of(std::size_t i) const {
    const SymbolicPoint& name = name_of_(i);
    return table_.find(hash_of(name), [&](Index k) { return k == i || name_of_(k) == name; });
  }

 private:
  const NameOf& name_of_;
  ConcurrentHashIndex table_;
};

}  // namespace

std::vector<PointId> PointTable::add(std::span<const SymbolicPoint> names, const Monitor& monitor) {
  const std::size_t known = constructed_.size();
  if (std::size_t{first()} + known + names.size() >= none) fail("more points than numbers", none);
  const auto name_of = [&](std::size_t i) -> const SymbolicPoint& {
    return i < known ? constructed_[i].name : names[i - known];
  };
  std::vector<PointId> numbers(names.size());
  const auto is_input = [&](std::size_t i) { return names[i].kind == SymbolicPoint::Kind::input; };
  const FirstOccurrences firsts(known + names.size(), name_of);
  for_each_index(names.size(), names_at_once, [&](std::size_t i) { numbers[i] = firsts.of(known + i); });
  std::vector<Index> fresh;  // indices of names that occur here first
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (is_input(i)) {
      numbers[i] = names[i].id[0];
    } else if (numbers[i] == known + i) {
      numbers[i] = first() + static_cast<PointId>(known + fresh.size());
      fresh.push_back(static_cast<Index>(i));
    } else {
      numbers[i] = numbers[i] < known ? first() + numbers[i] : numbers[numbers[i] - known];
    }
  }
  constructed_.resize(known + fresh.size());
  for_each_index(fresh.size(), 256, monitor,
                 [&](std::size_t i) { constructed_[known + i] = make_point(*input_, names[fresh[i]]); });
  return numbers;
}

std::vector<std::pair<PointId, PointId>> PointTable::equal_positions(std::vector<PointId> ids,
                                                                     const Monitor& monitor) const {
  std::vector<char> is_wanted(end(), 0);  // faces name most points several times
  for (const PointId id : ids) is_wanted[id] = 1;
  ids = collect(is_wanted.size(), [&](PointId id) { return is_wanted[id] != 0; });
  struct Place {
    InputComplex::Coordinates nearest;  ///< equal points have equal ones
    PointId id;
    bool operator<(const Place& p) const { return nearest < p.nearest || (nearest == p.nearest && id < p.id); }
  };
  std::vector<Place> places(ids.size());
  for_each_index(ids.size(), 256, monitor, [&](std::size_t i) {
    places[i] = {nearest_doubles(*input_, point(ids[i])), ids[i]};
  });
  tbb::parallel_sort(places.begin(), places.end());
  std::vector<std::size_t> starts;  // of places with equal doubles
  for (std::size_t i = 0; i < places.size(); ++i)
    if (i == 0 || places[i].nearest != places[i - 1].nearest) starts.push_back(i);
  starts.push_back(places.size());
  const auto find = [&](std::size_t first, std::size_t last, std::vector<std::pair<PointId, PointId>>& same) {
    constexpr std::size_t few = 8;
    if (last - first <= few) {
      for (std::size_t i = first + 1; i < last; ++i) {
        const Point p = point(places[i].id);
        for (std::size_t k = first; k < i; ++k) {
          if (!equal(*input_, point(places[k].id), p)) continue;
          same.emplace_back(places[k].id, places[i].id);
          break;
        }
      }
    } else {  // where doubles are sparse: near zero
      std::vector<std::pair<RationalPoint, PointId>> exact;
      for (std::size_t i = first; i < last; ++i)
        exact.emplace_back(exact_position(*input_, point(places[i].id)), places[i].id);
      std::sort(exact.begin(), exact.end());
      for (std::size_t i = 1; i < exact.size(); ++i)
        if (exact[i].first == exact[i - 1].first) same.emplace_back(exact[i - 1].second, exact[i].second);
    }
  };
  constexpr std::size_t at_once = 256;
  const std::size_t groups = starts.size() - 1;
  std::vector<std::vector<std::pair<PointId, PointId>>> found((groups + at_once - 1) / at_once);
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t n) {
    monitor.check();
    for (std::size_t k = n * at_once; k < std::min((n + 1) * at_once, groups); ++k)
      if (starts[k + 1] - starts[k] > 1) find(starts[k], starts[k + 1], found[n]);
  });
  std::vector<std::pair<PointId, PointId>> all;
  for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

void PointTable::identify(std::span<const std::pair<PointId, PointId>> equal) {
  if (equal.empty()) return;
  DisjointSets<PointId> sets(end());
  for (const auto& [a, b] : equal) sets.unite(a, b);
  same_.resize(end());
  for (PointId id = 0; id < end(); ++id) same_[id] = sets.find(id);
}

}  // namespace strata
