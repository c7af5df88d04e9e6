#include <algorithm>
#include <array>
#include <initializer_list>
#include <tuple>
#include <utility>
#include <vector>

#include "core/csg/solid_boundary.h"
#include "core/csg/solid_data.h"
#include "core/kernel/disjoint_sets.h"
#include "strata/carry_attributes.h"

namespace strata {
namespace {

using Index = std::uint32_t;
constexpr Index none = 0xffffffffu;

/// A wedge of the interior at an edge with others.
struct Wedge {
  EdgeUse use, other;
};

/// Corners of triangles, 3 t + i, that are one vertex: those around it on one sheet of the boundary.
class Corners {
 public:
  explicit Corners(const SolidBoundary& boundary) : sets_(3 * boundary.triangles().size()) {
    boundary.for_each_wedge([this](const EdgeUse& a, const EdgeUse& b, bool is_only) {
      sets_.unite(at_lower_end(a), at_lower_end(b));
      sets_.unite(at_higher_end(a), at_higher_end(b));
      if (!is_only) wedges_.push_back({a, b});
    });
  }
  /// The lowest corner of the vertex.
  [[nodiscard]] Index lowest(Index corner) { return sets_.find(corner); }

  /// The wedges of edges at which the copies of two wedges have the same ends.
  std::vector<Wedge> wedges_to_divide() {
    std::vector<Wedge> divided;
    for (std::size_t i = 0, last = 0; i < wedges_.size(); i = last) {
      std::vector<std::pair<Index, Index>> ends;
      for (; last < wedges_.size() && wedges_[last].use.same_edge(wedges_[i].use); ++last)
        ends.emplace_back(lowest(at_lower_end(wedges_[last].use)), lowest(at_higher_end(wedges_[last].use)));
      std::sort(ends.begin(), ends.end());
      if (std::adjacent_find(ends.begin(), ends.end()) == ends.end()) continue;
      divided.insert(divided.end(), wedges_.begin() + static_cast<std::ptrdiff_t>(i),
                     wedges_.begin() + static_cast<std::ptrdiff_t>(last));
    }
    return divided;
  }

 private:
  static Index first(const EdgeUse& use) { return 3 * use.triangle + use.corner; }
  static Index second(const EdgeUse& use) { return 3 * use.triangle + (use.corner + 1U) % 3; }
  static Index at_lower_end(const EdgeUse& use) { return use.forward ? first(use) : second(use); }
  static Index at_higher_end(const EdgeUse& use) { return use.forward ? second(use) : first(use); }

  DisjointSets<Index> sets_;
  std::vector<Wedge> wedges_;  ///< by edges
};

/// Appends a vertex.
Index add_vertex(ExactMesh& mesh, const RationalPoint& p) {
  const auto v = static_cast<Index>(mesh.mesh.vertices.size());
  Vertex rounded{};
  bool is_exact = true;
  for (std::size_t i = 0; i < 3; ++i) {
    rounded[i] = to_nearest_double(p[i]);
    is_exact = is_exact && to_rational(rounded[i]) == p[i];
  }
  mesh.mesh.vertices.push_back(rounded);
  if (!is_exact) mesh.exact.push_back({v, p});
  return v;
}

/// A vertex per set of corners: its own number where another set has not taken it, else a copy at the end.
ExactMesh with_copies(ExactMesh mesh, const SolidBoundary& boundary, Corners& corners) {
  mesh.mesh.triangles = boundary.triangles();
  std::vector<bool> is_taken(mesh.mesh.vertices.size(), false);
  for (Index corner = 0; corner < 3 * mesh.mesh.triangles.size(); ++corner) {
    Index& v = mesh.mesh.triangles[corner / 3][corner % 3];
    if (const Index lowest = corners.lowest(corner); lowest != corner) {
      v = mesh.mesh.triangles[lowest / 3][lowest % 3];
      continue;
    }
    v = boundary.mesh().mesh.triangles[corner / 3][corner % 3];  // as it is listed
    if (is_taken[v]) {
      v = add_vertex(mesh, boundary.mesh().position(v));
    } else {
      is_taken[v] = true;
    }
  }
  return mesh;
}

/// Divides triangles at vertices in the middle of their sides.
class Divider {
 public:
  Divider(ExactMesh& mesh, std::vector<Source>& sources) : mesh_(mesh), sources_(sources) {}

  void divide(const std::vector<Wedge>& wedges) {
    for (const Wedge& w : wedges) {
      const Triangle& t = mesh_.mesh.triangles[w.use.triangle];
      const RationalPoint p = mesh_.position(t[w.use.corner]), q = mesh_.position(t[(w.use.corner + 1U) % 3]);
      const Index middle = add_vertex(mesh_, {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
      for (const EdgeUse* use : {&w.use, &w.other}) sides_.push_back({use->triangle, use->corner, middle});
    }
    std::sort(sides_.begin(), sides_.end());
    for (std::size_t i = 0; i < sides_.size();) {
      std::array<Index, 3> middle{none, none, none};
      const Index triangle = std::get<0>(sides_[i]);
      for (; i < sides_.size() && std::get<0>(sides_[i]) == triangle; ++i)
        middle[std::get<1>(sides_[i])] = std::get<2>(sides_[i]);
      divide(triangle, middle);
    }
  }

 private:
  void divide(Index triangle, std::array<Index, 3> m) {
    Triangle v = mesh_.mesh.triangles[triangle];
    const auto turn = [&] {
      std::rotate(v.begin(), v.begin() + 1, v.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    };
    const auto count = std::count_if(m.begin(), m.end(), [](Index x) { return x != none; });
    if (count == 1) {
      while (m[0] == none) turn();
      replace(triangle, {{v[0], m[0], v[2]}, {m[0], v[1], v[2]}});
    } else if (count == 2) {
      while (m[2] != none) turn();
      replace(triangle, {{m[0], v[1], m[1]}, {v[0], m[0], m[1]}, {v[0], m[1], v[2]}});
    } else {
      replace(triangle, {{v[0], m[0], m[2]}, {m[0], v[1], m[1]}, {m[1], v[2], m[2]}, {m[0], m[1], m[2]}});
    }
  }
  void replace(Index triangle, std::initializer_list<Triangle> parts) {
    mesh_.mesh.triangles[triangle] = *parts.begin();
    for (const Triangle* part = parts.begin() + 1; part != parts.end(); ++part) {
      mesh_.mesh.triangles.push_back(*part);
      const Source source = sources_[triangle];
      sources_.push_back(source);
    }
  }

  ExactMesh& mesh_;
  std::vector<Source>& sources_;
  std::vector<std::tuple<Index, std::uint8_t, Index>> sides_;  ///< triangle, side, vertex in its middle
};

}  // namespace

Solid Solid::separated() const {
  if (is_empty()) return *this;
  const SolidBoundary boundary(exact_mesh());
  Corners corners(boundary);
  Data data{with_copies(exact_mesh(), boundary, corners), {}, notes()};
  for (Index t = 0; t < mesh().triangles.size(); ++t) data.sources.push_back({0, t});
  Divider(data.boundary, data.sources).divide(corners.wedges_to_divide());
  if (!attributes().empty())
    data.attributes = Shared<Attributes>::make(
        carry_attributes(std::array{AttributedMesh{exact_mesh(), &attributes()}}, data.boundary, data.sources));
  for (Source& s : data.sources) s = sources()[s.face];
  return Solid(Shared<Data>::make(std::move(data)));
}

}  // namespace strata
