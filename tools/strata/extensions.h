#pragma once
#include <vector>

#include "common/exit_code.h"
#include "settings.h"
#include "strata/expression.h"

// What verbs of the core take from extensions, if this build has them.

/// Engines of `--engine` beside the arrangement: for Booleans, for formulas, and for points to be located.
[[nodiscard]] std::vector<const strata::Engine*> boolean_engines();
[[nodiscard]] std::vector<const strata::Engine*> formula_engines();
[[nodiscard]] std::vector<const strata::Engine*> locating_engines();

/// A model of OpenSCAD, evaluated. Throws UsageError without the extension openscad, else as `run_model_file`.
[[nodiscard]] ExitCode run_model(Settings& settings);
