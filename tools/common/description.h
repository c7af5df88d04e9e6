#pragma once
#include <string>
#include <vector>

#include "common/json_report.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// What a program understands, from its own parser: the one source of manual pages, completions, the reference of the
/// site and the messages about misuse.
///
///   {name, about, aliases, operands, options, examples, more, verbs}
///   operand: {name, about, least, most}              most is null: any number
///   option:  {names, about, value, choices, default, required, flag}
///
/// `verbs` are described in the same way. Hidden verbs and options are left out.
[[nodiscard]] Json describe(const CLI::App& app);

/// The words that an option takes; empty where it takes more than a list of words.
[[nodiscard]] std::vector<std::string> choices(const CLI::Option& option);

/// What stands for the value of an option, without its choices: OUT, SECONDS.
[[nodiscard]] std::string value_name(const CLI::Option& option);

/// The lines under "Example:" or "Examples:" of a help text.
[[nodiscard]] std::vector<std::string> examples(const CLI::App& app);
