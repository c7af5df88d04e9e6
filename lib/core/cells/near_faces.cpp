#include "core/cells/near_faces.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>

#include "core/cells/face_blocks.h"
#include "core/containers/concatenated.h"

namespace strata {

Lines::Lines(const BrickGrid& bricks)
    : rows_(bricks.size(1)), numbers_(std::size_t{bricks.size(1)} * bricks.size(2), none) {}

std::uint32_t Lines::add(BrickCode code) {
  std::uint32_t& number = numbers_[BrickBox::along(code, 1) + rows_ * BrickBox::along(code, 2)];
  if (number == none) number = count_++;
  return number;
}

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
  std::vector<std::vector<CellFace>> faces(blocks.size());
  std::vector<std::vector<LineFace>> line_faces(blocks.size());
  VertexSet corners(input.vertex_count());
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
        near = near || (regions.place(brick) & Regions::mixed_flag) != 0;
      });
      lines.for_each(box, [&](std::uint32_t, std::uint32_t, std::uint32_t) { lined = true; });
      if (!near && !lined) continue;
      const CellFace face{grid.box(points[a], points[b], points[c]), block.first_face + i, raster.thins(box)};
      if (near) {
        faces[block.number].push_back(face);
        corners.add(block.first_vertex, block.faces[i]);
      }
      lines.for_each(box, [&](std::uint32_t line, std::uint32_t y, std::uint32_t z) {
        const auto& [gy, gz] = line_at[y + bricks.size(1) * z];
        if (face.box.lower[1] <= gy && gy <= face.box.upper[1] && face.box.lower[2] <= gz && gz <= face.box.upper[2])
          line_faces[block.number].push_back({line, face.face});
      });
    }
  });
  NearFaces all{concatenated(std::move(faces), monitor), concatenated(std::move(line_faces), monitor),
                std::move(corners)};
  tbb::parallel_sort(all.line_faces.begin(), all.line_faces.end());
  return all;
}

BrickFaces::BrickFaces(const InputComplex& input, const Raster& raster, const BrickCodes& codes, const Regions& regions,
                       std::span<const CellFace> near, const Monitor& monitor)
    : near_(near), first_(regions.mixed().size() + 1) {
  const auto for_each = [&](const auto& visit) {  // visit(index of a near face, number of a mixed brick)
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, near.size(), 1 << 12), [&](const auto& range) {
      monitor.check();
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        const auto operand = input.operand_of_face(near[i].face);
        const auto points = input.points(operand);
        const auto& t = input.faces(operand)[near[i].face - input.first_face(operand)];
        const BrickBox box = codes.box(input.first_vertex(operand), t);
        raster.for_each_brick(points[t[0]], points[t[1]], points[t[2]], box, [&](std::uint32_t brick) {
          const std::uint32_t place = regions.place(brick);
          if ((place & Regions::mixed_flag) != 0) visit(static_cast<std::uint32_t>(i), place - Regions::mixed_flag);
        });
      }
    });
  };
  const auto advance = [](std::uint32_t& counter) {
    return std::atomic_ref<std::uint32_t>(counter).fetch_add(1, std::memory_order_relaxed);
  };
  for_each([&](std::uint32_t, std::uint32_t brick) { advance(first_[brick]); });
  std::uint32_t sum = 0;
  for (std::uint32_t& n : first_) sum += std::exchange(n, sum);
  faces_ = std::make_unique_for_overwrite<std::uint32_t[]>(sum);
  // Filling moves each start on to the next one.
  for_each([&](std::uint32_t i, std::uint32_t brick) { faces_[advance(first_[brick])] = i; });
  for (std::size_t n = first_.size() - 1; n > 0; --n) first_[n] = first_[n - 1];
  first_[0] = 0;
}

FaceList BrickFaces::take(std::uint32_t n) {
  // Threads filled in any order.
  std::sort(&faces_[first_[n]], &faces_[first_[n + 1]]);
  FaceList list(first_[n + 1] - first_[n]);
  for (std::uint32_t k = first_[n]; k < first_[n + 1]; ++k) list.push_back(near_[faces_[k]]);
  return list;
}

}  // namespace strata
