#include "core/round/wrong_faces.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <span>
#include <utility>

#include "core/containers/box_cover.h"
#include "core/containers/collect.h"
#include "core/containers/huge_pages.h"
#include "core/kernel/disjoint_sets.h"
#include "core/kernel/input_complex.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/zero_area.h"
#include "core/overlap/self_intersections.h"

namespace strata {
namespace {

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
  if (2 * mesh.changed().size() > count) return collect(count, [&](std::uint32_t f) { return mesh.is_left(f); });
  return mesh.faces_that_meet(BoxCover(boxes_to_search(mesh)));
}

/// Some triangles of a mesh, as a mesh; `numbers` becomes the vertices' numbers in the whole.
Mesh part_of(MeshView mesh, std::span<const std::uint32_t> faces, std::vector<std::uint32_t>& numbers) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number_in_part;
  resize_fresh(number_in_part, mesh.vertices.size(), unused);
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t n) {
    for (const std::uint32_t v : mesh.triangles[faces[n]])
      if (const std::atomic_ref at(number_in_part[v]); at.load(std::memory_order_relaxed) != 0)
        at.store(0, std::memory_order_relaxed);
  });
  numbers = collect(mesh.vertices.size(), [&](std::uint32_t v) { return number_in_part[v] != unused; });
  Mesh part;
  if (faces.size() == mesh.triangles.size() && numbers.size() == mesh.vertices.size()) {
    tbb::parallel_invoke([&] { part.vertices.assign(mesh.vertices.begin(), mesh.vertices.end()); },
                         [&] { part.triangles.assign(mesh.triangles.begin(), mesh.triangles.end()); });
    return part;
  }
  resize_fresh(part.vertices, numbers.size());
  tbb::parallel_for(std::size_t{0}, numbers.size(), [&](std::size_t n) {
    number_in_part[numbers[n]] = static_cast<std::uint32_t>(n);
    part.vertices[n] = mesh.vertices[numbers[n]];
  });
  resize_fresh(part.triangles, faces.size());
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t n) {
    const auto& [a, b, c] = mesh.triangles[faces[n]];
    part.triangles[n] = {number_in_part[a], number_in_part[b], number_in_part[c]};
  });
  return part;
}

}  // namespace

ChangedRegion::ChangedRegion(const MovingMesh& mesh, const Monitor& monitor)
    : mesh_(mesh), faces_(faces_to_search(mesh)) {
  monitor.check();
  is_all_ = 2 * mesh.changed().size() > mesh.mesh().triangles.size() || faces_.size() == mesh.mesh().triangles.size();
  part_ = part_of(mesh.mesh(), faces_, vertices_);
  const std::vector<std::uint32_t> first = strata::equal_vertices(part_.vertices);
  for (const std::uint32_t v : collect(first.size(), [&](std::uint32_t v) { return first[v] != v; }))
    equal_.emplace_back(vertices_[v], vertices_[first[v]]);
  if (equal_.empty()) return;
  tbb::parallel_for(std::size_t{0}, faces_.size(), [&](std::size_t n) {
    for (std::uint32_t& v : part_.triangles[n]) v = first[v];
  });
  leave_out_collapsed();
}

void ChangedRegion::leave_out_collapsed() {
  const std::vector<std::uint32_t> collapsed =
      collect(faces_.size(), [&](std::uint32_t n) { return repeats_vertex(part_.triangles[n]); });
  if (collapsed.empty()) return;
  collapsed_at_.resize(part_.vertices.size(), false);
  for (const std::uint32_t n : collapsed)
    for (const std::uint32_t v : part_.triangles[n]) collapsed_at_[v] = true;
  std::size_t kept = collapsed.front();
  for (std::size_t n = kept; n < faces_.size(); ++n) {
    if (repeats_vertex(part_.triangles[n])) continue;
    part_.triangles[kept] = part_.triangles[n];
    faces_[kept++] = faces_[n];
  }
  part_.triangles.resize(kept);
  faces_.resize(kept);
}

std::vector<std::uint32_t> ChangedRegion::wrong_faces(const Monitor& monitor, std::size_t enough) {
  const InputComplex complex = complex_of(part_);
  if (is_all())
    stars_.emplace(complex, monitor);
  else if (mesh_.stars())
    stars_.emplace(known_stars(*mesh_.stars()));
  const EmbeddedStars* const stars = stars_ ? &*stars_ : nullptr;
  const ZeroAreaTest has_no_area(part_);
  const std::vector<std::uint32_t> flat = collect(faces_.size(), [&](std::uint32_t f) {
    const auto [a, b, c] = part_.triangles[f];  // each face of an embedded star is seen from one side
    return (stars == nullptr || !(stars->at(a) || stars->at(b) || stars->at(c))) && has_no_area(f);
  });
  has_area_everywhere_ = flat.empty() && !has_collapsed();
  std::vector<std::uint32_t> wrong = flat;
  if (flat.empty()) {
    for (const auto& s : find_self_intersections(complex, stars, monitor, enough)) pairs_.emplace_back(s.face, s.other);
  } else {
    const std::vector<std::uint32_t> sound =
        collect(faces_.size(), [&](std::uint32_t f) { return !std::binary_search(flat.begin(), flat.end(), f); });
    std::vector<Triangle> triangles;
    for (const std::uint32_t f : sound) triangles.push_back(part_.triangles[f]);
    for (const auto& s :
         find_self_intersections(complex_of(MeshView(part_.vertices, triangles)), stars, monitor, enough))
      pairs_.emplace_back(sound[s.face], sound[s.other]);
  }
  is_complete_ = pairs_.size() < enough;
  for (auto& [f, g] : pairs_) {
    wrong.insert(wrong.end(), {f, g});
    f = faces_[f];
    g = faces_[g];
  }
  std::sort(wrong.begin(), wrong.end());
  wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
  for (std::uint32_t& f : wrong) f = faces_[f];
  return wrong;
}

/// Of the region's part of the mesh, whose stars these are. Of vertices in one place, all must be embedded.
EmbeddedStars ChangedRegion::known_stars(const EmbeddedStars& of_mesh) const {
  EmbeddedStars known = of_mesh.of_part(vertices_);
  for (const auto& [vertex, first] : equal_)
    if (!of_mesh.at(vertex))
      known.forget(
          static_cast<std::uint32_t>(std::lower_bound(vertices_.begin(), vertices_.end(), first) - vertices_.begin()));
  return known;
}

FacePatches ChangedRegion::patches(std::span<const std::uint32_t> wrong) const {
  const auto contains = [](std::span<const std::uint32_t> sorted, std::uint32_t face) {
    return std::binary_search(sorted.begin(), sorted.end(), face);
  };
  std::vector<bool> is_changed(faces_.size()), is_wrong(faces_.size());
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    is_changed[f] = contains(mesh_.changed(), faces_[f]);
    is_wrong[f] = contains(wrong, faces_[f]);
  }
  const auto had_collapsed = [&](const EdgeUse& use) {
    return has_collapsed() && (collapsed_at_[use.low] || collapsed_at_[use.high]);
  };
  const auto is_lost = [&](const EdgeUse& use) {
    return mesh_.lost_sides().contains({vertices_[use.low], vertices_[use.high]});
  };
  DisjointSets<std::uint32_t> sets(faces_.size());
  std::vector<std::uint32_t> beside_known;  // faces with a side that a face outside the region has, too
  for_each_edge(edge_table(part_.triangles, part_.vertices.size()), [&](std::span<const EdgeUse> uses) {
    const bool changed = had_collapsed(uses[0]) || std::any_of(uses.begin(), uses.end(), [&](const EdgeUse& u) {
                           return is_changed[u.triangle];
                         });
    if (changed ? uses.size() != 2 || net_uses(uses) != 0 : is_lost(uses[0])) return;
    std::optional<std::uint32_t> first;
    for (const EdgeUse& use : uses) {
      if (is_wrong[use.triangle]) continue;
      if (first) sets.unite(*first, use.triangle);
      first = use.triangle;
    }
    if (first && net_uses(uses) != 0) beside_known.push_back(*first);
  });

  FacePatches result;
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(faces_.size(), none);  // of sets, by their representatives
  std::uint32_t count = 0;
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    if (is_wrong[f]) continue;
    std::uint32_t& patch = number[sets.find(f)];
    if (patch == none) patch = count++;
    result.faces.push_back(faces_[f]);
    result.patch.push_back(patch);
  }
  result.is_known.resize(count, false);
  for (const std::uint32_t f : beside_known) result.is_known[number[sets.find(f)]] = true;
  return result;
}

bool ChangedRegion::keeps_windings() const {
  if (!mesh_.swept()) return false;
  const std::vector<bool> is_known = patches({}).is_known;
  return std::all_of(is_known.begin(), is_known.end(), [](bool known) { return known; });
}

}  // namespace strata
