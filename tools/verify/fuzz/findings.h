#pragma once
#include <filesystem>
#include <string>

#include "verify/fuzz/search.h"

namespace fuzz {

/// A finding: what is broken where.
struct Finding {
  Round round;
  std::string engine;
  Broke broke;
  Question question;
};

/// strata fuzz --seed S --round K: asks the round again.
[[nodiscard]] std::string replay_command(const Finding& finding);

/// Writes a finding as a new case folder below `keep`, which is made. expected.json is written only if the oracle,
/// where there is one, has the same result as this program; else `why` says that nobody has said what is right. Nothing
/// is overwritten: a number makes the name new. Returns the folder.
[[nodiscard]] std::filesystem::path keep_finding(const Finding& finding, const std::filesystem::path& keep,
                                                 const std::filesystem::path& oracle, const verify::Limits& limits);

}  // namespace fuzz
