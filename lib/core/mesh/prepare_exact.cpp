#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/exact/bounded.h"
#include "core/exact/pace.h"
#include "core/mesh/equal_vertices.h"
#include "core/mesh/prepare.h"
#include "core/mesh/prepare_steps.h"
#include "core/mesh/zero_area.h"
#include "strata/measure.h"

namespace strata {
namespace {

using BoundedVertex = std::array<Bounded, 3>;

/// The coordinates of a vertex, which may be a rational, relative to an origin.
BoundedVertex about(const Vertex& p, const Vertex& origin) {
  BoundedVertex q;
  for (std::size_t i = 0; i < 3; ++i)
    q[i] = Bounded{p[i], std::abs(p[i]) * Bounded::rounding + Bounded::underflow} - Bounded{origin[i]};
  return q;
}

/// Six times the signed volume, with a bound. Partial sums have a few thousand terms, so that the bounds hold.
Bounded bounded_volume(MeshView mesh, const Monitor& monitor) {
  constexpr std::size_t block = 4096;
  const Vertex origin = mesh.vertices[mesh.triangles[0][0]];
  Bounded total;
  for (std::size_t first = 0; first < mesh.triangles.size(); first += block) {
    monitor.check();
    Bounded sum;
    for (const Triangle& t : mesh.triangles.subspan(first, std::min(block, mesh.triangles.size() - first))) {
      const auto a = about(mesh.vertices[t[0]], origin), b = about(mesh.vertices[t[1]], origin),
                 c = about(mesh.vertices[t[2]], origin);
      sum = sum + (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]));
    }
    total = total + Bounded{sum.value, sum.error * Bounded::slack};
  }
  return total;
}

bool has_zero_area(ExactMeshView mesh, const Monitor& monitor) {
  const ZeroAreaTest is_zero(mesh);
  std::atomic<bool> found = false;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.mesh.triangles.size(), 1024), [&](const auto& range) {
    monitor.check();
    for (std::size_t f = range.begin(); f != range.end() && !found; ++f)
      if (is_zero(f)) found = true;
  });
  return found;
}

}  // namespace

void require_increasing_vertices(ExactMeshView mesh) {
  std::uint64_t least = 0;
  for (const ExactVertex& e : mesh.exact) {
    if (e.vertex < least || e.vertex >= mesh.mesh.vertices.size())
      throw std::invalid_argument("exact places are not those of vertices by increasing index");
    least = std::uint64_t{e.vertex} + 1;
  }
}

void require_nearest_doubles(ExactMeshView mesh, const Monitor& monitor) {
  require_increasing_vertices(mesh);
  Pace pace(monitor);
  for (const ExactVertex& e : mesh.exact) {
    pace.step();
    for (std::size_t i = 0; i < 3; ++i)
      if (to_nearest_double(e.position[i]) != mesh.mesh.vertices[e.vertex][i])
        throw std::invalid_argument("the mesh does not hold the double nearest to the exact place of vertex " +
                                    std::to_string(e.vertex));
  }
}

Sign orientation(ExactMeshView mesh, const Monitor& monitor) {
  if (mesh.mesh.triangles.empty()) return Sign::zero;
  if (const auto sign = bounded_volume(mesh.mesh, monitor).sign()) return *sign;
  return sign_of(volume(mesh).sign());
}

Prepared prepare_exact(ExactMeshView mesh, std::size_t operand, const Monitor& monitor) {
  const auto refuse = [&] { throw InputError(diagnose(mesh, few_defects, monitor), operand); };
  require_nearest_doubles(mesh, monitor);
  Prepared result;
  if (mesh.mesh.triangles.empty()) return result;
  const Screening facts = screen(mesh.mesh, monitor);
  if (!facts.finite || !facts.indices_valid) refuse();
  if (!facts.chain_closed) {
    const std::vector<std::uint32_t> first = equal_vertices(mesh, monitor);
    Mesh welded{{mesh.mesh.vertices.begin(), mesh.mesh.vertices.end()}, {}};
    for (const Triangle& t : mesh.mesh.triangles) welded.triangles.push_back({first[t[0]], first[t[1]], first[t[2]]});
    if (!chain_is_closed(welded, monitor)) refuse();
    std::uint64_t count = 0;
    for (std::uint32_t v = 0; v < first.size(); ++v) count += first[v] != v;
    result.notes.push_back(weld_note(count));
    result.source_face.resize(welded.triangles.size());
    std::iota(result.source_face.begin(), result.source_face.end(), 0U);
    result.mesh = std::move(welded);
  }
  if (has_zero_area(mesh, monitor) || orientation(mesh, monitor) == Sign::negative) refuse();
  return result;
}

}  // namespace strata
