#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "extensions/openscad/tessellation.h"
#include "strata/planar.h"

namespace strata::openscad {

/// Which part of a picture is taken, and where it goes.
struct SvgPlacement {
  double dots_per_inch = 72;  ///< of a picture without units
  bool is_centred = false;    ///< the middle of its box is moved to 0 0
  std::string id, layer;      ///< only what is in the element of that id, or in the layer of that name; empty: all
};

struct SvgShapes {
  planar::Region region;
  std::vector<std::string> notes;
};

/// The union of what the shapes of a picture fill, in millimetres, y upwards: path, rect, circle, ellipse, polygon and
/// polyline under any transformations. Each is filled by its own rule (nonzero, unless fill-rule says evenodd). Curves
/// are divided by $fn: circles and arcs have $fn sides in a full turn (40 without), Bezier curves $fn parts (20
/// without). Strokes, text, images and uses are left out, with a note. Throws IoError for what is no XML and for path
/// data that breaks off, with the place.
[[nodiscard]] SvgShapes read_svg(const std::string& text, const SvgPlacement& placement, const Resolution& resolution);

}  // namespace strata::openscad
