#include "strata/transform.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace strata {
namespace {

constexpr std::array<std::size_t, 3> axes{0, 1, 2};

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
  for (const std::size_t i : axes) q[i] = rows_[i][0] * p[0] + rows_[i][1] * p[1] + rows_[i][2] * p[2] + rows_[i][3];
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
  ExactMesh image = mesh;
  if (map.is_identity()) return image;
  const std::size_t count = mesh.mesh.vertices.size();
  std::vector<std::optional<RationalPoint>> exact(count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const auto& range) {
    monitor.check();
    for (std::size_t v = range.begin(); v != range.end(); ++v) {
      RationalPoint p = map(mesh.position(static_cast<std::uint32_t>(v)));
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
  image.exact.clear();
  for (std::size_t v = 0; v < count; ++v)
    if (exact[v]) image.exact.push_back({static_cast<std::uint32_t>(v), std::move(*exact[v])});
  if (map.determinant() < 0)
    for (Triangle& t : image.mesh.triangles) std::swap(t[1], t[2]);
  return image;
}

}  // namespace strata
