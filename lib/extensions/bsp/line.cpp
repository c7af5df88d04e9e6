#include <algorithm>

#include "extensions/bsp/partition_data.h"

namespace strata::bsp {
namespace {

bool is_less(const std::optional<Rational>& lower,
             const std::optional<Rational>& other) {  // as lower ends of intervals
  if (!lower || !other) return !lower && other;
  return *lower < *other;
}

/// Joins intervals that touch or overlap.
std::vector<Interval> joined(std::vector<Interval> intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return is_less(a.lower, b.lower); });
  std::vector<Interval> result;
  for (Interval& i : intervals) {
    if (result.empty()) {
      result.push_back(std::move(i));
      continue;
    }
    std::optional<Rational>& end = result.back().upper;
    if (end && i.lower && *i.lower > *end) {
      result.push_back(std::move(i));
    } else if (!i.upper || (end && *i.upper > *end)) {
      end = std::move(i.upper);
    }
  }
  return result;
}

/// Descends with the part of a line in a node's part of space.
template <int D>
class LineCutter {
 public:
  LineCutter(const Partition<D>& region, const ParametricLine<D>& line) : region_(region), line_(line) {}

  std::vector<Interval> cut(Interval whole) {
    visit(tree_of(region_).root, std::move(whole));
    return joined(std::move(found_));
  }

 private:
  void visit(Link link, Interval part) {
    if (is_leaf(link)) {
      if (link == leaf_in) found_.push_back(std::move(part));
      return;
    }
    const Node& node = tree_of(region_).nodes[link];
    const auto& form = table_of(region_)[node.hyperplane].exact();
    Rational value = form[D], slope = 0;
    for (std::size_t i = 0; i < D; ++i) {
      value += form[i] * line_.p[i];
      slope += form[i] * line_.d[i];
    }
    if (slope == 0) {
      if (value <= 0) visit(node.minus, part);
      if (value >= 0) visit(node.plus, part);
      return;
    }
    const Rational t = -value / slope;
    const Link before = slope > 0 ? node.minus : node.plus, behind = slope > 0 ? node.plus : node.minus;
    if (!part.lower || *part.lower <= t) visit(before, {part.lower, part.upper && *part.upper < t ? *part.upper : t});
    if (!part.upper || *part.upper >= t) visit(behind, {part.lower && *part.lower > t ? *part.lower : t, part.upper});
  }

  const Partition<D>& region_;
  const ParametricLine<D>& line_;
  std::vector<Interval> found_;
};

}  // namespace

Partition<1> partition_of(std::span<const Interval> intervals) {
  HyperplaneTable<1> table;
  std::vector<Facet<1>> facets;
  const auto add = [&](const std::optional<Rational>& end, bool faces_plus) {
    if (!end) return;
    const std::uint32_t h = table.add(axis_hyperplane<1>(0, *end));
    facets.push_back({whole(table, h), faces_plus});
  };
  std::vector<Interval> long_ones;
  for (const Interval& i : intervals)
    if (!i.lower || !i.upper || *i.lower < *i.upper) long_ones.push_back(i);
  const std::vector<Interval> apart = joined(std::move(long_ones));
  if (!apart.empty() && !apart[0].lower && !apart[0].upper) return Partition<1>::all();
  for (const Interval& i : apart) {
    add(i.lower, false);
    add(i.upper, true);
  }
  Tree tree = built(table, std::move(facets));
  return compact(partition_from(std::move(table), std::move(tree)));
}

std::vector<Interval> intervals_of(const Partition<1>& region) { return intersection<1>(region, {{0}, {1}}); }

template <int D>
std::vector<Interval> intersection(const Partition<D>& region, const ParametricLine<D>& line) {
  return LineCutter<D>(region, line).cut({});
}

template <int D>
std::vector<Interval> ray_intersection(const Partition<D>& region, const ParametricLine<D>& ray) {
  return LineCutter<D>(region, ray).cut({Rational(0), std::nullopt});
}

#define STRATA_INSTANTIATE(D)                                                                 \
  template std::vector<Interval> intersection(const Partition<D>&, const ParametricLine<D>&); \
  template std::vector<Interval> ray_intersection(const Partition<D>&, const ParametricLine<D>&);
STRATA_INSTANTIATE(1)
STRATA_INSTANTIATE(2)
STRATA_INSTANTIATE(3)
#undef STRATA_INSTANTIATE

}  // namespace strata::bsp
