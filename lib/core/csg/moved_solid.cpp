#include <array>
#include <utility>

#include "core/csg/solid_data.h"
#include "strata/carry_attributes.h"

namespace strata {
Solid Solid::transformed(const Transform& map, Placement placement, const Monitor& monitor) const {
  const bool is_rounded = placement == Placement::rounded;
  if (map.is_identity() && (!is_rounded || exact_mesh().exact.empty())) return *this;
  ExactMesh image = transform(exact_mesh(), map, placement, monitor);
  Shared<Attributes> moved;
  if (data_->attributes) moved = Shared<Attributes>::make(transform(*data_->attributes, map));
  if (!is_rounded) return Solid(Shared<Data>::make(Data{std::move(image), sources(), notes(), std::move(moved)}));
  Options options;
  options.cancel = monitor.token();
  const Solid rounded(image.mesh, options);  // checked again: triangles may have lost their area
  if (moved && rounded.mesh() != image.mesh)
    moved = Shared<Attributes>::make(
        carry_attributes(std::array{AttributedMesh{image, moved.get()}}, rounded.exact_mesh(), rounded.sources()));
  std::vector<Source> origins;
  origins.reserve(rounded.sources().size());
  for (const Source& s : rounded.sources()) origins.push_back(sources()[s.face]);
  return Solid(Shared<Data>::make(Data{rounded.exact_mesh(), std::move(origins), rounded.notes(), std::move(moved)}));
}

Solid Solid::translated(const RationalPoint& by) const { return transformed(Transform::translation(by)); }
Solid Solid::scaled(const RationalPoint& factors) const { return transformed(Transform::scaling(factors)); }
Solid Solid::scaled(const Rational& factor) const { return scaled(RationalPoint{factor, factor, factor}); }
Solid Solid::mirrored(const RationalPoint& normal) const { return transformed(Transform::mirror(normal)); }
Solid Solid::mirrored(const Plane& plane) const { return transformed(Transform::mirror(plane)); }
Solid Solid::rotated(const Quaternion& by) const { return transformed(Transform::rotation(by)); }
Solid Solid::rotated(const std::array<double, 3>& axis, double degrees, Placement placement) const {
  return transformed(Transform::rotation(Quaternion::of_angle(axis, degrees)), placement);
}

}  // namespace strata
