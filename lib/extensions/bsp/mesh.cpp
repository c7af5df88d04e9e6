#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "core/kernel/filters.h"
#include "core/mesh/polygon_sweep.h"
#include "extensions/bsp/partition_data.h"
#include "extensions/bsp/triangle_facets.h"

namespace strata::bsp {
namespace {

std::vector<ExactFacet> exact_facets(const Partition<3>& region) {
  std::vector<ExactFacet> facets;
  for (const Facet<3>& f : facets_of(region)) {
    if (!f.piece.is_bounded()) throw std::domain_error("the boundary of the region is not bounded");
    std::vector<RationalPoint> loop;
    for (const HyperplaneMeet<3>& c : f.piece.corners) loop.push_back(table_of(region).position(c));
    if (!f.faces_plus) std::reverse(loop.begin(), loop.end());
    facets.push_back({std::move(loop)});
  }
  return facets;
}

/// Inserts vertices into sides of facets whose opposite side is divided, because vertices of other facets lie on them.
/// Along a line the numbers of vertices, which are in lexicographic order, increase or decrease.
class Sides {
 public:
  using Side = std::pair<std::uint32_t, std::uint32_t>;

  explicit Sides(const CanonicalForm& form) : form_(form) {
    std::map<Side, std::int64_t> net;
    for (const CanonicalFacets& facets : form.planes)
      for (const auto& loop : facets.loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
          net[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    for (const auto& [side, count] : net) {
      if (count == 0) continue;
      std::set<std::uint32_t>& line = lines_[line_through(side)];
      line.insert({side.first, side.second});
      line_of_.emplace(side, &line);
    }
  }

  /// The vertices of a loop with those on its sides.
  [[nodiscard]] std::vector<std::uint32_t> completed(const std::vector<std::uint32_t>& loop) const {
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      result.push_back(a);
      const auto found = line_of_.find(std::minmax(a, b));
      if (found == line_of_.end()) continue;
      const std::set<std::uint32_t>& line = *found->second;
      const auto low = line.upper_bound(std::min(a, b)), high = line.lower_bound(std::max(a, b));
      const std::size_t count = result.size();
      result.insert(result.end(), low, high);
      if (a > b) std::reverse(result.begin() + static_cast<std::ptrdiff_t>(count), result.end());
    }
    return result;
  }

 private:
  using Line = std::array<Rational, 6>;  ///< direction and moment, the first component that is not zero is 1

  [[nodiscard]] Line line_through(const Side& side) const {
    const RationalPoint &p = form_.vertices[side.first], &q = form_.vertices[side.second];
    Line line;
    for (std::size_t i = 0; i < 3; ++i) line[i] = q[i] - p[i];
    Rational first = 0;
    for (std::size_t i = 0; i < 3 && first == 0; ++i) first = line[i];
    for (std::size_t i = 0; i < 3; ++i) line[i] /= first;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      line[3 + i] = p[j] * line[k] - p[k] * line[j];
    }
    return line;
  }

  const CanonicalForm& form_;
  std::map<Line, std::set<std::uint32_t>> lines_;
  std::map<Side, const std::set<std::uint32_t>*> line_of_;
};

/// Vertices of a canonical form, rounded, with their exact positions.
ExactMesh rounded_vertices(const CanonicalForm& form) {
  ExactMesh mesh;
  for (const RationalPoint& p : form.vertices) {
    Vertex v{};
    bool is_exact = true;
    for (std::size_t i = 0; i < 3; ++i) {
      v[i] = to_nearest_double(p[i]);
      is_exact &= std::isfinite(v[i]) && to_rational(v[i]) == p[i];
    }
    if (!is_exact) mesh.exact.push_back({static_cast<std::uint32_t>(mesh.mesh.vertices.size()), p});
    mesh.mesh.vertices.push_back(v);
  }
  return mesh;
}

/// Triangulates the facets of one plane.
class Triangulation {
 public:
  Triangulation(const CanonicalForm& form, const ExactMesh& mesh) : form_(form), at_(mesh.mesh.vertices.size()) {
    for (std::size_t v = 0; v < at_.size(); ++v)
      for (std::size_t i = 0; i < 3; ++i) at_[v][i] = mesh.mesh.vertices[v][i];
    for (const ExactVertex& e : mesh.exact)
      for (Bounded& x : at_[e.vertex]) x.error = std::abs(x.value) * Bounded::rounding + Bounded::underflow;
  }

  /// Appends triangles; sides of loops are sides of triangles.
  void append(const CanonicalPlane& plane, const std::vector<std::vector<std::uint32_t>>& loops,
              std::vector<Triangle>& triangles) {
    choose_view(plane);
    places_.clear();
    for (const auto& loop : loops) places_.insert(places_.end(), loop.begin(), loop.end());
    std::sort(places_.begin(), places_.end(), [&](std::uint32_t a, std::uint32_t b) { return is_left_of(a, b); });
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    std::vector<PolygonSide> sides;
    for (const auto& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        sides.push_back({place_of(loop[i]), place_of(loop[(i + 1) % loop.size()])});
    const auto orientation = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      return orientation_of(places_[i], places_[j], places_[k]);
    };
    for (const Triangle& t : PolygonSweep(sides, orientation).divide())
      triangles.push_back({places_[t[0]], places_[t[1]], places_[t[2]]});
  }

 private:
  /// Two axes in which the plane is seen from its outer side.
  void choose_view(const CanonicalPlane& plane) {
    int axis = 2;
    while (plane.coefficients[static_cast<std::size_t>(axis)] == 0) --axis;
    u_ = (axis + 1) % 3;
    v_ = (axis + 2) % 3;
    if (plane.coefficients[static_cast<std::size_t>(axis)] < 0) std::swap(u_, v_);
  }
  [[nodiscard]] const Rational& exact(std::uint32_t vertex, int axis) const {
    return form_.vertices[vertex][static_cast<std::size_t>(axis)];
  }
  [[nodiscard]] bool is_left_of(std::uint32_t a, std::uint32_t b) const {
    if (exact(a, u_) != exact(b, u_)) return exact(a, u_) < exact(b, u_);
    return exact(a, v_) < exact(b, v_);
  }
  [[nodiscard]] std::uint32_t place_of(std::uint32_t vertex) const {
    const auto at = std::lower_bound(places_.begin(), places_.end(), vertex,
                                     [&](std::uint32_t a, std::uint32_t b) { return is_left_of(a, b); });
    return static_cast<std::uint32_t>(at - places_.begin());
  }
  [[nodiscard]] Sign orientation_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (const auto sign = strata::orientation_of<Bounded>(at_[a], at_[b], at_[c], u_, v_).sign()) return *sign;
    return sign_of(Rational((exact(b, u_) - exact(a, u_)) * (exact(c, v_) - exact(a, v_)) -
                            (exact(b, v_) - exact(a, v_)) * (exact(c, u_) - exact(a, u_))));
  }

  const CanonicalForm& form_;
  std::vector<BoundedPoint> at_;
  std::vector<std::uint32_t> places_;  ///< of one plane, from left to right and upwards
  int u_ = 0, v_ = 1;
};

}  // namespace

Partition<3> partition_of(ExactMeshView mesh, const Monitor& monitor) {
  HyperplaneTable<3> table;
  std::vector<Facet<3>> facets = triangle_facets(table, mesh, monitor);
  Tree tree = built(table, std::move(facets), monitor);
  return compact(partition_from(std::move(table), std::move(tree)));
}

CanonicalForm canonical_form_of(const Partition<3>& region) { return canonical_form(exact_facets(region)); }

BoundaryMesh boundary_mesh(const Partition<3>& region) {
  const CanonicalForm form = canonical_form_of(region);
  const Sides sides(form);
  BoundaryMesh result;
  result.mesh = rounded_vertices(form);
  std::vector<Triangle>& triangles = result.mesh.mesh.triangles;
  Triangulation triangulation(form, result.mesh);
  for (const CanonicalFacets& facets : form.planes) {
    std::vector<std::vector<std::uint32_t>> loops;
    for (const auto& loop : facets.loops) loops.push_back(sides.completed(loop));
    triangulation.append(facets.plane, loops, triangles);
    result.plane_of.resize(triangles.size(), static_cast<std::uint32_t>(result.planes.size()));
    result.planes.push_back(facets.plane);
  }
  return result;
}

ExactMesh exact_mesh_of(const Partition<3>& region) { return boundary_mesh(region).mesh; }

}  // namespace strata::bsp
