#pragma once
#include <memory>

#include "strata/cells/cell_tree.h"

namespace strata {

/// Faces of one cell while the tree grows: a plain array, since millions of them are written once and read once.
class FaceList {
 public:
  FaceList() = default;
  explicit FaceList(std::size_t capacity) : faces_(std::make_unique_for_overwrite<CellFace[]>(capacity)) {}

  void push_back(const CellFace& f) { faces_[size_++] = f; }
  void set_size(std::size_t size) { size_ = size; }
  [[nodiscard]] CellFace* data() { return faces_.get(); }
  [[nodiscard]] std::size_t size() const { return size_; }
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

/// Where the subdivision starts.
struct Root {
  Grid grid;
  GridBox box;                     ///< the space of interest, half-open: no operand is met outside of it by another
  Carriers::Coordinates origin{};  ///< in it
  Windings windings;               ///< at the origin
  FaceList faces;                  ///< all faces that reach into it, by increasing face
};

/// Boxes every face, finds the space that the bounds of different operands share (all space if `self`), and walks from
/// outside of everything to an origin in it. Two streaming passes.
[[nodiscard]] Root find_root(const Carriers& carriers, bool self);

}  // namespace strata
