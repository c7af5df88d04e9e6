#include "core/io/ply_numbers.h"

#include <algorithm>
#include <cmath>

#include "core/io/binary.h"

namespace strata::io {
namespace {

/// One coordinate of points that are `stride` bytes apart.
struct Column {
  const char* first;
  std::size_t stride;
  std::endian order;

  template <class T>
  void copy(std::span<Vertex> points, std::size_t axis) const {
    const char* at = first;
    for (Vertex& p : points) {
      p[axis] = static_cast<double>(load<T>(at, order));
      at += stride;
    }
  }
  void copy(PlyScalar type, std::span<Vertex> points, std::size_t axis) const {
    switch (type) {
      case PlyScalar::int8:
        return copy<std::int8_t>(points, axis);
      case PlyScalar::uint8:
        return copy<std::uint8_t>(points, axis);
      case PlyScalar::int16:
        return copy<std::int16_t>(points, axis);
      case PlyScalar::uint16:
        return copy<std::uint16_t>(points, axis);
      case PlyScalar::int32:
        return copy<std::int32_t>(points, axis);
      case PlyScalar::uint32:
        return copy<std::uint32_t>(points, axis);
      case PlyScalar::float32:
        return copy<float>(points, axis);
      case PlyScalar::float64:
        return copy<double>(points, axis);
    }
  }
};

/// NaN when any is not finite.
bool all_finite(std::span<const Vertex> points) {
  double differences = 0;
  for (const Vertex& p : points) differences += (p[0] - p[0]) + (p[1] - p[1]) + (p[2] - p[2]);
  return !std::isnan(differences);
}

}  // namespace

bool BinaryNumbers::take_points(const PlyElementPlan& plan, std::span<Vertex> points) {
  const PlyElement& element = *plan.element;
  const std::size_t stride = element.least_size();
  if (element.has_lists() || remaining() / stride < points.size()) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t place = offset_;
    for (std::size_t i = 0; i < plan.axes[axis]; ++i) place += size_of(element.properties[i].type);
    const Column column{data_.data() + place, stride, order_};
    column.copy(element.properties[plan.axes[axis]].type, points, axis);
  }
  if (!all_finite(points)) return false;
  offset_ += points.size() * stride;
  return true;
}

std::uint64_t BinaryNumbers::take_triangles(const PlyElementPlan& plan, std::uint64_t vertex_count, std::uint64_t count,
                                            FaceList& faces) {
  constexpr std::size_t size = 1 + 3 * 4;
  if (!plan.is_usual_list) return 0;
  // Negative integers are large ones in this comparison.
  const bool is_signed = plan.element->properties[plan.list].type == PlyScalar::int32;
  const std::uint64_t limit = is_signed ? std::min(vertex_count, std::uint64_t{1} << 31) : vertex_count;
  const std::uint64_t most = std::min<std::uint64_t>(count, remaining() / size);
  const char* bytes = data_.data() + offset_;
  std::uint64_t taken = 0;
  for (; taken < most && bytes[0] == 3; ++taken, bytes += size) {
    const auto corner = [&](std::size_t k) { return load<std::uint32_t>(bytes + 1 + 4 * k, order_); };
    const Triangle t{corner(0), corner(1), corner(2)};
    if (std::max({t[0], t[1], t[2]}) >= limit) break;
    faces.add(t);
  }
  offset_ += taken * size;
  return taken;
}

}  // namespace strata::io
