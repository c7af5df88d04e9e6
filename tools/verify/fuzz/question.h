#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "support/recipe.h"
#include "verify/case.h"

namespace fuzz {

/// Which round: a number in the sequence that a seed begins.
struct Round {
  std::uint64_t seed = 0;
  std::uint64_t number = 0;
};

/// What engines are asked in a round: an expression about solids s0, s1, ... without maps.
struct Question {
  strata::test::Recipe recipe;
  std::string kind;  ///< how its solids were made: "feature on feature, neighbours"
};

/// A random expression of depth up to 5 about solids that love to touch: on one lattice, through one point or line,
/// copies, one ulp apart, tiny, huge, slivers, with parts listed apart. The same round gives the same question on every
/// machine. Nearly always its operands are solids; whoever asks it must check.
[[nodiscard]] Question question_of(const Round& round);

/// Triangles of all solids that occur.
[[nodiscard]] std::size_t face_count(const Question& question);

/// Writes a case: case.json and the solids, as OFF where doubles hold them, else as XOFF; all bits are kept. The folder
/// is made. Throws strata::IoError, std::filesystem::filesystem_error.
void write_case(const std::filesystem::path& folder, const Question& question, const std::string& why,
                const std::vector<std::string>& tags);

}  // namespace fuzz
