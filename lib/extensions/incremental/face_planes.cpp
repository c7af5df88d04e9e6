#include "extensions/incremental/face_planes.h"

#include "core/kernel/approximation.h"
#include "core/kernel/exact_evaluation.h"
#include "core/kernel/point.h"

namespace strata {
namespace {

PlanePointer plane_through_corners(const InputComplex& input, std::uint32_t face) {
  const auto corners = input.face(face);
  std::array<Point, 3> points;
  for (std::size_t i = 0; i < 3; ++i) points[i] = make_point(input, SymbolicPoint::input(corners[i]));
  const std::array<const Point*, 3> list{&points[0], &points[1], &points[2]};
  const Ground ground(input, list);
  const ExactEvaluation<Integer> exact(input, ground.lattice());
  return std::make_shared<const SourcePlane>(exact.face(face), ground.lattice().unit(), points[0].fine);
}

}  // namespace

const PlanePointer& FacePlanes::of(std::uint32_t face, bool reversed) {
  PlanePointer& plane = planes_[std::size_t{2} * face];
  if (plane == nullptr) plane = plane_through_corners(input_, face);
  if (!reversed) return plane;
  PlanePointer& other = planes_[std::size_t{2} * face + 1];
  if (other == nullptr) other = std::make_shared<const SourcePlane>(plane->reversed());
  return other;
}

}  // namespace strata
