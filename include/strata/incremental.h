#pragma once
/// Solids that are changed in thousands of steps.
#include <cstddef>
#include <span>

#include "strata/options.h"
#include "strata/shared.h"
#include "strata/solid.h"

namespace strata {

/// A solid that is combined with one tool after the other, as in simulated machining. A step shares with the version
/// before it whatever it does not touch, so it costs about what the surfaces cost where tool and solid meet, and all
/// versions may be kept. Coordinates do not grow with the number of steps: every vertex is given, or the meet of three
/// planes of given faces (but where solids touch themselves within faces or edges, which results do not), or where a
/// tool crosses an edge within a facet of a solid with attributes. For some tens of steps, or tools about as large as
/// the solid, the operators of Solid are faster: a step takes its planes and a tree as well here.
///
/// An immutable value: copying is O(1), reading is thread-safe. Law: the same point set as that of the same operations
/// on Solid; its triangles may be others. Source: own; lib/extensions/incremental/theory.md.
class IncrementalSolid {
 public:
  IncrementalSolid();  ///< empty
  /// O(n log n).
  explicit IncrementalSolid(const Solid& solid);

  /// The regularized Boolean of this solid and a tool; difference: the tool is taken away. Exact, in all degenerate
  /// cases of `combine`. Of the options `threads`, `progress` and `cancel` count. Throws as `combine` does. Expected
  /// O(m log n) for m faces where the two meet and n in all, plus the faces that are dropped.
  [[nodiscard]] IncrementalSolid with(Operation operation, const Solid& tool, const Options& options = {}) const;

  /// The same with many tools, in any order: those that are near each other are combined in one step, which is faster
  /// than one after the other. union_: with all; difference: all are taken away; intersection: what is in all;
  /// symmetric_difference: what is in an odd number of them and this solid together. Without tools: this solid.
  [[nodiscard]] IncrementalSolid with(Operation operation, std::span<const Solid> tools,
                                      const Options& options = {}) const;

  /// With exact vertices, and the attributes of the solids that it was made of (carry_attributes.h). Of the options
  /// `threads`, `cancel` and `cut_material` count; the latter is for what differences have cut, and if no solid has
  /// attributes for what else is in one plane with it, too. O(n).
  [[nodiscard]] Solid solid(const Options& options = {}) const;
  [[nodiscard]] bool is_empty() const;
  [[nodiscard]] std::size_t triangle_count() const;
  /// Correct to a few units in the last place, unless nearly all of the solid cancels. O(1). `solid().volume()` is
  /// exact.
  [[nodiscard]] double volume() const;

 private:
  struct Data;
  Shared<Data> data_;
};

}  // namespace strata
