#include "strata/transform.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/exact/two_sum.h"
#include "core/kernel/rational_point.h"

namespace strata {
namespace {

constexpr std::array<std::size_t, 3> axes{0, 1, 2};

/// An affine map with integer coefficients over one denominator for each coordinate: an image takes products and sums
/// of integers, and one reduction to lowest terms.
class IntegerMap {
 public:
  explicit IntegerMap(const Transform& map) {
    for (const std::size_t i : axes) {
      const Transform::Row& row = map.rows()[i];
      denominators_[i] = 1;
      for (const Rational& x : row) denominators_[i] = lcm(denominators_[i], denominator(x));
      for (std::size_t j = 0; j < 4; ++j)
        coefficients_[i][j] = numerator(row[j]) * (denominators_[i] / denominator(row[j]));
    }
  }

  [[nodiscard]] RationalPoint operator()(const HPoint<Integer>& p) const {
    const std::array<const Integer*, 4> by{&p.x, &p.y, &p.z, &p.w};
    RationalPoint image;
    for (const std::size_t i : axes) {
      Integer sum;
      for (std::size_t j = 0; j < 4; ++j)
        if (!coefficients_[i][j].is_zero()) sum += coefficients_[i][j] * *by[j];
      image[i] = Rational(sum, denominators_[i] * p.w);
    }
    return image;
  }

 private:
  std::array<std::array<Integer, 4>, 3> coefficients_;
  std::array<Integer, 3> denominators_;
};

/// A map whose coordinates are each a coordinate or its negative, moved by a double: the images of doubles are sums.
class AxisMap {
 public:
  /// None for other maps.
  static std::optional<AxisMap> of(const Transform& map) {
    AxisMap found;
    for (const std::size_t i : axes) {
      const Transform::Row& row = map.rows()[i];
      std::size_t others = 0;
      for (const std::size_t j : axes) {
        if (row[j] == 0) continue;
        if (abs(row[j]) != 1) return std::nullopt;
        found.from_[i] = j;
        found.sign_[i] = row[j].sign();
        ++others;
      }
      found.by_[i] = to_nearest_double(row[3]);
      if (others != 1 || !std::isfinite(found.by_[i]) || to_rational(found.by_[i]) != row[3]) return std::nullopt;
    }
    return found;
  }

  /// The image, if it consists of doubles.
  [[nodiscard]] std::optional<Vertex> operator()(const Vertex& p) const {
    Vertex image;
    for (const std::size_t i : axes) {
      const WithRest sum = two_sum(sign_[i] * p[from_[i]], by_[i]);
      if (sum.rest != 0 || !std::isfinite(sum.value)) return std::nullopt;
      image[i] = sum.value;
    }
    return image;
  }

 private:
  std::array<std::size_t, 3> from_{};
  std::array<int, 3> sign_{};
  std::array<double, 3> by_{};
};

/// True if each coordinate of an image depends on one coordinate only.
bool keeps_axes(const Transform& map) {
  return std::all_of(map.rows().begin(), map.rows().end(), [](const Transform::Row& row) {
    return std::count_if(row.begin(), row.begin() + 3, [](const Rational& x) { return !x.is_zero(); }) == 1;
  });
}

void require_not_zero(const Rational& x, const char* what) {
  if (x == 0) throw std::invalid_argument(what);
}

}  // namespace

Transform::Transform() {
  for (const std::size_t i : axes) rows_[i][i] = 1;
}

Transform::Transform(std::array<Row, 3> rows) : rows_(std::move(rows)) {
  require_not_zero(determinant(), "a transform of determinant 0 flattens solids");
}

Transform Transform::from_matrix(std::span<const double, 16> m) {
  for (const double x : m)
    if (!std::isfinite(x)) throw std::invalid_argument("a coefficient of a transform is not finite");
  if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] == 0)
    throw std::invalid_argument("the last row of a transform is not 0 0 0 1");
  const Rational unit = to_rational(m[15]);
  std::array<Row, 3> rows;
  for (const std::size_t i : axes)
    for (std::size_t j = 0; j < 4; ++j) rows[i][j] = to_rational(m[4 * i + j]) / unit;
  return Transform(std::move(rows));
}

Transform Transform::translation(const RationalPoint& by) {
  Transform t;
  for (const std::size_t i : axes) t.rows_[i][3] = by[i];
  return t;
}

Transform Transform::scaling(const RationalPoint& factors) {
  std::array<Row, 3> rows;
  for (const std::size_t i : axes) rows[i][i] = factors[i];
  return Transform(std::move(rows));
}

Transform Transform::mirror(const RationalPoint& n) {
  const Rational square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  require_not_zero(square, "the normal of a mirror is zero");
  std::array<Row, 3> rows;
  for (const std::size_t i : axes)
    for (const std::size_t j : axes) rows[i][j] = Rational(i == j ? 1 : 0) - 2 * n[i] * n[j] / square;
  return Transform(std::move(rows));
}

Transform Transform::mirror(const Plane& plane) {
  Transform map = mirror(plane.normal);
  const auto& n = plane.normal;
  const Rational factor = 2 * plane.offset / (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (const std::size_t i : axes) map.rows_[i][3] = factor * n[i];
  return map;
}

Transform Transform::rotation(const Quaternion& q) {
  const Rational square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  require_not_zero(square, "the quaternion of a rotation is zero");
  const RationalPoint v{q.x, q.y, q.z};
  std::array<Row, 3> rows;
  for (const std::size_t i : axes) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    rows[i][i] = (q.w * q.w + v[i] * v[i] - v[j] * v[j] - v[k] * v[k]) / square;
    rows[i][j] = 2 * (v[i] * v[j] - q.w * v[k]) / square;
    rows[i][k] = 2 * (v[i] * v[k] + q.w * v[j]) / square;
  }
  return Transform(std::move(rows));
}

RationalPoint Transform::operator()(const RationalPoint& p) const {
  RationalPoint q;
  for (const std::size_t i : axes) {
    q[i] = rows_[i][3];
    for (const std::size_t j : axes)
      if (!rows_[i][j].is_zero()) q[i] += rows_[i][j] * p[j];
  }
  return q;
}

Rational Transform::determinant() const {
  Rational sum = 0;
  for (const std::size_t i : axes) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum += rows_[0][i] * (rows_[1][j] * rows_[2][k] - rows_[1][k] * rows_[2][j]);
  }
  return sum;
}

Transform Transform::inverse() const {
  const Rational d = determinant();
  std::array<Row, 3> rows;
  for (const std::size_t i : axes)
    for (const std::size_t j : axes) {
      // The cofactor of M_ji; cyclic indices give its sign.
      const std::size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, e = (i + 2) % 3;
      rows[i][j] = (rows_[a][c] * rows_[b][e] - rows_[a][e] * rows_[b][c]) / d;
    }
  for (const std::size_t i : axes)
    for (const std::size_t j : axes) rows[i][3] -= rows[i][j] * rows_[j][3];
  return Transform(std::move(rows));
}

Transform operator*(const Transform& a, const Transform& b) {
  Transform product;
  for (const std::size_t i : axes)
    for (std::size_t j = 0; j < 4; ++j) {
      Rational sum = j == 3 ? a.rows_[i][3] : Rational(0);
      for (const std::size_t k : axes) sum += a.rows_[i][k] * b.rows_[k][j];
      product.rows_[i][j] = sum;
    }
  return product;
}

ExactMesh transform(const ExactMesh& mesh, const Transform& map, Placement placement, const Monitor& monitor) {
  if (map.is_identity()) return mesh;
  ExactMesh image{mesh.mesh, {}};
  const std::size_t count = mesh.mesh.vertices.size();
  const std::optional<AxisMap> to_doubles = AxisMap::of(map);
  const IntegerMap in_integers(map);
  const bool is_simple = keeps_axes(map);
  std::vector<const RationalPoint*> given(count);
  for (const ExactVertex& e : mesh.exact)
    if (e.vertex < count) given[e.vertex] = &e.position;
  std::vector<std::optional<RationalPoint>> exact(count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const auto& range) {
    monitor.check();
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      const Vertex& from = mesh.mesh.vertices[v];
      if (to_doubles && given[v] == nullptr)
        if (const std::optional<Vertex> to = (*to_doubles)(from)) {
          image.mesh.vertices[v] = *to;
          continue;
        }
      RationalPoint p = is_simple             ? map(mesh.position(static_cast<std::uint32_t>(v)))
                        : given[v] != nullptr ? in_integers(homogeneous(*given[v]))
                                              : in_integers(homogeneous(from));
      bool is_rounded = false;
      for (const std::size_t i : axes) {
        const double x = to_nearest_double(p[i]);
        if (!std::isfinite(x)) throw std::overflow_error("a transformed coordinate is beyond all doubles");
        is_rounded = is_rounded || (placement == Placement::exact && to_rational(x) != p[i]);
        image.mesh.vertices[v][i] = x;
      }
      if (is_rounded) exact[v] = std::move(p);
    }
  });
  for (std::size_t v = 0; v < count; ++v)
    if (exact[v]) image.exact.push_back({static_cast<std::uint32_t>(v), std::move(*exact[v])});
  if (map.determinant() < 0)
    for (Triangle& t : image.mesh.triangles) std::swap(t[1], t[2]);
  return image;
}

}  // namespace strata
