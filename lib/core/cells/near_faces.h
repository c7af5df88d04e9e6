#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/cells/cell.h"
#include "core/cells/regions.h"
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
  FreshArray<std::uint32_t> faces;      ///< those in mixed bricks, in order
  std::vector<std::uint32_t> in_brick;  ///< how many of them, per mixed brick
  FreshArray<LineFace> line_faces;      ///< sorted
};

/// One streaming pass over all faces.
[[nodiscard]] NearFaces find_near_faces(const InputComplex& input, const Grid& grid, const BrickGrid& bricks,
                                        const Raster& raster, const BrickCodes& codes, const Occupancy& occupancy,
                                        const Regions& regions, const Lines& lines, const Monitor& monitor);

/// The near faces of each mixed brick.
class BrickFaces {
 public:
  BrickFaces(const InputComplex& input, const Grid& grid, const BrickGrid& bricks, const Raster& raster,
             const BrickCodes& codes, const Regions& regions, const NearFaces& near, const Monitor& monitor);

  /// Of mixed brick number n, in order. Sorts them: for one thread for each n.
  [[nodiscard]] std::span<const std::uint32_t> sorted(std::uint32_t n);
  /// These faces with their boxes.
  [[nodiscard]] FaceList with_boxes(std::span<const std::uint32_t> faces) const;
  /// Gives up the numbers that `sorted` shows; they stay where they are.
  [[nodiscard]] FreshArray<std::uint32_t> take() { return std::move(faces_); }

 private:
  const InputComplex& input_;
  const Grid& grid_;
  const BrickGrid& bricks_;
  const Raster& raster_;
  std::vector<std::uint32_t> first_;
  FreshArray<std::uint32_t> faces_;
};

}  // namespace strata
