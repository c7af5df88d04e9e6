#include <tbb/parallel_invoke.h>

#include "core/csg/arena.h"
#include "core/mesh/connections.h"
#include "strata/measure.h"

namespace strata {

Measures measure(const ExactMesh& mesh, const Options& options, bool count_facets) {
  Measures result;
  arena_for(options, mesh.mesh.triangles.size()).execute([&] {
    Connections connected;
    double signed_volume = 0;
    tbb::parallel_invoke([&] { connected = connections(mesh, count_facets ? Facets::count : Facets::skip); },
                         [&] { signed_volume = nearest_volume(mesh); }, [&] { result.area = area(mesh); });
    result.topology = connected.topology;
    result.facets = connected.facets;
    if (connected.topology.open_edges == 0) result.volume = signed_volume;
  });
  return result;
}

}  // namespace strata
