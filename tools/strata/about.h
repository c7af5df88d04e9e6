#pragma once
#include <string>
#include <vector>

#include "common/exit_code.h"
#include "common/json_report.h"

// What the program says about itself: everything is made from the description of its own parser.

/// A description (common/description.h) as a manual page in the language of man(7). `path`: the verb's words, as
/// {"planar", "union"}; empty: of the program, with a list of its verbs.
[[nodiscard]] std::string manual_page(const Json& program, const std::vector<std::string>& path);

/// Writes one page for the program, one for each verb and one for each verb of a verb into a folder, which is made.
/// Throws std::system_error where this cannot be done.
void write_manual(const Json& program, const std::string& folder);

/// A script that completes verbs, options and their words in `bash`, `zsh` or `fish`.
[[nodiscard]] std::string completion(const Json& program, const std::string& shell);

/// What can be read and written: a table, as text.
[[nodiscard]] ExitCode print_formats();

/// The JSON Schema (draft 2020-12) of a verb's report, with all that it refers to. Throws UsageError with the verbs
/// that have one, where this one has none.
[[nodiscard]] Json report_schema(const std::string& verb);
/// Verbs that write a report, in the order of the alphabet; "planar union" is one.
[[nodiscard]] std::vector<std::string> verbs_with_schema();
