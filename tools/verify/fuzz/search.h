#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verify/child.h"
#include "verify/fuzz/question.h"

namespace fuzz {

/// How questions are asked: each in a process of its own, so that crashes and hangs are findings.
struct Asking {
  std::string program;             ///< this one
  std::vector<std::string> words;  ///< options that go on to every process
  verify::Limits limits;           ///< of a process
};

/// A check that does not hold; `crash`, `hang`, `memory` and `error` are checks, too.
struct Broke {
  std::string check, reason;
};

/// What became of a question.
struct Reply {
  bool is_asked = true;  ///< false: the operands are no solids, or the engine cannot be asked
  std::optional<Broke> broke;
};

/// Asks one engine, all checks, or only one of them.
[[nodiscard]] Reply ask(const Question& question, const std::string& engine, const Asking& asking,
                        const std::string& only = {});

/// The smallest question found within some seconds for which the same check does not hold.
[[nodiscard]] Question shrunken(const Question& question, const std::string& engine, const std::string& check,
                                const Asking& asking, double seconds);

}  // namespace fuzz
