#include <tbb/parallel_invoke.h>

#include <utility>

#include "core/csg/arena.h"
#include "core/mesh/connections.h"
#include "strata/measure.h"

namespace strata {

Measures measure(const ExactMesh& mesh, const Options& options) {
  Measures result;
  arena_for(options, mesh.mesh.triangles.size()).execute([&] {
    Connections connected;
    Rational signed_volume;
    tbb::parallel_invoke([&] { connected = connections(mesh, Facets::count); }, [&] { signed_volume = volume(mesh); },
                         [&] { result.area = area(mesh); });
    result.topology = connected.topology;
    result.facets = connected.facets;
    if (connected.topology.open_edges == 0) result.volume = std::move(signed_volume);
  });
  return result;
}

}  // namespace strata
