#include "extensions/contact/shared_pieces.h"

#include <algorithm>

#include "core/kernel/predicates.h"
#include "extensions/contact/common_points.h"
#include "extensions/contact/near_pairs.h"

namespace strata::contact {
namespace {

SharedPieces::Segment segment(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// Sorts the corners of a convex polygon in the plane of a face counter-clockwise, as seen from its outer side.
void sort_around(const InputComplex& input, const Places& places, std::uint32_t face, SharedPieces::Polygon& corners) {
  const Projection projection = projection_of(input, face);
  const std::uint32_t first = corners.front();
  std::sort(corners.begin() + 1, corners.end(), [&](std::uint32_t p, std::uint32_t q) {
    return p != q &&
           orient2d(input, projection, places.point(first), places.point(p), places.point(q)) == Sign::positive;
  });
}

}  // namespace

SharedPieces shared_pieces(const Parts& parts, std::uint32_t a, std::uint32_t b, const Monitor& monitor) {
  const InputComplex& input = parts.input();
  SharedPieces pieces{Places(input), {}, {}, {}, {}};
  std::set<std::uint32_t> corners;
  for_each_meeting(parts, a, b, monitor,
                   [&](const FilteredFace& f, const FilteredFace&, const PairIntersections& intersections) {
                     SharedPieces::Polygon shared;
                     for (const SymbolicPoint& name : common_points(input, intersections))
                       shared.push_back(pieces.places.number(name));
                     std::sort(shared.begin(), shared.end());
                     shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
                     if (shared.size() == 1) {
                       pieces.points.insert(shared[0]);
                     } else if (shared.size() == 2) {
                       pieces.segments.insert(segment(shared[0], shared[1]));
                     } else {
                       sort_around(input, pieces.places, f.face, shared);
                       for (std::size_t i = 0; i < shared.size(); ++i)
                         pieces.sides.insert(segment(shared[i], shared[(i + 1) % shared.size()]));
                       pieces.polygons.push_back(std::move(shared));
                     }
                     return true;
                   });
  for (const auto& [p, q] : pieces.sides) corners.insert({p, q});
  std::erase_if(pieces.segments, [&](const auto& s) { return pieces.sides.contains(s); });
  for (const auto& [p, q] : pieces.segments) corners.insert({p, q});
  std::erase_if(pieces.points, [&](std::uint32_t p) { return corners.contains(p); });
  return pieces;
}

}  // namespace strata::contact
