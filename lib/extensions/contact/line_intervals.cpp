#include "extensions/contact/line_intervals.h"

#include <algorithm>

namespace strata::contact {
namespace {

/// The union, as disjoint intervals in order.
Intervals united(Intervals list) {
  std::sort(list.begin(), list.end());
  Intervals result;
  for (const Interval& i : list) {
    if (!result.empty() && i.first <= result.back().second)
      result.back().second = std::max(result.back().second, i.second);
    else
      result.push_back(i);
  }
  return result;
}

}  // namespace

Intervals without(const Intervals& all, const Intervals& taken) {
  const Intervals gaps = united(taken);
  Intervals result;
  for (const Interval& i : united(all)) {
    Rational from = i.first;
    for (const Interval& gap : gaps) {
      if (gap.second <= from || gap.first >= i.second) continue;
      if (from < gap.first) result.emplace_back(from, gap.first);
      from = std::max(from, gap.second);
    }
    if (from < i.second) result.emplace_back(from, i.second);
  }
  return result;
}

}  // namespace strata::contact
