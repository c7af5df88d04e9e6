#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "verify/case.h"
#include "verify/fuzz/evaluator.h"

namespace fuzz {

/// A program that is asked what is right: strata-oracle. Empty path: there is none.
struct Oracle {
  std::filesystem::path program;
  verify::Limits limits;
};

/// The checks, by name, in the order in which they are made:
/// embedded: `check` finds nothing in the result (exact engines).
/// volumes: vol(a) + vol(b) = vol(a | b) + vol(a & b), where a and b are the operands of the expression's last step.
/// commutativity, idempotence; de-morgan, in the form u - (a & b) = (u - a) | (u - b) with u = a | b;
/// differences: (a | b) - b = a - b and a ^ b = (a - b) | (b - a).
/// steps: one arrangement = step by step (exact engines).
/// operand-order, face-order, axes, scaling, translation: the same solid for operands listed otherwise; the image of
/// the solid for mapped operands.
/// membership: points off the operands are in or out of the result as the expression says (exact engines).
/// threads: the same bytes from two threads (exact engines).
/// incremental solid: steps on a IncrementalSolid are the same solids, and two xors with b undo each other (exact
/// engines). partitions: merging binary space partitions makes the same solid, and so does a tree built anew (exact
/// engines). reload: the same after a and b were written to files and read again (exact engines). oracle: the oracle
/// has the same volume and canonical form, where it is asked and the case is small.
[[nodiscard]] const std::vector<std::string>& check_names();

/// Makes all checks, or only one. Throws Broken for the first that does not hold, NoQuestion where the operands are no
/// solids or the engine cannot be asked. `only` that is no name of a check: all are made.
void ensure_laws(const verify::Case& c, const Evaluator& engine, const Oracle& oracle, const std::string& only);

}  // namespace fuzz
