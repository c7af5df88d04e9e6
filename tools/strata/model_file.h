#pragma once
#include "common/exit_code.h"
#include "settings.h"

/// Evaluates what OpenSCAD wrote (.csg), or has it written first (.scad), and writes the solid or the shape. Notes go
/// to stderr unless quiet. Throws strata::IoError for what cannot be read, UsageError where the output has the wrong
/// dimension.
[[nodiscard]] ExitCode run_model_file(Settings& settings);
