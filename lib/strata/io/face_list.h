#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "strata/io/mesh_file.h"
#include "strata/io/triangulate.h"

namespace strata::io {

/// Most vertices, faces or triangles: indices are 32 bits and the largest one is nobody's.
inline constexpr std::uint64_t most_items = 0xffff'fffe;

/// The faces of a file as they come in, and their triangles in the same order.
/// Consecutive repetitions of a vertex are dropped; so are faces with fewer than three different vertices, whose
/// sides cancel each other.
class FaceList {
 public:
  void add(const Triangle& t) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return drop();
    triangles_.push_back(t);
    ++count_;
  }
  void add(std::span<const std::uint32_t> corners);
  void reserve(std::size_t faces) { triangles_.reserve(faces); }
  [[nodiscard]] std::uint64_t count() const { return count_; }  ///< faces added, dropped ones included

  /// Moves the triangles into the file, whose vertices are all there, and notes what was done.
  /// Requires indices in range. Throws IoError when there are too many. Polygons are triangulated in parallel.
  void finish(MeshFile& file, const std::string& name);

 private:
  struct Polygon {
    std::uint64_t face = 0;
    std::size_t triangles_before = 0;  ///< entries of triangles_ that belong to earlier faces
    std::size_t first = 0;             ///< in corners_
    std::size_t corners = 0;           ///< 0: a face that was dropped

    [[nodiscard]] std::size_t triangle_count() const { return corners == 0 ? 0 : corners - 2; }
  };

  void drop();
  [[nodiscard]] std::vector<std::size_t> places() const;  ///< first triangle per polygon in the output, and the end
  PolygonShape divide(const Polygon& polygon, MeshFile& file, std::size_t place) const;
  void merge(MeshFile& file) const;
  void note_shapes(MeshFile& file, std::span<const PolygonShape> shapes) const;

  std::vector<Triangle> triangles_;  ///< the faces that are triangles
  std::vector<Polygon> polygons_;    ///< all others
  std::vector<std::uint32_t> corners_;
  std::uint64_t count_ = 0;
};

}  // namespace strata::io
