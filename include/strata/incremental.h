#pragma once
/// Solids that are changed in thousands of steps.
#include <cstddef>
#include <memory>
#include <span>

#include "strata/options.h"
#include "strata/solid.h"

namespace strata {

/// A solid that is changed step by step, thousands of times: an immutable value, cheap to copy, safe to read from many
/// threads. A step shares with the workpiece before it whatever it does not touch, so it costs about what the surfaces
/// cost where tool and workpiece meet, and all versions of a workpiece may be kept.
class Workpiece {
 public:
  Workpiece();  ///< empty
  explicit Workpiece(const Solid& solid);

  /// The workpiece and a tool combined; subtract: the tool is taken away. Exact. Throws as `combine` does.
  [[nodiscard]] Workpiece with(Operation operation, const Solid& tool, const Options& options = {}) const;

  /// The same with many tools, in any order: those that are near each other are taken in one step, which is faster than
  /// one after the other. unite: with all; subtract: all are taken away; intersect: what is in all; exclude: as often
  /// as there are tools.
  [[nodiscard]] Workpiece with(Operation operation, std::span<const Solid> tools, const Options& options = {}) const;

  [[nodiscard]] Solid solid() const;  ///< O(n)
  [[nodiscard]] bool is_empty() const;
  [[nodiscard]] std::size_t triangle_count() const;
  /// The volume, nearly to the last digit of a double. O(1). `solid().volume()` is exact.
  [[nodiscard]] double volume() const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace strata
