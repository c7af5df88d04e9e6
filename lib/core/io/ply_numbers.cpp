#include "core/io/ply_numbers.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>
#include <variant>

#include "core/io/binary.h"

namespace strata::io {
namespace {

/// One property of records that are `stride` bytes apart.
struct Column {
  const char* first;
  std::size_t stride;
  std::endian order;
  std::size_t count;

  /// `place(i)` is where the value of record i goes. Doubles hold all numbers, as in load_scalar.
  template <class T, class Place>
  void copy_as(const Place& place) const {
    const char* at = first;
    for (std::size_t i = 0; i < count; ++i) {
      auto& to = place(i);
      to = static_cast<std::remove_reference_t<decltype(to)>>(static_cast<double>(load<T>(at, order)));
      at += stride;
    }
  }
  template <class Place>
  void copy(PlyScalar type, const Place& place) const {
    switch (type) {
      case PlyScalar::int8:
        return copy_as<std::int8_t>(place);
      case PlyScalar::uint8:
        return copy_as<std::uint8_t>(place);
      case PlyScalar::int16:
        return copy_as<std::int16_t>(place);
      case PlyScalar::uint16:
        return copy_as<std::uint16_t>(place);
      case PlyScalar::int32:
        return copy_as<std::int32_t>(place);
      case PlyScalar::uint32:
        return copy_as<std::uint32_t>(place);
      case PlyScalar::float32:
        return copy_as<float>(place);
      case PlyScalar::float64:
        return copy_as<double>(place);
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

bool BinaryNumbers::take_points(const PlyElementPlan& plan, PlyStore& store, std::uint64_t first, std::uint64_t count) {
  const PlyElement& element = *plan.element;
  const std::size_t stride = element.least_size();
  if (element.has_lists() || remaining() / stride < count) return false;
  const auto points = std::span(store.vertices).subspan(first, count);
  for (std::size_t i = 0; i < plan.uses.size(); ++i) {
    const PlyUse& use = plan.uses[i];
    const PlyScalar type = element.properties[i].type;
    const Column column{data_.data() + offset_ + use.offset, stride, order_, static_cast<std::size_t>(count)};
    if (use.kind == PlyUse::Kind::coordinate)
      column.copy(type, [&](std::size_t p) -> double& { return points[p][use.component]; });
    else if (use.kind == PlyUse::Kind::value)
      std::visit(
          [&](auto& values) {
            column.copy(
                type, [&](std::size_t p) -> auto& { return values[use.place(first + p)]; });
          },
          store.values[use.channel]);
  }
  if (!all_finite(points)) return false;
  offset_ += count * stride;
  return true;
}

std::uint64_t BinaryNumbers::take_triangles(const PlyElementPlan& plan, std::uint64_t vertex_count, std::uint64_t count,
                                            FaceList& faces) {
  constexpr std::size_t size = 1 + 3 * 4;
  if (!plan.is_usual_list) return 0;
  // Negative integers are large ones in this comparison.
  const bool is_signed = plan.element->properties[0].type == PlyScalar::int32;
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
