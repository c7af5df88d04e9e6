#pragma once
/// Regions of the line, the plane and space as binary space partitions (BSP trees): exact, bounded or not, with all
/// Booleans.
///
/// A hyperplane is given by an AffineForm, a region is a Partition. It is made from half-spaces, a mesh, polygons or
/// intervals; combined with | & - ^ and `complement`; queried for its size, for the parts of lines in it, for the
/// location of points and the nearest point of its boundary; converted back to a mesh, sides or intervals, or to convex
/// cells. D is 1, 2 or 3. All functions may be called from many threads at once; they use the calling thread alone.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "strata/combine.h"
#include "strata/function.h"
#include "strata/measure.h"
#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/query.h"
#include "strata/rational.h"
#include "strata/shared.h"

namespace strata {

/// Computes `combine` by merging binary space partitions (Options::engine). Exact, by methods that are independent of
/// the arrangement: the same solid, but other triangles, since facets in one plane are merged and triangulated anew.
/// The source of a triangle is some face of an operand in its plane. Meant for checking results and for a few thousand
/// faces: at worst the tree of n faces has O(n^3) leaves. Throws as `combine` does.
extern const Engine bsp_engine;

}  // namespace strata

namespace strata::bsp {

/// A point or a vector of D-space.
template <int D>
using RationalVector = std::array<Rational, D>;

/// The affine function f(x) = n . x + c, as the components of n and then c. With n != 0 it stands for the hyperplane f
/// = 0 (a point of the line, a line of the plane, a plane of space), whose plus side is f > 0, and for the closed
/// half-space f <= 0. Positive multiples stand for the same.
template <int D>
using AffineForm = std::array<Rational, D + 1>;

/// A regular region (the closure of its interior) of the line, the plane or space, as a tree: every node cuts its
/// convex part of space by a hyperplane, every leaf is inside or outside. It may be unbounded, have cavities and
/// several parts, and touch itself; the empty set and all of space are regions.
///
/// Every decision is exact, for rationals of any size. The hyperplanes are those of the input and, where trees are
/// built, axis-parallel ones with doubles as coefficients: coefficients do not grow, however often regions are
/// combined.
///
/// An immutable value: copying is O(1), reading is thread-safe. D = 1, 2, 3.
/// Sources: Fuchs, Kedem, Naylor 1980 (the trees); Thibault, Naylor 1987 (trees as solids).
template <int D>
class Partition {
 public:
  Partition();  ///< the empty region

  [[nodiscard]] static Partition all();  ///< the whole line, plane or space
  /// The closed half-space f <= 0. Throws std::invalid_argument where the normal is zero.
  [[nodiscard]] static Partition half_space(const AffineForm<D>& f);
  /// The intersection of half-spaces, regularized: the points where no form is positive, or nothing if these have no
  /// interior. It may be unbounded; of no forms it is all of space. Built as a balanced tree of intersections, with
  /// axis-parallel cuts where these make it shallower. Throws std::invalid_argument where a normal is zero.
  [[nodiscard]] static Partition convex(std::span<const AffineForm<D>> forms);

  [[nodiscard]] bool is_empty() const;    ///< O(1)
  [[nodiscard]] bool is_full() const;     ///< all of space; O(1)
  [[nodiscard]] bool is_bounded() const;  ///< O(leaves that reach infinity * depth)
  /// True when another region is a subset of this one. Costs as `combined` does.
  [[nodiscard]] bool contains(const Partition& other) const;

  /// Where a point lies, exactly. Requires finite coordinates. O(depth); for points on the hyperplanes of k nodes both
  /// subtrees of each are visited.
  [[nodiscard]] Where classify(const std::array<double, D>& p) const;
  [[nodiscard]] Where classify_exact(const RationalVector<D>& p) const;  ///< the same for rationals

  struct Data;                                                       ///< internal: lib/extensions/bsp/partition_data.h
  [[nodiscard]] const Data& data() const { return *data_; }          ///< internal
  explicit Partition(Shared<Data> data) : data_(std::move(data)) {}  ///< internal

 private:
  Shared<Data> data_;
};

/// The regularized Boolean of two regions, by merging their trees. `difference` is a - b, `symmetric_difference` what
/// is in one only. Laws: those of sets (commutative, associative, distributive, De Morgan), as point sets; trees may
/// differ. Depths add up at worst: combine many regions by halves, not one after the other, or use `rebuilt_if_deep`.
/// Recursion is as deep as the trees: a depth of a thousand fits on any thread's stack. Expected output-sensitive; at
/// worst every node of one tree meets every node of the other. Throws Cancelled. Source: Naylor, Amanatides, Thibault
/// 1990.
template <int D>
[[nodiscard]] Partition<D> combined(Operation operation, const Partition<D>& a, const Partition<D>& b,
                                    const Monitor& monitor = {});

template <int D>
[[nodiscard]] Partition<D> operator|(const Partition<D>& a, const Partition<D>& b) {
  return combined(Operation::union_, a, b);
}
template <int D>
[[nodiscard]] Partition<D> operator&(const Partition<D>& a, const Partition<D>& b) {
  return combined(Operation::intersection, a, b);
}
template <int D>
[[nodiscard]] Partition<D> operator-(const Partition<D>& a, const Partition<D>& b) {
  return combined(Operation::difference, a, b);
}
template <int D>
[[nodiscard]] Partition<D> operator^(const Partition<D>& a, const Partition<D>& b) {
  return combined(Operation::symmetric_difference, a, b);
}
/// The closure of what is outside. O(nodes).
template <int D>
[[nodiscard]] Partition<D> complement(const Partition<D>& region);

/// Equal as point sets. Costs as `combined` does.
template <int D>
[[nodiscard]] bool operator==(const Partition<D>& a, const Partition<D>& b) {
  return (a ^ b).is_empty();
}

/// The same tree, without stored hyperplanes that no node uses any more, which results of Booleans keep. O(nodes).
template <int D>
[[nodiscard]] Partition<D> compact(const Partition<D>& region);

/// The same region, its tree built anew from its boundary. Expected O(n log^2 n) for n facets.
template <int D>
[[nodiscard]] Partition<D> rebuilt(const Partition<D>& region);

/// The same region, its tree built anew if it is deeper than 30 + 6 log2(leaves).
template <int D>
[[nodiscard]] Partition<D> rebuilt_if_deep(const Partition<D>& region);

/// Sizes of a tree, for reports.
struct TreeSize {
  std::size_t nodes = 0, leaves = 0;
  std::size_t inside = 0;       ///< of the leaves
  std::size_t depth = 0;        ///< nodes above the deepest leaf
  std::size_t hyperplanes = 0;  ///< stored, each once
  std::size_t splits = 0;       ///< facets that were divided when it was built from facets; 0 for merged trees
  std::size_t bytes = 0;        ///< of memory, roughly
  double mean_depth = 0;        ///< of leaves
};
template <int D>
[[nodiscard]] TreeSize size_of_tree(const Partition<D>& region);

extern template class Partition<1>;
extern template class Partition<2>;
extern template class Partition<3>;

// --- Boundary and cells, any D ---

/// A convex part of the boundary, of dimension D - 1: a point, a segment or a convex polygon.
template <int D>
struct BoundaryFacet {
  AffineForm<D> outward{};  ///< coprime integers; not positive in the region near the facet
  /// One point; or from, to, with the region on the left; or a polygon, counter-clockwise as seen from outside.
  std::vector<RationalVector<D>> corners;
};

/// The boundary as convex facets with disjoint interiors, in the order of the tree. They are as the tree divides them:
/// several may lie in one plane, and corners may lie in the middle of sides of others (T-junctions, which
/// `boundary_mesh` resolves). Throws std::domain_error when the boundary is not bounded. O(sum over nodes of depth and
/// of leaves next to the node).
template <int D>
[[nodiscard]] std::vector<BoundaryFacet<D>> boundary_facets(const Partition<D>& region);

/// Calls `visit` for the facets of `boundary_facets` sorted by depth as seen from a point: no facet hides a part of an
/// earlier one. (The painter's order is the reverse.) Facets in a hyperplane through the point are seen edge-on and
/// hide nothing. Throws std::domain_error when the boundary is not bounded, possibly after some calls. Source: Fuchs,
/// Kedem, Naylor 1980.
template <int D>
void for_each_front_to_back(const Partition<D>& region, const RationalVector<D>& from,
                            FunctionRef<void(const BoundaryFacet<D>& facet)> visit);

/// Calls `visit` for the inside leaves: convex cells with disjoint interiors that cover the region. A cell is the set
/// of points where none of its forms is positive; each form bounds it in a facet. Cells may be unbounded; all of space
/// has no forms. In the order of the tree. O(leaves * depth^2).
template <int D>
void for_each_cell(const Partition<D>& region, FunctionRef<void(const std::vector<AffineForm<D>>& cell)> visit);

/// The same cells as polytopes: the facets of each, which look away from it. In the same order. Throws
/// std::domain_error where a cell is not bounded, maybe after some cells. O(leaves * depth^2), and a rational point per
/// corner.
template <int D>
void for_each_bounded_cell(const Partition<D>& region,
                           FunctionRef<void(const std::vector<BoundaryFacet<D>>& facets)> visit);

// --- Space: meshes ---

/// The region that a closed mesh bounds. Requires winding numbers 0 and 1, or 0 and -1: a mesh turned inside out bounds
/// all of space but the solid. Triangles without area are ignored, an empty mesh is the empty region.
/// Requires that the mesh does not cross itself (`check` finds out), which is not checked here: for others the region
/// is unspecified. Expected O(n log^2 n) for n triangles; worst cases are long needles in all directions and grids of
/// slabs, up to O(n^3). Cuts are chosen to divide few facets, then for balance; axis-parallel ones keep trees of convex
/// solids from degenerating to lists. Throws Cancelled.
[[nodiscard]] Partition<3> partition_of(ExactMeshView mesh, const Monitor& monitor = {});

/// A mesh and the oriented planes of its triangles, each once.
struct BoundaryMesh {
  ExactMesh mesh;
  std::vector<CanonicalPlane> planes;
  std::vector<std::uint32_t> plane_of;  ///< per triangle
};

/// The boundary as a closed triangle mesh with outward normals: facets in one plane are merged and triangulated anew.
/// Where two facets meet in a part of an edge, its ends are corners of both. Sheets that only touch, in an edge of four
/// facets or a vertex on a facet, need not have it in common: `resolve` divides them there. Vertices in lexicographic
/// order, coordinates rounded to nearest doubles, exact positions beside them. Law: depends on the point set alone, not
/// on the tree. O(n log n) for n facets, after finding them. Throws std::domain_error when the boundary is not bounded.
[[nodiscard]] BoundaryMesh boundary_mesh(const Partition<3>& region);
[[nodiscard]] ExactMesh exact_mesh_of(const Partition<3>& region);  ///< the mesh alone

/// `canonical_form` of the boundary mesh: equal exactly for equal regions.
/// Throws as `boundary_mesh`.
[[nodiscard]] CanonicalForm canonical_form_of(const Partition<3>& region);

// --- Space: where points lie ---

/// Tells where points lie in a scene, with the same answers as `Locator`, by descending a tree for each solid.
/// An immutable value, cheap to copy, safe to ask from many threads.
class PartitionLocator {
 public:
  /// The solids of the scene must not cross themselves. Expected O(n log^2 n) for n faces. Throws Cancelled.
  explicit PartitionLocator(Scene scene, const Monitor& monitor = {});

  /// Which solids q is in, and on which faces it lies. Exact. O(solids * depth); on a boundary all planes of that solid
  /// are asked, and the faces in those through q.
  [[nodiscard]] Location locate(const Vertex& q) const;

 private:
  struct Data;
  Shared<Data> data_;
};

// --- The line: intervals ---

/// The closed interval from `lower` to `upper`; an end without a value is infinite.
struct Interval {
  std::optional<Rational> lower, upper;
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// The union of intervals, which may overlap. Those with lower >= upper are ignored. O(n log n).
[[nodiscard]] Partition<1> partition_of(std::span<const Interval> intervals);

/// The components of a region of the line, in increasing order; no two of them touch. O(nodes).
[[nodiscard]] std::vector<Interval> intervals_of(const Partition<1>& region);

/// The points p + t d for all t.
template <int D>
struct ParametricLine {
  RationalVector<D> p, d;
};

/// The intersection of a line with the closed region: disjoint intervals of t, in increasing order. A stretch within
/// the boundary belongs to it; where the line meets the region in a single point, the interval is that point.
/// Requires d != 0. O(nodes that the line meets); each end is one quotient of the line and a hyperplane.
template <int D>
[[nodiscard]] std::vector<Interval> intersection(const Partition<D>& region, const ParametricLine<D>& line);

/// The same for the ray from t = 0 on.
template <int D>
[[nodiscard]] std::vector<Interval> ray_intersection(const Partition<D>& region, const ParametricLine<D>& ray);

// --- The plane: polygons ---

/// A closed polygon, its last point joined to the first; what it bounds is on the left of its sides.
using PolygonLoop = std::vector<RationalVector<2>>;

/// A directed side with the region on its left.
struct PlaneSide {
  RationalVector<2> from, to;
};

/// The region of the plane that sides bound, in any order. Requires that they are the whole boundary of a region,
/// without crossings and overlaps, which is not checked; sides without length are ignored. Expected O(n log^2 n).
[[nodiscard]] Partition<2> partition_of(std::span<const PlaneSide> sides);

/// The same for the sides of loops: outer ones counter-clockwise, holes clockwise.
[[nodiscard]] Partition<2> partition_of(std::span<const PolygonLoop> loops);

/// The boundary as directed sides, as the tree divides them. Throws std::domain_error when it is not bounded.
[[nodiscard]] std::vector<PlaneSide> sides_of(const Partition<2>& region);

// --- Measures, any D ---

/// Length, area or volume, exact; no value where it is infinite, which it is exactly for unbounded regions. O(size of
/// the boundary).
template <int D>
[[nodiscard]] std::optional<Rational> size(const Partition<D>& region);

/// The centre of mass, exact; no value where the region is empty or unbounded.
template <int D>
[[nodiscard]] std::optional<RationalVector<D>> barycentre(const Partition<D>& region);

/// The size of the boundary: number of points (D = 1), length (2) or area (3); every facet to a few units in the last
/// place, summed in doubles; infinite when the boundary is not bounded.
template <int D>
[[nodiscard]] double boundary_size(const Partition<D>& region);

/// A point of the boundary that is nearest to another point.
template <int D>
struct NearestPoint {
  RationalVector<D> point;
  Rational squared_distance;
  double distance = 0;  ///< correctly rounded; negative for points inside, 0 on the boundary
};

/// The nearest point of the boundary, exact; of several at one distance the one found first, front to back. No value
/// when the boundary is empty. Descends to the leaf of p and visits whatever is nearer than the best so far: O(depth^2)
/// for points near the boundary, all facets at worst.
template <int D>
[[nodiscard]] std::optional<NearestPoint<D>> nearest_boundary_point(const Partition<D>& region,
                                                                    const RationalVector<D>& p);

// --- Maps, any D ---

/// x -> matrix x + shift.
template <int D>
struct AffineMap {
  std::array<RationalVector<D>, D> matrix{};  ///< rows
  RationalVector<D> shift{};
};

/// The image of a region, exact: every hyperplane is mapped, the tree keeps its shape. Laws: images of combinations are
/// combinations of images; the size is multiplied by |det|, also for reflections (inside stays inside). O(nodes).
/// Coefficients grow by those of the map. Throws std::invalid_argument when the map is singular.
template <int D>
[[nodiscard]] Partition<D> transformed(const Partition<D>& region, const AffineMap<D>& map);

// --- Files ---

/// Reads a tree of space as Hipparchus and Apache Commons Math dump it: "PolyhedronsSet", a tolerance, then nodes from
/// the root, each "internal" with a point and the normal of its plane, minus child first, or "leaf true|false". Numbers
/// are doubles, taken as they are written; tolerances are not used, and nodes that do not divide their part of space
/// are left out.
/// Throws std::runtime_error that names the line of what cannot be read. O(size of the text), plus pruning.
[[nodiscard]] Partition<3> read_polyhedrons_set(std::string_view text);

}  // namespace strata::bsp
