#pragma once
#include <optional>

#include "common/exit_code.h"
#include "common/watch.h"
#include "files.h"
#include "report.h"
#include "reproduction.h"
#include "settings.h"
#include "strata/combine.h"
#include "strata/mesh.h"

/// What all verbs that make a mesh do with it: checks it where asked to, completes the report with the result and the
/// times, writes both. Not certified: says so and tells by the exit code. If that was no matter
/// of rounding, what `verb` asked is kept as a reproduction.
[[nodiscard]] ExitCode write_result(const strata::ExactMesh& exact, const strata::Attributes& attributes,
                                    strata::Format format, Json report, const Settings& settings, Watch& watch,
                                    const char* verb, const Asked& asked);

/// The same for a result of `combine`, which may be measured already, and rounded to the format.
[[nodiscard]] ExitCode write_result(strata::BooleanResult result, strata::Format format, Json report,
                                    const Settings& settings, Watch& watch, const char* verb, const Asked& asked);
