#include "core/attributes/triangle_origins.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <stdexcept>
#include <string>

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

}  // namespace

TriangleOrigins::TriangleOrigins(std::span<const AttributedMesh> operands, ExactMeshView result,
                                 std::span<const Source> sources, bool may_turn, const Monitor& monitor)
    : points_(result), sources_(sources), may_turn_(may_turn), origin_(sources.size()) {
  operands_.reserve(operands.size());
  for (const AttributedMesh& o : operands) operands_.emplace_back(o.mesh);
  if (sources.size() != result.mesh.triangles.size())
    throw std::invalid_argument(std::to_string(sources.size()) + " sources of " +
                                std::to_string(result.mesh.triangles.size()) + " triangles");
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, sources.size(), 1 << 13), [&](const auto& range) {
    monitor.check();
    for (std::size_t t = range.begin(); t != range.end(); ++t) {
      require_source(operands_, sources[t]);
      require_vertices(result.mesh, result.mesh.triangles[t]);
      origin_[t] = origin_of(t);
    }
  });
  parts_ = collect(sources.size(), [&](std::uint32_t t) { return origin_[t] == part; });
}

std::uint8_t TriangleOrigins::origin_of(std::size_t triangle) const {
  const MeshPoints& operand = operands_[sources_[triangle].operand];
  const Triangle &t = result().triangles[triangle], &source = source_corners(sources_[triangle]);
  for (std::uint8_t n = 0; n < orders.size(); ++n) {
    bool is_equal = true;
    for (std::size_t k = 0; k < 3 && is_equal; ++k)
      is_equal = MeshPoints::are_equal(points_, t[k], operand, source[orders[n][k]]);
    if (is_equal) return n;
  }
  return part;
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
