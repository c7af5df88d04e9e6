#pragma once
/// Solids that are changed in thousands of steps.
#include <cstddef>
#include <span>

#include "strata/options.h"
#include "strata/shared.h"
#include "strata/solid.h"

namespace strata {

/// A solid that is changed step by step, thousands of times: an immutable value, cheap to copy, safe to read from many
/// threads. A step shares with the incremental solid before it whatever it does not touch, so it costs about what the
/// surfaces cost where tool and incremental solid meet, and all versions of a incremental solid may be kept.
class IncrementalSolid {
 public:
  IncrementalSolid();  ///< empty
  explicit IncrementalSolid(const Solid& solid);

  /// The incremental solid and a tool combined; difference: the tool is taken away. Exact. Throws as `combine` does.
  [[nodiscard]] IncrementalSolid with(Operation operation, const Solid& tool, const Options& options = {}) const;

  /// The same with many tools, in any order: those that are near each other are taken in one step, which is faster than
  /// one after the other. union_: with all; difference: all are taken away; intersection: what is in all;
  /// symmetric_difference: as often as there are tools.
  [[nodiscard]] IncrementalSolid with(Operation operation, std::span<const Solid> tools,
                                      const Options& options = {}) const;

  [[nodiscard]] Solid solid() const;  ///< O(n)
  [[nodiscard]] bool is_empty() const;
  [[nodiscard]] std::size_t triangle_count() const;
  /// The volume, nearly to the last digit of a double. O(1). `solid().volume()` is exact.
  [[nodiscard]] double volume() const;

 private:
  struct Data;
  Shared<Data> data_;
};

}  // namespace strata
