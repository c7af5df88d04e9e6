#include "extensions/contact/part_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

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

/// A face, and where it is on a Z-curve through 1024 cells each way (Morton 1966).
struct Placed {
  std::uint32_t cell = 0;
  std::uint32_t face = 0;
};

/// Every third bit of a number of ten bits.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 16) & 0x30000ff;
  x = (x | x << 8) & 0x300f00f;
  x = (x | x << 4) & 0x30c30c3;
  return (x | x << 2) & 0x9249249;
}

/// By the sums of their corners. Eighths of coordinates do not overflow when added.
std::vector<Placed> placed_faces(const InputComplex& input, std::uint32_t part) {
  const auto points = input.points(part);
  const auto faces = input.faces(part);
  Box bounds;
  for (const auto& p : points) bounds.include(p);
  double extent = 0;
  for (std::size_t i = 0; i < 3; ++i) extent = std::max(extent, bounds.upper[i] / 8 - bounds.lower[i] / 8);
  const double scale = extent > 0x1p-1000 ? 1023 / (3 * extent) : 0;  // of three eighths
  std::vector<Placed> placed(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const auto& [a, b, c] = faces[f];
    const auto &p = points[a], &q = points[b], &r = points[c];
    const auto cell = [&](std::size_t i) {
      const double above = p[i] / 8 + q[i] / 8 + r[i] / 8 - 3 * (bounds.lower[i] / 8);
      return spread(static_cast<std::uint32_t>(std::clamp(above * scale, 0.0, 1023.0)));
    };
    placed[f] = {cell(0) << 2 | cell(1) << 1 | cell(2), input.first_face(part) + f};
  }
  return placed;
}

/// By cells, and within a cell by number, digit by digit.
void sort_by_cells(std::vector<Placed>& faces) {
  constexpr std::uint32_t digits = 1024;
  std::vector<Placed> sorted(faces.size());
  for (const int shift : {0, 10, 20}) {
    const auto digit = [shift](const Placed& p) { return p.cell >> shift & (digits - 1); };
    std::array<std::uint32_t, digits + 1> place{};
    for (const Placed& p : faces) ++place[digit(p) + 1];
    std::partial_sum(place.begin(), place.end(), place.begin());
    for (const Placed& p : faces) sorted[place[digit(p)]++] = p;
    faces.swap(sorted);
  }
}

}  // namespace

PartTree::PartTree(const InputComplex& input, std::uint32_t part) {
  std::vector<Placed> placed = placed_faces(input, part);
  if (placed.empty()) return;
  sort_by_cells(placed);
  faces_.reserve(placed.size());
  for (const Placed& p : placed) faces_.push_back(p.face);
  nodes_.reserve(2 * placed.size() / (leaf_size / 2) + 1);
  build(input, part, 0, static_cast<std::uint32_t>(placed.size()));
}

void PartTree::build(const InputComplex& input, std::uint32_t part, std::uint32_t first, std::uint32_t count) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({{}, first, count, 0});
  Box box;
  if (count <= leaf_size) {
    for (const std::uint32_t f : faces(nodes_[node])) box.include(box_of_face(input, part, f));
  } else {
    const std::uint32_t half = count / 2;
    build(input, part, first, half);
    nodes_[node].right = static_cast<std::uint32_t>(nodes_.size());
    build(input, part, first + half, count - half);
    box = nodes_[node + 1].box;
    box.include(nodes_[nodes_[node].right].box);
  }
  nodes_[node].box = box;
}

}  // namespace strata::contact
