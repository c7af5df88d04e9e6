#pragma once
#include <tbb/concurrent_vector.h>

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "core/cells/cell.h"
#include "core/cells/grid.h"
#include "core/cells/vertex_set.h"
#include "core/kernel/input_complex.h"
#include "strata/options.h"

namespace strata {

struct CellOptions {
  bool self = false;            ///< faces of one operand may meet each other
  bool everywhere = false;      ///< origins for space without faces as well
  std::size_t leaf_faces = 64;  ///< refine cells with more faces
  Monitor monitor = {};         ///< checked at every cut
};

/// A cell during refinement, and its halves once it is divided. Linked by pointers, so that subtrees grow
/// independently.
struct Branch {
  /// The extent of the faces: the boxes of those of the first operand present, and of the others.
  struct Content {
    GridBox first, rest;
  };

  GridBox box{};
  InputComplex::Coordinates origin{};
  std::shared_ptr<const Windings> windings;
  FaceList faces;  ///< all whose boxes meet the cell, by increasing face
  Content content{};
  int axis = -1;  ///< of the cut: below are grid coordinates < split, above those >= split; -1: a leaf
  std::int32_t split = 0;
  std::uint32_t cell = 0;  ///< of a leaf
  std::unique_ptr<Branch> below, above;
};

/// Divides cells where faces that may meet are near each other.
class Refinement {
 public:
  /// Leaves are appended to `cells`, corners of faces that may meet others are added to `corners`.
  Refinement(const InputComplex& input, const CellOptions& options, const Grid& grid,
             tbb::concurrent_vector<Cell>& cells, VertexSet& corners)
      : input_(input), options_(options), grid_(grid), cells_(cells), corners_(corners) {}

  /// Refines a cell of which everything but `content` is set. Thread-safe; runs tasks in parallel where cells are
  /// large.
  void refine(Branch& root) const;
  /// Makes a cell of a branch whose faces have these numbers, but no list yet, if they are few and apart.
  [[nodiscard]] bool is_apart(Branch& root, std::span<const std::uint32_t> faces) const;

 private:
  struct Cut {
    int axis = 0;
    std::int32_t split = 0;
  };
  /// Candidates, best first.
  struct Cuts;

  /// What is known of the faces of a leaf.
  enum class Kind { of_one_operand, apart, mixed };

  void grow(Branch& branch, int depth) const;
  void finish(Branch& branch, Kind kind, std::span<const std::uint32_t> numbers = {}) const;
  [[nodiscard]] bool are_few_and_apart(std::span<const std::uint32_t> faces) const;
  [[nodiscard]] bool are_few_and_apart(const FaceList& faces) const;
  void measure(Branch& branch) const;
  [[nodiscard]] std::uint32_t end_of_operand(std::uint32_t face) const;
  [[nodiscard]] bool is_mixed(const FaceList& faces) const;
  [[nodiscard]] Cuts cuts(const Branch& branch) const;
  [[nodiscard]] bool divide(Branch& branch, const Cut& cut) const;
  [[nodiscard]] bool is_worthwhile(std::size_t n, const FaceList& low, const FaceList& high) const;
  [[nodiscard]] Windings share(const Branch& branch, const Cut& cut, const InputComplex::Coordinates& to, Branch& low,
                               Branch& high) const;
  [[nodiscard]] std::optional<InputComplex::Coordinates> place_origin(InputComplex::Coordinates origin,
                                                                      const GridBox& box, int axis) const;

  const InputComplex& input_;
  const CellOptions& options_;
  const Grid& grid_;
  tbb::concurrent_vector<Cell>& cells_;
  VertexSet& corners_;
};

}  // namespace strata
