#include "contact_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cell_file.h"
#include "common/binary_records.h"
#include "common/output_file.h"
#include "palette.h"
#include "strata/errors.h"

namespace {

using strata::Triangle;
using strata::Vertex;
using strata::contact::Assembly;
using strata::contact::ContactFacet;
using strata::contact::ContactRegion;
using strata::contact::Relation;

constexpr Colour light_grey{200, 200, 200}, dark_grey{90, 90, 90};

std::vector<Colour> colours_of_parts(const Assembly& parts, const std::vector<PairFacts>& pairs) {
  std::vector<Colour> colours(parts.size(), light_grey);
  for (const PairFacts& p : pairs)
    if (p.pair.relation == Relation::interfering) colours[p.pair.a] = colours[p.pair.b] = dark_grey;
  return colours;
}

/// Points of a region as doubles, and its facets as triangles of them.
struct RegionMesh : strata::contact::FacetTriangles {
  std::vector<Vertex> vertices;

  explicit RegionMesh(const ContactRegion& region) : FacetTriangles(triangles_of(region)) {
    for (const strata::RationalPoint& p : region.points)
      vertices.push_back(
          {strata::to_nearest_double(p[0]), strata::to_nearest_double(p[1]), strata::to_nearest_double(p[2])});
  }
};

struct PlyFace {
  Triangle corners{};
  Colour colour{};
  std::int32_t part = -1, pair = -1;
};
struct PlyEdge {
  std::array<std::uint32_t, 2> ends{};
  Colour colour{};
  std::int32_t pair = -1;
};

struct PlyParts {
  std::vector<Vertex> vertices;
  std::vector<PlyFace> faces;
  std::vector<PlyEdge> edges;

  void add_part(const strata::Mesh& mesh, std::int32_t part, Colour colour) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const Triangle& t : mesh.triangles)
      faces.push_back({{t[0] + first, t[1] + first, t[2] + first}, colour, part, -1});
  }
  void add_region(const ContactRegion& region, std::int32_t pair, Colour colour) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    const RegionMesh mesh(region);
    vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const Triangle& t : mesh.triangles)
      faces.push_back({{t[0] + first, t[1] + first, t[2] + first}, colour, -1, pair});
    for (const auto& e : region.edges) edges.push_back({{e.ends[0] + first, e.ends[1] + first}, colour, pair});
  }
};

}  // namespace

void write_contacts(const std::string& path, const Assembly& parts, const std::vector<PairFacts>& pairs) {
  PlyParts all;
  const std::vector<Colour> colours = colours_of_parts(parts, pairs);
  for (std::uint32_t p = 0; p < parts.size(); ++p)
    all.add_part(parts.part(p).mesh(), static_cast<std::int32_t>(p), colours[p]);
  for (std::size_t n = 0; n < pairs.size(); ++n)
    all.add_region(pairs[n].region, static_cast<std::int32_t>(n), palette_colour(n));
  OutputFile file(path);
  file.write(fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty int part\nproperty int pair\nelement edge {}\n"
      "property int vertex1\nproperty int vertex2\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property int pair\nend_header\n",
      all.vertices.size(), all.faces.size(), all.edges.size()));
  write_records(file, all.vertices.size(), sizeof(Vertex), [&](std::size_t i, char* at) {
    for (const double x : all.vertices[i]) at = store(at, x);
    return at;
  });
  write_records(file, all.faces.size(), 1 + 3 * 4 + 3 + 2 * 4, [&](std::size_t i, char* at) {
    const PlyFace& face = all.faces[i];
    *at++ = '\3';
    for (const std::uint32_t v : face.corners) at = store(at, v);
    for (const std::uint8_t c : face.colour) at = store(at, c);
    at = store(at, face.part);
    return store(at, face.pair);
  });
  write_records(file, all.edges.size(), 2 * 4 + 3 + 4, [&](std::size_t i, char* at) {
    const PlyEdge& edge = all.edges[i];
    for (const std::uint32_t v : edge.ends) at = store(at, v);
    for (const std::uint8_t c : edge.colour) at = store(at, c);
    return store(at, edge.pair);
  });
  file.finish();
}

namespace {

/// How far facets of contacts are above surfaces, beside the size of everything.
constexpr double lift = 0.002;

class PictureCells {
 public:
  PictureCells(const Assembly& parts, const std::vector<Colour>& of_parts)
      : cells(parts.size()), colours(parts.size()) {
    Vertex lower{HUGE_VAL, HUGE_VAL, HUGE_VAL}, upper{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (std::uint32_t p = 0; p < parts.size(); ++p) {
      const strata::Mesh& mesh = parts.part(p).mesh();
      for (const Vertex& v : mesh.vertices)
        for (std::size_t i = 0; i < 3; ++i) {
          lower[i] = std::min(lower[i], v[i]);
          upper[i] = std::max(upper[i], v[i]);
        }
      for (const Triangle& t : mesh.triangles)
        add(p, {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}, of_parts[p]);
    }
    for (std::size_t i = 0; i < 3; ++i) size_ = std::max(size_, upper[i] - lower[i]);
  }

  void add_contact(const PairFacts& facts, Colour colour) {
    const RegionMesh mesh(facts.region);
    for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
      const Triangle& t = mesh.triangles[n];
      const ContactFacet& facet = facts.region.facets[mesh.facet_of[n]];
      const std::array<Vertex, 3> corners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
      add(facts.pair.a, lifted(corners, facet, 1), colour);
      const auto below = lifted(corners, facet, -1);
      add(facts.pair.b, {below[0], below[2], below[1]}, colour);
    }
  }

  std::vector<CellPolygons> cells;
  std::vector<std::vector<Colour>> colours;

 private:
  void add(std::uint32_t part, const std::array<Vertex, 3>& corners, Colour colour) {
    cells[part].emplace_back(corners.begin(), corners.end());
    colours[part].push_back(colour);
  }
  [[nodiscard]] std::array<Vertex, 3> lifted(std::array<Vertex, 3> corners, const ContactFacet& facet, int sign) const {
    for (Vertex& v : corners)
      for (std::size_t i = 0; i < 3; ++i)
        v[i] += sign * lift * size_ * (strata::to_nearest_double(facet.area_vector[i]) / facet.area);
    return corners;
  }
  double size_ = 0;
};

}  // namespace

void write_contact_picture(const std::string& path, const Assembly& parts, const std::vector<PairFacts>& pairs) {
  PictureCells picture(parts, colours_of_parts(parts, pairs));
  for (std::size_t n = 0; n < pairs.size(); ++n) picture.add_contact(pairs[n], palette_colour(n));
  write_cells(path, picture.cells, picture.colours, exploded);
}
