#include "strata/overlap/coincidences.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace strata {
namespace {

struct Place {
  double x;
  std::uint32_t vertex;

  friend bool operator<(const Place& a, const Place& b) { return a.x < b.x || (a.x == b.x && a.vertex < b.vertex); }
};

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Every vertex is looked at in the one cell that holds it.
void find_in_cell(const Carriers& carriers, const Grid& grid, const Cell& cell, std::vector<Place>& places,
                  Pairs& pairs) {
  places.clear();
  for (const CellFace& f : cell.faces)
    for (const std::uint32_t v : carriers.face(f.face)) {
      const Carriers::Coordinates& p = carriers.vertex(v);
      if (cell.box.holds(grid.at(p)) && carriers.exact(v) == nullptr) places.push_back({p[0], v});
    }
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i > 0 && places[i].vertex == places[i - 1].vertex) continue;
    for (std::size_t j = i + 1; j < places.size() && places[j].x == places[i].x; ++j) {
      if (places[j].vertex == places[j - 1].vertex) continue;
      if (carriers.vertex(places[j].vertex) != carriers.vertex(places[i].vertex)) continue;
      pairs.emplace_back(places[i].vertex, places[j].vertex);
      break;  // the next one of the place is paired in its turn
    }
  }
}

}  // namespace

Pairs find_coincidences(const Carriers& carriers, const CellTree& cells, const Monitor& monitor) {
  struct Found {
    std::vector<Place> places;
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
