#include "core/csg/moved_vertices.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include "core/containers/collect.h"
#include "core/containers/huge_pages.h"

namespace strata {
namespace {

/// A vertex is as near to the exact boundary as any of its triangles.
class VertexMovements {
 public:
  VertexMovements(std::size_t vertices, double far) : far_(far) {
    for (std::vector<char>* marks : {&is_used_, &is_unmoved_, &is_near_}) resize_fresh(*marks, vertices);
  }
  /// From many threads.
  void add(const Triangle& t, double way) {
    mark(t, is_used_);
    if (way == 0) mark(t, is_unmoved_);
    if (way <= far_) mark(t, is_near_);
  }
  void count(RoundingReport& report) const {
    const auto count_without = [&](const std::vector<char>& marks) {
      return collect(is_used_.size(), [&](std::uint32_t v) { return is_used_[v] != 0 && marks[v] == 0; }).size();
    };
    report.moved_vertices += count_without(is_unmoved_);
    report.far_vertices += count_without(is_near_);
  }

 private:
  static void mark(const Triangle& t, std::vector<char>& marks) {
    for (const std::uint32_t v : t) std::atomic_ref(marks[v]).store(1, std::memory_order_relaxed);
  }

  double far_;
  std::vector<char> is_used_, is_unmoved_, is_near_;
};

}  // namespace

void count_moved_vertices(const MovingMesh::Parts& rounded, double far, RoundingReport& report) {
  VertexMovements movements(rounded.mesh.vertices.size(), far);
  tbb::parallel_for(std::size_t{0}, rounded.moved.size(),
                    [&](std::size_t t) { movements.add(rounded.mesh.triangles[t], rounded.moved[t]); });
  movements.count(report);
}

void count_moved_vertices(const MovingMesh& rounded, const ChangedRegion& region, double far, RoundingReport& report) {
  const MeshView mesh = rounded.mesh();
  const std::vector<std::uint32_t>& changed = rounded.changed();
  if (changed.empty()) return;
  const auto position_in = [](const std::vector<std::uint32_t>& sorted, std::uint32_t number) {
    return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), number) - sorted.begin());
  };
  VertexMovements movements(region.vertices().size(), far);
  tbb::parallel_for(std::size_t{0}, region.faces().size(), [&](std::size_t n) {
    const std::uint32_t f = region.faces()[n], at = position_in(changed, f);
    Triangle t = mesh.triangles[f];
    for (std::uint32_t& v : t) v = position_in(region.vertices(), v);
    movements.add(t, at < changed.size() && changed[at] == f ? rounded.moved_of_changed()[at] : 0);
  });
  movements.count(report);
}

}  // namespace strata
