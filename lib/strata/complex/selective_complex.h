#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "strata/complex/cells.h"
#include "strata/complex/incidences.h"
#include "strata/mesh/monitor.h"
#include "strata/select/formula.h"

namespace strata::complex {

/// A point set of the plane or of space as a selective geometric complex: cells that are pairwise disjoint and cover
/// everything, each in the set or not. Neither open nor closed, of mixed dimension, bounded or not: whatever
/// finitely many polygons, segments and points bound. The same as a Nef polyhedron whose facets are bounded.
///
/// Always the minimal complex of its set, so sets are equal when complexes are. An immutable value, cheap to copy, safe
/// to read from many threads.
/// Source: Rossignac and O'Connor 1989; theory.md.
class SelectiveComplex {
 public:
  explicit SelectiveComplex(int dimension = 3);                  ///< the empty set of the plane (2) or of space (3)
  [[nodiscard]] static SelectiveComplex all(int dimension = 3);  ///< the whole plane, or space
  /// Whatever cells these are, simplified. Requires what `simplified` does: `validate` tells.
  [[nodiscard]] static SelectiveComplex of(const Cells& cells);

  [[nodiscard]] int dimension() const { return cells().dimension; }
  [[nodiscard]] const Cells& cells() const;
  [[nodiscard]] const Incidences& incidences() const;
  [[nodiscard]] std::uint32_t count(int d) const { return cells().count(d); }  ///< cells of one dimension
  [[nodiscard]] bool mark(Cell c) const { return cells().marks[static_cast<std::size_t>(c.dimension)][c.index] != 0; }
  [[nodiscard]] std::vector<std::uint8_t> marks() const;  ///< of all cells, as `incidences` numbers them
  /// Another set over the same cells. O(n log n).
  [[nodiscard]] SelectiveComplex with_marks(std::span<const std::uint8_t> marks) const;
  [[nodiscard]] SelectiveComplex with_marks(const std::function<bool(Cell)>& mark) const;

  [[nodiscard]] bool is_empty() const;
  [[nodiscard]] bool is_all() const;
  /// True when the unbounded cell of the highest dimension is not in the set: all others are bounded.
  [[nodiscard]] bool is_bounded() const { return !mark({dimension(), 0}); }

  friend bool operator==(const SelectiveComplex& a, const SelectiveComplex& b);  ///< as point sets, exactly

 private:
  struct Data;
  explicit SelectiveComplex(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

/// The points for which a closed formula about operands holds: not regularized, one overlay of all operands. Throws
/// std::invalid_argument if their number is not the formula's or their dimensions differ, Cancelled, std::length_error.
[[nodiscard]] SelectiveComplex combine(const Formula& formula, std::span<const SelectiveComplex> operands,
                                       const Monitor& monitor = {});

[[nodiscard]] SelectiveComplex unite(std::span<const SelectiveComplex> operands, const Monitor& monitor = {});
[[nodiscard]] SelectiveComplex operator|(const SelectiveComplex& a, const SelectiveComplex& b);
[[nodiscard]] SelectiveComplex operator&(const SelectiveComplex& a, const SelectiveComplex& b);
[[nodiscard]] SelectiveComplex operator-(const SelectiveComplex& a, const SelectiveComplex& b);
[[nodiscard]] SelectiveComplex operator^(const SelectiveComplex& a, const SelectiveComplex& b);
[[nodiscard]] SelectiveComplex operator~(const SelectiveComplex& a);  ///< the complement. O(n)

}  // namespace strata::complex
