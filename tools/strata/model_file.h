#pragma once
#include "settings.h"
#include "strata/expression.h"

/// The expression of the model that `settings.expression` names, as OpenSCAD wrote it (.csg). Throws strata::IoError.
[[nodiscard]] strata::Expression read_model_file(const Settings& settings);
