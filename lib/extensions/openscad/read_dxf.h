#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "extensions/openscad/tessellation.h"
#include "strata/planar.h"

namespace strata::openscad {

/// Which part of a drawing is taken, and where it goes.
struct DxfPlacement {
  std::string layer;  ///< its name; empty: all layers
  planar::PlanePoint origin{};
  double scale = 1;  ///< after the origin is moved to 0 0
};

struct DxfShapes {
  planar::Region region;
  std::vector<std::string> notes;
};

/// The shape that the lines of a drawing enclose, as OpenSCAD reads it: LINE, POLYLINE,
/// LWPOLYLINE, CIRCLE, ARC, ELLIPSE and
/// INSERT; curves have the sides of circles. Lines whose ends are in the same or neighbouring squares of a grid of
/// 0.001 are joined there, because drawings do not repeat coordinates exactly; chains that do not close are left out,
/// with a note. Closed ones are filled by parity. Throws IoError with the line of what is no DXF.
[[nodiscard]] DxfShapes read_dxf(std::string_view text, const DxfPlacement& placement, const Resolution& resolution);

}  // namespace strata::openscad
