#include "extensions/scene/cone_filter.h"

#include "core/exact/vector.h"

namespace strata {
namespace {

using Vector = InputComplex::Coordinates;

double length(const Vector& a) { return std::sqrt(dot(a, a)); }

/// Lengths whose products and squares neither overflow nor underflow.
bool is_moderate(double x) { return x > 0x1p-200 && x < 0x1p200; }

/// How small a value may be relative to its terms; theory.md, "Cones in floats".
constexpr double thin_edge = 0x1p-22, thin_face = 0x1p-20, grazing = 0x1p-6;

}  // namespace

ConeFilter::ConeFilter(const Vector& origin, const std::array<Vector, 3>& corners, double scale) {
  const std::array<Vector, 3> p{minus(corners[0], origin), minus(corners[1], origin), minus(corners[2], origin)};
  const Vector u = minus(corners[1], corners[0]), v = minus(corners[2], corners[0]), normal = cross(u, v);
  const double area = length(normal), far = length(p[0]), offset = dot(normal, p[0]);
  if (!is_moderate(length(u)) || !is_moderate(length(v)) || !is_moderate(far) || !is_moderate(scale)) return;
  if (!(area > thin_face * length(u) * length(v)) || !(std::abs(offset) > grazing * area * far)) return;
  std::array<std::array<float, 3>, 3> edges;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector &a = p[i], &b = p[(i + 1) % 3], n = cross(a, b);
    const double size = length(n), a_size = length(a), b_size = length(b);
    if (!is_moderate(a_size) || !is_moderate(b_size) || !(size > thin_edge * a_size * b_size)) return;
    const double factor = (offset > 0 ? 1 : -1) / size;
    for (std::size_t k = 0; k < 3; ++k) edges[i][k] = static_cast<float>(n[k] * factor);
  }
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double m = normal[k] / offset * scale;
    if (!(std::abs(m) < 0x1p100)) return;
    plane_[k] = static_cast<float>(m);
    sum += std::abs(m);
  }
  size_ = static_cast<float>(sum);
  edges_ = edges;
}

}  // namespace strata
