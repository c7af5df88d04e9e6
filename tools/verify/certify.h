#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "verify/run.h"

namespace verify {

/// Completes expected.json from this program's exact result, for cases whose author's knowledge (`known`) agrees and
/// whose result is a valid mesh. Where expected.json says the same already, who else has said so is kept; where it says
/// something else, nothing is written. Verdicts are `exact` for what was written or holds already, else `wrong`.
[[nodiscard]] Run certify(std::vector<Case> cases, const RunOptions& options);

/// Adds an engine to the origin of all cases for which its result is exact. Writes expected.json.
void add_to_origins(const Run& run, std::size_t engine);

/// Asks the oracle (strata-oracle) for every case and compares it with expected.json. Where it agrees, "nef" is added
/// to the origin. Verdicts are `exact`, `wrong` for a contradiction, `oracle_failed`, `timed_out`, and `not_applicable`
/// for inputs that are no solids.
[[nodiscard]] Run recertify(std::vector<Case> cases, const std::filesystem::path& oracle, const RunOptions& options);

}  // namespace verify
