#include <stdexcept>

#include "core/kernel/disjoint_sets.h"
#include "strata/complex.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

}  // namespace

Components components(const SelectiveComplex& s, bool of_the_set) {
  const std::vector<std::uint8_t> marks = s.marks();
  const auto counts = [&](Index c) { return (marks[c] != 0) == of_the_set; };
  const auto n = static_cast<Index>(marks.size());
  DisjointSets<Index> sets(n);
  for (Index c = 0; c < n; ++c)
    for (const Index f : s.incidences().star(c))
      if (counts(c) && counts(f)) sets.unite(c, f);
  Components result;
  result.of_cell.assign(n, none);
  for (Index c = 0; c < n; ++c) {
    if (!counts(c)) continue;
    const Index root = sets.find(c);  // the lowest
    result.of_cell[c] = root == c ? result.count++ : result.of_cell[root];
  }
  return result;
}

std::vector<SelectiveComplex> separate(const SelectiveComplex& s) {
  const Components all = components(s);
  std::vector<SelectiveComplex> result;
  for (Index i = 0; i < all.count; ++i) {
    std::vector<std::uint8_t> marks(all.of_cell.size());
    for (std::size_t c = 0; c < marks.size(); ++c) marks[c] = all.of_cell[c] == i ? 1 : 0;
    result.push_back(s.with_marks(marks));
  }
  return result;
}

SelectiveComplex holes(const SelectiveComplex& s) {
  const Components outside = components(s, false);
  const Index unbounded = outside.of_cell[s.incidences().number({s.dimension(), 0})];
  std::vector<std::uint8_t> marks(outside.of_cell.size());
  for (std::size_t c = 0; c < marks.size(); ++c)
    marks[c] = outside.of_cell[c] != none && outside.of_cell[c] != unbounded ? 1 : 0;
  return s.with_marks(marks);
}

Index count_holes(const SelectiveComplex& s) { return components(s, false).count - (s.is_bounded() ? 1 : 0); }

bool is_connected(const SelectiveComplex& s) { return components(s).count <= 1; }

bool is_simply_connected(const SelectiveComplex& s) {
  if (!s.is_bounded()) throw std::invalid_argument("holes tell of bounded sets whether they are simply connected");
  return count_holes(s) == 0;
}

bool is_open(const SelectiveComplex& s) { return interior(s) == s; }
bool is_closed(const SelectiveComplex& s) { return closure(s) == s; }
bool is_closed_regularized(const SelectiveComplex& s) { return regularized(s) == s; }
bool is_open_regularized(const SelectiveComplex& s) { return open_regularized(s) == s; }

}  // namespace strata::complex
