#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "strata/mesh.h"
#include "strata/monitor.h"
#include "strata/solid.h"

/// A solid in the viewer, with what its list says of it.
struct ViewerPart {
  std::string name;
  strata::Solid solid;
  std::vector<std::pair<std::string, std::string>> facts;  ///< names and values
  bool is_shown = true;
};

/// A page that shows solids, which can be turned, hidden and cut. It has everything inside, and loads nothing. Edges
/// are those of the maximal facets, exactly. Coordinates in it are floats, relative to the middle of all parts. Throws
/// Cancelled. O(n log n).
[[nodiscard]] std::string viewer_page(const std::string& title, const std::vector<ViewerPart>& parts,
                                      const strata::Monitor& monitor);
