#pragma once
#include <memory>
#include <string>
#include <vector>

#include "verify/engine.h"

namespace verify {

/// This program, `strata eval` in a process of its own: strata (exact results, XOFF), strata-doubles (the same,
/// rounded), layers (exact results of `--engine layers`), strata-python (the Python package), strata-node (the package
/// for JavaScript), strata-chromium (the same in a browser). Null for another name.
[[nodiscard]] std::unique_ptr<Engine> make_strata_engine(const std::string& name, const EngineFolders& folders);

/// NAME=FILE for all operands of a case; those that are no files yet are written to `folder`.
[[nodiscard]] std::vector<std::string> bindings_of(const Case& c, const std::filesystem::path& folder);

}  // namespace verify
