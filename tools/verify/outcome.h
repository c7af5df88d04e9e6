#pragma once
#include <array>
#include <string>
#include <string_view>

namespace verify {

/// What became of a case. From exact to wrong by how much is known of the result, then those without a result.
enum class Outcome {
  exact,           ///< equal as a point set, and a valid mesh
  rounded,         ///< volume, area and topology are right within rounding, and the mesh is valid
  collapsed,       ///< another solid, and the engine says that its numbers cannot hold some feature; the mesh is valid
  wrong,           ///< another solid
  invalid,         ///< no boundary of a solid: open, crossing or coinciding faces, inverted
  refused,         ///< the engine says that it has no result
  crashed,         ///< it ended otherwise than it should, or ran out of memory
  timed_out,       ///< it was stopped
  oracle_failed,   ///< nobody knows what is right
  not_applicable,  ///< the engine cannot be given the operands, or has no such operation
};

inline constexpr std::array all_outcomes = {
    Outcome::exact,   Outcome::rounded, Outcome::collapsed, Outcome::wrong,         Outcome::invalid,
    Outcome::refused, Outcome::crashed, Outcome::timed_out, Outcome::oracle_failed, Outcome::not_applicable};

[[nodiscard]] std::string_view name(Outcome outcome);  ///< "timed out"

/// An outcome and one sentence about it; empty for `exact`.
struct Verdict {
  Outcome outcome = Outcome::exact;
  std::string reason;
};

}  // namespace verify
