#include "extensions/convex/touching_faces.h"

#include <tbb/parallel_for.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "extensions/convex/directions.h"
#include "extensions/convex/sum_points.h"

namespace strata::convex {
namespace {

/// A bit per face of one surface and edge of the other.
class BitRows {
 public:
  BitRows(std::size_t rows, std::size_t columns) : words_((columns + 63) / 64), bits_(rows * words_) {}

  [[nodiscard]] bool at(std::size_t row, std::size_t column) const {
    return (bits_[row * words_ + column / 64] >> (column % 64) & 1) != 0;
  }
  void set(std::size_t row, std::size_t column) {
    bits_[row * words_ + column / 64] |= std::uint64_t{1} << (column % 64);
  }
  /// Visits the columns in which two rows differ.
  template <class Visit>
  void differences(std::size_t first, std::size_t second, Visit visit) const {
    for (std::size_t w = 0; w < words_; ++w)
      for (std::uint64_t x = bits_[first * words_ + w] ^ bits_[second * words_ + w]; x != 0; x &= x - 1)
        visit(static_cast<std::uint32_t>(64 * w + static_cast<std::size_t>(std::countr_zero(x))));
  }

 private:
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

/// The edges that end in each vertex of a surface.
class VertexEdges {
 public:
  struct End {
    std::uint32_t edge = 0;
    bool outgoing = false;  ///< the vertex is the edge's `from`
  };

  explicit VertexEdges(const Surface& surface)
      : first_(surface.points.mesh.vertices.size() + 1, 0), ends_(2 * surface.edges.size()) {
    for (const SurfaceEdge& e : surface.edges)
      for (const std::uint32_t v : {e.from, e.to}) ++first_[v];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    for (std::uint32_t e = 0; e < surface.edges.size(); ++e) {
      ends_[--first_[surface.edges[e].from]] = {e, true};
      ends_[--first_[surface.edges[e].to]] = {e, false};
    }
    std::vector<bool> used(surface.points.mesh.vertices.size(), false);
    for (const Fan& fan : surface.fans) used[fan.vertex] = true;
    for (std::uint32_t v = 0; v < used.size(); ++v)
      if (used[v]) vertices_.push_back(v);
  }

  /// The vertices on the surface.
  [[nodiscard]] const std::vector<std::uint32_t>& vertices() const { return vertices_; }
  /// True if all edges of a vertex lead to vertices for which a condition does not hold.
  template <class Beyond>
  [[nodiscard]] bool none_leads(std::uint32_t vertex, Beyond beyond) const {
    for (std::uint32_t i = first_[vertex]; i < first_[vertex + 1]; ++i)
      if (beyond(ends_[i].edge) == ends_[i].outgoing) return false;
    return true;
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<End> ends_;
  std::vector<std::uint32_t> vertices_;
};

template <class N>
class TouchingFaces {
 public:
  TouchingFaces(const Surface& a, const LatticePoints& on_a, const Surface& b, const LatticePoints& on_b,
                const Monitor& monitor)
      : a_(a),
        b_(b),
        a_directions_(directions_of<N>(a, on_a, monitor)),
        b_directions_(directions_of<N>(b, on_b, monitor)),
        sums_(a.points, b.points),
        monitor_(monitor),
        beyond_(a.faces.size(), b.edges.size()) {}

  ExactMesh run() {
    tbb::parallel_for(std::uint32_t{0}, static_cast<std::uint32_t>(a_.faces.size()), [&](std::uint32_t f) {
      monitor_.check();
      for (std::uint32_t g = 0; g < b_.edges.size(); ++g)
        if (face_of_a_beyond(f, g)) beyond_.set(f, g);
    });
    for (std::uint32_t e = 0; e < a_.edges.size(); ++e) {
      monitor_.check();
      if (a_directions_.bend[e] > 0)
        beyond_.differences(a_.edges[e].left, a_.edges[e].right, [&](std::uint32_t g) { add_parallelogram(e, g); });
    }
    add_faces(
        a_, b_, [&](std::uint32_t f, std::uint32_t g) { return beyond_.at(f, g); }, false);
    add_faces(
        b_, a_, [&](std::uint32_t f, std::uint32_t e) { return face_of_b_beyond(f, e); }, true);
    ExactMesh result = std::move(sums_.points());
    result.mesh.triangles = std::move(triangles_);
    return result;
  }

 private:
  // The directions of B are those of B transformed by I + E with infinitesimal E, so that nothing is parallel.
  /// Side of a normal of A with respect to an edge of B: the scalar product with the transformed edge.
  [[nodiscard]] bool face_of_a_beyond(std::uint32_t face, std::uint32_t edge) const {
    const int sign = product_sign(a_directions_.normals, face, b_directions_.edges, edge);
    return (sign != 0 ? sign
                      : infinitesimal_sign(a_directions_.normals.approximate[face],
                                           b_directions_.edges.approximate[edge])) > 0;
  }
  /// Side of a normal of B with respect to an edge of A: transforming normals by the inverse transpose of I + E equals
  /// transforming the edge by I - E.
  [[nodiscard]] bool face_of_b_beyond(std::uint32_t face, std::uint32_t edge) const {
    const int sign = product_sign(b_directions_.normals, face, a_directions_.edges, edge);
    return (sign != 0 ? sign
                      : -infinitesimal_sign(b_directions_.normals.approximate[face],
                                            a_directions_.edges.approximate[edge])) > 0;
  }

  /// Adds the parallelogram of two convex edges, if both are extreme in a common direction: the normals of the faces
  /// beside an edge are the ends of an arc on the sphere of directions, and two arcs cross in one point. Their great
  /// circles cross in two opposite points; both arcs must contain the same one. The outward normal is e x g times the
  /// side of a's left face.
  void add_parallelogram(std::uint32_t e, std::uint32_t g) {
    if (b_directions_.bend[g] <= 0) return;
    const SurfaceEdge &of_a = a_.edges[e], &of_b = b_.edges[g];
    const bool left_of_a = beyond_.at(of_a.left, g);
    if (of_b.left != Surface::no_face) {
      const bool left_of_b = face_of_b_beyond(of_b.left, e);
      if (left_of_b == face_of_b_beyond(of_b.right, e) || left_of_a == left_of_b) return;
    }
    if (are_parallel(e, g)) return;
    const std::uint32_t p = sums_.number(of_a.from, of_b.from), q = sums_.number(of_a.to, of_b.from),
                        r = sums_.number(of_a.to, of_b.to), s = sums_.number(of_a.from, of_b.to);
    if (left_of_a) {
      triangles_.insert(triangles_.end(), {{p, q, r}, {p, r, s}});
    } else {
      triangles_.insert(triangles_.end(), {{p, r, q}, {p, s, r}});
    }
  }

  [[nodiscard]] bool are_parallel(std::uint32_t e, std::uint32_t g) const {
    const auto &u = a_directions_.edges.approximate[e], &v = b_directions_.edges.approximate[g];
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = u[(i + 1) % 3] * v[(i + 2) % 3], y = u[(i + 2) % 3] * v[(i + 1) % 3];
      if (std::abs(x - y) > 16 * 0x1p-53 * (std::abs(x) + std::abs(y))) return false;
    }
    const auto n = cross(a_directions_.edges.exact[e], b_directions_.edges.exact[g]);
    return sign_number(n[0]) == 0 && sign_number(n[1]) == 0 && sign_number(n[2]) == 0;
  }

  /// Faces of one surface at the vertices of the other from which no edge rises along the face's normal.
  template <class Beyond>
  void add_faces(const Surface& surface, const Surface& other, Beyond beyond, bool vertices_of_a) {
    const VertexEdges ends(other);
    for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
      monitor_.check();
      for (const std::uint32_t v : ends.vertices())
        if (ends.none_leads(v, [&](std::uint32_t edge) { return beyond(f, edge); }))
          add_face(surface.faces[f], v, vertices_of_a);
    }
  }

  void add_face(const std::vector<std::uint32_t>& loop, std::uint32_t vertex, bool vertex_of_a) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t v : loop)
      corners.push_back(vertex_of_a ? sums_.number(vertex, v) : sums_.number(v, vertex));
    for (std::size_t i = 2; i < corners.size(); ++i) triangles_.push_back({corners[0], corners[i - 1], corners[i]});
  }

  const Surface& a_;
  const Surface& b_;
  const Directions<N> a_directions_, b_directions_;
  SumPoints sums_;
  const Monitor& monitor_;
  BitRows beyond_;  ///< faces of A beyond edges of B
  std::vector<Triangle> triangles_;
};

}  // namespace

ExactMesh touching_faces(const Surface& a, const Surface& b, const Monitor& monitor) {
  const LatticePoints on_a = lattice_points(a.points, monitor), on_b = lattice_points(b.points, monitor);
  const int bits = 3 * std::max(on_a.bits, on_b.bits) + 7;
  if (bits <= 128) return TouchingFaces<__int128>(a, on_a, b, on_b, monitor).run();
  if (bits <= 256) return TouchingFaces<WideInt<4>>(a, on_a, b, on_b, monitor).run();
  return TouchingFaces<Integer>(a, on_a, b, on_b, monitor).run();
}

}  // namespace strata::convex
