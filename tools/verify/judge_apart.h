#pragma once
#include <filesystem>

#include "verify/case.h"
#include "verify/child.h"
#include "verify/outcome.h"

namespace verify {

/// `judge_file` in a process of its own, for an engine with this unit roundoff: a result that brings the judge down, or
/// is too large for it, ends its case and no other, as `oracle_failed`. Files go to `folder`. Safe to call from many
/// threads.
[[nodiscard]] Verdict judge_apart(const std::filesystem::path& file, const Case& c, double unit_roundoff,
                                  const Limits& limits, const std::filesystem::path& folder);

}  // namespace verify
