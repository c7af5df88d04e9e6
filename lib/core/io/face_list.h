#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "strata/io.h"

namespace strata::io {

/// The largest number of vertices, faces or triangles: indices have 32 bits and the largest value is not used.
inline constexpr std::uint64_t most_items = 0xffff'fffe;

/// Numbers of a list's first face and first triangle in the file.
struct ListStart {
  std::uint64_t face = 0;
  std::uint64_t triangle = 0;
};

/// The faces of a file, or of a piece of it, in order. Consecutive repetitions of a vertex are dropped. So are faces
/// with fewer than three different vertices, whose sides cancel each other.
class FaceList {
 public:
  void add(const Triangle& t) {
    const bool flat = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    if (flat || !sizes_.empty()) return add_sized(t);
    triangles_.push_back(t);
  }
  void add(std::span<const std::uint32_t> corners) {
    if (corners.size() == 3) return add(Triangle{corners[0], corners[1], corners[2]});
    add_sized(corners);
  }
  void reserve(std::size_t triangles) { triangles_.reserve(triangles); }
  /// Vertex v becomes v + by, modulo 2^32.
  void shift(std::uint32_t by);

  /// Number of faces added, dropped ones included.
  [[nodiscard]] std::uint64_t count() const { return triangles_.size() + sizes_.size(); }
  /// Number of triangles after triangulation.
  [[nodiscard]] std::uint64_t triangle_count() const { return triangles_.size() + triangles_of_polygons_; }

  /// The first faces, up to the first one that is no triangle.
  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  /// Numbers of corners of all other faces, triangles or not; 0 for a face that was dropped.
  [[nodiscard]] std::span<const std::uint32_t> sizes() const { return sizes_; }
  /// The corners of these faces, one face after the other.
  [[nodiscard]] std::span<const std::uint32_t> corners() const { return corners_; }

 private:
  void add_sized(std::span<const std::uint32_t> corners);

  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> corners_;
  std::vector<std::uint32_t> sizes_;
  std::uint64_t triangles_of_polygons_ = 0;
};

/// Moves faces into the file, which has all their vertices, list after list, as triangles, and adds notes on the
/// changes. Lists are triangulated in parallel. Requires indices in range. Throws IoError when there are too many.
void gather_faces(std::span<const FaceList> lists, MeshFile& file, const std::string& name);

}  // namespace strata::io
