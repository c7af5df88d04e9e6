#include "core/cells/cell_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/cells/near_faces.h"
#include "core/cells/origins.h"
#include "core/cells/walk.h"

namespace strata {
namespace {

/// The median of the longest sides of faces' boxes on the grid, of a sample.
std::int32_t typical_extent(const InputComplex& input, const Grid& grid) {
  constexpr std::uint32_t sample = 1023;
  std::vector<std::int32_t> extents;
  const std::uint32_t step = input.face_count() / sample + 1;
  for (std::uint32_t f = step / 2; f < input.face_count(); f += step) {
    const auto v = input.face(f);
    const GridBox box = grid.box(input.vertex(v[0]), input.vertex(v[1]), input.vertex(v[2]));
    std::int32_t longest = 0;
    for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, box.upper[i] - box.lower[i]);
    extents.push_back(longest);
  }
  const auto middle = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() / 2);
  std::nth_element(extents.begin(), middle, extents.end());
  return *middle;
}

/// Bricks that contain a few faces each, if these have about the same size.
BrickGrid bricks_for(const InputComplex& input, const Space& space) {
  constexpr std::size_t most = std::size_t{1} << 21;
  return {space, std::min(most, std::size_t{2} * input.face_count()), 2 * typical_extent(input, space.grid)};
}

/// The space of interest as one cell. One pass over all faces lists those that reach into it, and walks to its origin.
Branch undivided(const InputComplex& input, const Space& space) {
  const BrickGrid one(space, 1, Grid::extent);
  const BrickCode only = 1 | 1 << 8 | 1 << 16;
  Branch root;
  root.box = one.box(only);
  root.origin = one.centre(only);
  root.faces = FaceList(input.face_count());
  const auto line = space.grid.at(root.origin);
  const InputComplex::Coordinates outside{space.beyond, root.origin[1], root.origin[2]};
  Windings windings;
  for (std::uint32_t o = 0; o < input.operand_count(); ++o) {
    const auto points = input.points(o);
    std::uint32_t f = input.first_face(o);
    for (const auto& corners : input.faces(o)) {
      const auto& [a, b, c] = corners;
      const CellFace face{space.grid.box(points[a], points[b], points[c]), f++, false};
      if (face.box.reaches_into(root.box)) root.faces.push_back(face);
      if (face.box.lower[1] <= line[1] && line[1] <= face.box.upper[1] && face.box.lower[2] <= line[2] &&
          line[2] <= face.box.upper[2])
        windings.add(o, crossing_along_axis(input, face.face, outside, root.origin, 0));
    }
  }
  root.windings = std::make_shared<const Windings>(std::move(windings));
  return root;
}

}  // namespace

CellTree::CellTree(const InputComplex& input, const CellOptions& options)
    : input_(input), space_(find_space(input, options.self)) {
  cells_.push_back({.windings = std::make_shared<const Windings>()});
  if (space_.empty) return;
  constexpr std::uint32_t few = 512;
  if (input.face_count() < few) {
    make_cells_without_bricks(input, options);
  } else {
    bricks_ = bricks_for(input, space_);
    make_cells(input, options);
  }
}

void CellTree::make_cells_without_bricks(const InputComplex& input, const CellOptions& options) {
  options.monitor.check();
  tbb::concurrent_vector<Cell> cells;
  cells.push_back(std::move(cells_.front()));
  near_corners_ = VertexSet(input.vertex_count());
  Branch root = undivided(input, space_);
  Refinement(input, options, space_.grid, cells, near_corners_).refine(root);
  cells_.assign(std::make_move_iterator(cells.begin()), std::make_move_iterator(cells.end()));
  roots_.push_back(collect(root));
}

void CellTree::make_cells(const InputComplex& input, const CellOptions& options) {
  const Monitor& monitor = options.monitor;
  raster_ = std::make_unique<const Raster>(input, bricks_);
  const Raster& raster = *raster_;
  codes_ = std::make_unique<const BrickCodes>(input, space_.grid, bricks_, monitor);
  const Occupancy occupancy(input, bricks_, raster, *codes_, options.self, monitor);
  regions_ = std::make_unique<const Regions>(bricks_, occupancy, options.everywhere);
  Lines lines(bricks_);
  std::vector<Target> targets;
  for (const auto* places : {&regions_->regions(), &regions_->mixed()})
    for (const std::uint32_t brick : *places) targets.push_back({lines.add(bricks_.code_of(brick)), brick});
  const NearFaces near =
      find_near_faces(input, space_.grid, bricks_, raster, *codes_, occupancy, *regions_, lines, monitor);
  near_corners_ = VertexSet(input.vertex_count());
  const std::vector<Windings> windings = walk_to_origins(input, space_, bricks_, near.line_faces, targets, monitor);

  tbb::concurrent_vector<Cell> cells;
  cells.push_back(std::move(cells_.front()));
  const auto cell_of_target = [&](std::size_t n) {
    const BrickCode code = bricks_.code_of(targets[n].brick);
    return Cell{.box = bricks_.box(code),
                .origin = bricks_.centre(code),
                .windings = std::make_shared<const Windings>(windings[n])};
  };
  const std::size_t regions = regions_->regions().size(), mixed = regions_->mixed().size();
  for (std::size_t n = 0; n < regions; ++n) cells.push_back(cell_of_target(n));
  BrickFaces brick_faces(input, space_.grid, bricks_, raster, *codes_, *regions_, near, monitor);
  const Refinement refinement(input, options, space_.grid, cells, near_corners_);
  std::vector<Branch> branches(mixed);
  tbb::parallel_for(std::size_t{0}, mixed, [&](std::size_t n) {
    monitor.check();
    Cell cell = cell_of_target(regions + n);
    Branch& root = branches[n];
    root.box = cell.box;
    root.origin = cell.origin;
    root.windings = std::move(cell.windings);
    const std::span<const std::uint32_t> faces = brick_faces.sorted(static_cast<std::uint32_t>(n));
    if (refinement.is_apart(root, faces)) return;
    root.faces = brick_faces.with_boxes(faces);
    refinement.refine(root);
  });
  numbers_ = brick_faces.take();
  cells_.assign(std::make_move_iterator(cells.begin()), std::make_move_iterator(cells.end()));
  roots_.reserve(mixed);
  for (Branch& root : branches) roots_.push_back(collect(root));
}

std::uint32_t CellTree::collect(Branch& branch) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({branch.axis, branch.split, branch.cell, 0});
  if (branch.axis < 0) return index;
  const std::uint32_t below = collect(*branch.below);
  branch.below.reset();
  const std::uint32_t above = collect(*branch.above);
  branch.above.reset();
  nodes_[index].below = below;
  nodes_[index].above = above;
  return index;
}

std::uint32_t CellTree::cell_at(const std::array<std::int32_t, 3>& g) const {
  if (regions_ == nullptr) return cell_without_bricks(g);
  const std::uint32_t place = regions_->place(bricks_.index(bricks_.code(g)));
  return (place & Regions::mixed_flag) == 0 ? place : descend(roots_[place - Regions::mixed_flag], g);
}

std::uint32_t CellTree::cell_without_bricks(const std::array<std::int32_t, 3>& g) const {
  return !space_.empty && space_.interest.holds(g) ? descend(roots_.front(), g) : outside_cell;
}

PlaneFilter CellTree::plane_of(std::uint32_t face) const {
  const auto v = input_.face(face);
  return {input_.vertex(v[0]), input_.vertex(v[1]), input_.vertex(v[2])};
}

/// The first brick common to both faces owns the pair.
bool CellTree::owns_thinned(const Cell& cell, const CellFace& a, const CellFace& b,
                            std::array<std::int32_t, 3> corner) const {
  const BrickCode own = bricks_.code(cell.box.lower);
  std::array<std::int32_t, 3> end{};
  for (std::size_t i = 0; i < 3; ++i) end[i] = std::min(a.box.upper[i], b.box.upper[i]);
  const BrickBox common{bricks_.code(corner), bricks_.code(end)};
  const auto plane_a = plane_of(a.face), plane_b = plane_of(b.face);
  const auto has = [&](BrickCode brick) {
    return (!a.is_thinned || raster_->meets(plane_a, brick)) && (!b.is_thinned || raster_->meets(plane_b, brick));
  };
  for (auto z = BrickBox::along(common.lower, 2); z <= BrickBox::along(common.upper, 2); ++z)
    for (auto y = BrickBox::along(common.lower, 1); y <= BrickBox::along(common.upper, 1); ++y)
      for (auto x = BrickBox::along(common.lower, 0); x <= BrickBox::along(common.upper, 0); ++x) {
        const BrickCode brick = x | y << 8 | z << 16;
        if (bricks_.is_outside(brick) || !has(brick)) continue;
        if (brick != own) return false;
        const GridBox box = bricks_.box(brick);
        for (std::size_t i = 0; i < 3; ++i) corner[i] = std::max(corner[i], box.lower[i]);
        return cell.box.holds(corner);
      }
  return false;
}

std::uint32_t CellTree::mixed_cell_of_vertex(std::uint32_t place, std::uint32_t vertex) const {
  return descend(roots_[place - Regions::mixed_flag], space_.grid.at(input_.vertex(vertex)));
}

std::uint32_t CellTree::descend(std::uint32_t node, const std::array<std::int32_t, 3>& g) const {
  while (nodes_[node].axis >= 0)
    node =
        g[static_cast<std::size_t>(nodes_[node].axis)] < nodes_[node].split ? nodes_[node].below : nodes_[node].above;
  return nodes_[node].below;
}

std::size_t CellTree::bytes() const {
  if (space_.empty) return 0;
  std::size_t sum = near_corners_.bytes() + cells_.size() * sizeof(Cell) + roots_.size() * sizeof(std::uint32_t) +
                    nodes_.size() * sizeof(Node);
  if (regions_ != nullptr)
    sum += input_.vertex_count() * sizeof(BrickCode) + bricks_.brick_count() * sizeof(std::uint32_t);
  sum += numbers_.size() * sizeof(std::uint32_t);
  for (const Cell& c : cells_) sum += c.faces.size() * sizeof(CellFace);
  return sum;
}

}  // namespace strata
