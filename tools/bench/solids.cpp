#include "solids.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace bench {
namespace {

using std::uint32_t;
using strata::Mesh;
using strata::Vertex;

/// A place on the surface of a box, counted in parts.
using Step = std::array<uint32_t, 3>;

/// Numbers the lattice points on the surface of a box as they come.
class BoxSurface {
 public:
  BoxSurface(const Vertex& lower, const Vertex& upper, uint32_t parts) : lower_(lower), upper_(upper), parts_(parts) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      add_side(axis, 0);
      add_side(axis, parts);
    }
  }

  Mesh take() { return std::move(mesh_); }

 private:
  /// The side where the coordinate `axis` is `level`; the next two axes span it and see it from above.
  void add_side(std::size_t axis, uint32_t level) {
    const auto at = [&](uint32_t i, uint32_t j) {
      Step step{};
      step[axis] = level;
      step[(axis + 1) % 3] = i;
      step[(axis + 2) % 3] = j;
      return number_of(step);
    };
    for (uint32_t i = 0; i < parts_; ++i)
      for (uint32_t j = 0; j < parts_; ++j) {
        const uint32_t a = at(i, j);
        const uint32_t b = level == 0 ? at(i, j + 1) : at(i + 1, j);
        const uint32_t c = at(i + 1, j + 1);
        const uint32_t d = level == 0 ? at(i + 1, j) : at(i, j + 1);
        mesh_.triangles.push_back({a, b, c});
        mesh_.triangles.push_back({a, c, d});
      }
  }

  uint32_t number_of(const Step& step) {
    const auto [place, is_new] = numbers_.try_emplace(step, static_cast<uint32_t>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.push_back(coordinates(step));
    return place->second;
  }

  /// Corners are the box's own doubles.
  [[nodiscard]] Vertex coordinates(const Step& step) const {
    Vertex v{};
    for (std::size_t k = 0; k < 3; ++k)
      v[k] = step[k] == parts_ ? upper_[k] : lower_[k] + (upper_[k] - lower_[k]) * step[k] / parts_;
    return v;
  }

  Vertex lower_;
  Vertex upper_;
  uint32_t parts_;
  std::map<Step, uint32_t> numbers_;
  Mesh mesh_;
};

}  // namespace

Mesh box(const Vertex& lower, const Vertex& upper) { return fine_box(lower, upper, 1); }

Mesh fine_box(const Vertex& lower, const Vertex& upper, uint32_t parts) {
  return BoxSurface(lower, upper, parts).take();
}

Mesh prism(const Prism& shape) {
  Mesh mesh;
  const uint32_t n = shape.sides;
  for (const double z : {shape.bottom, shape.top})
    for (uint32_t k = 0; k < n; ++k) {
      const double angle = shape.angle + 2 * std::numbers::pi * k / n;
      mesh.vertices.push_back({shape.radius * std::cos(angle), shape.radius * std::sin(angle), z});
    }
  for (uint32_t k = 0; k < n; ++k) {
    const uint32_t next = (k + 1) % n;
    mesh.triangles.insert(mesh.triangles.end(), {{k, next, n + next}, {k, n + next, n + k}});
  }
  for (uint32_t k = 1; k + 1 < n; ++k) {
    mesh.triangles.insert(mesh.triangles.end(), {{0, k + 1, k}, {n, n + k, n + k + 1}});
  }
  return mesh;
}

std::vector<Mesh> cube_grid(unsigned side) {
  std::vector<Mesh> cubes;
  for (unsigned i = 0; i < side; ++i)
    for (unsigned j = 0; j < side; ++j)
      for (unsigned k = 0; k < side; ++k) {
        const Vertex lower = {double(i), double(j), double(k)};
        cubes.push_back(box(lower, {lower[0] + 1, lower[1] + 1, lower[2] + 1}));
      }
  return cubes;
}

}  // namespace bench
