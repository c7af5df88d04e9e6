#include <tbb/parallel_invoke.h>

#include <utility>

#include "core/csg/arena.h"
#include "core/mesh/closed_volume.h"
#include "core/mesh/connections.h"
#include "strata/measure.h"

namespace strata {

Measures measure(const ExactMesh& mesh, const Options& options, bool count_facets) {
  Measures result;
  arena_for(options, mesh.mesh.triangles.size()).execute([&] {
    const Monitor monitor(options.cancel);
    Connections connected;
    ClosedVolume volume;
    tbb::parallel_invoke([&] { connected = connections(mesh, count_facets ? Facets::count : Facets::skip, monitor); },
                         [&] { volume = volume_of_closed(mesh, monitor); },
                         [&] { result.area = area_of(mesh, monitor); });
    result.topology = connected.topology;
    result.facets = connected.facets;
    if (connected.topology.open_edges != 0) return;
    result.volume = volume.nearest;
    result.exact_volume = std::move(volume.exact);
  });
  return result;
}

}  // namespace strata
