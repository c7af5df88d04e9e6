#include "support/mesh_text.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace strata::test {
namespace {

void append(std::string& text, double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  text.append(buffer, end);
}

void read_line(Mesh& mesh, const std::string& line) {
  std::istringstream words(line);
  std::string kind;
  if (!(words >> kind)) return;
  if (kind == "v") {
    Vertex v{};
    if (words >> v[0] >> v[1] >> v[2]) return mesh.vertices.push_back(v);
  } else if (kind == "f") {
    Triangle t{};
    if (words >> t[0] >> t[1] >> t[2]) return mesh.triangles.push_back(t);
  }
  throw std::invalid_argument("no vertex and no triangle: " + line);
}

}  // namespace

std::string off_text(const Mesh& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.vertices.size()) + ' ' + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vertex& v : mesh.vertices) {
    for (int k = 0; k < 3; ++k) {
      append(text, v[k]);
      text += k < 2 ? ' ' : '\n';
    }
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    text += "3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
  }
  return text;
}

Mesh mesh_from_text(std::string_view text) {
  std::string lines(text);
  std::replace(lines.begin(), lines.end(), ';', '\n');
  std::istringstream stream(lines);
  Mesh mesh;
  for (std::string line; std::getline(stream, line);) read_line(mesh, line);
  return mesh;
}

std::string dump_off(std::string_view stem, std::initializer_list<const Mesh*> meshes) {
  std::string names;
  int number = 0;
  for (const Mesh* mesh : meshes) {
    const std::string name = std::string(stem) + '-' + std::to_string(number++) + ".off";
    std::ofstream(name) << off_text(*mesh);
    names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

}  // namespace strata::test
