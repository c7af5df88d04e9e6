#include "core/cells/apart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace strata {
namespace {

using Coordinates = InputComplex::Coordinates;

/// Some faces of one operand.
class OperandFaces {
 public:
  OperandFaces(const InputComplex& input, std::uint32_t operand, std::span<const std::uint32_t> faces)
      : points_(input.points(operand)),
        triangles_(input.faces(operand)),
        first_(input.first_face(operand)),
        faces_(faces) {}

  /// The sum of their normals, each as long as twice the area.
  [[nodiscard]] Coordinates area_vector() const {
    Coordinates sum{};
    for (const std::uint32_t f : faces_) {
      const auto& [ia, ib, ic] = triangles_[f - first_];
      const Coordinates &a = points_[ia], &b = points_[ib], &c = points_[ic];
      const Coordinates u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
      sum[0] += u[1] * v[2] - u[2] * v[1];
      sum[1] += u[2] * v[0] - u[0] * v[2];
      sum[2] += u[0] * v[1] - u[1] * v[0];
    }
    return sum;
  }

  template <class Visit>
  void for_each_corner(const Visit& visit) const {
    for (const std::uint32_t f : faces_)
      for (const std::uint32_t v : triangles_[f - first_]) visit(points_[v]);
  }

 private:
  std::span<const Coordinates> points_;
  std::span<const InputComplex::Indices> triangles_;
  std::uint32_t first_;
  std::span<const std::uint32_t> faces_;
};

/// The extent of faces along a direction, and the largest magnitude of their coordinates.
struct Extent {
  Extent(const OperandFaces& faces, const Coordinates& direction) {
    faces.for_each_corner([&](const Coordinates& p) {
      const double along = direction[0] * p[0] + direction[1] * p[1] + direction[2] * p[2];
      lower = std::min(lower, along);
      upper = std::max(upper, along);
      for (std::size_t i = 0; i < 3; ++i) largest[i] = std::max(largest[i], std::abs(p[i]));
    });
  }
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  Coordinates largest{};  ///< for each coordinate: the three do not wait for each other
};

}  // namespace

bool are_apart(const InputComplex& input, std::span<const std::uint32_t> faces) {
  if (faces.empty()) return false;
  const std::uint32_t operand = input.operand_of_face(faces.front()), other = input.operand_of_face(faces.back());
  const std::uint32_t end = input.first_face(operand) + input.face_count(operand);
  const auto first = static_cast<std::size_t>(std::lower_bound(faces.begin(), faces.end(), end) - faces.begin());
  if (operand == other || input.operand_of_face(faces[first]) != other) return false;

  const OperandFaces some(input, operand, faces.first(first)), others(input, other, faces.subspan(first));
  const Coordinates direction = some.area_vector();
  const Extent a(some, direction), b(others, direction);
  double size = 0, largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    size += std::abs(direction[i]);
    largest = std::max({largest, a.largest[i], b.largest[i]});
  }
  // A product of sums has an error of 3 * 2^-53 of its terms' sizes; there are two, and coordinates have errors. No sum
  // overflows below the limit; what is not a number is not below it.
  const double bound = size * largest;
  return bound < 0x1p1000 && std::max(b.lower - a.upper, a.lower - b.upper) > 0x1p-48 * bound + 0x1p-1000;
}

}  // namespace strata
