#include "extensions/scene/dominance.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

#include "extensions/scene/subordination.h"

namespace strata {
namespace {

/// A pair is tested in the square that contains the corner where the overlap of their rectangles begins. One square
/// contains it, and both faces are listed there, unless a large face was left out because its edges show that it is not
/// there.
bool is_tested_here(const Footprint& a, const Footprint& b, const ChartSquare& square) {
  if (a.is_large || b.is_large) return true;
  return square.holds(std::max(a.lower[0], b.lower[0]), std::max(a.lower[1], b.lower[1]));
}

bool rectangles_overlap(const Footprint& a, const Footprint& b) {
  return a.lower[0] <= b.upper[0] && b.lower[0] <= a.upper[0] && a.lower[1] <= b.upper[1] && b.lower[1] <= a.upper[1];
}

class PairTester {
 public:
  PairTester(const Sight& sight, const DirectionIndex& index, const std::vector<Sign>& orientations)
      : sight_(sight), index_(index), orientations_(orientations) {}

  void test(const DirectionIndex::Leaf& leaf) {
    const auto footprints = index_.footprints(leaf.chart);
    for (std::size_t i = 0; i < leaf.footprints.size(); ++i) {
      const Footprint& a = footprints[leaf.footprints[i]];
      if (orientations_[a.face] == Sign::zero) continue;
      const Subordination s(sight_, {sight_.input().face(a.face), orientations_[a.face]});
      for (std::size_t j = i + 1; j < leaf.footprints.size(); ++j) {
        const Footprint& b = footprints[leaf.footprints[j]];
        if (orientations_[b.face] == Sign::zero || !rectangles_overlap(a, b) || !is_tested_here(a, b, leaf.square))
          continue;
        add(a.face, b.face, s.to({sight_.input().face(b.face), orientations_[b.face]}));
      }
    }
  }

  Dominance found;

 private:
  void add(std::uint32_t s, std::uint32_t t, TetrahedraOverlap overlap) {
    ++found.pairs_tested;
    switch (overlap) {
      case TetrahedraOverlap::before:
        found.dominations.push_back({s, t});
        return;
      case TetrahedraOverlap::behind:
        found.dominations.push_back({t, s});
        return;
      case TetrahedraOverlap::crossing:
        found.crossings.push_back({std::min(s, t), std::max(s, t)});
        return;
      case TetrahedraOverlap::apart:
      case TetrahedraOverlap::touching:
      case TetrahedraOverlap::coplanar:
        return;
    }
  }

  const Sight& sight_;
  const DirectionIndex& index_;
  const std::vector<Sign>& orientations_;
};

void sort_and_unite(std::vector<Domination>& pairs) {
  tbb::parallel_sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace

Dominance find_dominance(const Sight& sight, const DirectionIndex& index, const std::vector<Sign>& orientations,
                         const Monitor& monitor) {
  tbb::enumerable_thread_specific<PairTester> testers([&] { return PairTester(sight, index, orientations); });
  index.for_each_leaf([&](const DirectionIndex::Leaf& leaf) {
    monitor.check();
    testers.local().test(leaf);
  });
  Dominance all;
  for (PairTester& t : testers) {
    all.pairs_tested += t.found.pairs_tested;
    all.dominations.insert(all.dominations.end(), t.found.dominations.begin(), t.found.dominations.end());
    all.crossings.insert(all.crossings.end(), t.found.crossings.begin(), t.found.crossings.end());
    t.found = {};
  }
  sort_and_unite(all.dominations);
  sort_and_unite(all.crossings);
  return all;
}

}  // namespace strata
