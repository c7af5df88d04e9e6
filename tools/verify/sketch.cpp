#include "verify/sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "common/view.h"

namespace verify {
namespace {

using strata::Mesh;
using strata::Triangle;
using strata::Vertex;

constexpr std::size_t most_triangles = 120;
constexpr int width = 150, shades = 10;
constexpr double scale = width / 1.8;  // the unit cube in this direction is not quite as large
constexpr Vertex looking{-2, 3, -2};

Vertex minus(const Vertex& a, const Vertex& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Vertex& a, const Vertex& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vertex unit_normal(const Vertex& a, const Vertex& b, const Vertex& c) {
  const Vertex u = minus(b, a), v = minus(c, a);
  const Vertex n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(dot(n, n));
  return length > 0 ? Vertex{n[0] / length, n[1] / length, n[2] / length} : Vertex{};
}

/// The mesh in the cube of size 1, so that no scale is too large or too small to draw.
Mesh moderate(Mesh mesh) {
  Vertex lower = mesh.vertices.at(mesh.triangles[0][0]), upper = lower;
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t)
      for (std::size_t i = 0; i < 3; ++i) {
        lower[i] = std::min(lower[i], mesh.vertices[v][i]);
        upper[i] = std::max(upper[i], mesh.vertices[v][i]);
      }
  const double size = std::max({upper[0] / 2 - lower[0] / 2, upper[1] / 2 - lower[1] / 2, upper[2] / 2 - lower[2] / 2});
  for (Vertex& v : mesh.vertices)
    for (std::size_t i = 0; i < 3; ++i) v[i] = size > 0 ? (v[i] / 2 - lower[i] / 2) / size : 0;
  return mesh;
}

struct Face {
  double depth;
  Triangle corners;
  Vertex normal;
};

/// Faces towards the viewer, the farthest first.
std::vector<Face> seen_faces(const Mesh& mesh) {
  std::vector<Face> faces;
  for (const Triangle& t : mesh.triangles) {
    const Vertex &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Vertex normal = unit_normal(a, b, c);
    if (dot(normal, looking) < 0) faces.push_back({dot(a, looking) + dot(b, looking) + dot(c, looking), t, normal});
  }
  std::stable_sort(faces.begin(), faces.end(), [](const Face& f, const Face& g) { return f.depth > g.depth; });
  return faces;
}

using Side = std::pair<Vertex, Vertex>;

/// How many faces of each plane have a side; by places, since meshes may list vertices twice.
std::map<Side, std::vector<Vertex>> normals_at_sides(const Mesh& mesh) {
  std::map<Side, std::vector<Vertex>> normals;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex &a = mesh.vertices[t[i]], &b = mesh.vertices[t[(i + 1) % 3]];
      normals[std::minmax(a, b)].push_back(unit_normal(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]));
    }
  return normals;
}

bool is_flat(const std::vector<Vertex>& normals) { return normals.size() == 2 && dot(normals[0], normals[1]) > .99; }

std::string instead(const std::string& text) {
  return fmt::format("<svg width=\"{0}\" height=\"40\"><text x=\"4\" y=\"24\" font-size=\"12\">{1}</text></svg>", width,
                     text);
}

/// A path over integers, of a class that the style sheet knows.
void append_path(std::string& svg, const std::string& look, const PaperPath& corners, const char* end) {
  svg += fmt::format("<path class=\"{}\" d=\"M", look);
  for (const PaperPoint& p : corners)
    fmt::format_to(std::back_inserter(svg), "{} {} ", std::lround(p[0] * scale + width / 2),
                   std::lround(p[1] * scale + width / 2));
  svg.back() = end[0];
  svg += end + 1;
}

}  // namespace

std::string sketch_style() {
  std::string css = "path.e{fill:none;stroke:#222;stroke-linecap:round}";
  for (int shade = 0; shade < shades; ++shade) {
    const int light = 60 + 190 * shade / (shades - 1);
    css += fmt::format("path.s{0}{{fill:#{1:02x}{1:02x}{2:02x}}}", shade, light, std::min(light + 6, 255));
  }
  return css;
}

std::string sketch(const Mesh& given) {
  if (given.triangles.empty()) return instead("nothing");
  if (given.triangles.size() > most_triangles) return instead(fmt::format("{} triangles", given.triangles.size()));
  const Mesh mesh = moderate(given);
  const View view(strata::Origin::direction(looking), {.5, .5, .5}, {0, 0, 1});
  const auto normals = normals_at_sides(mesh);
  std::string svg = fmt::format("<svg width=\"{0}\" height=\"{0}\">", width);
  for (const Face& face : seen_faces(mesh)) {
    std::vector<Vertex> corners;
    for (const std::uint32_t v : face.corners) corners.push_back(mesh.vertices[v]);
    const auto shade = std::lround(view.brightness(face.normal) * (shades - 1));
    append_path(svg, fmt::format("s{}", shade), view.polygon(corners), "z\"/>");
    for (std::size_t i = 0; i < 3; ++i)
      if (!is_flat(normals.at(std::minmax(corners[i], corners[(i + 1) % 3]))))
        append_path(svg, "e", view.segment(corners[i], corners[(i + 1) % 3]), "\"/>");
  }
  return svg + "</svg>";
}

}  // namespace verify
