#include "strata/overlap/coincidences.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <bit>
#include <cstdint>

namespace strata {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Vertices by their places.
class Places {
 public:
  /// Makes room for so many vertices and forgets all.
  void clear(std::size_t vertices) { slots_.assign(std::bit_ceil(2 * vertices + 1), nobody); }

  /// The vertex that was first at this place, itself if it is the first.
  std::uint32_t first_at(const Carriers& carriers, const Carriers::Coordinates& p, std::uint32_t vertex) {
    for (std::size_t s = hash_of(p);; ++s) {
      std::uint32_t& slot = slots_[s & (slots_.size() - 1)];
      if (slot == nobody) slot = vertex;
      if (slot == vertex || carriers.vertex(slot) == p) return slot;
    }
  }

 private:
  static constexpr std::uint32_t nobody = 0xffffffffu;

  static std::size_t hash_of(const Carriers::Coordinates& p) {
    std::uint64_t h = 0;
    for (const double x : p) h = (h ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0xff51afd7ed558ccdu;  // -0 is 0
    return h >> 20;
  }
  std::vector<std::uint32_t> slots_;
};

/// Every vertex is looked at in the one cell that holds it.
void find_in_cell(const Carriers& carriers, const Grid& grid, const Cell& cell, Places& places, Pairs& pairs) {
  places.clear(3 * cell.faces.size());
  for (const CellFace& f : cell.faces)
    for (const std::uint32_t v : carriers.face(f.face)) {
      const Carriers::Coordinates& p = carriers.vertex(v);
      if (!cell.box.holds(grid.at(p)) || carriers.exact(v) != nullptr) continue;
      const std::uint32_t first = places.first_at(carriers, p, v);
      if (first != v && (pairs.empty() || pairs.back() != std::pair(first, v))) pairs.emplace_back(first, v);
    }
}

}  // namespace

Pairs find_coincidences(const Carriers& carriers, const CellTree& cells, const Monitor& monitor) {
  struct Found {
    Places places;
    Pairs pairs;
  };
  tbb::enumerable_thread_specific<Found> found;
  tbb::parallel_for(std::size_t{0}, cells.cells().size(), [&](std::size_t i) {
    if (!cells.cells()[i].mixed) return;
    monitor.check();
    Found& f = found.local();
    find_in_cell(carriers, cells.grid(), cells.cells()[i], f.places, f.pairs);
  });
  Pairs all;
  for (const Found& f : found) all.insert(all.end(), f.pairs.begin(), f.pairs.end());
  return all;
}

}  // namespace strata
