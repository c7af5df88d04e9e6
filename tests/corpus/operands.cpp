#include "corpus/operands.h"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "corpus/corpus.h"
#include "support/transform.h"

namespace strata::test {
namespace {

using Columns = std::array<Vertex, 4>;

Columns columns_of(const std::string& text) {
  Columns columns{};
  std::istringstream numbers(text);
  for (Vertex& column : columns) numbers >> column[0] >> column[1] >> column[2];
  return columns;
}

double determinant(const Columns& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) + m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Mesh mapped(Mesh mesh, const Columns& m) {
  for (Vertex& v : mesh.vertices) {
    const Vertex p = v;
    for (int k = 0; k < 3; ++k) v[k] = m[0][k] * p[0] + m[1][k] * p[1] + m[2][k] * p[2] + m[3][k];
  }
  return determinant(m) < 0 ? reversed(std::move(mesh)) : mesh;
}

double extent(const Mesh& mesh) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Vertex& v : mesh.vertices) {
    low = std::min(low, v[0]);
    high = std::max(high, v[0]);
  }
  return high - low;
}

Vertex centre(const Mesh& mesh) {
  Vertex sum{};
  for (const Vertex& v : mesh.vertices) {
    for (int k = 0; k < 3; ++k) sum[k] += v[k] / static_cast<double>(mesh.vertices.size());
  }
  return sum;
}

}  // namespace

MeshPair ember_pair(const std::filesystem::path& root, const std::string& number) {
  const std::string folder = "csg/manifold/extras/ember_tests/testfiles/raw_meshes/";
  for (const Row& row : read_csv(root / "expected/ember_cases.csv")) {
    if (row.at("case") != number) continue;
    return {mapped(load(root, folder + row.at("id_a") + ".stl"), columns_of(row.at("T_a(col-major 4x3: c0 c1 c2 c3)"))),
            mapped(load(root, folder + row.at("id_b") + ".stl"), columns_of(row.at("T_b")))};
  }
  throw std::invalid_argument("no case " + number);
}

Mesh rotated_copy(const Mesh& mesh) {
  const Vertex c = centre(mesh);
  const double step = extent(mesh) / 16;
  Mesh copy = mesh;
  for (Vertex& v : copy.vertices) {
    const double x = v[0] - c[0];
    const double y = v[1] - c[1];
    const double z = v[2] - c[2];
    const Vertex about_z{0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y, z};
    v = {c[0] + about_z[0] + step, c[1] + 0.8 * about_z[1] - 0.6 * about_z[2],
         c[2] + 0.6 * about_z[1] + 0.8 * about_z[2]};
  }
  return copy;
}

}  // namespace strata::test
