#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/csg/arena.h"
#include "extensions/surface/parts.h"
#include "extensions/surface/space_cells.h"
#include "extensions/surface/walls.h"
#include "strata/carry_attributes.h"
#include "strata/surface.h"

namespace strata {
namespace {

using Index = std::uint32_t;
constexpr Index none = 0xffffffffu;

/// How often each wall counts in an operand: once for every face of it, negative where this is reversed.
std::vector<std::int32_t> multiplicities(const Arrangement& a, Index operand) {
  std::vector<std::int32_t> times(a.sources.size(), 0);
  for (Index w = 0; w < times.size(); ++w) times[w] = a.sources[w].operand == operand ? 1 : 0;
  for (const Arrangement::Cover& c : a.covers)
    if (c.face.operand == operand) times[c.wall] += c.is_reversed ? -1 : 1;
  return times;
}

/// The walls between different cells, by cell.
class Neighbours {
 public:
  explicit Neighbours(const Arrangement& a) : first_(a.cell_count + 1, 0) {
    for (const auto& [front, back] : a.cells)
      if (front != back) {
        ++first_[front + 1];
        ++first_[back + 1];
      }
    for (std::size_t c = 0; c < a.cell_count; ++c) first_[c + 1] += first_[c];
    walls_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (Index w = 0; w < a.cells.size(); ++w)
      if (const auto& [front, back] = a.cells[w]; front != back) {
        walls_[next[front]++] = w;
        walls_[next[back]++] = w;
      }
  }
  [[nodiscard]] std::span<const Index> walls(Index cell) const {
    return std::span(walls_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<Index> walls_;
};

}  // namespace

std::vector<std::int32_t> Arrangement::windings(std::uint32_t operand) const {
  const std::vector<std::int32_t> times = multiplicities(*this, operand);
  const Neighbours neighbours(*this);
  std::vector<std::optional<std::int32_t>> known(cell_count);
  std::vector<Index> waiting{0};
  known[0] = 0;
  while (!waiting.empty()) {
    const Index cell = waiting.back();
    waiting.pop_back();
    for (const Index w : neighbours.walls(cell)) {
      const auto [front, back] = cells[w];
      const Index other = front == cell ? back : front;
      if (known[other]) continue;
      known[other] = *known[cell] + (front == cell ? times[w] : -times[w]);
      waiting.push_back(other);
    }
  }
  for (Index w = 0; w < cells.size(); ++w)
    if (const auto [front, back] = cells[w]; *known[front] + times[w] != *known[back])
      throw std::invalid_argument("surface " + std::to_string(operand) + " is not closed: it has no winding numbers");
  std::vector<std::int32_t> windings;
  for (const auto& w : known) windings.push_back(*w);
  return windings;
}

std::vector<Solid> Arrangement::solids() const {
  std::vector<Index> all(cell_count - 1);
  for (Index c = 0; c < all.size(); ++c) all[c] = c + 1;
  return solids_of(*this, all);
}

std::vector<Solid> solids_of(const Arrangement& a, std::span<const std::uint32_t> cells) {
  const Neighbours neighbours(a);
  std::vector<Solid> solids;
  std::vector<Index> number(a.mesh.mesh.vertices.size(), none);
  for (const Index cell : cells) {
    MeshPart part(a.mesh, number);
    std::vector<Source> sources;
    for (const Index w : neighbours.walls(cell)) {
      part.add(a.mesh.mesh.triangles[w], a.cells[w][1] != cell);
      sources.push_back(a.sources[w]);
    }
    solids.push_back(Solid::trusted(std::move(part).mesh(), std::move(sources)));
  }
  return solids;
}

Arrangement arrange(std::span<const Surface> surfaces, const Options& options) {
  const Monitor monitor(options.cancel, &options.progress);
  monitor.check();
  std::size_t faces = 0;
  for (const Surface& s : surfaces) faces += s.mesh().triangles.size();
  Arrangement result;
  if (faces == 0) return result;
  arena_for(options, faces).execute([&] {
    const Walls walls(surfaces, monitor);
    monitor.report(0.6);
    result.mesh = walls.mesh(monitor);
    SpaceCells cells = find_cells(walls, result.mesh, monitor);
    monitor.report(0.9);
    result.cells = std::move(cells.of_wall);
    result.cell_count = cells.count;
    result.sources = walls.boundary().sources;
    monitor.check();
    for (const Cover& c : walls.boundary().covers)
      result.covers.push_back({c.triangle, walls.source(c.face), walls.is_reversed(c)});
  });
  monitor.report(1);
  return result;
}

std::vector<Solid> cells_of(std::span<const Surface> surfaces, const Options& options) {
  return cells_of(arrange(surfaces, options), surfaces, options);
}

std::vector<Solid> cells_of(const Arrangement& arrangement, std::span<const Surface> surfaces, const Options& options) {
  std::vector<Solid> solids = arrangement.solids();
  if (carry_nothing(surfaces)) return solids;
  const std::vector<AttributedMesh> sources = attributed_meshes(surfaces);
  for (Solid& solid : solids)
    solid = solid.with_attributes(carry_attributes(sources, solid.exact_mesh(), solid.sources(), options));
  return solids;
}

}  // namespace strata
