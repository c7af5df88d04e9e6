#pragma once
/// How the parts of an assembly lie to each other: interfering, in contact or apart.
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "strata/measure.h"
#include "strata/options.h"
#include "strata/rational.h"
#include "strata/solid.h"

namespace strata::contact {

class Parts;  // internal

/// How two closed regular solids lie to each other.
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

/// A connected piece of a plane in which two solids touch, with the outward side of the first one.
struct ContactFacet {
  CanonicalPlane plane;
  /// Corners by numbers of ContactRegion::points: first the outer polygon, then holes, the facet on the left as seen
  /// from outside of the first solid. No corner lies inside a straight side.
  std::vector<std::vector<std::uint32_t>> loops;
  RationalPoint area_vector;  ///< exact: the normal as long as the area
  Rational squared_area;      ///< exact: the square of its length
  double area = 0;            ///< within an ulp
};

/// A segment in which two solids touch and that bounds no facet of their contact.
struct ContactEdge {
  std::array<std::uint32_t, 2> ends{};  ///< numbers of ContactRegion::points, the lower one first
  Rational squared_length;              ///< exact
  double length = 0;                    ///< within an ulp
};

/// A.b n B.b for two closed regular solids A and B whose interiors do not meet: the closed, non-regularized set in
/// which they touch. Each dimension holds what no higher one has: facets are maximal; edges are maximal segments of
/// what is left without the closures of facets; vertices are what is left of both.
///
/// A canonical form of the point set: it does not depend on how the solids are triangulated; the order of the solids
/// matters for the sides of facets only.
struct ContactRegion {
  std::vector<RationalPoint> points;  ///< exact, in lexicographic order
  std::vector<ContactFacet> facets;
  std::vector<ContactEdge> edges;
  std::vector<std::uint32_t> vertices;  ///< numbers of points

  [[nodiscard]] bool is_empty() const { return points.empty(); }
  /// Sums in doubles: within a relative (n + 1) 2^-52 for n facets or edges.
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

/// The least distance of two parts, exactly, and a pair of points that have it.
///
/// Of all pairs of closest points it is the one whose point on a is lexicographically least, and with it the one on b:
/// it depends on the point sets only. A feature is the lowest-dimensional one of the mesh that has the point inside.
struct Nearest {
  Rational squared;     ///< exact, positive
  double distance = 0;  ///< its root, within an ulp; infinite beyond doubles
  RationalPoint on_a, on_b;
  MeshFeature feature_a, feature_b;
};

/// Two parts that are not apart, the lower number first.
struct RelatedPair {
  std::uint32_t a = 0, b = 0;
  Relation relation = Relation::apart;

  friend bool operator==(const RelatedPair&, const RelatedPair&) = default;
};

/// Solids that stand beside one another, and what is between them: interference, contacts, distances. Exact for all
/// finite doubles and for rational vertices, at any scale.
///
/// Requires solids: surfaces with winding numbers 0 and 1, which may touch themselves anywhere, but have no membranes:
/// faces that lie on one another with the solid on no side. Parts are numbered as given; the same solid may occur
/// several times, and then interferes with itself. An immutable value, cheap to copy, safe to ask from many threads.
class Assembly {
 public:
  /// O(vertices); trees of faces are made when they are first needed. Throws std::length_error (more than 2^32 - 2
  /// vertices or faces in all).
  explicit Assembly(std::span<const Solid> parts);

  [[nodiscard]] std::uint32_t size() const;
  [[nodiscard]] const Solid& part(std::uint32_t number) const;

  /// All pairs that are not apart, by increasing numbers; all others are. The same for any number of threads. Pairs
  /// whose boxes are apart cost nothing but a comparison. Throws Cancelled.
  [[nodiscard]] std::vector<RelatedPair> pairs(const Monitor& monitor = {}) const;

  /// Pairs of parts that may be apart by `reach` at most, as their boxes tell, by increasing numbers, the lower one
  /// first; those that are not apart are among them. Infinite reach: all pairs of parts that are not empty. Requires
  /// that `reach` is not negative.
  [[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(double reach) const;

  /// How two different parts lie to each other. Law: symmetric.
  [[nodiscard]] Relation relation(std::uint32_t a, std::uint32_t b) const;
  /// Where two parts touch. Requires that they do not interfere; nothing where they are apart.
  [[nodiscard]] ContactRegion contact_region(std::uint32_t a, std::uint32_t b) const;
  /// What two parts have in common, regularized: a solid with exact vertices; empty unless they interfere. Where it
  /// shows that one touches itself inside of faces, both are resolved first.
  [[nodiscard]] Solid overlap(std::uint32_t a, std::uint32_t b) const;
  /// The least distance of two parts that are apart, and where it is. Requires that neither is empty.
  [[nodiscard]] Nearest nearest(std::uint32_t a, std::uint32_t b) const;

 private:
  std::shared_ptr<const Parts> parts_;
};

}  // namespace strata::contact
