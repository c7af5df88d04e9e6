#include "layer_file.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "cell_file.h"
#include "common/binary_records.h"
#include "common/output_file.h"
#include "palette.h"
#include "strata/mesh.h"
#include "strata/query.h"
#include "strata/rational.h"

namespace {

using strata::LayerDecomposition;
using strata::Triangle;
using strata::Vertex;
Colour colour_of(std::uint32_t layer) { return layer == 0 ? grey : palette_colour(layer - 1); }

/// The pieces that are not replaced by parts, with vertices for them: those of the scene, then corners of cuts.
class PieceMesh {
 public:
  explicit PieceMesh(const LayerDecomposition& layers) : layers_(layers) {
    const strata::Scene& scene = layers.scene();
    vertices.reserve(scene.vertex_count());
    for (std::uint32_t v = 0; v < scene.vertex_count(); ++v) vertices.push_back(scene.vertex(v));
    for (std::uint32_t p = 0; p < layers.piece_count(); ++p) {
      if (layers.is_replaced(p)) continue;
      pieces.push_back(p);
      triangles.push_back(p < scene.face_count() ? scene.face(p) : triangle_of_part(p));
    }
  }

  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> pieces;  ///< per triangle

 private:
  /// Corners of the face stay what they are; others are made once per solid and place.
  Triangle triangle_of_part(std::uint32_t piece) {
    const std::uint32_t face = layers_.face_of(piece);
    const Triangle own = layers_.scene().face(face);
    const auto places = layers_.triangle(piece);
    Triangle t{};
    for (std::size_t i = 0; i < 3; ++i) {
      Vertex q;
      for (std::size_t axis = 0; axis < 3; ++axis) q[axis] = strata::to_nearest_double(places[i][axis]);
      t[i] = vertex_at(q, own, layers_.scene().solid_of(face));
    }
    return t;
  }

  std::uint32_t vertex_at(const Vertex& q, const Triangle& own, std::uint32_t solid) {
    for (const std::uint32_t v : own)
      if (vertices[v] == q) return v;
    const auto [at, is_new] = made_.try_emplace({solid, q}, static_cast<std::uint32_t>(vertices.size()));
    if (is_new) vertices.push_back(q);
    return at->second;
  }

  const LayerDecomposition& layers_;
  std::map<std::pair<std::uint32_t, Vertex>, std::uint32_t> made_;
};

std::string header_of(const PieceMesh& mesh) {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty int layer\nproperty int solid\nend_header\n",
      mesh.vertices.size(), mesh.triangles.size());
}

}  // namespace

void write_layers(const std::string& path, const LayerDecomposition& layers) {
  const PieceMesh mesh(layers);
  OutputFile file(path);
  file.write(header_of(mesh));
  write_records(file, mesh.vertices.size(), sizeof(Vertex), [&](std::size_t i, char* at) {
    for (const double x : mesh.vertices[i]) at = store(at, x);
    return at;
  });
  write_records(file, mesh.triangles.size(), 1 + 3 * 4 + 3 + 2 * 4, [&](std::size_t i, char* at) {
    const std::uint32_t piece = mesh.pieces[i];
    *at++ = '\3';
    for (const std::uint32_t v : mesh.triangles[i]) at = store(at, v);
    for (const std::uint8_t c : colour_of(layers.layer(piece))) at = store(at, c);
    at = store(at, layers.layer(piece));
    return store(at, layers.scene().solid_of(layers.face_of(piece)));
  });
  file.finish();
}

void write_layer_picture(const std::string& path, const LayerDecomposition& layers) {
  const PieceMesh mesh(layers);
  std::vector<CellPolygons> polygons(1);
  std::vector<std::vector<Colour>> colours(1);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    polygons.front().push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    colours.front().push_back(colour_of(layers.layer(mesh.pieces[i])));
  }
  write_cells(path, polygons, colours, in_place);
}
