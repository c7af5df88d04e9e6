#include "core/cells/occupancy.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "core/cells/face_blocks.h"
#include "core/containers/huge_pages.h"

namespace strata {

BrickCodes::BrickCodes(const InputComplex& input, const Grid& grid, const BrickGrid& bricks, const Monitor& monitor)
    : codes_(std::make_unique_for_overwrite<BrickCode[]>(input.vertex_count())) {
  prefer_huge_pages(codes_.get(), input.vertex_count() * sizeof(BrickCode));
  for (std::uint32_t o = 0; o < input.operand_count(); ++o) {
    const auto points = input.points(o);
    BrickCode* codes = codes_.get() + input.first_vertex(o);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 1 << 14), [&](const auto& range) {
      monitor.check();
      for (std::size_t i = range.begin(); i != range.end(); ++i) codes[i] = bricks.code(grid.at(points[i]));
    });
  }
}

Occupancy::Occupancy(const InputComplex& input, const BrickGrid& bricks, const Raster& raster, const BrickCodes& codes,
                     bool self, const Monitor& monitor) {
  resize_fresh(owners_, bricks.brick_count(), nobody);
  const std::vector<FaceBlock> blocks = face_blocks(input);
  runs_.resize(blocks.size());
  for_each_face_block(input, blocks, monitor, [&](const FaceBlockView& block) {
    const auto points = block.points;
    const Owner own = self || block.operand + 1 >= mixed ? mixed : static_cast<Owner>(block.operand + 1);
    std::vector<BrickBox>& runs = runs_[block.number];
    runs.reserve(block.faces.size() / run_length + 1);
    BrickCode last = 0;  // a brick that was marked; 0 is outside
    for (std::size_t first = 0; first < block.faces.size(); first += run_length) {
      const auto faces = block.faces.subspan(first, std::min(run_length, block.faces.size() - first));
      BrickBox run = codes.box(block.first_vertex, faces[0]);
      for (const auto& t : faces) {
        const BrickBox box = codes.box(block.first_vertex, t);
        run = run.with(box);
        if (box.lower == box.upper) {
          if (box.lower == last) continue;
          last = box.lower;
        }
        raster.for_each_brick(points[t[0]], points[t[1]], points[t[2]], box,
                              [&](std::uint32_t brick) { mark(brick, own); });
      }
      runs.push_back(run);
    }
  });
  mark_outside(bricks);
}

/// The result does not depend on the order of marks.
void Occupancy::mark(std::uint32_t brick, Owner own) {
  const std::atomic_ref<Owner> owner(owners_[brick]);
  Owner known = owner.load(std::memory_order_relaxed);
  while (known != own && known != mixed) {
    const Owner now = known == nobody ? own : mixed;
    if (owner.compare_exchange_weak(known, now, std::memory_order_relaxed)) return;
  }
}

void Occupancy::mark_outside(const BrickGrid& bricks) {
  const std::uint32_t nx = bricks.size(0), ny = bricks.size(1), nz = bricks.size(2);
  Owner* row = owners_.data();
  for (std::uint32_t z = 0; z < nz; ++z)
    for (std::uint32_t y = 0; y < ny; ++y, row += nx) {
      const bool whole = z == 0 || z + 1 == nz || y == 0 || y + 1 == ny;
      row[0] = row[nx - 1] = outside;
      if (whole) std::fill(row, row + nx, outside);
    }
}

}  // namespace strata
