#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/mesh/prepare.h"
#include "extensions/bsp/triangle_facets.h"
#include "extensions/convex/wedges.h"
#include "strata/bsp.h"
#include "strata/convex.h"
#include "strata/measure.h"

namespace strata::convex {
namespace {

/// The boundary of the complement of a solid: triangles with opposite orientation.
ExactMesh reversed(const ExactMesh& mesh) {
  ExactMesh result = mesh;
  for (Triangle& t : result.mesh.triangles) std::swap(t[1], t[2]);
  return result;
}

/// Some triangles of a mesh, with the vertices that they use.
ExactMesh part_of(const ExactMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  std::map<std::uint32_t, std::uint32_t> number;
  for (const std::uint32_t t : triangles)
    for (const std::uint32_t v : mesh.mesh.triangles[t]) number.emplace(v, 0);
  ExactMesh part;
  auto rational = mesh.exact.begin();
  for (auto& [v, n] : number) {
    n = static_cast<std::uint32_t>(part.mesh.vertices.size());
    part.mesh.vertices.push_back(mesh.mesh.vertices[v]);
    rational = std::lower_bound(rational, mesh.exact.end(), v,
                                [](const ExactVertex& e, std::uint32_t w) { return e.vertex < w; });
    if (rational != mesh.exact.end() && rational->vertex == v) part.exact.push_back({n, rational->position});
  }
  for (const std::uint32_t t : triangles) {
    const auto [a, b, c] = mesh.mesh.triangles[t];
    part.mesh.triangles.push_back({number.at(a), number.at(b), number.at(c)});
  }
  return part;
}

/// A connected component of the boundary as seen from outside the solid, as triangles of the mesh with opposite
/// orientation.
struct OuterShell {
  std::vector<std::uint32_t> triangles;
  ExactMesh mesh;
  bool is_cavity = false;  ///< it encloses the region on its outer side
  std::uint32_t volume = 0;
};

/// Triangles connected through the complement of the solid, in the order of their first ones.
std::vector<OuterShell> outer_shells(const ExactMesh& outside) {
  HyperplaneTable<3> table;
  const std::vector<bsp::Facet<3>> facets = bsp::triangle_facets(table, outside);
  std::vector<std::uint32_t> parent(facets.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::uint32_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  for (const Wedge& w : wedges_of(table, facets, outside)) parent[root(w.faces[0])] = root(w.faces[1]);
  std::map<std::uint32_t, std::size_t> number;
  std::vector<OuterShell> shells;
  for (std::uint32_t t = 0; t < facets.size(); ++t) {
    const auto [at, is_new] = number.try_emplace(root(t), shells.size());
    if (is_new) shells.emplace_back();
    shells[at->second].triangles.push_back(t);
  }
  for (OuterShell& shell : shells) {
    shell.mesh = part_of(outside, shell.triangles);
    shell.is_cavity = orientation(shell.mesh) == Sign::positive;
  }
  return shells;
}

/// A point inside a triangle: no other triangle of a solid's boundary contains it.
RationalPoint middle(const ExactMesh& mesh, const Triangle& t) {
  const RationalPoint a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
  RationalPoint p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = (a[i] + b[i] + c[i]) / 3;
  return p;
}

/// Numbers the volumes outside the solid: cavities from 1 on. A shell that encloses no cavity belongs to the innermost
/// cavity around it, or to the outside. Returns the number of volumes.
std::uint32_t assign_volumes(std::vector<OuterShell>& shells) {
  std::vector<const OuterShell*> cavities;
  for (OuterShell& shell : shells)
    if (shell.is_cavity) {
      cavities.push_back(&shell);
      shell.volume = static_cast<std::uint32_t>(cavities.size());
    }
  if (cavities.empty() || cavities.size() == shells.size()) return static_cast<std::uint32_t>(cavities.size()) + 1;
  // Cavities around a point are nested: the innermost is the smallest.
  std::vector<std::pair<Rational, std::size_t>> by_size;
  std::vector<bsp::Partition<3>> regions;
  for (std::size_t k = 0; k < cavities.size(); ++k) {
    by_size.emplace_back(volume(cavities[k]->mesh), k);
    regions.push_back(bsp::partition_of(cavities[k]->mesh));
  }
  std::sort(by_size.begin(), by_size.end());
  for (OuterShell& shell : shells) {
    if (shell.is_cavity) continue;
    const RationalPoint p = middle(shell.mesh, shell.mesh.mesh.triangles.front());
    const auto around = std::find_if(by_size.begin(), by_size.end(), [&](const auto& cavity) {
      return regions[cavity.second].classify_exact(p) == Where::in;
    });
    shell.volume = around == by_size.end() ? 0 : cavities[around->second]->volume;
  }
  return static_cast<std::uint32_t>(cavities.size()) + 1;
}

void add_interfaces(VolumeComplex& complex, const Decomposition& d, const std::vector<std::uint32_t>& outside_of) {
  const std::uint32_t first = complex.first_piece;
  for (const Wall& wall : d.walls)
    complex.interfaces.push_back({{first + wall.pieces[0], first + wall.pieces[1]}, wall.polygon});
  for (const BoundaryPart& part : d.boundary)
    complex.interfaces.push_back({{first + part.piece, outside_of[part.triangle]}, part.polygon});
}

/// Outer volumes have the shells that were found; pieces have one each.
void add_shells(VolumeComplex& complex, const Decomposition& d, const std::vector<OuterShell>& shells) {
  std::vector<std::pair<std::uint32_t, std::size_t>> shell_of(d.boundary.empty() ? 0 : d.boundary.back().triangle + 1);
  for (const bool is_cavity : {true, false})  // the enclosing shell of a cavity is first
    for (const OuterShell& shell : shells) {
      if (shell.is_cavity != is_cavity) continue;
      Volume& volume = complex.volumes[shell.volume];
      for (const std::uint32_t t : shell.triangles) shell_of[t] = {shell.volume, volume.shells.size()};
      volume.shells.emplace_back();
    }
  for (std::uint32_t v = complex.first_piece; v < complex.volumes.size(); ++v) complex.volumes[v].shells.emplace_back();
  for (std::uint32_t i = 0; i < complex.interfaces.size(); ++i) {
    for (const std::uint32_t v : complex.interfaces[i].volumes)
      if (v >= complex.first_piece) complex.volumes[v].shells.front().push_back(i);
    if (i < d.walls.size()) continue;
    const auto [volume, shell] = shell_of[d.boundary[i - d.walls.size()].triangle];
    complex.volumes[volume].shells[shell].push_back(i);
  }
}

void add_neighbours(VolumeComplex& complex) {
  for (const Interface& face : complex.interfaces) {
    const auto [a, b] = face.volumes;
    complex.volumes[a].neighbours.push_back(b);
    complex.volumes[b].neighbours.push_back(a);
  }
  for (Volume& volume : complex.volumes) {
    std::vector<std::uint32_t>& list = volume.neighbours;
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
}

}  // namespace

VolumeComplex volumes_of(const Solid& solid, const Decomposition& decomposition) {
  VolumeComplex complex;
  complex.points = decomposition.points;
  complex.exact = decomposition.exact();
  std::vector<OuterShell> shells = outer_shells(reversed(solid.exact_mesh()));
  complex.first_piece = assign_volumes(shells);
  complex.volumes.resize(complex.first_piece + decomposition.pieces.size());
  for (std::uint32_t v = 1; v < complex.volumes.size(); ++v)
    complex.volumes[v].mark = v < complex.first_piece ? Mark::cavity : Mark::piece;
  std::vector<std::uint32_t> outside_of(solid.mesh().triangles.size());
  for (const OuterShell& shell : shells)
    for (const std::uint32_t t : shell.triangles) outside_of[t] = shell.volume;
  add_interfaces(complex, decomposition, outside_of);
  add_shells(complex, decomposition, shells);
  add_neighbours(complex);
  return complex;
}

}  // namespace strata::convex
