#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/overlap/constraint.h"
#include "core/overlap/embedded_stars.h"
#include "core/overlap/shells.h"
#include "core/winding/winding_oracle.h"
#include "strata/monitor.h"

namespace strata {

/// The sheets of one closed mesh that crosses itself: its patches, and its free vertices. Around a free vertex the
/// faces are one disc, and no other face touches the vertex. So the winding number just above them is one there, and
/// faces with constraints have it from their neighbours.
class Sheets {
 public:
  static constexpr std::uint32_t no_face = 0xffffffffu;

  /// `constraints`: all of the mesh. The patches must outlive it.
  Sheets(const InputComplex& input, const EmbeddedStars& stars, const Shells& patches,
         std::span<const Constraint> constraints);

  [[nodiscard]] bool is_free(std::uint32_t vertex) const { return is_free_[vertex]; }
  [[nodiscard]] bool is_subdivided(std::uint32_t face) const { return is_subdivided_[face]; }
  [[nodiscard]] const Shells& patches() const { return patches_; }
  /// The first face of each patch; `no_face` for one whose only face has constraints.
  [[nodiscard]] std::span<const std::uint32_t> first_faces() const { return first_; }
  /// Faces in which winding numbers may have to be found: one of each patch, and those with constraints that share no
  /// free vertex with a patch.
  [[nodiscard]] std::vector<std::uint32_t> asked(const InputComplex& input) const;

 private:
  const Shells& patches_;
  std::vector<bool> is_free_;        ///< per vertex
  std::vector<bool> is_subdivided_;  ///< per face
  std::vector<std::uint32_t> first_;
};

/// Winding numbers just above sheets.
class SheetWindings {
 public:
  /// One point is asked about for each patch. In parallel. Throws Cancelled.
  SheetWindings(const InputComplex& input, Sheets sheets, const WindingOracle& oracle, const Monitor& monitor);

  [[nodiscard]] const Sheets& sheets() const { return sheets_; }
  /// Above a patch. 0 for one whose only face has constraints.
  [[nodiscard]] std::int32_t above_patch(std::uint32_t patch) const { return of_patch_[patch]; }
  /// Above a free vertex, if a patch has it.
  [[nodiscard]] std::optional<std::int32_t> above_vertex(std::uint32_t vertex) const;

 private:
  static constexpr std::int32_t unknown = 0x7fffffff;

  Sheets sheets_;
  std::vector<std::int32_t> of_patch_, of_vertex_;
};

}  // namespace strata
