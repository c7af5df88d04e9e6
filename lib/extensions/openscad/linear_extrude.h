#pragma once
#include <array>
#include <optional>

#include "extensions/openscad/tessellation.h"
#include "strata/options.h"
#include "strata/planar.h"
#include "strata/solid.h"

namespace strata::openscad {

/// The arguments of OpenSCAD's linear_extrude.
struct LinearExtrusion {
  Vertex along{0, 0, 100};  ///< from the lower end to the upper one
  bool is_centred = false;
  double twist = 0;                       ///< degrees, clockwise as seen from above
  std::array<double, 2> scale{1, 1};      ///< at the upper end; not negative
  std::optional<std::uint32_t> slices;    ///< none: chosen by the resolution
  std::optional<std::uint32_t> segments;  ///< of every outline, at least; none: its own
  Resolution resolution;
};

/// How many layers an extrusion of that region has.
[[nodiscard]] std::uint32_t slices_of(const planar::Region& region, const LinearExtrusion& extrusion);

/// The solid between a region and its images, layer by layer. Without a twist the region's vertices are scaled and
/// moved exactly; with one they are rounded to doubles and turned in doubles. Between two layers each edge makes two
/// triangles, along the shorter diagonal. Where faces cross then (a twist of some steps), the solid is what they wind
/// around. A scale of 0 in one direction or in both makes a ridge or a point. Requires finite arguments and a height
/// that is not 0. Throws std::length_error beyond ten million corners, what Solid throws.
[[nodiscard]] Solid linear_extrude(const planar::Region& region, const LinearExtrusion& extrusion,
                                   const Options& options);

}  // namespace strata::openscad
