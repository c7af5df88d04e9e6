#include "strata/cells/root_faces.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "strata/cells/walk.h"

namespace strata {
namespace {

/// lower > upper when it holds nothing.
struct Box {
  Carriers::Coordinates lower, upper;
};

Box nothing() {
  Box b;
  b.lower.fill(std::numeric_limits<double>::infinity());
  b.upper.fill(-std::numeric_limits<double>::infinity());
  return b;
}

void include(Box& box, const Carriers::Coordinates& lower, const Carriers::Coordinates& upper) {
  for (std::size_t i = 0; i < 3; ++i) {
    box.lower[i] = std::min(box.lower[i], lower[i]);
    box.upper[i] = std::max(box.upper[i], upper[i]);
  }
}

Box bounds_of_operand(const Carriers& carriers, std::uint32_t operand) {
  const auto points = carriers.points(operand);
  const auto faces = carriers.faces(operand);
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, faces.size(), 1 << 14), nothing(),
      [&](const auto& range, Box b) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          for (const std::uint32_t v : faces[i]) include(b, points[v], points[v]);
        return b;
      },
      [](Box a, const Box& b) {
        include(a, b.lower, b.upper);
        return a;
      });
}

bool overlap(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a.lower[i] > b.upper[i] || b.lower[i] > a.upper[i]) return false;
  return true;
}

/// The box around everything that bounds of two operands share.
Box shared_bounds(std::vector<Box> operands) {
  std::sort(operands.begin(), operands.end(), [](const Box& a, const Box& b) { return a.lower[0] < b.lower[0]; });
  Box shared = nothing();
  for (std::size_t i = 0; i < operands.size(); ++i)
    for (std::size_t j = i + 1; j < operands.size() && operands[j].lower[0] <= operands[i].upper[0]; ++j) {
      const Box &a = operands[i], &b = operands[j];
      if (!overlap(a, b)) continue;
      Carriers::Coordinates lower, upper;
      for (std::size_t k = 0; k < 3; ++k) {
        lower[k] = std::max(a.lower[k], b.lower[k]);
        upper[k] = std::min(a.upper[k], b.upper[k]);
      }
      include(shared, lower, upper);
    }
  return shared;
}

/// A run of faces of one operand.
struct Block {
  std::uint32_t operand = 0, first = 0, last = 0;
  FaceList faces;
  std::int32_t change = 0;  ///< of the operand's winding number on the way to the origin
};

std::vector<Block> blocks_of(const Carriers& carriers) {
  constexpr std::uint32_t size = 1 << 14;
  std::vector<Block> blocks;
  for (std::uint32_t o = 0; o < carriers.operand_count(); ++o)
    for (std::uint32_t i = 0; i < carriers.face_count(o); i += size)
      blocks.push_back({o, i, std::min(i + size, carriers.face_count(o)), {}, 0});
  return blocks;
}

FaceList joined(std::vector<Block>& blocks) {
  std::vector<std::size_t> first(blocks.size() + 1, 0);
  for (std::size_t n = 0; n < blocks.size(); ++n) first[n + 1] = first[n] + blocks[n].faces.size();
  FaceList all(first.back());
  all.set_size(first.back());
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t n) {
    std::copy(blocks[n].faces.begin(), blocks[n].faces.end(), all.data() + first[n]);
    blocks[n].faces.clear();
  });
  return all;
}

/// The space of interest on the grid, and an origin in it. The way to the origin is along x, from beyond everything.
void place(Root& root, const Box& all, const Box& shared, double beyond, bool self) {
  if (self) {
    root.box = {{0, 0, 0}, {Grid::extent + 1, Grid::extent + 1, Grid::extent + 1}};
    root.origin = {beyond, all.lower[1] * 0.5 + all.upper[1] * 0.5, all.lower[2] * 0.5 + all.upper[2] * 0.5};
    return;
  }
  for (int k = 0; k < 3; ++k) {
    const auto a = static_cast<std::size_t>(k);
    root.box.lower[a] = root.grid.at(k, shared.lower[a]);
    root.box.upper[a] = root.grid.at(k, shared.upper[a]) + 1;
    // Off the middle, as in the cells below; the lower bound itself if that is all doubles have to offer.
    const double middle = shared.lower[a] * 0.5362 + shared.upper[a] * 0.4638;
    root.origin[a] = middle >= shared.lower[a] && middle <= shared.upper[a] ? middle : shared.lower[a];
  }
}

}  // namespace

Root find_root(const Carriers& carriers, bool self) {
  std::vector<Box> operands;
  Box all = nothing();
  for (std::uint32_t o = 0; o < carriers.operand_count(); ++o) {
    operands.push_back(bounds_of_operand(carriers, o));
    include(all, operands.back().lower, operands.back().upper);
  }
  Root root;
  const Box shared = shared_bounds(operands);
  const bool any = self ? carriers.face_count() > 0 : shared.lower[0] <= shared.upper[0];
  if (!any) return root;
  root.grid = Grid(all.lower, all.upper);
  // In the sense of walk.h an origin on the upper x side of everything is outside. A rational point may lie above its
  // nearest double, but below the next one.
  const double beyond = carriers.has_rationals() ? std::nextafter(all.upper[0], HUGE_VAL) : all.upper[0];
  place(root, all, shared, beyond, self);

  const Carriers::Coordinates outside{beyond, root.origin[1], root.origin[2]};
  const GridBox way{root.grid.at(root.origin), root.grid.at(outside)};
  const GridBox interest{root.box.lower, {root.box.upper[0] - 1, root.box.upper[1] - 1, root.box.upper[2] - 1}};
  std::vector<Block> blocks = blocks_of(carriers);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t n) {
    Block& b = blocks[n];
    const auto points = carriers.points(b.operand);
    const auto faces = carriers.faces(b.operand);
    b.faces = FaceList(b.last - b.first);
    for (std::uint32_t i = b.first; i < b.last; ++i) {
      const auto& t = faces[i];
      const GridBox box = root.grid.box(points[t[0]], points[t[1]], points[t[2]]);
      const std::uint32_t face = carriers.first_face(b.operand) + i;
      if (box.overlaps(interest)) b.faces.push_back({box, face});
      if (box.overlaps(way)) b.change += crossing_along_axis(carriers, face, outside, root.origin, 0);
    }
  });
  for (const Block& b : blocks) root.windings.add(b.operand, b.change);
  root.faces = joined(blocks);
  return root;
}

}  // namespace strata
