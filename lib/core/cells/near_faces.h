#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "core/cells/cell.h"
#include "core/cells/regions.h"
#include "core/cells/vertex_set.h"
#include "core/containers/fresh_array.h"

namespace strata {

/// The lines along x, through the centres of bricks, on which walks from outside reach origins.
class Lines {
 public:
  explicit Lines(const BrickGrid& bricks);

  /// The line through a brick's centre.
  std::uint32_t add(BrickCode code);
  [[nodiscard]] std::uint32_t count() const { return count_; }
  /// Visits the lines through a box of bricks: (line, y, z).
  template <class Visit>
  void for_each(const BrickBox& box, const Visit& visit) const {
    for (auto z = BrickBox::along(box.lower, 2); z <= BrickBox::along(box.upper, 2); ++z)
      for (auto y = BrickBox::along(box.lower, 1); y <= BrickBox::along(box.upper, 1); ++y)
        if (const std::uint32_t line = numbers_[y + rows_ * z]; line != none) visit(line, y, z);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t rows_;
  std::uint32_t count_ = 0;
  std::vector<std::uint32_t> numbers_;
};

/// A face whose box meets a line.
struct LineFace {
  std::uint32_t line, face;

  friend auto operator<=>(const LineFace&, const LineFace&) = default;
};

/// The faces that the cells need. All others are skipped.
struct NearFaces {
  FreshArray<CellFace> faces;       ///< those in mixed bricks, by increasing face
  FreshArray<LineFace> line_faces;  ///< sorted
  VertexSet corners;                ///< of `faces`
};

/// One streaming pass over all faces.
[[nodiscard]] NearFaces find_near_faces(const InputComplex& input, const Grid& grid, const BrickGrid& bricks,
                                        const Raster& raster, const BrickCodes& codes, const Occupancy& occupancy,
                                        const Regions& regions, const Lines& lines, const Monitor& monitor);

/// The near faces of each mixed brick.
class BrickFaces {
 public:
  BrickFaces(const InputComplex& input, const Raster& raster, const BrickCodes& codes, const Regions& regions,
             std::span<const CellFace> near, const Monitor& monitor);

  /// Of mixed brick number n: by increasing face.
  [[nodiscard]] FaceList take(std::uint32_t n);

 private:
  std::span<const CellFace> near_;
  std::vector<std::uint32_t> first_;
  std::unique_ptr<std::uint32_t[]> faces_;  ///< indices into near_
};

}  // namespace strata
