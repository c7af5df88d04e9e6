#include "core/overlap/fans.h"

#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <cmath>

#include "core/containers/box_sweep.h"
#include "core/containers/collect.h"
#include "core/containers/huge_pages.h"

namespace strata {
namespace {

/// A direction divided by its largest coordinate: a point on the surface of the cube of side 2.
struct Direction {
  std::array<double, 3> at;
  double error;  ///< of each coordinate, at most
};

constexpr double unknown = 4;  ///< an error that allows every direction

/// Two differences and their quotient have relative errors of 2^-53 each; coordinates are at most 1. A point that is
/// not a double is up to 2^-53 of its coordinates away from the nearest doubles, and so is the other.
Direction direction(const Vertex& from, const Vertex& to, bool has_doubles) {
  Direction d{};
  double size = 0, magnitude = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    d.at[i] = to[i] - from[i];
    size = std::max(size, std::abs(d.at[i]));
    magnitude = std::max({magnitude, std::abs(from[i]), std::abs(to[i])});
  }
  const double moved = has_doubles ? 0 : magnitude * 0x1p-51 + 0x1p-1070;
  if (!(size < Box::infinity) || !(size > 2 * moved)) return {{}, unknown};
  for (double& x : d.at) x /= size;
  d.error = 0x1p-51 + 4 * (moved / size);
  return d;
}

/// Of all directions between two. Points c of the segment from a to b, whose ends have size 1, have a size from
/// 1 - |b - a| / 2 to 1, so their coordinates grow at most by that divisor when c is moved to the cube.
Box box_between(const Direction& a, const Direction& b) {
  const double error = std::max(a.error, b.error);
  double distance = 0;
  for (std::size_t i = 0; i < 3; ++i) distance = std::max(distance, std::abs(b.at[i] - a.at[i]));
  const double least_size = 1 - distance / 2 - 2 * error;
  Box box{{-1, -1, -1}, {1, 1, 1}};
  if (!(least_size > 0)) return box;
  for (std::size_t i = 0; i < 3; ++i) {
    const double lower = std::min(a.at[i], b.at[i]) - 2 * error, upper = std::max(a.at[i], b.at[i]) + 2 * error;
    box.lower[i] = std::max(-1.0, lower < 0 ? lower / least_size : lower);
    box.upper[i] = std::min(1.0, upper > 0 ? upper / least_size : upper);
  }
  return box;
}

/// One in four faces of a large mesh is counted: a vertex that is left out costs time, and no pair.
std::vector<std::uint32_t> vertices_of_many_faces(const InputComplex& input, const EmbeddedStars* stars) {
  const std::size_t vertex_count = input.points(0).size();
  const auto faces = input.faces(0);
  std::vector<bool> is_open(vertex_count, stars == nullptr);
  if (stars != nullptr) {
    const auto open = collect(vertex_count, [&](std::uint32_t v) { return !stars->at(v); });
    if (open.empty()) return {};
    for (const std::uint32_t v : open) is_open[v] = true;
  }
  const std::uint32_t step = faces.size() < (1 << 16) ? 1 : 4;
  std::vector<std::uint32_t> face_count;
  resize_fresh(face_count, vertex_count);
  tbb::parallel_for(std::size_t{0}, faces.size() / step, [&](std::size_t n) {
    for (const std::uint32_t v : faces[n * step])
      if (is_open[v]) std::atomic_ref(face_count[v]).fetch_add(step, std::memory_order_relaxed);
  });
  return collect(vertex_count, [&](std::uint32_t v) { return face_count[v] >= Fans::least_faces; });
}

/// Of a face, from one of its vertices.
Box directions_from(const InputComplex& input, std::uint32_t vertex, std::uint32_t face) {
  const auto points = input.points(0);
  const auto& corners = input.faces(0)[face];
  const auto at = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
  const auto towards = [&](std::size_t turns) {
    return direction(points[vertex], points[corners[(at + turns) % 3]], input.has_doubles(corners));
  };
  return box_between(towards(1), towards(2));
}

}  // namespace

Fans::Fans(const InputComplex& input, const EmbeddedStars* stars)
    : faces_(input.faces(0)), vertices_(vertices_of_many_faces(input, stars)) {
  if (vertices_.empty()) return;
  const std::vector<std::vector<std::uint32_t>> faces_of = faces_around();
  std::vector<std::size_t> first(vertices_.size() + 1, 0), axis(vertices_.size());
  for (std::size_t n = 0; n < vertices_.size(); ++n) first[n + 1] = first[n] + faces_of[n].size();
  blades_.resize(first.back());
  tbb::parallel_for(std::size_t{0}, vertices_.size(), [&](std::size_t n) {
    std::vector<Box> boxes;
    for (const std::uint32_t f : faces_of[n]) boxes.push_back(directions_from(input, vertices_[n], f));
    const BoxSweep sweep = sweep_of(boxes);
    axis[n] = sweep.axis;
    for (std::size_t k = 0; k < sweep.order.size(); ++k)
      blades_[first[n] + k] = {faces_of[n][sweep.order[k]], boxes[sweep.order[k]]};
  });

  constexpr std::size_t most_in_part = 64;
  for (std::size_t n = 0; n < vertices_.size(); ++n)
    for (std::size_t k = first[n]; k < first[n + 1]; k += most_in_part)
      parts_.push_back({k, std::min(k + most_in_part, first[n + 1]), first[n + 1], axis[n], vertices_[n]});
}

/// Of each fan, by increasing number.
std::vector<std::vector<std::uint32_t>> Fans::faces_around() const {
  std::vector<std::vector<std::uint32_t>> faces_of(vertices_.size());
  const auto is_in_fan = [&](std::uint32_t f) {
    return std::any_of(faces_[f].begin(), faces_[f].end(), [&](std::uint32_t v) { return at(v); });
  };
  for (const std::uint32_t f : collect(faces_.size(), is_in_fan))
    for (const std::uint32_t v : faces_[f])
      if (const auto n = std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin(); at(v))
        faces_of[static_cast<std::size_t>(n)].push_back(f);
  return faces_of;
}

/// Do two faces share a fan of a lower number?
bool Fans::have_earlier_fan(std::uint32_t face, std::uint32_t other, std::uint32_t vertex) const {
  const auto& corners = faces_[other];
  return std::any_of(faces_[face].begin(), faces_[face].end(), [&](std::uint32_t v) {
    return v < vertex && std::find(corners.begin(), corners.end(), v) != corners.end() && at(v);
  });
}

void Fans::append_pairs_of(std::size_t part, std::vector<PackedBoxes::Pair>& pairs) const {
  const auto& [first, end, end_of_fan, axis, vertex] = parts_[part];
  for (std::size_t i = first; i < end; ++i) {
    const auto& [face, directions] = blades_[i];
    for (std::size_t k = i + 1; k < end_of_fan && blades_[k].directions.lower[axis] <= directions.upper[axis]; ++k)
      if (const Blade& other = blades_[k];
          directions.overlaps(other.directions) && !have_earlier_fan(face, other.face, vertex))
        pairs.push_back({face, other.face});
  }
}

}  // namespace strata
