#include "extensions/contact/shared_pieces.h"

#include <algorithm>

#include "core/kernel/predicates.h"
#include "extensions/contact/common_points.h"
#include "extensions/contact/near_pairs.h"

namespace strata::contact {
namespace {

SharedPieces::Segment segment(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// Sorts a list, and leaves each member once.
template <class T>
void make_set(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Takes the members of one sorted list out of another.
template <class T>
void take_out(std::vector<T>& list, const std::vector<T>& others) {
  std::erase_if(list, [&](const T& x) { return std::binary_search(others.begin(), others.end(), x); });
}

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
  for_each_meeting(parts, a, b, monitor,
                   [&](const FilteredFace& f, const FilteredFace&, const PairIntersections& intersections) {
                     SharedPieces::Polygon shared;
                     for (const SymbolicPoint& name : common_points(input, intersections))
                       shared.push_back(pieces.places.number(name));
                     make_set(shared);
                     if (shared.size() == 1) {
                       pieces.points.push_back(shared[0]);
                     } else if (shared.size() == 2) {
                       pieces.segments.push_back(segment(shared[0], shared[1]));
                     } else {
                       sort_around(input, pieces.places, f.face, shared);
                       for (std::size_t i = 0; i < shared.size(); ++i)
                         pieces.sides.push_back(segment(shared[i], shared[(i + 1) % shared.size()]));
                       pieces.polygons.push_back(std::move(shared));
                     }
                     return true;
                   });
  monitor.check();
  make_set(pieces.sides);
  make_set(pieces.segments);
  make_set(pieces.points);
  take_out(pieces.segments, pieces.sides);
  std::vector<std::uint32_t> corners;
  for (const auto* segments : {&pieces.sides, &pieces.segments})
    for (const SharedPieces::Segment& s : *segments) corners.insert(corners.end(), s.begin(), s.end());
  make_set(corners);
  take_out(pieces.points, corners);
  return pieces;
}

}  // namespace strata::contact
