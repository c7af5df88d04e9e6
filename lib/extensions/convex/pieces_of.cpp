#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "extensions/convex/piece_surface.h"
#include "strata/carry_attributes.h"
#include "strata/convex.h"

namespace strata::convex {
namespace {

constexpr std::uint32_t of_solid = 0, of_walls = 1;  // operands of sources

/// The polygons that bound each piece: parts of the solid's boundary, then walls.
std::vector<std::vector<PiecePolygon>> polygons_by_piece(const Decomposition& d) {
  std::vector<std::vector<PiecePolygon>> polygons(d.pieces.size());
  for (const BoundaryPart& part : d.boundary) polygons[part.piece].push_back({part.polygon, {of_solid, part.triangle}});
  for (std::uint32_t w = 0; w < d.walls.size(); ++w) {
    const Wall& wall = d.walls[w];
    const Source source{of_walls, w};
    polygons[wall.pieces[0]].push_back({wall.polygon, source});
    polygons[wall.pieces[1]].push_back({{wall.polygon.rbegin(), wall.polygon.rend()}, source});
  }
  return polygons;
}

/// The surfaces of all pieces over the points of the decomposition.
struct AllPieces {
  ExactMesh mesh;
  std::vector<Source> sources;
  std::vector<std::size_t> ends;  ///< of every piece in the triangles
};

AllPieces all_pieces(const Decomposition& d, const Monitor& monitor) {
  AllPieces all;
  all.mesh.mesh.vertices = d.points;
  all.mesh.exact = d.exact();
  for (const std::vector<PiecePolygon>& polygons : polygons_by_piece(d)) {
    monitor.check();
    PieceSurface surface = piece_surface(all.mesh, polygons);
    all.mesh.mesh.triangles.insert(all.mesh.mesh.triangles.end(), surface.triangles.begin(), surface.triangles.end());
    all.sources.insert(all.sources.end(), surface.sources.begin(), surface.sources.end());
    all.ends.push_back(all.sources.size());
  }
  return all;
}

/// The attributes of all pieces. Walls are the second operand of an intersection, one that has no attributes: their
/// triangles are their own faces.
Attributes carried(const Solid& solid, const AllPieces& all, const Options& options) {
  std::vector<Source> sources = all.sources;
  for (std::uint32_t t = 0; t < sources.size(); ++t)
    if (sources[t].operand == of_walls) sources[t].face = t;
  const std::array operands{AttributedMesh{solid.exact_mesh(), &solid.attributes()}, AttributedMesh{all.mesh}};
  return carry_attributes(operands, all.mesh, sources, options, CutFaces::of_later_operands);
}

/// Some of the triangles, with the vertices that they use. `number`: memory for numbers of vertices.
Solid piece_of(const AllPieces& all, const Attributes& attributes, std::size_t first, std::size_t last,
               std::vector<std::uint32_t>& number) {
  const Mesh& mesh = all.mesh.mesh;
  std::vector<std::uint32_t> used, faces(last - first);
  std::iota(faces.begin(), faces.end(), static_cast<std::uint32_t>(first));
  for (const std::uint32_t t : faces) used.insert(used.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  ExactMesh piece;
  auto exact = all.mesh.exact.begin();
  for (const std::uint32_t v : used) {
    number[v] = static_cast<std::uint32_t>(piece.mesh.vertices.size());
    piece.mesh.vertices.push_back(mesh.vertices[v]);
    exact = std::lower_bound(exact, all.mesh.exact.end(), v,
                             [](const ExactVertex& e, std::uint32_t w) { return e.vertex < w; });
    if (exact != all.mesh.exact.end() && exact->vertex == v) piece.exact.push_back({number[v], exact->position});
  }
  for (const std::uint32_t t : faces) {
    const auto [a, b, c] = mesh.triangles[t];
    piece.mesh.triangles.push_back({number[a], number[b], number[c]});
  }
  const auto begin = all.sources.begin();
  return Solid::trusted(std::move(piece), {begin + static_cast<std::ptrdiff_t>(first),  //
                                           begin + static_cast<std::ptrdiff_t>(last)})
      .with_attributes(part_of(attributes, faces, used));
}

}  // namespace

std::vector<Solid> pieces_of(const Solid& solid, const Decomposition& decomposition, const Options& options) {
  if (decomposition.pieces.empty()) return {};
  const AllPieces all = all_pieces(decomposition, Monitor(options.cancel));
  const Attributes attributes = carried(solid, all, options);
  std::vector<std::uint32_t> number(decomposition.points.size());
  std::vector<Solid> pieces;
  std::size_t first = 0;
  for (const std::size_t last : all.ends) {
    pieces.push_back(piece_of(all, attributes, first, last, number));
    first = last;
  }
  return pieces;
}

}  // namespace strata::convex
