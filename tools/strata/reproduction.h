#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "common/write_case.h"
#include "settings.h"
#include "strata/errors.h"
#include "strata/options.h"

/// What a verb asked of the library, for whoever looks for the error: made only when there is one. Meshes that it
/// points to must outlive it.
using Asked = std::function<verify::NewCase()>;

/// "s0 | s1 | s2" for operands that are called so.
[[nodiscard]] std::string joined_expression(strata::Operation operation, std::size_t count);

/// Writes a case to a new folder strata-reproduction-<n>, in $STRATA_REPRODUCTIONS or else in the current folder.
/// Overwrites nothing. Returns a sentence that names the folder, or says why it cannot be written; throws nothing.
[[nodiscard]] std::string keep_reproduction(const Asked& asked, const char* verb, const std::string& error,
                                            const Settings& settings) noexcept;

/// For tests of this file alone: throws LogicError if $STRATA_TEST_LOGIC_ERROR is set. Nobody else sets it.
void provoke_logic_error();

/// Calls `work`. A LogicError, which is our fault, is thrown on with a sentence that names the reproduction.
template <class Work>
auto with_reproduction(const Asked& asked, const char* verb, const Settings& settings, const Work& work) {
  try {
    provoke_logic_error();
    return work();
  } catch (const strata::LogicError& error) {
    throw strata::LogicError(std::string(error.what()) + ". " + keep_reproduction(asked, verb, error.what(), settings));
  }
}
