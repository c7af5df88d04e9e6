#pragma once
#include <memory>
#include <string>
#include <vector>

#include "verify/engine.h"

namespace verify {

/// This program: `strata eval` in a process of its own. Results are exact files (XOFF), or OFF files in doubles.
[[nodiscard]] std::unique_ptr<Engine> make_strata_engine(bool doubles);

/// NAME=FILE for all operands of a case; those that are no files yet are written to `folder`.
[[nodiscard]] std::vector<std::string> bindings_of(const Case& c, const std::filesystem::path& folder);

}  // namespace verify
