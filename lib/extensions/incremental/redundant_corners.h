#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/overlap/point_table.h"
#include "extensions/incremental/face_planes.h"

namespace strata {

/// A triangle of a result, by points of an evaluation, and the face of which it is a part.
struct ResultTriangle {
  std::array<PointId, 3> v{};
  std::uint32_t face = 0;
  bool reversed = false;   ///< it has the opposite orientation of its face
  bool untouched = false;  ///< it is its face
};

/// The planes that meet in a point that is named by them, or none.
using MeetingPlanes = std::array<PlanePointer, 3>;

/// Removes corners that a result does not need: those of `candidates` all of whose faces lie in planes through one
/// line. The faces around them are triangulated again. The remaining candidates are vertices of the result as a point
/// set, where three of its planes meet, so the planes bound the size of their coordinates.
///
/// Requires that `triangles` contains all faces around the candidates, whose numbers are below `points.end()`. A corner
/// at which sheets meet that do not share their edges is kept, and so is one at which triangles of one plane are parts
/// of faces with different attributes, which `origins` tells of the faces; empty: there are none. Returns the planes of
/// the kept candidates, in their order; none where no three planes determine the point. O(k d log d) for k candidates
/// with d triangles around them each, for bounded d; O(d^3) for one of them in the worst case.
std::vector<MeetingPlanes> remove_redundant_corners(const InputComplex& input, const PointTable& points,
                                                    FacePlanes& planes, const std::vector<PointId>& candidates,
                                                    std::vector<ResultTriangle>& triangles,
                                                    const std::vector<FaceOrigin>& origins);

}  // namespace strata
