#pragma once
#include <string>

#include "common/json_report.h"
#include "verify/run.h"

namespace verify {

/// {operation, cases, seconds, engines: [{name, outcomes}], tags, findings: [{case, engine, outcome, reason, seconds,
/// peak_bytes}]}.
[[nodiscard]] Json json_report(const Run& run);

/// JUnit XML, a suite per engine: wrong and invalid results are failures, what gave no result is an error, cases that
/// do not apply are skipped.
[[nodiscard]] std::string junit_report(const Run& run);

/// A page of its own: engines by tags, each cell with its cases, every case with pictures of operands and result. Opens
/// from disk, without a network, without scripts. Where `workbench` is the address of that page, cases link to it.
[[nodiscard]] std::string scoreboard(const Run& run, const std::string& workbench = {});

/// A table for the terminal, and what was not as it should be.
[[nodiscard]] std::string summary(const Run& run);

/// Tags of the run's cases, the most frequent first.
[[nodiscard]] std::vector<std::string> tags_of(const Run& run);

/// A text for XML and HTML.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace verify
