#pragma once
/// Binary space partitions: regular regions of the line, the plane and space, bounded or not, exact.
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "strata/combine.h"
#include "strata/measure.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/query.h"
#include "strata/rational.h"

namespace strata {

template <int D>
class HyperplaneTable;  // internal
template <int D>
struct OrientedHyperplane;  // internal

/// The engine `bsp` of `combine`: merged binary space partitions, exact, of other mathematics than the arrangement. The same
/// solid, divided into other triangles: facets in one plane are merged. The source of a triangle is some face of an operand
/// in its plane. For some thousand faces. Throws as `combine` does.
extern const Engine bsp_engine;

}  // namespace strata

namespace strata::bsp {

template <int D>
struct Facet;  // internal
template <int D>
struct Piece;  // internal

/// A point or a vector of D-space.
template <int D>
using RationalVector = std::array<Rational, D>;

/// A node of a tree or a leaf.
using Link = std::uint32_t;

/// Leaves: parts of space that are outside and inside.
inline constexpr Link leaf_out = 0xffff'fffe, leaf_in = 0xffff'ffff;

[[nodiscard]] constexpr bool is_leaf(Link link) { return link >= leaf_out; }
[[nodiscard]] constexpr Link leaf(bool is_inside) { return is_inside ? leaf_in : leaf_out; }
[[nodiscard]] constexpr Link other(Link leaf) { return leaf == leaf_in ? leaf_out : leaf_in; }

/// A hyperplane that divides a part of space in two.
struct Node {
  std::uint32_t hyperplane = 0;
  Link minus = leaf_out, plus = leaf_out;
};

/// A binary space partition: convex leaves, each inside or outside.
struct Tree {
  std::vector<Node> nodes;
  Link root = leaf_out;
  std::size_t splits = 0;  ///< facets that were divided when it was built
};

/// A regular region of the line (D = 1), the plane (2) or space (3), bounded or not, as a binary space partition: cuts
/// by hyperplanes, convex leaves that are inside or outside. All decisions are exact for whatever rationals it is made
/// of. Hyperplanes are those of the input and, where trees are built, axis-parallel ones through doubles: coefficients
/// do not grow, whatever is combined.
///
/// An immutable value, cheap to copy, safe to read from many threads.
template <int D>
class Partition {
 public:
  Partition();  ///< the empty region

  [[nodiscard]] static Partition all();  ///< the whole line, plane or space
  /// What is behind a hyperplane as it was given, the side that it does not look to.
  [[nodiscard]] static Partition half_space(const OrientedHyperplane<D>& hyperplane);  // internal
  /// The points x with n . x + c <= 0, for coefficients n, then c. Throws std::invalid_argument for n = 0.
  [[nodiscard]] static Partition half_space(const std::array<Rational, D + 1>& coefficients);
  /// What is behind all of these: convex, may be empty. Merged by halves, and built anew with
  /// axis-parallel cuts where that is less deep.
  [[nodiscard]] static Partition convex(std::span<const OrientedHyperplane<D>> hyperplanes);  // internal
  /// A tree over a table. Every node must divide its part of space; `pruned` makes trees so.
  [[nodiscard]] static Partition of(HyperplaneTable<D> table, Tree tree);  // internal

  [[nodiscard]] const HyperplaneTable<D>& table() const;  // internal: the hyperplanes of nodes by number
  [[nodiscard]] const Tree& tree() const;

  [[nodiscard]] bool is_empty() const { return tree().root == leaf_out; }
  [[nodiscard]] bool is_full() const { return tree().root == leaf_in; }
  [[nodiscard]] bool is_bounded() const;
  /// True when another region is part of this one.
  [[nodiscard]] bool contains(const Partition& other) const;

  /// Descends from the root; on a hyperplane both sides are asked. Exact. O(depth) for most points.
  [[nodiscard]] Where classify(const std::array<double, D>& p) const;
  [[nodiscard]] Where classify_exact(const RationalVector<D>& p) const;  ///< the same for rationals

  /// Convex facets with their interiors apart; `table()` has their corners.
  [[nodiscard]] std::vector<Facet<D>> boundary() const;  // internal; see boundary_mesh, sides_of, intervals_of

  /// The parts of a piece over this table that are in the region or on its boundary, convex and with interiors apart.
  [[nodiscard]] std::vector<Piece<D>> part_inside(const Piece<D>& piece) const;  // internal

 private:
  struct Data;
  explicit Partition(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

/// The regularized combination, by merging the trees. Laws: those of sets, up to the choice of leaves.
/// Depths add up at worst: where many are combined, do it by halves, or use `rebuilt_if_deep` (recursion is as deep
/// as trees are: a depth of a thousand fits on any thread's stack). Expected output-sensitive; at worst every node of
/// one tree meets every node of the other. Throws Cancelled.
template <int D>
[[nodiscard]] Partition<D> combined(Operation operation, const Partition<D>& a, const Partition<D>& b,
                                    const Monitor& monitor = {});

template <int D>
[[nodiscard]] Partition<D> operator|(const Partition<D>& a, const Partition<D>& b) {
  return combined(Operation::unite, a, b);
}
template <int D>
[[nodiscard]] Partition<D> operator&(const Partition<D>& a, const Partition<D>& b) {
  return combined(Operation::intersect, a, b);
}
template <int D>
[[nodiscard]] Partition<D> operator-(const Partition<D>& a, const Partition<D>& b) {
  return combined(Operation::subtract, a, b);
}
template <int D>
[[nodiscard]] Partition<D> operator^(const Partition<D>& a, const Partition<D>& b) {
  return combined(Operation::exclude, a, b);
}
/// The closure of what is outside. O(nodes).
template <int D>
[[nodiscard]] Partition<D> complement(const Partition<D>& region);

/// Equal as point sets.
template <int D>
[[nodiscard]] bool operator==(const Partition<D>& a, const Partition<D>& b) {
  return (a ^ b).is_empty();
}

/// The same tree, without hyperplanes that are not in it.
template <int D>
[[nodiscard]] Partition<D> compact(const Partition<D>& region);

/// The same region, its tree built anew from its boundary.
template <int D>
[[nodiscard]] Partition<D> rebuilt(const Partition<D>& region);

/// The same region, its tree built anew if it is deep for its size: deeper than 30 + 6 log2(leaves).
template <int D>
[[nodiscard]] Partition<D> rebuilt_if_deep(const Partition<D>& region);

/// Sizes of a tree, for reports.
struct TreeSize {
  std::size_t nodes = 0, leaves = 0, inside = 0, depth = 0, hyperplanes = 0, bytes = 0;
  double mean_depth = 0;  ///< of leaves
};
template <int D>
[[nodiscard]] TreeSize size_of_tree(const Partition<D>& region);

extern template class Partition<1>;
extern template class Partition<2>;
extern template class Partition<3>;

/// The region that a closed mesh bounds, whose winding numbers are 0 and 1; a mesh turned inside out bounds all else.
/// Triangles without area do not count. Requires that the mesh does not cross itself (`check` tells).
/// Expected O(n log^2 n); `built` has the choice of cuts.
[[nodiscard]] Partition<3> partition_of(ExactMeshView mesh, const Monitor& monitor = {});

/// A mesh and the oriented planes of its triangles, each once.
struct BoundaryMesh {
  ExactMesh mesh;
  std::vector<CanonicalPlane> planes;
  std::vector<std::uint32_t> plane_of;  ///< per triangle
};

/// The boundary as a closed triangle mesh with outward normals: facets in one plane are merged and divided anew, and
/// every vertex on an edge is a corner of all triangles there. Vertices in lexicographic order, coordinates rounded to
/// nearest doubles, exact places beside them. O(n log n) beside `boundary()`.
/// Throws std::domain_error when the boundary is not bounded.
[[nodiscard]] BoundaryMesh boundary_mesh(const Partition<3>& region);
[[nodiscard]] ExactMesh exact_mesh_of(const Partition<3>& region);  ///< the mesh alone

/// The boundary's one description; `canonical_form` of the mesh.
[[nodiscard]] CanonicalForm canonical_form_of(const Partition<3>& region);

/// The numbers between two ends, the ends with them; an end that is not there is infinite.
struct Interval {
  std::optional<Rational> lower, upper;
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// The points p + t d.
template <int D>
struct ParametricLine {
  RationalVector<D> p, d;
};

/// The region of the line that intervals cover together, which may overlap; those without length do not count.
[[nodiscard]] Partition<1> partition_of(std::span<const Interval> intervals);

/// The components of a region of the line, in increasing order.
[[nodiscard]] std::vector<Interval> intervals_of(const Partition<1>& region);

/// Where a line is in the closed region: intervals of t, apart, in increasing order. Where it lies in the boundary it
/// is in; where it meets the region in a point only, the interval is this point. Requires d != 0. O(nodes that the line
/// meets * depth); the numbers are rationals of bounded size over the region's hyperplanes.
template <int D>
[[nodiscard]] std::vector<Interval> intersection(const Partition<D>& region, const ParametricLine<D>& line);

/// The same for the ray from t = 0 on.
template <int D>
[[nodiscard]] std::vector<Interval> ray_intersection(const Partition<D>& region, const ParametricLine<D>& ray);

/// A closed polygon; what it bounds is on the left of its sides.
using PolygonLoop = std::vector<RationalVector<2>>;

/// A directed side with the region on its left.
struct PlaneSide {
  RationalVector<2> from, to;
};

/// The region of the plane that sides bound. They must be the whole boundary of a region, without crossings and
/// overlaps; sides without length do not count.
[[nodiscard]] Partition<2> partition_of(std::span<const PlaneSide> sides);

/// The same for the sides of loops: outer ones counter-clockwise, holes clockwise.
[[nodiscard]] Partition<2> partition_of(std::span<const PolygonLoop> loops);

/// The boundary as directed sides; throws std::domain_error when it is not bounded.
[[nodiscard]] std::vector<PlaneSide> sides_of(const Partition<2>& region);

/// Length, area or volume, exact; nothing when it is infinite. Unbounded regions are infinite: they are regular.
template <int D>
[[nodiscard]] std::optional<Rational> size(const Partition<D>& region);

/// The centre of mass, exact; nothing when the region is empty or unbounded.
template <int D>
[[nodiscard]] std::optional<RationalVector<D>> barycentre(const Partition<D>& region);

/// Of the boundary: number of points, length or area; facets to a few units in the last place, summed in
/// doubles; infinity when it has no end.
template <int D>
[[nodiscard]] double boundary_size(const Partition<D>& region);

/// A point of the boundary that is nearest to another point.
template <int D>
struct NearestPoint {
  RationalVector<D> point;
  Rational squared_distance;
  double distance = 0;  ///< correctly rounded; negative for points inside, 0 on the boundary
};

/// The nearest point of the boundary; of several the one met first, front to back. Nothing when there is no boundary.
/// Exact. Visits the leaf of p and whatever is nearer than the best so far: O(depth^2) for points near the boundary.
template <int D>
[[nodiscard]] std::optional<NearestPoint<D>> nearest_boundary_point(const Partition<D>& region,
                                                                    const RationalVector<D>& p);

/// The double nearest to the square root of q >= 0.
[[nodiscard]] double nearest_square_root(const Rational& q);

/// x -> matrix x + shift.
template <int D>
struct AffineMap {
  std::array<RationalVector<D>, D> matrix{};  ///< rows
  RationalVector<D> shift{};
};

/// The image of a region, exact: every hyperplane is mapped, the tree stays. O(nodes). Coefficients grow by those of
/// the map. Throws std::invalid_argument when the map is singular.
template <int D>
[[nodiscard]] Partition<D> transformed(const Partition<D>& region, const AffineMap<D>& map);

/// Shows the nodes of a tree in the order in which they are met from a point: what is on the point's side of a node
/// comes before the node, what is on the other side behind it. Of two nodes no part of the later one hides a part of
/// the earlier one. A point in a hyperplane counts as on the minus side.
template <int D>
void for_each_front_to_back(const Partition<D>& region, const RationalVector<D>& from,
                            const std::function<void(Link node)>& visit);

/// Reads a tree as Hipparchus and Commons Math dump it ("PolyhedronsSet", a tolerance, then nodes from the root, each
/// "internal" with a point and the normal of its plane, minus child first, or "leaf true|false"). Numbers are doubles,
/// taken as they are written; the tolerances are not used. Throws std::runtime_error with the line of what cannot be
/// read.
[[nodiscard]] Partition<3> read_polyhedrons_set(std::string_view text);

}  // namespace strata::bsp
