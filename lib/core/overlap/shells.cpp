#include "core/overlap/shells.h"

#include <span>

#include "core/kernel/disjoint_sets.h"
#include "core/mesh/edge_table.h"

namespace strata {
namespace {

constexpr std::uint32_t no_face = 0xffffffffu;

/// Faces with an edge both of whose ends are not in embedded stars. All faces of such an edge are among them.
struct Rest {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> faces;
};

/// Around an embedded star, faces are connected across edges that two of them have.
Rest connect_stars(std::span<const Triangle> faces, std::size_t vertex_count, const EmbeddedStars& stars,
                   const std::vector<bool>& crossing, DisjointSets<std::uint32_t>& sets) {
  Rest rest;
  std::vector<std::uint32_t> first_face(vertex_count, no_face);
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    std::size_t embedded = 0;
    for (const std::uint32_t v : faces[f]) {
      if (!stars.at(v)) continue;
      ++embedded;
      if (!crossing.empty() && crossing[f]) continue;
      if (first_face[v] == no_face)
        first_face[v] = f;
      else
        sets.unite(first_face[v], f);
    }
    if (embedded > 1) continue;
    rest.triangles.push_back(faces[f]);
    rest.faces.push_back(f);
  }
  return rest;
}

}  // namespace

Shells find_patches(const InputComplex& input, const EmbeddedStars& stars, const std::vector<bool>& crossing) {
  const auto faces = input.faces(0);
  const auto crosses = [&](std::uint32_t f) { return !crossing.empty() && crossing[f]; };
  DisjointSets<std::uint32_t> sets(faces.size());
  const Rest rest = connect_stars(faces, input.points(0).size(), stars, crossing, sets);
  Shells result;
  for_each_edge(edge_table(rest.triangles, input.points(0).size()), [&](std::span<const EdgeUse> uses) {
    result.share_edges = result.share_edges || uses.size() > 2;
    if (uses.size() != 2) return;
    const std::uint32_t f = rest.faces[uses[0].triangle], g = rest.faces[uses[1].triangle];
    if (!crosses(f) && !crosses(g)) sets.unite(f, g);
  });
  result.of_face.resize(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const std::uint32_t first = sets.find(f);
    result.of_face[f] = first == f ? result.count++ : result.of_face[first];
  }
  return result;
}

Shells find_shells(const InputComplex& input, const EmbeddedStars& stars) { return find_patches(input, stars, {}); }

}  // namespace strata
