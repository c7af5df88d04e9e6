#include "core/mesh/planar_chain.h"

#include <algorithm>
#include <utility>

namespace strata::facets {
namespace {

/// Orders by first end point, then by second.
struct EdgeOrder {
  const PointTable& points;
  bool operator()(const NetEdge& a, const NetEdge& b) const {
    const int first = points.compare(a.low, b.low);
    return first != 0 ? first < 0 : points.compare(a.high, b.high) < 0;
  }
};

/// Sorts, adds up equal edges and removes those with sum zero.
void sum_up(const PointTable& points, Chain& chain) {
  std::sort(chain.begin(), chain.end(), EdgeOrder{points});
  Chain sums;
  for (const NetEdge& edge : chain) {
    if (!sums.empty() && sums.back().low == edge.low && sums.back().high == edge.high) {
      sums.back().count += edge.count;
    } else {
      if (!sums.empty() && sums.back().count == 0) sums.pop_back();
      sums.push_back(edge);
    }
  }
  if (!sums.empty() && sums.back().count == 0) sums.pop_back();
  chain = std::move(sums);
}

/// The box of an edge along y and z, in ranks.
struct RankBox {
  std::uint32_t lower[2];
  std::uint32_t upper[2];

  [[nodiscard]] bool meets(const RankBox& other) const {
    return lower[0] <= other.upper[0] && other.lower[0] <= upper[0] && lower[1] <= other.upper[1] &&
           other.lower[1] <= upper[1];
  }
};

RankBox box_of(const PointTable& points, const NetEdge& edge) {
  RankBox box{};
  for (int axis = 1; axis < 3; ++axis) {
    const std::uint32_t a = points.rank(edge.low, axis);
    const std::uint32_t b = points.rank(edge.high, axis);
    box.lower[axis - 1] = std::min(a, b);
    box.upper[axis - 1] = std::max(a, b);
  }
  return box;
}

/// Calls visit(i, j) for all pairs of edges whose boxes meet, except pairs of which one ends before the other starts,
/// in lexicographic order. Every point must be one given at the start, so that numbers are in that order.
template <class Visit>
void for_each_near_pair(const PointTable& points, const Chain& chain, Visit visit) {
  std::vector<RankBox> boxes;
  boxes.reserve(chain.size());
  for (const NetEdge& edge : chain) boxes.push_back(box_of(points, edge));
  std::vector<std::size_t> active;
  for (std::size_t j = 0; j < chain.size(); ++j) {
    std::size_t kept = 0;
    for (const std::size_t i : active) {
      if (chain[i].high <= chain[j].low) continue;
      active[kept++] = i;
      if (boxes[i].meets(boxes[j])) visit(i, j);
    }
    active.resize(kept);
    active.push_back(j);
  }
}

/// Points at which an edge is divided.
struct Cut {
  std::size_t edge;
  std::uint32_t point;
};

/// Replaces every edge by its pieces between cuts. Cuts may repeat points under different names.
Chain apply(const PointTable& points, const Chain& chain, std::vector<Cut> cuts) {
  std::sort(cuts.begin(), cuts.end(), [&](const Cut& a, const Cut& b) {
    return a.edge != b.edge ? a.edge < b.edge : points.compare(a.point, b.point) < 0;
  });
  Chain pieces;
  auto cut = cuts.begin();
  for (std::size_t i = 0; i < chain.size(); ++i) {
    std::uint32_t start = chain[i].low;
    for (; cut != cuts.end() && cut->edge == i; ++cut) {
      if (points.compare(start, cut->point) == 0) continue;
      pieces.push_back({start, cut->point, chain[i].count});
      start = cut->point;
    }
    pieces.push_back({start, chain[i].high, chain[i].count});
  }
  sum_up(points, pieces);
  return pieces;
}

/// The point where the lines of two crossing edges meet.
HPoint<Integer> crossing(const PointTable& points, Projection axes, const NetEdge& e, const NetEdge& f) {
  const RationalPoint a = rational(points[e.low]);
  const RationalPoint b = rational(points[e.high]);
  const RationalPoint c = rational(points[f.low]);
  const RationalPoint d = rational(points[f.high]);
  const auto side = [&](const RationalPoint& p) -> Rational {
    const auto [i, j] = axes;
    return (d[i] - c[i]) * (p[j] - c[j]) - (d[j] - c[j]) * (p[i] - c[i]);
  };
  const Rational at_a = side(a);
  const Rational t = at_a / (at_a - side(b));
  RationalPoint result;
  for (int i = 0; i < 3; ++i) result[i] = a[i] + t * (b[i] - a[i]);
  return homogeneous(result);
}

/// Gives each point of the cuts one name.
void unify_names(const PointTable& points, std::vector<Cut>& cuts) {
  std::vector<std::uint32_t> names;
  for (const Cut& cut : cuts) names.push_back(cut.point);
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    const int order = points.compare(a, b);
    return order != 0 ? order < 0 : a < b;
  };
  std::sort(names.begin(), names.end(), less);
  for (Cut& cut : cuts) {
    cut.point = *std::partition_point(names.begin(), names.end(),
                                      [&](std::uint32_t n) { return points.compare(n, cut.point) < 0; });
  }
}

}  // namespace

Chain net_chain(const PointTable& points, const std::vector<Side>& sides) {
  Chain chain;
  chain.reserve(sides.size());
  for (const Side& side : sides) {
    const int order = points.compare(side.from, side.to);
    if (order < 0) chain.push_back({side.from, side.to, 1});
    if (order > 0) chain.push_back({side.to, side.from, -1});
  }
  sum_up(points, chain);
  return chain;
}

Chain cut_at_contacts(const PointTable& points, Projection axes, const Chain& chain) {
  std::vector<Cut> cuts;
  const auto cut_where_inside = [&](std::size_t i, std::uint32_t p) {
    const NetEdge& e = chain[i];
    if (e.low < p && p < e.high && orientation(points, axes, e.low, e.high, p) == 0) cuts.push_back({i, p});
  };
  for_each_near_pair(points, chain, [&](std::size_t i, std::size_t j) {
    cut_where_inside(i, chain[j].low);
    cut_where_inside(i, chain[j].high);
    cut_where_inside(j, chain[i].low);
    cut_where_inside(j, chain[i].high);
  });
  return cuts.empty() ? chain : apply(points, chain, std::move(cuts));
}

Chain cut_at_crossings(PointTable& points, Projection axes, const Chain& chain) {
  std::vector<Cut> cuts;
  for_each_near_pair(points, chain, [&](std::size_t i, std::size_t j) {
    const NetEdge& e = chain[i];
    const NetEdge& f = chain[j];
    const auto separates = [&](const NetEdge& g, const NetEdge& h) {
      return orientation(points, axes, g.low, g.high, h.low) * orientation(points, axes, g.low, g.high, h.high) < 0;
    };
    if (!separates(e, f) || !separates(f, e)) return;
    const std::uint32_t p = points.add(crossing(points, axes, e, f));
    cuts.push_back({i, p});
    cuts.push_back({j, p});
  });
  if (cuts.empty()) return chain;
  unify_names(points, cuts);
  return apply(points, chain, std::move(cuts));
}

}  // namespace strata::facets
