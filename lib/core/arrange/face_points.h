#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/kernel/predicates.h"
#include "core/overlap/point_table.h"

namespace strata {

/// The points of one face under local numbers, the face's corners first, and the orientation of three of them, seen
/// with the face counter-clockwise.
class FacePoints {
 public:
  /// The number of a point that is not in the table.
  static constexpr PointId unnumbered = std::numeric_limits<PointId>::max();

  FacePoints(const InputComplex& input, const PointTable& table) : input_(input), table_(table) {}

  /// Starts again with the corners of a face, as points 0, 1, 2.
  void start(std::uint32_t face);
  /// Appends a point of the table. `find` then finds it.
  std::int32_t add(PointId id);
  /// Appends a point that has no number.
  std::int32_t add(const Point& point);
  /// Gives point v its number in the table.
  void number(std::int32_t v, PointId id);
  /// After this `find(id)` returns the point `known`.
  void remember(PointId id, std::int32_t known);
  /// The local number of a point of the table, or -1.
  [[nodiscard]] std::int32_t find(PointId id) const;
  /// Removes the last point, if it is not in the table.
  void drop_last();

  /// Positive when a, b, c are counter-clockwise; exact.
  [[nodiscard]] Sign orientation(std::int32_t a, std::int32_t b, std::int32_t c) const;
  /// True when the names of both points show that they lie on corner k's edge, from corner k to the next.
  [[nodiscard]] bool are_on_edge(int k, std::int32_t a, std::int32_t b) const;

  [[nodiscard]] std::uint32_t face() const { return face_; }
  [[nodiscard]] const InputComplex::Indices& corners() const { return corners_; }
  [[nodiscard]] Projection projection() const { return projection_; }
  [[nodiscard]] std::int32_t size() const { return static_cast<std::int32_t>(points_.size()); }
  [[nodiscard]] const Point& operator[](std::int32_t v) const { return points_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] std::span<const Point> all() const { return points_; }
  /// The number in the table, or `unnumbered`.
  [[nodiscard]] PointId id(std::int32_t v) const { return ids_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] const PointTable& table() const { return table_; }

 private:
  [[nodiscard]] bool collinear_by_name(const Point& p, const Point& q, const Point& r) const;
  [[nodiscard]] bool collinear_by_planes(const Point& p, const Point& q, const Point& r) const;
  [[nodiscard]] bool collinear_by_faces(const Point& p, const Point& q, const Point& r) const;
  [[nodiscard]] bool is_surely_other_plane(const SourcePlane& plane) const;
  [[nodiscard]] bool collinear_by_edges(const Point& p, const Point& q, const Point& r) const;
  [[nodiscard]] bool leaves_plane(const InputComplex::Indices& vertices) const;

  const InputComplex& input_;
  const PointTable& table_;
  std::uint32_t face_ = 0;
  InputComplex::Indices corners_{};
  Projection projection_;
  std::vector<Point> points_;
  std::vector<PointId> ids_;
  std::vector<std::pair<PointId, std::int32_t>> known_;   ///< searched while there are few points
  std::unordered_map<PointId, std::int32_t> many_known_;  ///< searched when there are many
};

}  // namespace strata
