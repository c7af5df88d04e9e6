#include "core/cells/near_faces.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>

#include "core/cells/face_blocks.h"
#include "core/containers/concatenated.h"
#include "core/containers/scattered.h"

namespace strata {

Lines::Lines(const BrickGrid& bricks)
    : rows_(bricks.size(1)), numbers_(std::size_t{bricks.size(1)} * bricks.size(2), none) {}

std::uint32_t Lines::add(BrickCode code) {
  std::uint32_t& number = numbers_[BrickBox::along(code, 1) + rows_ * BrickBox::along(code, 2)];
  if (number == none) number = count_++;
  return number;
}

namespace {

/// Adds one to a number that other threads may add to. Returns what it was.
std::uint32_t advance(std::uint32_t& counter) {
  return std::atomic_ref<std::uint32_t>(counter).fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

NearFaces find_near_faces(const InputComplex& input, const Grid& grid, const BrickGrid& bricks, const Raster& raster,
                          const BrickCodes& codes, const Occupancy& occupancy, const Regions& regions,
                          const Lines& lines, const Monitor& monitor) {
  std::vector<std::array<std::int32_t, 2>> line_at(std::size_t{bricks.size(1)} * bricks.size(2));
  for (std::uint32_t z = 1; z + 1 < bricks.size(2); ++z)
    for (std::uint32_t y = 1; y + 1 < bricks.size(1); ++y) {
      const auto g = grid.at(bricks.centre(1 | y << 8 | z << 16));
      line_at[y + bricks.size(1) * z] = {g[1], g[2]};
    }
  const std::vector<FaceBlock> blocks = face_blocks(input);
  std::vector<std::vector<std::uint32_t>> faces(blocks.size());
  std::vector<std::vector<LineFace>> line_faces(blocks.size());
  std::vector<std::uint32_t> in_brick(regions.mixed().size());
  const auto may_matter = [&](const BrickBox& box) {
    constexpr std::uint32_t many = 64;
    if (box.size() > many) return true;
    bool matters = false;
    lines.for_each(box, [&](std::uint32_t, std::uint32_t, std::uint32_t) { matters = true; });
    bricks.for_each(
        box, [&](std::uint32_t brick) { matters = matters || (regions.place(brick) & Regions::mixed_flag) != 0; });
    return matters;
  };
  for_each_face_block(input, blocks, monitor, [&](const FaceBlockView& block) {
    const auto points = block.points;
    for (std::uint32_t i = 0; i < block.faces.size(); ++i) {
      if (i % Occupancy::run_length == 0 && !may_matter(occupancy.run(block.number, i / Occupancy::run_length))) {
        i += static_cast<std::uint32_t>(Occupancy::run_length) - 1;
        continue;
      }
      const auto& [a, b, c] = block.faces[i];
      const BrickBox box = codes.box(block.first_vertex, block.faces[i]);
      bool near = false, lined = false;
      raster.for_each_brick(points[a], points[b], points[c], box, [&](std::uint32_t brick) {
        const std::uint32_t place = regions.place(brick);
        if ((place & Regions::mixed_flag) == 0) return;
        near = true;
        advance(in_brick[place - Regions::mixed_flag]);
      });
      lines.for_each(box, [&](std::uint32_t, std::uint32_t, std::uint32_t) { lined = true; });
      const std::uint32_t face = block.first_face + i;
      if (near) faces[block.number].push_back(face);
      if (!lined) continue;
      const GridBox extent = grid.box(points[a], points[b], points[c]);
      lines.for_each(box, [&](std::uint32_t line, std::uint32_t y, std::uint32_t z) {
        const auto& [gy, gz] = line_at[y + bricks.size(1) * z];
        if (extent.lower[1] <= gy && gy <= extent.upper[1] && extent.lower[2] <= gz && gz <= extent.upper[2])
          line_faces[block.number].push_back({line, face});
      });
    }
  });
  NearFaces all{concatenated(std::move(faces), monitor), std::move(in_brick),
                concatenated(std::move(line_faces), monitor)};
  tbb::parallel_sort(all.line_faces.begin(), all.line_faces.end());
  return all;
}

BrickFaces::BrickFaces(const InputComplex& input, const Grid& grid, const BrickGrid& bricks, const Raster& raster,
                       const BrickCodes& codes, const Regions& regions, const NearFaces& near, const Monitor& monitor)
    : input_(input), grid_(grid), bricks_(bricks), raster_(raster), first_(near.in_brick) {
  first_.push_back(0);
  std::uint32_t sum = 0;
  for (std::uint32_t& n : first_) sum += std::exchange(n, sum);
  faces_ = FreshArray<std::uint32_t>(sum);
  constexpr std::size_t run = 1 << 12;
  const std::size_t runs = (near.faces.size() + run - 1) / run;
  const Scattered order(runs);
  tbb::parallel_for(std::size_t{0}, runs, [&](std::size_t n) {
    monitor.check();
    const std::size_t first = order[n] * run, last = std::min(first + run, near.faces.size());
    for (std::size_t i = first; i != last; ++i) {
      const std::uint32_t face = near.faces[i], operand = input.operand_of_face(face);
      const auto points = input.points(operand);
      const auto& t = input.faces(operand)[face - input.first_face(operand)];
      const BrickBox box = codes.box(input.first_vertex(operand), t);
      raster.for_each_brick(points[t[0]], points[t[1]], points[t[2]], box, [&](std::uint32_t brick) {
        const std::uint32_t place = regions.place(brick);
        if ((place & Regions::mixed_flag) != 0) faces_[advance(first_[place - Regions::mixed_flag])] = face;
      });
    }
  });
  // Filling has moved each start on to the next one.
  for (std::size_t n = first_.size() - 1; n > 0; --n) first_[n] = first_[n - 1];
  first_[0] = 0;
}

std::span<const std::uint32_t> BrickFaces::sorted(std::uint32_t n) {
  const std::span<std::uint32_t> faces(faces_.begin() + first_[n], faces_.begin() + first_[n + 1]);
  std::sort(faces.begin(), faces.end());  // threads filled in any order
  return faces;
}

FaceList BrickFaces::with_boxes(std::span<const std::uint32_t> faces) const {
  FaceList list(faces.size());
  std::uint32_t operand = 0, end = 0;
  for (const std::uint32_t f : faces) {
    if (f >= end) {
      operand = input_.operand_of_face(f);
      end = input_.first_face(operand) + input_.face_count(operand);
    }
    const auto points = input_.points(operand);
    const auto& [a, b, c] = input_.faces(operand)[f - input_.first_face(operand)];
    const GridBox box = grid_.box(points[a], points[b], points[c]);
    list.push_back({box, f, raster_.thins({bricks_.code(box.lower), bricks_.code(box.upper)})});
  }
  return list;
}

}  // namespace strata
