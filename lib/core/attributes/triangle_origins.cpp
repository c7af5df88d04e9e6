#include "core/attributes/triangle_origins.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/attributes/face_frame.h"
#include "core/containers/collect.h"

namespace strata {
namespace {

void require_vertices(const MeshView& mesh, const Triangle& t) {
  for (const std::uint32_t v : t)
    if (v >= mesh.vertices.size()) throw std::invalid_argument("a triangle has the vertex " + std::to_string(v));
}

void require_source(std::span<const MeshPoints> operands, const Source& s) {
  if (s.operand >= operands.size() || s.face >= operands[s.operand].mesh().triangles.size())
    throw std::invalid_argument("there is no face " + std::to_string(s.face) + " of operand " +
                                std::to_string(s.operand));
  require_vertices(operands[s.operand].mesh(), operands[s.operand].mesh().triangles[s.face]);
}

/// Vertices of a result and of operands that were found equal: per vertex of the result the last one. So most corners
/// are compared by numbers. Threads may ask at once.
class KnownVertices {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  KnownVertices(std::span<const MeshPoints> operands, const MeshPoints& result)
      : result_(result), known_(result.mesh().vertices.size(), none) {
    std::uint64_t count = 0;
    for (const MeshPoints& o : operands) {
      first_.push_back(static_cast<std::uint32_t>(count));
      count += o.mesh().vertices.size();
      if (count >= none) throw std::length_error("more than 2^32 - 2 vertices");
    }
  }

  [[nodiscard]] bool are_equal(std::uint32_t vertex, const MeshPoints& operand, std::uint32_t number,
                               std::uint32_t corner) {
    const std::uint32_t global = first_[number] + corner;
    const std::atomic_ref<std::uint32_t> known(known_[vertex]);
    if (known.load(std::memory_order_relaxed) == global) return true;
    if (!MeshPoints::are_equal(result_, vertex, operand, corner)) return false;
    known.store(global, std::memory_order_relaxed);
    return true;
  }

 private:
  const MeshPoints& result_;
  std::vector<std::uint32_t> known_, first_;
};

/// The first order in which the corners of a source are those of a triangle; none if there is none.
template <class Orders>
std::size_t order_of(const Orders& orders, const Triangle& t, const Triangle& source, std::uint32_t number,
                     const MeshPoints& operand, KnownVertices& known) {
  for (std::size_t n = 0; n < orders.size(); ++n) {
    bool is_equal = true;
    for (std::size_t k = 0; k < 3 && is_equal; ++k)
      is_equal = known.are_equal(t[k], operand, number, source[orders[n][k]]);
    if (is_equal) return n;
  }
  return orders.size();
}

}  // namespace

TriangleOrigins::TriangleOrigins(std::span<const AttributedMesh> operands, ExactMeshView result,
                                 std::span<const Source> sources, bool may_turn, const Monitor& monitor)
    : points_(result), sources_(sources), may_turn_(may_turn), origin_(sources.size()) {
  operands_.reserve(operands.size());
  for (const AttributedMesh& o : operands) operands_.emplace_back(o.mesh);
  if (sources.size() != result.mesh.triangles.size())
    throw std::invalid_argument(std::to_string(sources.size()) + " sources of " +
                                std::to_string(result.mesh.triangles.size()) + " triangles");
  static_assert(part == orders.size());
  KnownVertices known(operands_, points_);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sources.size(), 1 << 13), [&](const auto& range) {
    monitor.check();
    for (std::size_t t = range.begin(); t != range.end(); ++t) {
      require_source(operands_, sources[t]);
      require_vertices(result.mesh, result.mesh.triangles[t]);
      const std::uint32_t number = sources[t].operand;
      origin_[t] = static_cast<std::uint8_t>(
          order_of(orders, result.mesh.triangles[t], source_corners(sources[t]), number, operands_[number], known));
    }
  });
  parts_ = collect(sources.size(), [&](std::uint32_t t) { return origin_[t] == part; });
}

void TriangleOrigins::find_turned_parts(const Monitor& monitor) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts_.size(), 256), [&](const auto& range) {
    monitor.check();
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const std::uint32_t t = parts_[i];
      const FaceFrame frame(points_of(sources_[t].operand), source_corners(sources_[t]));
      if (frame.is_opposite(points_, result().triangles[t])) origin_[t] = turned_part;
    }
  });
}

}  // namespace strata
