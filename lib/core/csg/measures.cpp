#include "core/csg/measures.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/csg/arena.h"
#include "core/kernel/predicates.h"
#include "core/mesh/closed_volume.h"
#include "core/mesh/split_vertices.h"
#include "core/overlap/starlike.h"
#include "core/round/rounding.h"

namespace strata {
namespace {

/// What the doubles nearest to a vertex leave of it.
SplitVertices::Low rest_of(const InputComplex& input, const Boundary& boundary, std::uint32_t vertex,
                           const Vertex& nearest) {
  constexpr double precise = 0x1p-95;
  const Point point = boundary.points.point(boundary.point(vertex));
  SplitVertices::Low rest;
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const DoubleDouble low = point.fine[k] - DoubleDouble(nearest[k]);
    rest.low[k] = low.value;
    rest.error = std::max(rest.error, (std::abs(low.low) + low.error) * Bounded::slack);
    largest = std::max(largest, std::abs(nearest[k]));
  }
  return rest.error <= largest * precise ? rest : strata::rest_of(exact_position(input, point), nearest);
}

/// Do two faces lie in one plane? Requires that their planes have a line in common.
bool are_coplanar(const InputComplex& input, std::uint32_t f, std::uint32_t g) {
  if (f == g) return true;
  const auto plane = input.face(f), corners = input.face(g);
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
    return std::find(plane.begin(), plane.end(), v) != plane.end() ||
           orient3d(input, plane[0], plane[1], plane[2], v) == Sign::zero;
  });
}

/// Boundaries of starlike solids are spheres, which needs less than a look at all of their stars.
Connections connections_of(ExactMeshView mesh, Facets facets, const Monitor& monitor) {
  constexpr Topology sphere{.components = 1, .euler = 2};
  if (facets == Facets::skip && mesh.exact.empty() && is_found_starlike(mesh.mesh, monitor)) return {sphere, 0};
  return connections(mesh, facets, monitor);
}

}  // namespace

Measures measures_of(ExactMeshView mesh, Facets facets, const Monitor& monitor) {
  Measures result;
  Connections connected;
  ClosedVolume volume;
  tbb::parallel_invoke([&] { connected = connections_of(mesh, facets, monitor); },
                       [&] { volume = volume_of_closed(mesh, monitor); },
                       [&] { result.area = area_of(mesh, monitor); });
  result.topology = connected.topology;
  result.facets = connected.facets;
  if (connected.topology.open_edges != 0) return result;
  result.volume = volume.nearest;
  result.exact_volume = std::move(volume.exact);
  return result;
}

Measures measures_of(const InputComplex& input, const Boundary& boundary, const NearestMesh& mesh,
                     std::span<const Source> sources, const Monitor& monitor) {
  const auto exactly = [&] {
    const std::vector<ExactVertex> exact = exact_positions(input, boundary, mesh.mesh.vertices, monitor);
    return measures_of(ExactMeshView(mesh.mesh, exact), Facets::count, monitor);
  };
  if (mesh.rounded.size() <= most_rational_vertices) return exactly();
  const auto low_of = [&](std::uint32_t v) { return rest_of(input, boundary, v, mesh.mesh.vertices[v]); };
  const SplitVertices split(mesh.mesh.vertices.size(), mesh.rounded, low_of);
  const auto face_of = [&](std::uint32_t triangle) {
    return input.first_face(sources[triangle].operand) + sources[triangle].face;
  };
  const auto is_one_plane = [&](std::uint32_t f, std::uint32_t g) {
    return are_coplanar(input, face_of(f), face_of(g));
  };
  Connections connected;
  std::optional<double> volume, area;
  tbb::parallel_invoke([&] { connected = connections(mesh, is_one_plane, monitor); },
                       [&] { volume = decided_volume(mesh.mesh, split, Closed::known, monitor); },
                       [&] { area = decided_area(mesh.mesh, split, monitor); });
  if (!volume || !area) return exactly();
  Measures result{connected.topology, {}, {}, *area, connected.facets};
  if (connected.topology.open_edges == 0) result.volume = volume;
  return result;
}

Measures measure(const ExactMesh& mesh, const Options& options, bool count_facets) {
  Measures result;
  arena_for(options, mesh.mesh.triangles.size()).execute([&] {
    result = measures_of(mesh, count_facets ? Facets::count : Facets::skip, Monitor(options.cancel));
  });
  return result;
}

}  // namespace strata
