#pragma once
/// Sections of solids by planes, as polygons in the plane (planar.h). Exact.
///
///   const planar::Region outline = section(part, {{0, 0, 1}, 0.2});
///   slice(part, 2, heights, [&](std::size_t layer, const planar::Region& region) { print(layer, region); });
///
/// What holds in a plane that contains faces or touches the solid: the section is the limit of sections by planes in
/// front of it, moved back. So faces in the plane belong to it where the solid is in front of them (the bottom of a
/// box, seen from above), and not where it is behind them (its top): consecutive layers of a solid are closed below and
/// open above. Edges and vertices in which the solid touches the plane have no area, and are in no section.
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "strata/function.h"
#include "strata/options.h"
#include "strata/planar.h"
#include "strata/plane.h"
#include "strata/rational.h"
#include "strata/solid.h"

namespace strata {

/// The axes of space that are the coordinates of a plane's points. The third coordinate follows from the plane.
struct PlaneAxes {
  std::size_t u = 0, v = 1, left_out = 2;
};

/// Left out is the first axis along which the normal is longest; u and v turn counter-clockwise as seen from in front
/// of the plane. So z = h has the coordinates x, y; -z = h has y, x; a section has its true area along a coordinate
/// axis, else that of its projection. Throws std::invalid_argument for a normal 0.
[[nodiscard]] PlaneAxes axes_of(const Plane& plane);

/// The point of space with these coordinates in a plane.
[[nodiscard]] RationalPoint point_in(const Plane& plane, const planar::RationalPlacement& p);

/// The true area of a part of a plane from that of its projection, along the axis left out, to an ulp or two.
[[nodiscard]] double true_area(const Plane& plane, const Rational& projected);

/// The section of a solid by a plane: its open regular set of points, in the coordinates `axes_of(plane)`.
/// Laws: that of a union is the union of sections, and so on for all Booleans; that of the opposite plane has the same
/// area but for faces in the plane. Of the options, `cancel` is used. O(n) to find faces that cross the plane, and
/// O(k log k) for k of them. Throws std::invalid_argument for a normal 0, Cancelled.
[[nodiscard]] planar::Region section(const Solid& solid, const Plane& plane, const Options& options = {});

/// The sections by planes perpendicular to an axis (0, 1, 2), at coordinates that do not decrease. Coordinates in the
/// plane are those of `axes_of` for the axis's positive direction. `visit` is called for every plane, in order, from
/// one thread at a time, also where the section is empty. Planes are cut in parallel, in batches, so that what is
/// waiting is bounded whatever their number. Uses threads, progress, cancel. O(n + k log k) for n faces and k crossings
/// of faces and planes. Requires that the boundary meets itself in common vertices and edges only, as in results of
/// operations, and as `check` finds. A mesh that was taken at its word (InputClass::solid) may cross itself, or touch
/// itself elsewhere: then loops do, too. Throws std::invalid_argument for coordinates that decrease or are not finite,
/// and for another axis; Cancelled; what `visit` throws.
void slice(const Solid& solid, std::size_t axis, std::span<const double> coordinates,
           FunctionRef<void(std::size_t plane, planar::Region region)> visit, const Options& options = {});

/// The same in a list.
[[nodiscard]] std::vector<planar::Region> slice(const Solid& solid, std::size_t axis,
                                                std::span<const double> coordinates, const Options& options = {});

}  // namespace strata
