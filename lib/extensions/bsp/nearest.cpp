#include <algorithm>
#include <cmath>

#include "core/exact/scaled_root.h"
#include "extensions/bsp/partition_data.h"

namespace strata::bsp {
namespace {

template <int D>
Rational dot(const RationalVector<D>& u, const RationalVector<D>& v) {
  Rational sum = 0;
  for (std::size_t i = 0; i < D; ++i) sum += u[i] * v[i];
  return sum;
}

template <int D>
Rational squared_distance(const RationalVector<D>& p, const RationalVector<D>& q) {
  Rational sum = 0;
  for (std::size_t i = 0; i < D; ++i) sum += (p[i] - q[i]) * (p[i] - q[i]);
  return sum;
}

template <int D>
RationalVector<D> normal_of(const Hyperplane<D>& plane) {
  RationalVector<D> n;
  for (std::size_t i = 0; i < D; ++i) n[i] = plane.exact()[i];
  return n;
}

/// The foot of p on a hyperplane.
template <int D>
RationalVector<D> foot_on(const Hyperplane<D>& plane, const RationalVector<D>& p) {
  const RationalVector<D> n = normal_of(plane);
  const Rational t = (dot<D>(n, p) + plane.exact()[D]) / dot<D>(n, n);
  RationalVector<D> foot = p;
  for (std::size_t i = 0; i < D; ++i) foot[i] -= t * n[i];
  return foot;
}

/// The foot of p on the line where two planes meet: within the first plane, along the projection of the second's
/// normal.
RationalVector<3> foot_on_line(const Hyperplane<3>& plane, const Hyperplane<3>& wall, const RationalVector<3>& p) {
  const RationalVector<3> n = normal_of(plane), m = normal_of(wall);
  RationalVector<3> foot = foot_on<3>(plane, p), along = m;
  const Rational share = dot<3>(m, n) / dot<3>(n, n);
  for (std::size_t i = 0; i < 3; ++i) along[i] -= share * n[i];
  const Rational t = (dot<3>(m, foot) + wall.exact()[3]) / dot<3>(along, along);
  for (std::size_t i = 0; i < 3; ++i) foot[i] -= t * along[i];
  return foot;
}

/// Nearest points of convex pieces.
template <int D>
class PieceProjector {
 public:
  PieceProjector(const HyperplaneTable<D>& table, const RationalVector<D>& p) : table_(table), p_(p) {}

  [[nodiscard]] RationalVector<D> nearest(const Piece<D>& piece) const {
    RationalVector<D> foot = foot_on<D>(table_[piece.hyperplane], p_);
    if constexpr (D == 1) return foot;
    if constexpr (D == 2) return on_segment(foot, piece.corners[0], piece.corners[1]);
    if constexpr (D == 3) return in_polygon(std::move(foot), piece);
  }

 private:
  /// The point of a segment nearest to a point of its line: that point itself, or the corner beyond which it is.
  [[nodiscard]] RationalVector<D> on_segment(const RationalVector<D>& foot, const HyperplaneMeet<D>& a,
                                             const HyperplaneMeet<D>& b) const {
    if (is_beyond(foot, a, b)) return table_.position(a);
    if (is_beyond(foot, b, a)) return table_.position(b);
    return foot;
  }

  /// True when the direction from the first corner to a point of the line leads away from the second corner.
  [[nodiscard]] bool is_beyond(const RationalVector<D>& foot, const HyperplaneMeet<D>& first,
                               const HyperplaneMeet<D>& second) const {
    if (first.is_far) return false;
    const RationalVector<D> from = table_.position(first);
    const RationalVector<D> to = second.is_far ? direction(second) : table_.position(second);
    for (std::size_t i = 0; i < D; ++i) {
      const Rational way = second.is_far ? to[i] : Rational(to[i] - from[i]);
      if (way != 0) return (foot[i] - from[i]) * way < 0;
    }
    return false;
  }

  /// The direction of a far corner, up to length: its longest component has its sign, others are left out.
  [[nodiscard]] static RationalVector<D> direction(const HyperplaneMeet<D>& far) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < D; ++i)
      if (std::abs(far.at[i].value) > std::abs(far.at[longest].value)) longest = i;
    RationalVector<D> d{};
    d[longest] = far.at[longest].value > 0 ? 1 : -1;
    return d;
  }

  [[nodiscard]] RationalVector<D> in_polygon(RationalVector<D> foot, const Piece<D>& polygon) const {
    if (is_inside(foot, polygon)) return foot;
    std::optional<RationalVector<D>> best;
    Rational least = 0;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
      if (HyperplaneTable<D>::is_frame(polygon.walls[i])) continue;
      const RationalVector<D> candidate =
          on_segment(foot_on_line(table_[polygon.hyperplane], table_[polygon.walls[i]], p_), polygon.corners[i],
                     polygon.corners[(i + 1) % polygon.corners.size()]);
      Rational away = squared_distance<D>(candidate, p_);
      if (best && away >= least) continue;
      best = candidate;
      least = std::move(away);
    }
    return *best;  // a polygon without walls is a whole plane, and every point is inside
  }

  [[nodiscard]] bool is_inside(const RationalVector<D>& foot, const Piece<D>& polygon) const {
    for (const std::uint32_t wall : polygon.walls) {
      if (HyperplaneTable<D>::is_frame(wall)) continue;
      Sign inner = Sign::zero;
      for (std::size_t i = 0; i < polygon.corners.size() && inner == Sign::zero; ++i)
        inner = table_.side(wall, polygon.corners[i]);
      if (table_.side(wall, foot) * inner == Sign::negative) return false;
    }
    return true;
  }

  const HyperplaneTable<D>& table_;
  const RationalVector<D>& p_;
};

/// Front to back, skipping parts that are farther than the best point so far.
template <int D>
class NearestFinder {
 public:
  NearestFinder(const Partition<D>& region, const RationalVector<D>& p)
      : table_(table_of(region)), tree_(tree_of(region)), p_(p), projector_(table_, p_) {}

  [[nodiscard]] std::optional<NearestPoint<D>> find() {
    visit(tree_.root);
    return std::move(best_);
  }

 private:
  void visit(Link link) {
    if (is_leaf(link)) return;
    const Node& node = tree_.nodes[link];
    const Sign side = table_.side(node.hyperplane, p_) == Sign::positive ? Sign::positive : Sign::negative;
    descend(node, side);
    const Rational away = squared_distance<D>(foot_on<D>(table_[node.hyperplane], p_), p_);
    if (best_ && away >= best_->squared_distance) return;
    for_each_facet<D>(table_, tree_, link, path_, [&](const Facet<D>& f) { offer(projector_.nearest(f.piece)); });
    descend(node, -side);
  }

  void descend(const Node& node, Sign side) {
    path_.push_back({node.hyperplane, side});
    visit(side == Sign::negative ? node.minus : node.plus);
    path_.pop_back();
  }

  void offer(const RationalVector<D>& point) {
    Rational away = squared_distance<D>(point, p_);
    if (!best_ || away < best_->squared_distance) best_ = NearestPoint<D>{point, std::move(away), 0};
  }

  const HyperplaneTable<D>& table_;
  const Tree& tree_;
  const RationalVector<D>& p_;
  PieceProjector<D> projector_;
  Path path_;
  std::optional<NearestPoint<D>> best_;
};

}  // namespace

double nearest_square_root(const Rational& q) {
  if (q == 0) return 0;
  // The root of q 4^k in integers, with more bits than a double and the midpoints of doubles have. Where the root is no
  // integer, no midpoint of two doubles is between the integers around it, so all numbers between them round to the
  // same double.
  constexpr int kept = 140;
  const long size = binary_size(q), k = (kept - size + (size & 1)) / 2;
  const Integer root = scaled_root(q, k), power = Integer(1) << static_cast<unsigned long>(std::abs(k));
  const auto in_units = [&](Rational x) { return k >= 0 ? std::move(x /= power) : std::move(x *= power); };
  const Rational floor = in_units(root);
  return to_nearest_double(floor * floor == q ? floor : in_units(Rational(2 * root + 1, Integer(2))));
}

template <int D>
std::optional<NearestPoint<D>> nearest_boundary_point(const Partition<D>& region, const RationalVector<D>& p) {
  std::optional<NearestPoint<D>> nearest = NearestFinder<D>(region, p).find();
  if (!nearest) return nearest;
  const double distance = nearest_square_root(nearest->squared_distance);
  nearest->distance = region.classify_exact(p) == Where::in ? -distance : distance;
  return nearest;
}

template std::optional<NearestPoint<1>> nearest_boundary_point<1>(const Partition<1>&, const RationalVector<1>&);
template std::optional<NearestPoint<2>> nearest_boundary_point<2>(const Partition<2>&, const RationalVector<2>&);
template std::optional<NearestPoint<3>> nearest_boundary_point<3>(const Partition<3>&, const RationalVector<3>&);

}  // namespace strata::bsp
