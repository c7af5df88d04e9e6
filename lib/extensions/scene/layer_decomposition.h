#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "extensions/scene/painters_order.h"
#include "extensions/scene/signed_covering.h"
#include "strata/options.h"

namespace strata {

/// The faces of a scene in layers as seen from an origin (after Rueda, Feito, Ortega, "Layer-based decomposition of
/// solids"): the first layer is what nothing dominates, the faces farthest along all their rays; every other face
/// is in the layer after the last one that dominates it. Going through the layers from the first to the last is the
/// painter's order, back to front.
///
/// Faces that cross are cut along each other, and rings of faces that dominate one another are cut open; the parts are
/// numbered after the faces. Flat faces, whose planes hold the origin, are in no layer: no ray meets them inside.
/// Faces that lie on one another in one plane do not dominate each other.
///
/// An immutable value, cheap to copy, safe to ask from many threads. The same for any number of threads.
class LayerDecomposition {
 public:
  /// O((n + k) log n) in n faces and k pairs of faces that are seen in one square of directions. Throws
  /// std::invalid_argument (an origin that is none), Cancelled.
  LayerDecomposition(Scene scene, const Origin& origin, const Monitor& monitor = {});

  [[nodiscard]] const Scene& scene() const { return data_->covering.scene(); }
  [[nodiscard]] const Origin& origin() const { return data_->covering.origin(); }
  [[nodiscard]] const SignedCovering& covering() const { return data_->covering; }

  [[nodiscard]] std::uint32_t layer_count() const { return data_->order.layer_count; }
  /// Faces and parts of faces, replaced ones included.
  [[nodiscard]] std::uint32_t piece_count() const { return data_->pieces.count(); }
  /// From 1; 0 for flat faces and for pieces that were cut into parts.
  [[nodiscard]] std::uint32_t layer(std::uint32_t piece) const { return data_->order.layer[piece]; }
  [[nodiscard]] bool is_replaced(std::uint32_t piece) const { return data_->pieces.is_replaced(piece); }
  [[nodiscard]] std::uint32_t face_of(std::uint32_t piece) const { return data_->pieces.face_of(piece); }
  /// Exact; corners made by cuts are rationals. Counter-clockwise seen from outside.
  [[nodiscard]] std::array<RationalPoint, 3> triangle(std::uint32_t piece) const;
  [[nodiscard]] const Pieces& pieces() const { return data_->pieces; }
  /// The sign of a piece's tetrahedron: +1 when the outward normal points away from the origin, -1 when towards it, 0
  /// when flat.
  [[nodiscard]] int sign(std::uint32_t piece) const { return -to_int(covering().turn(face_of(piece))); }

  /// The pieces of a layer, 1 to layer_count(), by increasing number.
  [[nodiscard]] std::span<const std::uint32_t> layer_pieces(std::uint32_t layer) const;
  /// All pieces back to front: those of the first layer, then the second's, ...
  [[nodiscard]] std::span<const std::uint32_t> back_to_front() const { return data_->sorted; }
  /// The pieces found to dominate this one, by increasing number. All that come next on some ray are among them.
  [[nodiscard]] std::span<const std::uint32_t> dominators(std::uint32_t piece) const;

  [[nodiscard]] std::uint32_t cuts_at_crossings() const { return data_->order.cuts_at_crossings; }
  [[nodiscard]] std::uint32_t cuts_of_cycles() const { return data_->order.cuts_of_cycles; }
  [[nodiscard]] std::uint64_t domination_count() const { return data_->order.dominators.size(); }
  [[nodiscard]] std::uint64_t pairs_tested() const { return data_->pairs_tested; }
  /// Memory held, the scene's own arrays left out.
  [[nodiscard]] std::size_t bytes() const;

  /// The invariants that do not hold, as sentences; empty if all do: every dominator is in a lower layer, every layer
  /// has its pieces, every piece comes right after its last dominator, and the signed covering gives at `samples`
  /// points the winding numbers that walks from infinity past all faces give. O(n + k) and O(n) per sample.
  [[nodiscard]] std::vector<std::string> validate(std::size_t samples = 16) const;

 private:
  struct Data {
    explicit Data(SignedCovering c) : covering(std::move(c)), pieces(covering.scene()) {}
    SignedCovering covering;
    Pieces pieces;
    LayerOrder order;
    std::vector<std::uint32_t> sorted, first;  ///< pieces by layer; where each layer begins
    std::uint64_t pairs_tested = 0;
  };
  std::shared_ptr<const Data> data_;
};

}  // namespace strata
