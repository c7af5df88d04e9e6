#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "extensions/convex/point_cloud.h"
#include "strata/monitor.h"

namespace strata::convex {

/// The boundary of the hull of points as triangles; points are added incrementally.
///
/// A point that is not processed yet is assigned to a face that it is strictly above. The farthest point of a face
/// becomes a corner: the faces that it is strictly above are replaced by triangles from it to their rim, and the points
/// assigned to them are distributed to the new triangles. Points above none are in the hull. So coplanar triangles are
/// neighbours and are treated like others here, and no triangle has zero area; theory.md, "Hulls". Source: Barber,
/// Dobkin and Huhdanpaa 1996.
class Quickhull {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  struct Face {
    std::array<std::uint32_t, 3> corner;    ///< counter-clockwise from outside
    std::array<std::uint32_t, 3> neighbor;  ///< across the edge from corner i to the next
  };

  /// The plane of a face in doubles: the side of a point is certain if its `height` is beyond `bound`.
  struct Plane {
    Vertex anchor{}, normal{};
    double bound = 0;

    [[nodiscard]] double height(const Vertex& p) const {
      return normal[0] * (p[0] - anchor[0]) + normal[1] * (p[1] - anchor[1]) + normal[2] * (p[2] - anchor[2]);
    }
  };
  /// The hull of four points that are not coplanar; others are added later.
  Quickhull(const PointCloud& cloud, const std::array<std::uint32_t, 4>& simplex);

  /// Adds points, which are different numbers, to the hull. Throws Cancelled.
  void add(std::span<const std::uint32_t> points, const Monitor& monitor);

  /// The triangles by number; numbers for which `is_used` is false are free.
  [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
  [[nodiscard]] bool is_used(std::uint32_t face) const { return mark_[face] != none; }
  /// The planes of the triangles.
  [[nodiscard]] std::vector<Plane> planes() const;
  /// True when the triangle beyond an edge of a face is in its plane.
  [[nodiscard]] bool is_flat(std::uint32_t face, std::uint32_t edge) const;

  /// The edge of a face that it shares with a neighbour.
  [[nodiscard]] static std::uint32_t edge_to(const Face& face, std::uint32_t neighbor) {
    return face.neighbor[0] == neighbor ? 0 : face.neighbor[1] == neighbor ? 1 : 2;
  }

 private:
  struct Waiting {
    std::uint32_t first = none;     ///< of a list through next_
    std::uint32_t farthest = none;  ///< of them, judged in doubles
    double height = 0;
  };
  struct HorizonEdge {
    std::uint32_t from, to;    ///< corners, as in the visible face
    std::uint32_t face, edge;  ///< beyond the edge
  };
  struct Visit {
    std::uint32_t face, edge, left;
  };

  [[nodiscard]] Plane plane_of(const Face& face) const;
  [[nodiscard]] bool sees(std::uint32_t point, std::uint32_t face, double height) const;
  [[nodiscard]] bool sees(std::uint32_t point, std::uint32_t face) const;
  void wait(std::uint32_t point, std::uint32_t face, double height);
  void insert(std::uint32_t point, std::uint32_t face);
  void find_horizon(std::uint32_t point, std::uint32_t face);
  void make_cone(std::uint32_t point);
  void share_out(std::uint32_t point);
  [[nodiscard]] std::uint32_t new_face(const Face& face);
  void run(const Monitor& monitor);

  const PointCloud& cloud_;
  std::vector<Face> faces_;
  std::vector<Plane> planes_;
  std::vector<Waiting> waiting_;
  std::vector<std::uint32_t> mark_;  ///< 2 * round, and 1 more where visible in that round; `none` where unused
  std::vector<std::uint32_t> unused_;
  std::vector<std::uint32_t> next_;  ///< by point
  std::vector<std::uint32_t> pending_;
  std::uint32_t round_ = 0;
  // Of the current point.
  std::vector<std::uint32_t> visible_, cone_;
  std::vector<HorizonEdge> horizon_;
  std::vector<Visit> visits_;
};

}  // namespace strata::convex
