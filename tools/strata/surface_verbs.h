#pragma once
#include <string>
#include <vector>

#include "common/exit_code.h"
#include "settings.h"
#include "strata/surface.h"

/// What the verbs of surfaces ask for beside the common settings.
struct SurfaceSettings {
  strata::ClipTo keep = strata::ClipTo::inside;
  std::vector<std::string> planes;  ///< a,b,c,d: the points with a x + b y + c z = d
  bool walls = false;               ///< write the walls between cells
};

/// The part of a surface in, on or outside a solid.
[[nodiscard]] ExitCode run_clip(const SurfaceSettings& surface, const Settings& settings);

/// The pieces into which surfaces and planes divide a solid.
[[nodiscard]] ExitCode run_split(const SurfaceSettings& surface, const Settings& settings);

/// Surfaces with the traces of one another as edges.
[[nodiscard]] ExitCode run_imprint(const Settings& settings);

/// What surfaces enclose together.
[[nodiscard]] ExitCode run_cells(const SurfaceSettings& surface, const Settings& settings);
