#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "strata/complex/cells.h"

namespace strata::complex {

/// Lists of numbers, one after the other.
class Lists {
 public:
  Lists() = default;
  /// Lists of what `visit(add)` adds by `add(list, entry)`; it is called twice. Entries keep their order.
  template <class Visit>
  Lists(std::uint32_t count, const Visit& visit);
  /// Lists of lists: to every entry those of its own list, and so on; each once, rising. Requires that this ends.
  [[nodiscard]] Lists followed() const;

  [[nodiscard]] std::span<const std::uint32_t> operator[](std::uint32_t list) const {
    return std::span(entries_).subspan(first_[list], first_[list + 1] - first_[list]);
  }
  [[nodiscard]] std::size_t size() const { return entries_.size(); }  ///< of all lists

 private:
  std::vector<std::uint32_t> first_{0};
  std::vector<std::uint32_t> entries_;
};

/// Which cells bound which, of all dimensions: cells have one numbering here, vertices first, volumes last.
class Incidences {
 public:
  Incidences() = default;
  explicit Incidences(const Cells& cells);  ///< O(k log d) for k incidences and at most d at a cell below volumes

  [[nodiscard]] std::uint32_t number(Cell c) const { return first_[static_cast<std::size_t>(c.dimension)] + c.index; }
  [[nodiscard]] Cell cell(std::uint32_t number) const;
  [[nodiscard]] std::uint32_t count() const { return first_[4]; }  ///< cells
  /// The cells that a cell lies in the boundary of.
  [[nodiscard]] std::span<const std::uint32_t> star(std::uint32_t number) const { return star_[number]; }
  /// The cells that make up its boundary.
  [[nodiscard]] std::span<const std::uint32_t> boundary(std::uint32_t number) const { return boundary_[number]; }
  [[nodiscard]] std::size_t size() const { return star_.size(); }  ///< pairs of cells

 private:
  std::array<std::uint32_t, 5> first_{};
  Lists star_, boundary_;
};

}  // namespace strata::complex
