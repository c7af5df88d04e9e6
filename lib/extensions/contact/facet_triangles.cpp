#include "core/io/exact_polygon.h"
#include "strata/contact.h"
#include "strata/errors.h"
#include "strata/rational.h"

namespace strata::contact {

FacetTriangles triangles_of(const ContactRegion& region) {
  std::vector<Vertex> rounded;
  std::vector<ExactVertex> exact;
  for (std::uint32_t n = 0; n < region.points.size(); ++n) {
    const RationalPoint& p = region.points[n];
    rounded.push_back({to_nearest_double(p[0]), to_nearest_double(p[1]), to_nearest_double(p[2])});
    exact.push_back({n, p});
  }
  FacetTriangles result;
  for (std::uint32_t f = 0; f < region.facets.size(); ++f) {
    io::LoopFace face;
    for (const auto& loop : region.facets[f].loops) {
      face.corners.insert(face.corners.end(), loop.begin(), loop.end());
      face.ends.push_back(face.corners.size());
    }
    const std::string wrong = io::divide_face(face, {rounded, exact}, result.triangles);
    if (!wrong.empty()) throw LogicError("a contact " + wrong);
    result.facet_of.resize(result.triangles.size(), f);
  }
  return result;
}

}  // namespace strata::contact
