#pragma once
#include <string_view>

#include "common/json_report.h"

/// True for verify and fuzz, verbs that the program `strata-verify` has.
[[nodiscard]] bool is_suite_verb(std::string_view verb);

/// Replaces this process by `strata-verify` with the same arguments. Returns only where there is no such program, with
/// the exit code for files; says so.
[[nodiscard]] int become_suite(char** arguments);

/// The verbs that `strata-verify` describes, as `describe` does; an empty list where there is no such program.
[[nodiscard]] Json suite_description();
