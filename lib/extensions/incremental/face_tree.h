#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/exact/double_double.h"
#include "core/kernel/box.h"
#include "core/kernel/input_complex.h"
#include "core/kernel/source_plane.h"
#include "extensions/incremental/painted_solid.h"

namespace strata {

using PlanePointer = std::shared_ptr<const SourcePlane>;

/// A vertex of an incremental solid: at doubles, at a given rational position, or where three source planes meet.
struct IncrementalVertex {
  InputComplex::Coordinates at{};           ///< the position, or the nearest doubles
  bool is_given = true;                     ///< a vertex of an operand, as opposed to a constructed one
  std::optional<RationalPoint> rational;    ///< if given, and not in doubles
  MeetOfPlanes meet;                        ///< if constructed, and not in doubles
  std::array<PlanePointer, 3> meet_planes;  ///< own the planes of `meet`

  [[nodiscard]] bool has_doubles() const { return !rational && meet_planes[0] == nullptr; }
};
using IncrementalVertexPointer = std::shared_ptr<const IncrementalVertex>;

/// The face of a solid with attributes that a triangle is a part of; null: of one without.
struct FaceOrigin {
  PaintedSolidPointer solid;
  std::uint32_t face = 0;
  bool is_turned = false;  ///< it has the opposite orientation, as what a difference cuts
  friend bool operator==(const FaceOrigin&, const FaceOrigin&) = default;
};

/// A triangle of an incremental solid.
class WorkFace {
 public:
  /// Corners counter-clockwise from outside; the source plane of the face, or null for the one through its corners,
  /// which are doubles then.
  WorkFace(std::array<IncrementalVertexPointer, 3> corners, PlanePointer plane, FaceOrigin origin);
  WorkFace() = default;  ///< no face: to be assigned

  [[nodiscard]] const std::array<IncrementalVertexPointer, 3>& corners() const { return corners_; }
  [[nodiscard]] const PlanePointer& plane() const { return plane_; }
  [[nodiscard]] const FaceOrigin& origin() const { return origin_; }
  /// The box of the corners' doubles. Rounding is monotone: boxes of faces that meet overlap.
  [[nodiscard]] const Box& box() const { return box_; }
  /// Six times the signed volume between the face and the coordinates' origin, within bounds.
  [[nodiscard]] const DoubleDouble& determinant() const { return determinant_; }

 private:
  std::array<IncrementalVertexPointer, 3> corners_;
  PlanePointer plane_;
  FaceOrigin origin_;
  Box box_;
  DoubleDouble determinant_;
};

/// Faces of a tree, by their addresses, that are removed, and the faces that replace them.
struct FaceChange {
  std::vector<const WorkFace*> removed;
  std::vector<WorkFace> added;
};

/// The faces of an incremental solid in an immutable tree of boxes. A tree that differs in a few faces shares all equal
/// subtrees. The shape of a tree depends on its history, not on threads or addresses.
class FaceTree {
 public:
  FaceTree() = default;
  explicit FaceTree(std::vector<WorkFace> faces);  ///< O(n log n)

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] Box bounds() const;
  /// Six times the volume inside, within bounds.
  [[nodiscard]] DoubleDouble determinant() const;

  /// Calls `visit(const WorkFace&)` for all faces whose boxes may meet a region, in the order of the tree.
  /// `overlaps(const Box&)` must be true for a box if it is for a box inside. The references are valid as long as the
  /// tree is.
  template <class Overlaps, class Visit>
  void for_each_in(const Overlaps& overlaps, const Visit& visit) const {
    if (root_ != nullptr) visit_node(*root_, overlaps, visit);
  }
  template <class Visit>
  void for_each(const Visit& visit) const {
    for_each_in([](const Box&) { return true; }, visit);
  }

  /// The tree after changes of this tree, no two of which remove the same face. O(k log n) for k faces that are removed
  /// and inserted, amortized.
  [[nodiscard]] FaceTree with(std::vector<FaceChange> changes) const;

 private:
  struct Node;
  using NodePointer = std::shared_ptr<const Node>;
  struct Node {
    Box box;
    std::size_t count = 0;
    DoubleDouble determinant;
    std::array<NodePointer, 2> children;  ///< null: a leaf
    std::vector<WorkFace> faces;          ///< of a leaf
  };

  explicit FaceTree(NodePointer root) : root_(std::move(root)) {}

  template <class Overlaps, class Visit>
  static void visit_node(const Node& node, const Overlaps& overlaps, const Visit& visit) {
    if (!overlaps(node.box)) return;
    if (node.children[0] != nullptr) {
      for (const NodePointer& child : node.children) visit_node(*child, overlaps, visit);
    } else {
      for (const WorkFace& face : node.faces)
        if (overlaps(face.box())) visit(face);
    }
  }

  static NodePointer leaf(std::vector<WorkFace> faces);
  static NodePointer inner(NodePointer a, NodePointer b);
  static NodePointer build(std::vector<WorkFace> faces);
  static NodePointer build(std::span<WorkFace> faces, std::span<std::uint32_t> order);
  static NodePointer without(const NodePointer& node, std::span<const Box> regions,
                             std::span<const WorkFace* const> removed);
  static NodePointer with_faces(const NodePointer& node, std::span<WorkFace> added);

  NodePointer root_;
};

}  // namespace strata
