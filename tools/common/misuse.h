#pragma once
#include <string>

#include "common/usage_error.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

/// What to say about a command line that was not understood: what is wrong, the word that was probably meant, and
/// what to type. Several lines, which end with a newline.
[[nodiscard]] std::string explain_misuse(const CLI::App& app, const CLI::ParseError& error);
/// The same for what the verb that was named found out itself.
[[nodiscard]] std::string explain_misuse(const CLI::App& app, const UsageError& error);
