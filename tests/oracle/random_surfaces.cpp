#include "oracle/random_surfaces.h"

#include <algorithm>
#include <utility>

#include "support/random.h"

namespace strata::oracle {
namespace {

using Polygons = std::vector<std::vector<std::uint32_t>>;

Vertex plus(const Vertex& a, const Vertex& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vertex minus(const Vertex& a, const Vertex& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Exact for small integers and halves.
double determinant(const Vertex& a, const Vertex& b, const Vertex& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

bool are_parallel(const Vertex& a, const Vertex& b) {
  return a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2] && a[0] * b[1] == a[1] * b[0];
}

/// Corner i + 2 j + 4 k is a + i u + j v + k w; outwards for a positive determinant of u, v, w.
PolygonSurface parallelepiped(const Vertex& a, const Vertex& u, const Vertex& v, const Vertex& w) {
  PolygonSurface s;
  for (unsigned n = 0; n < 8; ++n) {
    Vertex p = a;
    if (n & 1U) p = plus(p, u);
    if (n & 2U) p = plus(p, v);
    if (n & 4U) p = plus(p, w);
    s.points.push_back(p);
  }
  s.polygons = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return s;
}

class Shapes {
 public:
  explicit Shapes(std::uint64_t seed) : random_(seed), size_(2 + static_cast<int>(seed % 3)) {}

  [[nodiscard]] bool once_in(std::uint64_t n) { return random_.once_in(n); }
  [[nodiscard]] int number(int least, int most) { return random_.between(least, most); }

  /// The next surface, often with corners of the ones before.
  PolygonSurface next() {
    PolygonSurface s = shape();
    pool_.insert(pool_.end(), s.points.begin(), s.points.end());
    return s;
  }
  /// A box around all that stays near the lattice, and around those of lower numbers.
  PolygonSurface around(int number) {
    const double low = -4.0 * number, width = size_ - 2 * low;
    return parallelepiped({low, low, low}, {width, 0, 0}, {0, width, 0}, {0, 0, width});
  }

 private:
  PolygonSurface shape() {
    if (!left_out_.polygons.empty() && once_in(2)) return std::exchange(left_out_, {});
    switch (random_.below(10)) {
      case 0:
        return tetrahedron();
      case 1:
        return box();
      case 2:
        return skew_box();
      case 3:
        return opened(box());
      case 4:
        return opened(skew_box());
      case 5:
        return opened(tetrahedron());
      case 6:
        return quadrilateral();
      case 7:
        return roof();
      case 8:
        return once_in(2) ? triangle() : big_sheet();
      default:
        return once_in(2) ? big_box() : big_sheet();
    }
  }

  Vertex point() {
    if (!pool_.empty() && once_in(3)) return random_.pick(pool_);
    Vertex p;
    for (double& x : p) x = random_.between(0, size_) + (once_in(12) ? 0.5 : 0);
    return p;
  }
  Vertex vector() { return minus(point(), point()); }

  PolygonSurface tetrahedron() {
    while (true) {
      const Vertex a = point(), b = point(), c = point(), d = point();
      const double volume = determinant(minus(b, a), minus(c, a), minus(d, a));
      if (volume > 0) return {{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    }
  }
  PolygonSurface box() {
    const Vertex a = point();
    Vertex d = vector();
    for (double& x : d)
      if (x <= 0) x = random_.between(1, size_);
    return parallelepiped(a, {d[0], 0, 0}, {0, d[1], 0}, {0, 0, d[2]});
  }
  PolygonSurface skew_box() {
    while (true) {
      const Vertex u = vector(), v = vector(), w = vector();
      if (determinant(u, v, w) > 0) return parallelepiped(point(), u, v, w);
    }
  }
  /// Around everything else.
  PolygonSurface big_box() {
    const double low = random_.between(-2, 0), width = size_ + random_.between(0, 2) - low;
    return parallelepiped({low, low, low}, {width, 0, 0}, {0, width, 0}, {0, 0, width});
  }
  PolygonSurface parallelogram(const Vertex& a, const Vertex& u, const Vertex& v) {
    return {{a, plus(a, u), plus(plus(a, u), v), plus(a, v)}, {{0, 1, 2, 3}}};
  }
  PolygonSurface quadrilateral() {
    while (true) {
      const Vertex u = vector(), v = vector();
      if (!are_parallel(u, v)) return parallelogram(point(), u, v);
    }
  }
  PolygonSurface triangle() {
    while (true) {
      const Vertex a = point(), b = point(), c = point();
      if (!are_parallel(minus(b, a), minus(c, a))) return {{a, b, c}, {{0, 1, 2}}};
    }
  }
  /// Two parallelograms with a common edge.
  PolygonSurface roof() {
    while (true) {
      const Vertex a = point(), u = vector(), v = vector(), w = vector();
      if (determinant(u, v, w) == 0) continue;
      const Vertex b = plus(a, u);
      return {{a, b, plus(b, v), plus(a, v), plus(a, w), plus(b, w)}, {{0, 1, 2, 3}, {1, 0, 4, 5}}};
    }
  }
  /// Across everything, in a plane across an axis or a diagonal one.
  PolygonSurface big_sheet() {
    const auto axis = static_cast<std::size_t>(random_.below(3));
    Vertex a{-1, -1, -1}, u{0, 0, 0}, v{0, 0, 0};
    a[axis] = random_.between(0, size_);
    u[(axis + 1) % 3] = v[(axis + 2) % 3] = size_ + 2;
    if (once_in(3)) u[axis] = random_.between(-size_, size_);
    return parallelogram(a, u, v);
  }
  /// Without some polygons, which may come later as a surface of their own.
  PolygonSurface opened(PolygonSurface s) {
    left_out_ = s;
    left_out_.polygons.clear();
    const int most = static_cast<int>(s.polygons.size()) - 1;
    for (int n = random_.between(1, std::min(3, most)); n > 0; --n) {
      const auto at = s.polygons.begin() + static_cast<std::ptrdiff_t>(random_.below(s.polygons.size()));
      left_out_.polygons.push_back(*at);
      s.polygons.erase(at);
    }
    return s;
  }

  test::Random random_;
  int size_;
  std::vector<Vertex> pool_;
  PolygonSurface left_out_;
};

}  // namespace

RandomScene::RandomScene(std::uint64_t seed) {
  Shapes shapes(seed);
  const int count = shapes.number(2, 4), around = shapes.once_in(5) ? shapes.number(1, count - 1) : 0;
  const bool are_outer_first = shapes.once_in(2);
  for (int n = 0; n < count; ++n) {
    first_part.push_back(parts.size());
    const int from_inside = are_outer_first ? around - n : n + 1 + around - count;
    if (from_inside > 0) {
      parts.push_back(shapes.around(from_inside));
    } else {
      for (int m = shapes.once_in(4) ? 2 : 1; m > 0; --m) parts.push_back(shapes.next());
    }
  }
  first_part.push_back(parts.size());
}

std::vector<Mesh> RandomScene::meshes() const {
  std::vector<Mesh> meshes(first_part.size() - 1);
  for (std::size_t s = 0; s < meshes.size(); ++s)
    for (std::size_t p = first_part[s]; p < first_part[s + 1]; ++p) {
      Mesh& mesh = meshes[s];
      const auto shift = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.insert(mesh.vertices.end(), parts[p].points.begin(), parts[p].points.end());
      for (const auto& polygon : parts[p].polygons)
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
          mesh.triangles.push_back({polygon[0] + shift, polygon[i] + shift, polygon[i + 1] + shift});
    }
  return meshes;
}

}  // namespace strata::oracle
