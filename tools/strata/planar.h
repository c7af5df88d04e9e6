#pragma once
#include <optional>
#include <string>

#include "exit_code.h"
#include "settings.h"
#include "strata/planar.h"

/// What `strata planar` asks for beside the common settings.
struct PlanarSettings {
  std::string fill;  ///< even-odd, nonzero, positive, negative; empty: what the files mean
};

/// Booleans of polygons in files: `name` is the operation as it stands in the report.
[[nodiscard]] ExitCode run_planar(strata::planar::Operation operation, const char* name, const PlanarSettings& planar,
                                  const Settings& settings);

/// Where the loops of a file meet themselves.
[[nodiscard]] ExitCode run_planar_check(const Settings& settings);

/// Areas, components, holes of what a file fills.
[[nodiscard]] ExitCode run_planar_info(const PlanarSettings& planar, const Settings& settings);
