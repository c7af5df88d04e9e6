#pragma once
#include <optional>
#include <string>

#include "common/exit_code.h"
#include "settings.h"
#include "strata/planar.h"

/// What `strata planar` asks for beside the common settings.
struct PlanarSettings {
  std::string fill;            ///< even-odd, nonzero, positive, negative; empty: what the files mean
  bool by_partitions = false;  ///< Booleans by binary space partitions of the plane
};

/// Booleans of polygons in files: `name` is the operation as it stands in the report.
[[nodiscard]] ExitCode run_planar(strata::planar::Operation operation, const char* name, const PlanarSettings& planar,
                                  const Settings& settings);

/// Where the loops of a file meet themselves.
[[nodiscard]] ExitCode run_planar_check(const Settings& settings);

/// Areas, components, holes of what a file fills.
[[nodiscard]] ExitCode run_planar_info(const PlanarSettings& planar, const Settings& settings);

/// Every polygon of what a file fills as one loop, its holes joined to it by bridges.
[[nodiscard]] ExitCode run_planar_bridge(const PlanarSettings& planar, const Settings& settings);

/// Which points (CSV: x, y) are in, on or out of what a file fills.
[[nodiscard]] ExitCode run_planar_locate(const PlanarSettings& planar, const Settings& settings);

/// Which of what files fill interfere, touch or are apart, and where they touch.
[[nodiscard]] ExitCode run_planar_contacts(const PlanarSettings& planar, const Settings& settings);

/// The canonical decomposition of the plane by every polygon that a file fills: faces, edges and vertices.
[[nodiscard]] ExitCode run_planar_decompose(const PlanarSettings& planar, const Settings& settings);
