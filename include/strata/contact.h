#pragma once
/// Interference, contact and distance between the parts of an assembly.
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "strata/measure.h"
#include "strata/monitor.h"
#include "strata/options.h"
#include "strata/rational.h"
#include "strata/shared.h"
#include "strata/solid.h"

namespace strata::contact {

class Parts;  // internal

/// The relation of two closed regular solids.
enum class Relation {
  apart,       ///< they have no point in common
  contact,     ///< their boundaries meet, their interiors do not
  interfering  ///< their interiors meet: what they have in common has a volume
};

/// apart, contact, interfering.
[[nodiscard]] constexpr const char* name(Relation relation) {
  constexpr std::array names{"apart", "contact", "interfering"};
  return names[static_cast<std::size_t>(relation)];
}

/// A maximal connected planar region in which two solids touch, oriented as the boundary of the first one.
struct ContactFacet {
  CanonicalPlane plane;
  /// Corners by numbers of ContactRegion::points: first the outer polygon, then holes, the facet on the left as seen
  /// from outside of the first solid. No corner lies inside a straight side.
  std::vector<std::vector<std::uint32_t>> loops;
  RationalPoint area_vector;  ///< exact: the outward normal whose length is the area
  Rational squared_area;      ///< exact: the square of its length
  double area = 0;            ///< within an ulp
};

/// A maximal segment in which two solids touch and that lies in no facet of their contact.
struct ContactEdge {
  std::array<std::uint32_t, 2> ends{};  ///< numbers of ContactRegion::points, the lower one first
  Rational squared_length;              ///< exact
  double length = 0;                    ///< within an ulp
};

/// The intersection of the boundaries of two closed regular solids whose interiors do not meet: the closed set, not
/// regularized, in which they touch. Facets are maximal; edges are the maximal segments of what is left without the
/// closures of facets; vertices are the points that are left then.
///
/// A canonical form of the point set: it does not depend on how the solids are triangulated; the order of the solids
/// matters for the sides of facets only.
struct ContactRegion {
  std::vector<RationalPoint> points;  ///< exact, in lexicographic order
  std::vector<ContactFacet> facets;
  std::vector<ContactEdge> edges;
  std::vector<std::uint32_t> vertices;  ///< numbers of points

  [[nodiscard]] bool is_empty() const { return points.empty(); }
  /// Of all facets, and of all edges: sums in doubles, within a relative (n + 1) 2^-52 for n of them.
  [[nodiscard]] double area() const;
  [[nodiscard]] double length() const;
};

/// The facets of a region as triangles.
struct FacetTriangles {
  std::vector<Triangle> triangles;      ///< of points of the region; counter-clockwise as the loops of facets are
  std::vector<std::uint32_t> facet_of;  ///< per triangle
};

/// Divides the facets of a region into triangles without moving or adding a point. Exact; no triangle is degenerate.
/// O(n log n) decisions for n corners.
[[nodiscard]] FacetTriangles triangles_of(const ContactRegion& region);

/// A vertex, edge or face of a part, by vertex numbers of its mesh in increasing order; the unused ones are 0.
struct MeshFeature {
  enum class Kind : std::uint8_t { vertex, edge, face };
  Kind kind = Kind::vertex;
  std::array<std::uint32_t, 3> vertices{};

  friend auto operator<=>(const MeshFeature&, const MeshFeature&) = default;
};

/// vertex, edge, face.
[[nodiscard]] constexpr const char* name(MeshFeature::Kind kind) {
  constexpr std::array names{"vertex", "edge", "face"};
  return names[static_cast<std::size_t>(kind)];
}

/// The least distance of two parts, exactly, and a pair of closest points.
///
/// Of all pairs of closest points it is the one whose point on a is lexicographically least, and with it the one on b:
/// it depends on the point sets only. The feature of a point is the vertex, edge or face of the mesh in whose relative
/// interior it lies.
struct Nearest {
  Rational squared;     ///< exact, positive
  double distance = 0;  ///< its square root, within an ulp; infinite beyond the largest double
  RationalPoint on_a, on_b;
  MeshFeature feature_a, feature_b;
};

/// Two parts that are not apart, the lower number first.
struct RelatedPair {
  std::uint32_t a = 0, b = 0;
  Relation relation = Relation::apart;

  friend bool operator==(const RelatedPair&, const RelatedPair&) = default;
};

/// A list of solids, to be queried for interference, contacts and distances of pairs. Exact for all finite doubles and
/// for rational vertices, at any scale.
///
/// Requires solids: surfaces with winding numbers 0 and 1, which may touch themselves anywhere, but have no membranes
/// (coincident faces with the solid on neither side). Parts are numbered as given; the same solid may occur several
/// times, and then interferes with itself. An immutable value: copying is O(1), reading is thread-safe.
/// Source: lib/extensions/contact/theory.md.
class Assembly {
 public:
  /// O(vertices); trees of faces are made when they are first needed. Throws std::length_error (more than 2^32 - 2
  /// vertices or faces in all).
  explicit Assembly(std::span<const Solid> parts);

  [[nodiscard]] std::uint32_t size() const;
  [[nodiscard]] const Solid& part(std::uint32_t number) const;

  /// All pairs that are not apart, by increasing numbers. In parallel; the result does not depend on the number of
  /// threads. Pairs whose boxes are apart cost a comparison at most. Throws Cancelled.
  [[nodiscard]] std::vector<RelatedPair> pairs(const Monitor& monitor = {}) const;

  /// Pairs of parts whose bounding boxes are at most `reach` apart: a superset of the pairs whose distance is at most
  /// `reach`. By increasing numbers, the lower one first. Infinite reach: all pairs of parts that are not empty.
  /// Requires that `reach` is not negative.
  [[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(double reach) const;

  /// The relation of two different parts. Law: symmetric. An empty part is apart from all. This and what follows throw
  /// Cancelled.
  [[nodiscard]] Relation relation(std::uint32_t a, std::uint32_t b, const Monitor& monitor = {}) const;
  /// The contact region of two parts; empty where they are apart. Requires that they do not interfere.
  [[nodiscard]] ContactRegion contact_region(std::uint32_t a, std::uint32_t b, const Monitor& monitor = {}) const;
  /// The regularized intersection of two parts, with exact vertices; empty unless they interfere. Of the options those
  /// count that do for `combine_solids`.
  [[nodiscard]] Solid overlap(std::uint32_t a, std::uint32_t b, const Options& options = {}) const;
  /// The least distance of two parts, and a pair of closest points. Requires that they are apart, and not empty.
  [[nodiscard]] Nearest nearest(std::uint32_t a, std::uint32_t b, const Monitor& monitor = {}) const;

 private:
  Shared<Parts> parts_;
};

}  // namespace strata::contact
