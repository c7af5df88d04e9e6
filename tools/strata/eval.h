#pragma once
#include "common/exit_code.h"
#include "common/stopwatch.h"
#include "common/watch.h"
#include "files.h"
#include "report.h"
#include "reproduction.h"
#include "settings.h"
#include "strata/expression.h"

/// Evaluates an expression, and writes the solid and the report; `read` is what is measured before.
[[nodiscard]] ExitCode evaluate_and_write(const strata::Expression& expression, const Json& operands, Json report,
                                          Settings& settings, Watch& watch, Stopwatch& stopwatch,
                                          const Asked& question);
