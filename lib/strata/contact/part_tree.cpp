#include "strata/contact/part_tree.h"

#include <algorithm>
#include <cmath>

namespace strata::contact {
namespace {

/// One step of doubles outwards.
void widen(Box& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    box.lower[i] = std::nextafter(box.lower[i], -Box::infinity);
    box.upper[i] = std::nextafter(box.upper[i], Box::infinity);
  }
}

}  // namespace

Box box_of_face(const Carriers& carriers, std::uint32_t part, std::uint32_t face) {
  const auto points = carriers.points(part);
  Box box;
  for (const std::uint32_t v : carriers.faces(part)[face - carriers.first_face(part)]) box.include(points[v]);
  if (carriers.has_rationals() && !carriers.has_doubles(carriers.face(face))) widen(box);
  return box;
}

Box box_of_vertex(const Carriers& carriers, std::uint32_t vertex) {
  Box box;
  box.include(carriers.vertex(vertex));
  if (!carriers.has_doubles(vertex)) widen(box);
  return box;
}

/// Where a face is, roughly: halved coordinates do not overflow when added.
struct PartTree::Middle {
  std::array<float, 3> at{};
  std::uint32_t face = 0;
};

PartTree::PartTree(const Carriers& carriers, std::uint32_t part) {
  const std::uint32_t count = carriers.face_count(part), first = carriers.first_face(part);
  if (count == 0) return;
  Box bounds;
  for (const auto& p : carriers.points(part)) bounds.include(p);
  std::array<double, 3> scale{};  // to [0, 1], so that floats tell
  for (std::size_t i = 0; i < 3; ++i) {
    const double extent = bounds.upper[i] * 0.25 - bounds.lower[i] * 0.25;
    scale[i] = extent > 0 ? extent : 1;
  }
  const auto points = carriers.points(part);
  std::vector<Middle> middles(count);
  for (std::uint32_t f = 0; f < count; ++f) {
    const auto& [a, b, c] = carriers.faces(part)[f];
    middles[f].face = first + f;
    for (std::size_t i = 0; i < 3; ++i) {
      const double sum = points[a][i] * 0.25 + points[b][i] * 0.25 + points[c][i] * 0.25 - 0.75 * bounds.lower[i];
      middles[f].at[i] = static_cast<float>(sum / scale[i]);
    }
  }
  nodes_.reserve(2 * count / (leaf_size / 2) + 1);
  faces_.resize(count);
  build(carriers, part, middles, 0);
}

void PartTree::build(const Carriers& carriers, std::uint32_t part, std::span<Middle> middles, std::uint32_t first) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({{}, first, static_cast<std::uint32_t>(middles.size()), 0});
  Box box;
  if (middles.size() <= leaf_size) {
    for (std::size_t i = 0; i < middles.size(); ++i) {
      faces_[first + i] = middles[i].face;
      box.include(box_of_face(carriers, part, middles[i].face));
    }
    nodes_[node].box = box;
    return;
  }
  std::array<float, 3> low = middles[0].at, high = low;
  for (const Middle& m : middles)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], m.at[i]);
      high[i] = std::max(high[i], m.at[i]);
    }
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
  const std::size_t half = middles.size() / 2;
  std::nth_element(middles.begin(), middles.begin() + static_cast<std::ptrdiff_t>(half), middles.end(),
                   [axis](const Middle& a, const Middle& b) {
                     return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.face < b.face;
                   });
  build(carriers, part, middles.first(half), first);
  nodes_[node].right = static_cast<std::uint32_t>(nodes_.size());
  build(carriers, part, middles.subspan(half), first + static_cast<std::uint32_t>(half));
  box = nodes_[node + 1].box;
  box.include(nodes_[nodes_[node].right].box);
  nodes_[node].box = box;
}

}  // namespace strata::contact
