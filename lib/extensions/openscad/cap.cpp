#include "extensions/openscad/cap.h"

#include <map>
#include <string>
#include <utility>

#include "core/io/exact_polygon.h"
#include "extensions/openscad/rational_mesh.h"
#include "strata/errors.h"

namespace strata::openscad {

Cap cap_of(const planar::Region& region) {
  Cap cap;
  std::map<std::uint32_t, std::uint32_t> number_of;
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    auto& loop = cap.loops.emplace_back();
    for (const std::uint32_t v : region.loops.loop(l)) {
      const auto [at, is_new] = number_of.try_emplace(v, static_cast<std::uint32_t>(cap.exact.size()));
      if (is_new) {
        cap.exact.push_back(position(region, v));
        cap.nearest.push_back(region.loops.places.place[v]);
      }
      loop.push_back(at->second);
    }
  }
  for (std::uint32_t p = 0; p < region.polygons(); ++p) cap.loops_of_polygon.push_back(1 + region.holes(p));
  return cap;
}

std::vector<Triangle> triangles_of(const Cap& cap) {
  VertexCollector flat;
  for (const auto& p : cap.exact) flat.add(RationalPoint{p[0], p[1], 0});
  std::vector<Triangle> triangles;
  std::size_t next = 0;
  for (const std::uint32_t count : cap.loops_of_polygon) {
    io::LoopFace face;
    for (std::uint32_t l = 0; l < count; ++l, ++next) {
      face.corners.insert(face.corners.end(), cap.loops[next].begin(), cap.loops[next].end());
      face.ends.push_back(face.corners.size());
    }
    const std::string defect = io::divide_face(face, {flat.mesh().mesh.vertices, flat.mesh().exact}, triangles);
    if (!defect.empty()) throw LogicError("a polygon of a region " + defect);
  }
  return triangles;
}

}  // namespace strata::openscad
