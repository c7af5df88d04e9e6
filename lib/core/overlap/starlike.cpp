#include "core/overlap/starlike.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "core/kernel/box.h"
#include "core/kernel/filtered_orientation.h"
#include "core/kernel/filtered_plane.h"
#include "core/mesh/prepare.h"

namespace strata {
namespace {

/// A point near the middle of the box of all vertices. It is off the planes, axes and diagonals of symmetry, where the
/// vertical ray from it would meet vertices and edges.
Vertex somewhere_in_the_middle(std::span<const Vertex> vertices) {
  Box box;
  for (const Vertex& v : vertices)
    for (std::size_t i = 0; i < 3; ++i) {
      box.lower[i] = std::min(box.lower[i], v[i]);
      box.upper[i] = std::max(box.upper[i], v[i]);
    }
  constexpr std::array<double, 3> share{0.5039, 0.4951, 0.5017};
  Vertex middle;
  for (std::size_t i = 0; i < 3; ++i) middle[i] = box.lower[i] + share[i] * (box.upper[i] - box.lower[i]);
  return middle;
}

enum class Upwards { misses, meets, uncertain };

/// How the ray from `eye` along +z meets a face whose inner side the eye sees. It meets the face where the image of the
/// eye in the xy-plane lies in that of the face, and this is counter-clockwise: then the eye is below its plane.
Upwards upwards(const Vertex& eye, const std::array<const Vertex*, 3>& corners) {
  const auto& [a, b, c] = corners;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto [least, largest] = std::minmax({(*a)[i], (*b)[i], (*c)[i]});
    if (eye[i] < least || largest < eye[i]) return Upwards::misses;
  }
  bool is_certain = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex &from = *corners[i], &to = *corners[(i + 1) % 3];
    const int side = filtered_orientation({from[0], from[1]}, {to[0], to[1]}, {eye[0], eye[1]});
    if (side < 0) return Upwards::misses;
    is_certain = is_certain && side > 0;
  }
  return is_certain ? Upwards::meets : Upwards::uncertain;
}

}  // namespace

bool is_found_starlike(MeshView mesh, const Monitor& monitor) {
  if (mesh.triangles.empty()) return false;
  const Vertex eye = somewhere_in_the_middle(mesh.vertices);
  std::atomic<bool> is_starlike = true;
  std::atomic<std::size_t> met = 0;
  const auto look = [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f != last; ++f) {
      const Triangle& t = mesh.triangles[f];
      if (std::max({t[0], t[1], t[2]}) >= mesh.vertices.size()) return false;
      const std::array<const Vertex*, 3> corners{&mesh.vertices[t[0]], &mesh.vertices[t[1]], &mesh.vertices[t[2]]};
      if (FilteredPlane(*corners[0], *corners[1], *corners[2]).side(eye) >= 0) return false;
      const Upwards ray = upwards(eye, corners);
      if (ray == Upwards::uncertain) return false;
      if (ray == Upwards::meets && met.fetch_add(1, std::memory_order_relaxed) > 0) return false;
    }
    return true;
  };
  constexpr std::size_t grain = 1 << 12;
  if (!look(0, std::min(grain, mesh.triangles.size()))) return false;
  if (mesh.triangles.size() > grain)
    tbb::parallel_for(tbb::blocked_range<std::size_t>(grain, mesh.triangles.size(), grain), [&](const auto& range) {
      monitor.check();
      if (is_starlike.load(std::memory_order_relaxed) && !look(range.begin(), range.end()))
        is_starlike.store(false, std::memory_order_relaxed);
    });
  return is_starlike && met == 1 && chain_is_closed(mesh);
}

}  // namespace strata
