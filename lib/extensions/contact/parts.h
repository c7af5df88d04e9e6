#pragma once
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "core/kernel/box.h"
#include "core/kernel/input_complex.h"
#include "core/kernel/point.h"
#include "extensions/contact/part_boxes.h"
#include "strata/solid.h"

namespace strata::contact {

/// The parts of an assembly under one numbering, with cached data. Trees and components are computed when they are
/// first needed. Reading is thread-safe.
class Parts {
 public:
  explicit Parts(std::span<const Solid> solids);

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(solids_.size()); }
  [[nodiscard]] const Solid& solid(std::uint32_t part) const { return solids_[part]; }
  [[nodiscard]] const InputComplex& input() const { return input_; }
  /// A box that contains the part; empty for an empty one.
  [[nodiscard]] const Box& box(std::uint32_t part) const { return boxes_[part]; }
  /// The intersection of the boxes of two parts; empty if they are disjoint.
  [[nodiscard]] Box common_box(std::uint32_t a, std::uint32_t b) const;
  /// True when the boxes alone prove that the interiors of two parts are disjoint.
  [[nodiscard]] bool are_beside(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] const BoxTree& tree(std::uint32_t part) const;

  /// True when some component of a part's surface, connected by common vertices, lies inside another part. Requires
  /// that the surfaces of the two do not meet. One walk per component: theory.md, section 3.
  [[nodiscard]] bool has_piece_inside(std::uint32_t part, std::uint32_t other) const;
  /// True when a point that is not on a part's surface is inside the part: by the winding number, exactly. O(log n)
  /// plus the faces that a ray from there may meet.
  [[nodiscard]] bool is_inside(const Point& point, std::uint32_t part) const;

 private:
  /// A connected component of a surface.
  struct Piece {
    std::uint32_t vertex = 0;  ///< some vertex of it
    Box box;
  };
  struct Lazy {
    std::once_flag tree_once, pieces_once;
    std::unique_ptr<const BoxTree> tree;
    std::vector<Piece> pieces;
  };
  [[nodiscard]] const std::vector<Piece>& pieces(std::uint32_t part) const;

  std::vector<Solid> solids_;
  InputComplex input_;
  std::vector<Box> boxes_;
  std::unique_ptr<Lazy[]> lazy_;
};

}  // namespace strata::contact
