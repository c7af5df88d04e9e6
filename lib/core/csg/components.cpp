#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/csg/arena.h"
#include "core/csg/solid_boundary.h"
#include "core/csg/solid_data.h"
#include "core/kernel/disjoint_sets.h"
#include "core/kernel/predicates.h"
#include "core/kernel/ray_crossing.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/prepare.h"
#include "core/overlap/embedded_stars.h"
#include "core/overlap/self_intersections.h"
#include "core/overlap/shells.h"
#include "strata/carry_attributes.h"

namespace strata {
namespace {

/// A part of the boundary that is connected over edges as seen from one side. From the interior: it bounds a component
/// of the interior from outside, or it is the boundary of a cavity of one. From the exterior: it is what a component of
/// the exterior surrounds, or it bounds such a component from outside, which then is closed off from infinity.
struct Shell {
  std::vector<std::uint32_t> faces;  ///< rising
  bool is_outer = false;             ///< its volume is positive
};

/// The boundary of a solid as shells.
class ShelledBoundary {
 public:
  explicit ShelledBoundary(ExactMeshView mesh) : boundary_(mesh), mesh_(mesh) {}

  [[nodiscard]] const InputComplex& input() const { return boundary_.input(); }
  [[nodiscard]] const Triangle& triangle(std::uint32_t face) const { return boundary_.triangles()[face]; }
  [[nodiscard]] const Vertex& vertex(std::uint32_t v) const { return mesh_.mesh.vertices[v]; }

  /// In the order of their first faces.
  [[nodiscard]] std::vector<Shell> shells() const {
    const std::vector<std::uint32_t> shell = shell_of_faces();
    std::vector<Shell> shells;
    for (std::uint32_t f = 0; f < shell.size(); ++f) {
      if (shell[f] == shells.size()) shells.emplace_back();
      shells[shell[f]].faces.push_back(f);
    }
    for (Shell& s : shells)
      s.is_outer =
          orientation(ExactMeshView(MeshView(mesh_.mesh.vertices, triangles_of(s)), mesh_.exact)) == Sign::positive;
    return shells;
  }

  [[nodiscard]] Rational volume(const Shell& shell) const {
    return strata::volume(ExactMeshView(MeshView(mesh_.mesh.vertices, triangles_of(shell)), mesh_.exact));
  }

 private:
  [[nodiscard]] std::vector<Triangle> triangles_of(const Shell& shell) const {
    std::vector<Triangle> triangles;
    for (const std::uint32_t f : shell.faces) triangles.push_back(triangle(f));
    return triangles;
  }

  [[nodiscard]] std::vector<std::uint32_t> shell_of_faces() const {
    DisjointSets<std::uint32_t> sets(boundary_.triangles().size());
    boundary_.for_each_wedge([&](const EdgeUse& a, const EdgeUse& b, bool) { sets.unite(a.triangle, b.triangle); });
    // The representative is the lowest face: shells are numbered when it comes.
    std::vector<std::uint32_t> shell(boundary_.triangles().size());
    std::uint32_t count = 0;
    for (std::uint32_t f = 0; f < shell.size(); ++f) {
      const std::uint32_t lowest = sets.find(f);
      shell[f] = lowest == f ? count++ : shell[lowest];
    }
    return shell;
  }

  SolidBoundary boundary_;
  ExactMeshView mesh_;
};

/// A point inside a face of a cavity's boundary, from where a ray runs in the direction of x.
struct Query {
  std::size_t shell = 0;
  Point point;
  Vertex nearest{};
  std::map<std::size_t, int> windings;  ///< of outer shells about the point
};

/// The queries that the ray of may meet a face, by doubles, which are sorted by z.
template <class Visit>
void for_each_near(const ShelledBoundary& boundary, const Triangle& t, std::vector<Query>& queries,
                   const Visit& visit) {
  Vertex lower = boundary.vertex(t[0]), upper = lower;
  for (const std::uint32_t v : t)
    for (std::size_t i = 0; i < 3; ++i) {
      lower[i] = std::min(lower[i], boundary.vertex(v)[i]);
      upper[i] = std::max(upper[i], boundary.vertex(v)[i]);
    }
  auto q = std::lower_bound(queries.begin(), queries.end(), lower[2],
                            [](const Query& a, double z) { return a.nearest[2] < z; });
  for (; q != queries.end() && q->nearest[2] <= upper[2]; ++q)
    if (lower[1] <= q->nearest[1] && q->nearest[1] <= upper[1] && q->nearest[0] <= upper[0]) visit(*q);
}

void count_crossings(const ShelledBoundary& boundary, const std::vector<Shell>& shells, std::vector<Query>& queries) {
  const InputComplex& input = boundary.input();
  for (std::size_t s = 0; s < shells.size(); ++s) {
    if (!shells[s].is_outer) continue;
    for (const std::uint32_t f : shells[s].faces) {
      std::optional<std::array<Point, 3>> corners;
      for_each_near(boundary, boundary.triangle(f), queries, [&](Query& q) {
        if (!corners) {
          corners.emplace();
          for (std::size_t i = 0; i < 3; ++i)
            (*corners)[i] = make_point(input, SymbolicPoint::input(boundary.triangle(f)[i]));
        }
        if (const int crossing = crossing_along_x(input, f, *corners, q.point); crossing != 0)
          q.windings[s] += crossing;
      });
    }
  }
}

/// Per shell the outer shell of its component. Shells around a point of a cavity's boundary lie within one another, and
/// the innermost is that of the cavity's component: it has the least volume.
std::vector<std::size_t> outer_shells(const ShelledBoundary& boundary, const std::vector<Shell>& shells) {
  std::vector<std::size_t> outer(shells.size());
  std::vector<Query> queries;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    outer[s] = s;
    if (shells[s].is_outer) continue;
    const Point inside = make_point(boundary.input(), SymbolicPoint::weighted(shells[s].faces.front(), 1));
    queries.push_back({s, inside, nearest_doubles(boundary.input(), inside), {}});
  }
  std::sort(queries.begin(), queries.end(), [](const Query& a, const Query& b) { return a.nearest[2] < b.nearest[2]; });
  count_crossings(boundary, shells, queries);
  std::map<std::size_t, Rational> volumes;
  const auto volume_of = [&](std::size_t s) -> const Rational& {
    const auto known = volumes.find(s);
    return known != volumes.end() ? known->second : volumes.emplace(s, boundary.volume(shells[s])).first->second;
  };
  for (const Query& q : queries) {
    std::optional<std::size_t> innermost;
    for (const auto& [s, winding] : q.windings)
      if (winding != 0 && (!innermost || volume_of(s) < volume_of(*innermost))) innermost = s;
    if (innermost) outer[q.shell] = *innermost;
  }
  return outer;
}

/// Some triangles of a mesh, which bound a solid. Where sheets touch and are listed apart, each with a sheet that is
/// not among them, equal vertices become one.
std::vector<Triangle> closed_part_of(const ExactMesh& whole, const std::vector<std::uint32_t>& faces) {
  std::vector<Triangle> part;
  part.reserve(faces.size());
  for (const std::uint32_t f : faces) part.push_back(whole.mesh.triangles[f]);
  if (chain_is_closed({whole.mesh.vertices, part})) return part;
  const std::vector<std::uint32_t> first = equal_vertices(whole);
  for (Triangle& t : part)
    for (std::uint32_t& v : t) v = first[v];
  return part;
}

/// Some triangles of a solid, rising, with the vertices that they use, in their order.
Solid::Data part_of(const Solid& solid, const std::vector<std::uint32_t>& faces, std::vector<std::uint32_t>& number) {
  const ExactMesh& whole = solid.exact_mesh();
  const std::vector<Triangle> triangles = closed_part_of(whole, faces);
  std::vector<std::uint32_t> used;
  for (const Triangle& t : triangles) used.insert(used.end(), t.begin(), t.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  Solid::Data part;
  for (const std::uint32_t v : used) {
    number[v] = static_cast<std::uint32_t>(part.boundary.mesh.vertices.size());
    part.boundary.mesh.vertices.push_back(whole.mesh.vertices[v]);
    const auto exact = std::lower_bound(whole.exact.begin(), whole.exact.end(), v,
                                        [](const ExactVertex& e, std::uint32_t w) { return e.vertex < w; });
    if (exact != whole.exact.end() && exact->vertex == v) part.boundary.exact.push_back({number[v], exact->position});
  }
  for (const auto& [a, b, c] : triangles) part.boundary.mesh.triangles.push_back({number[a], number[b], number[c]});
  for (const std::uint32_t f : faces) part.sources.push_back(solid.sources()[f]);
  if (!solid.attributes().empty()) part.attributes = Shared<Attributes>::make(part_of(solid.attributes(), faces, used));
  return part;
}

/// True where the boundary is one shell as seen from anywhere, since its faces are connected across edges that two
/// have.
bool is_plainly_one_shell(const ExactMesh& mesh, const Options& options) {
  bool is_one = false;
  arena_for(options, mesh.mesh.triangles.size()).execute([&] {
    const InputComplex complex = complex_of(mesh);
    is_one = find_shells(complex, EmbeddedStars(complex, Monitor(options.cancel))).count == 1;
  });
  return is_one;
}

}  // namespace

std::vector<Solid> Solid::components() const {
  if (is_empty()) return {};
  const ShelledBoundary boundary(exact_mesh());
  const std::vector<Shell> shells = boundary.shells();
  const std::vector<std::size_t> outer = outer_shells(boundary, shells);
  std::map<std::size_t, std::vector<std::uint32_t>> faces;  // by outer shell
  for (std::size_t s = 0; s < shells.size(); ++s) {
    std::vector<std::uint32_t>& list = faces[outer[s]];
    list.insert(list.end(), shells[s].faces.begin(), shells[s].faces.end());
  }
  if (faces.size() == 1) return {*this};
  std::vector<std::vector<std::uint32_t>> lists;
  for (auto& [shell, list] : faces) {
    std::sort(list.begin(), list.end());
    lists.push_back(std::move(list));
  }
  std::sort(lists.begin(), lists.end(), [](const auto& a, const auto& b) { return a.front() < b.front(); });
  std::vector<Solid> components;
  std::vector<std::uint32_t> number(mesh().vertices.size());
  for (const auto& list : lists) components.push_back(Solid(Shared<Data>::make(part_of(*this, list, number))));
  return components;
}

Solid Solid::without_cavities(const Options& options) const {
  if (is_empty() || is_plainly_one_shell(exact_mesh(), options)) return *this;
  // What is closed off is a component of the exterior, which may touch others, and infinity, in edges and vertices.
  std::vector<Triangle> reversed = mesh().triangles;
  for (Triangle& t : reversed) std::swap(t[1], t[2]);
  std::vector<Shell> shells = ShelledBoundary({{mesh().vertices, reversed}, exact_mesh().exact}).shells();
  for (Shell& s : shells) s.is_outer = !s.is_outer;
  if (std::all_of(shells.begin(), shells.end(), [](const Shell& s) { return s.is_outer; })) return *this;
  std::vector<Solid> parts;
  std::vector<std::uint32_t> number(mesh().vertices.size());
  for (const Shell& s : shells)
    if (s.is_outer) parts.push_back(Solid(Shared<Data>::make(part_of(*this, s.faces, number))));
  if (parts.size() == 1) return parts.front();
  const Solid all = combine_solids(Operation::union_, parts, options);
  Data data = *all.data_;
  for (Source& source : data.sources) source = parts[source.operand].sources()[source.face];
  return Solid(Shared<Data>::make(std::move(data)));
}

}  // namespace strata
