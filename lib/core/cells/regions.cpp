#include "core/cells/regions.h"

#include <algorithm>
#include <limits>

#include "core/containers/huge_pages.h"

namespace strata {

Regions::Regions(const BrickGrid& bricks, const Occupancy& occupancy, bool everywhere) {
  resize_fresh(places_, bricks.brick_count());
  const std::uint32_t nx = bricks.size(0), ny = bricks.size(1), nz = bricks.size(2);
  for (std::uint32_t z = 0; z < nz; ++z)
    for (std::uint32_t y = 0; y < ny; ++y) {
      const std::size_t row = first_run_.size();
      first_run_.push_back(static_cast<std::uint32_t>(runs_.size()));
      find_runs(occupancy, everywhere, nx * static_cast<std::uint32_t>(row), nx * static_cast<std::uint32_t>(row + 1));
      if (y > 0) join_rows(row, row - 1, nx);
      if (z > 0) join_rows(row, row - ny, nx * ny);
    }
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> region(runs_.size(), none);
  for (std::uint32_t i = 0; i < runs_.size(); ++i) {
    const std::uint32_t r = root(i);  // the first run of its region
    if (r == i) {
      region[i] = static_cast<std::uint32_t>(regions_.size());
      regions_.push_back(runs_[i].first);
    }
    for (std::uint32_t b = runs_[i].first; b < runs_[i].last; ++b) places_[b] = region[r] + 1;
  }
}

/// Lists the runs of a row.
void Regions::find_runs(const Occupancy& occupancy, bool everywhere, std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t b = first; b < last;) {
    const Occupancy::Owner owner = occupancy.owner(b);
    if ((owner == Occupancy::nobody && !everywhere) || owner == Occupancy::outside) {
      ++b;
    } else if (owner == Occupancy::mixed) {
      places_[b] = mixed_flag | static_cast<std::uint32_t>(mixed_.size());
      mixed_.push_back(b++);
    } else {
      const std::uint32_t start = b;
      while (b < last && occupancy.owner(b) == owner) ++b;
      runs_.push_back({start, b, static_cast<std::uint32_t>(runs_.size()), owner});
    }
  }
}

/// Joins the runs of the last row with the adjacent ones of an earlier row, `distance` bricks back.
void Regions::join_rows(std::size_t row, std::size_t other, std::uint32_t distance) {
  std::uint32_t j = first_run_[other];
  const std::uint32_t end = first_run_[other + 1];
  for (auto i = first_run_[row]; i < runs_.size(); ++i) {
    while (j < end && runs_[j].last + distance <= runs_[i].first) ++j;
    for (std::uint32_t k = j; k < end && runs_[k].first + distance < runs_[i].last; ++k) {
      if (runs_[k].owner != runs_[i].owner) continue;
      const std::uint32_t a = root(i), b = root(k);
      runs_[std::max(a, b)].parent = std::min(a, b);
    }
  }
}

std::uint32_t Regions::root(std::uint32_t run) {
  while (runs_[run].parent != run) run = runs_[run].parent = runs_[runs_[run].parent].parent;
  return run;
}

}  // namespace strata
