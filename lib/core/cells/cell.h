#pragma once
#include <cstdint>
#include <memory>
#include <span>

#include "core/cells/grid.h"
#include "core/cells/windings.h"

namespace strata {

/// A face and its grid box. Arrays of millions are written once: so there are no initial values.
struct CellFace {
  GridBox box;
  std::uint32_t face;
  bool is_thinned;  ///< not in all bricks of its box
};

/// Faces of one cell: a plain array, because millions of them are written once and read once.
class FaceList {
 public:
  FaceList() = default;
  explicit FaceList(std::size_t capacity) : faces_(std::make_unique_for_overwrite<CellFace[]>(capacity)) {}

  void push_back(const CellFace& f) { faces_[size_++] = f; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const CellFace& operator[](std::size_t i) const { return faces_[i]; }
  [[nodiscard]] const CellFace* begin() const { return faces_.get(); }
  [[nodiscard]] const CellFace* end() const { return faces_.get() + size_; }
  void clear() {
    faces_.reset();
    size_ = 0;
  }

 private:
  std::unique_ptr<CellFace[]> faces_;
  std::size_t size_ = 0;
};

/// A convex piece of space with a local origin whose winding numbers are known. A point belongs to the one cell with
/// lower <= grid coordinates < upper. In a mixed cell faces may meet, and all faces whose boxes meet the cell are
/// listed. So every walk inside the cell meets listed faces only: the grid is monotone, hence a cell is convex. The
/// faces in any other cell belong to one operand; the winding numbers about all other operands are the origin's
/// throughout. Of a mixed cell that is apart, no two faces meet: a plane separates the two operands' faces. The bricks
/// of a region count as one cell; `box` is one of them.
struct Cell {
  GridBox box{};
  InputComplex::Coordinates origin{};
  std::shared_ptr<const Windings> windings;  ///< at the origin (in the sense of walk.h)
  FaceList faces{};                          ///< of a mixed cell, by increasing face number
  std::span<const std::uint32_t> numbers{};  ///< instead of `faces` where a whole brick is apart: numbers alone
  bool mixed = false;
  bool apart = false;
};

}  // namespace strata
