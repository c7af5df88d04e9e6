#include "extensions/contact/part_boxes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/containers/z_cells.h"
#include "core/containers/z_order.h"

namespace strata::contact {
Box widened(Box box) {
  for (std::size_t i = 0; i < 3; ++i) {
    box.lower[i] = std::nextafter(box.lower[i], -Box::infinity);
    box.upper[i] = std::nextafter(box.upper[i], Box::infinity);
  }
  return box;
}

Box box_of_vertex(const InputComplex& input, std::uint32_t vertex) {
  Box box;
  box.include(input.vertex(vertex));
  return input.has_doubles(vertex) ? box : widened(box);
}

namespace {

/// By the sums of their corners. Eighths of coordinates do not overflow when added.
FreshArray<PlacedItem> placed_faces(const InputComplex& input, std::uint32_t part) {
  const auto points = input.points(part);
  const auto faces = input.faces(part);
  Box bounds;
  for (const auto& p : points) bounds.include(p);
  double extent = 0;
  for (std::size_t i = 0; i < 3; ++i) extent = std::max(extent, bounds.upper[i] / 8 - bounds.lower[i] / 8);
  const double scale = extent > 0x1p-1000 ? 1023 / (3 * extent) : 0;  // of three eighths
  FreshArray<PlacedItem> placed(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const auto& [a, b, c] = faces[f];
    const auto &p = points[a], &q = points[b], &r = points[c];
    const auto cell = [&](std::size_t i) {
      const double above = p[i] / 8 + q[i] / 8 + r[i] / 8 - 3 * (bounds.lower[i] / 8);
      return static_cast<std::uint32_t>(std::clamp(above * scale, 0.0, 1023.0));
    };
    placed[f] = {z_order(cell(0), cell(1), cell(2)), input.first_face(part) + f};
  }
  return placed;
}

}  // namespace

BoxTree tree_of_part(const InputComplex& input, std::uint32_t part) {
  FreshArray<PlacedItem> placed = placed_faces(input, part);
  sort_by_code(placed);
  std::vector<std::uint32_t> faces;
  faces.reserve(placed.size());
  for (const PlacedItem& p : placed) faces.push_back(p.item);
  return BoxTree::by_order(std::move(faces), [&](std::span<const std::uint32_t> some) {
    Box box;
    for (const std::uint32_t f : some) box.include(box_of_face(input, part, f));
    return box;
  });
}

}  // namespace strata::contact
