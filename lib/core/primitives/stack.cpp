#include "core/primitives/stack.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "core/io/triangulate.h"
#include "core/mesh/circle.h"

namespace strata {
namespace {

/// Writes rings and what joins them into a mesh.
class Stack {
 public:
  Stack(std::span<const Ring> rings, std::uint32_t sides) : sides_(sides) {
    for (std::uint32_t i = 0; i < sides; ++i) directions_.push_back(cosine_sine(360.0 * i / sides));
    add_ring(rings[0]);
    if (!lower_.is_point) add_cap(false);
    for (const Ring& ring : rings.subspan(1)) {
      add_ring(ring);
      add_wall();
    }
    if (!upper_.is_point) add_cap(true);
  }
  Mesh take() { return std::move(mesh_); }

 private:
  /// Numbers of a ring's corners.
  struct Corners {
    std::uint32_t first = 0;
    bool is_point = false;
    [[nodiscard]] std::uint32_t at(std::uint32_t side) const { return is_point ? first : first + side; }
  };

  /// The ring that was the upper one becomes the lower one.
  void add_ring(const Ring& ring) {
    const Corners corners{static_cast<std::uint32_t>(mesh_.vertices.size()), ring.radius == 0};
    lower_ = mesh_.vertices.empty() ? corners : upper_;
    upper_ = corners;
    if (corners.is_point) {
      mesh_.vertices.push_back({0, 0, ring.z});
      return;
    }
    for (const CosineSine& d : directions_)
      mesh_.vertices.push_back({ring.radius * d.cosine, ring.radius * d.sine, ring.z});
  }
  void add_cap(bool above) {
    const Corners& ring = above ? upper_ : lower_;
    const std::size_t first = mesh_.triangles.size();
    mesh_.triangles.resize(first + sides_ - 2);
    const std::span<Triangle> cap = std::span(mesh_.triangles).subspan(first);
    io::triangulate(std::span(mesh_.vertices).subspan(ring.first, sides_), cap);
    for (Triangle& t : cap) {
      for (std::uint32_t& v : t) v += ring.first;
      if (!above) std::swap(t[1], t[2]);
    }
  }
  void add_wall() {
    for (std::uint32_t i = 0; i < sides_; ++i) {
      const std::uint32_t j = i + 1 == sides_ ? 0 : i + 1;
      if (!lower_.is_point) mesh_.triangles.push_back({lower_.at(i), lower_.at(j), upper_.at(j)});
      if (!upper_.is_point) mesh_.triangles.push_back({lower_.at(i), upper_.at(j), upper_.at(i)});
    }
  }

  std::uint32_t sides_;
  std::vector<CosineSine> directions_;
  Mesh mesh_;
  Corners lower_, upper_;
};

}  // namespace

Mesh stack(std::span<const Ring> rings, std::uint32_t sides) { return Stack(rings, sides).take(); }

}  // namespace strata
