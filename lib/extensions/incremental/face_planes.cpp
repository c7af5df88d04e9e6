#include "extensions/incremental/face_planes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <memory>

#include "core/kernel/approximation.h"
#include "core/kernel/exact_evaluation.h"
#include "core/kernel/point.h"

namespace strata {
namespace {

/// In long integers if they can represent it.
HPlane<Integer> exact_plane(const InputComplex& input, const Lattice& lattice, std::uint32_t face) {
  auto p = in_integers(ExactEvaluation<LongInt>(input, lattice).face(face));
  return p ? *std::move(p) : ExactEvaluation<Integer>(input, lattice).face(face);
}

PlanePointer plane_through_corners(const InputComplex& input, std::uint32_t face) {
  const auto corners = input.face(face);
  std::array<Point, 3> points;
  for (std::size_t i = 0; i < 3; ++i) points[i] = make_point(input, SymbolicPoint::input(corners[i]));
  const std::array<const Point*, 3> list{&points[0], &points[1], &points[2]};
  const Ground ground(input, list);
  return std::make_shared<const SourcePlane>(exact_plane(input, ground.lattice(), face), ground.lattice().unit(),
                                             points[0].fine);
}

}  // namespace

void FacePlanes::compute(std::span<const OrientedFace> faces) {
  std::vector<char> is_wanted(planes_.size());
  for (const OrientedFace& f : faces) is_wanted[place(f)] = 1;
  constexpr std::size_t at_once = 16;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, input_.face_count(), at_once), [&](const auto& range) {
    for (std::size_t f = range.begin(); f != range.end(); ++f)
      for (const bool reversed : {false, true})
        if (is_wanted[2 * f + (reversed ? 1 : 0)]) static_cast<void>(of({static_cast<std::uint32_t>(f), reversed}));
  });
}

const PlanePointer& FacePlanes::of(OrientedFace face) {
  PlanePointer& plane = planes_[place({face.face, false})];
  if (plane == nullptr) plane = plane_through_corners(input_, face.face);
  if (!face.reversed) return plane;
  PlanePointer& other = planes_[place(face)];
  if (other == nullptr) other = std::make_shared<const SourcePlane>(plane->reversed());
  return other;
}

}  // namespace strata
