#include "core/round/wrong_faces.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "core/containers/box_cover.h"
#include "core/containers/collect.h"
#include "core/kernel/disjoint_sets.h"
#include "core/kernel/input_complex.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/zero_area.h"
#include "core/overlap/embedded_stars.h"
#include "core/overlap/self_intersections.h"

namespace strata {
namespace {

/// Pairs beyond that are found in a later search.
constexpr std::size_t most_pairs = 1 << 18;

std::vector<Box> boxes_to_search(const MovingMesh& mesh) {
  if (mesh.swept()) return *mesh.swept();
  std::vector<Box> boxes;
  for (const std::uint32_t f : mesh.changed())
    if (mesh.is_left(f)) boxes.push_back(mesh.box(f));
  return boxes;
}

std::vector<std::uint32_t> faces_to_search(const MovingMesh& mesh) {
  const std::size_t count = mesh.mesh().triangles.size();
  if (mesh.changed().empty()) return {};
  if (2 * mesh.changed().size() > count)
    return collect(count, [&](std::uint32_t f) { return mesh.is_left(f); });
  const BoxCover cover(boxes_to_search(mesh));
  return collect(count, [&](std::uint32_t f) { return mesh.is_left(f) && cover.meets(mesh.box(f)); });
}

/// Some triangles of a mesh, as a mesh; `numbers` are the vertices' numbers in the whole.
Mesh part_of(const Mesh& mesh, std::span<const std::uint32_t> faces, std::vector<std::uint32_t>& numbers) {
  for (const std::uint32_t f : faces) numbers.insert(numbers.end(), mesh.triangles[f].begin(), mesh.triangles[f].end());
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  Mesh part;
  for (const std::uint32_t v : numbers) part.vertices.push_back(mesh.vertices[v]);
  std::vector<std::uint32_t> number_in_part(mesh.vertices.size());
  for (std::uint32_t n = 0; n < numbers.size(); ++n) number_in_part[numbers[n]] = n;
  for (const std::uint32_t f : faces) {
    const auto& [a, b, c] = mesh.triangles[f];
    part.triangles.push_back({number_in_part[a], number_in_part[b], number_in_part[c]});
  }
  return part;
}

}  // namespace

ChangedRegion::ChangedRegion(const MovingMesh& mesh, const Monitor& monitor)
    : mesh_(mesh), faces_(faces_to_search(mesh)) {
  monitor.check();
  part_ = part_of(mesh.mesh(), faces_, vertices_);
  const std::vector<std::uint32_t> first = strata::equal_vertices(part_.vertices);
  for (std::uint32_t v = 0; v < first.size(); ++v)
    if (first[v] != v) equal_.emplace_back(vertices_[v], vertices_[first[v]]);
  if (equal_.empty()) return;
  for (Triangle& t : part_.triangles)
    for (std::uint32_t& v : t) v = first[v];
}

std::vector<std::uint32_t> ChangedRegion::wrong_faces(const Monitor& monitor) const {
  const ZeroAreaTest has_no_area(part_);
  const std::vector<std::uint32_t> flat = collect(
      faces_.size(), [&](std::uint32_t f) { return repeats_vertex(part_.triangles[f]) || has_no_area(f); });
  std::vector<std::uint32_t> sound(faces_.size());
  std::iota(sound.begin(), sound.end(), 0U);
  std::erase_if(sound, [&](std::uint32_t f) { return std::binary_search(flat.begin(), flat.end(), f); });
  std::vector<Triangle> triangles;
  for (const std::uint32_t f : sound) triangles.push_back(part_.triangles[f]);

  InputComplex complex(SelfIntersections::possible);
  complex.add(part_.vertices, triangles);
  std::optional<EmbeddedStars> stars;
  if (flat.empty() && faces_.size() == mesh_.mesh().triangles.size()) stars.emplace(complex, monitor);  // it is closed
  std::vector<std::uint32_t> wrong = flat;
  for (const SelfIntersection& s : find_self_intersections(complex, stars ? &*stars : nullptr, monitor, most_pairs)) {
    wrong.push_back(sound[s.face]);
    wrong.push_back(sound[s.other]);
  }
  std::sort(wrong.begin(), wrong.end());
  wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
  for (std::uint32_t& f : wrong) f = faces_[f];
  return wrong;
}

bool ChangedRegion::keeps_windings() const {
  if (!mesh_.swept()) return false;
  std::vector<bool> is_changed(faces_.size());
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
    is_changed[f] = std::binary_search(mesh_.changed().begin(), mesh_.changed().end(), faces_[f]);
  const auto is_lost = [&](const EdgeUse& use) {
    return mesh_.lost_sides().contains({vertices_[use.low], vertices_[use.high]});
  };
  DisjointSets<std::uint32_t> patches(faces_.size());
  std::vector<std::uint32_t> beside_known;  // faces with a side that a face outside the region has, too
  for_each_edge(edge_table(part_.triangles, part_.vertices.size()), [&](std::span<const EdgeUse> uses) {
    const bool changed = std::any_of(uses.begin(), uses.end(), [&](const EdgeUse& u) { return is_changed[u.triangle]; });
    if (changed ? uses.size() != 2 || net_uses(uses) != 0 : is_lost(uses[0])) return;
    for (const EdgeUse& use : uses) patches.unite(uses[0].triangle, use.triangle);
    if (net_uses(uses) != 0) beside_known.push_back(uses[0].triangle);
  });
  std::vector<bool> is_known(faces_.size(), false);
  for (const std::uint32_t f : beside_known) is_known[patches.find(f)] = true;
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
    if (!is_known[patches.find(f)]) return false;
  return true;
}

}  // namespace strata
