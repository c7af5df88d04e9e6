#include "oracle/comparison.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>
#include <optional>

#include "oracle/isolated.h"
#include "oracle/nef.h"
#include "strata/measure.h"
#include "strata/solid.h"
#include "support/mesh_text.h"
#include "support/planes.h"
#include "support/transform.h"

namespace strata::oracle {
namespace {

/// The engine's answer, or why there is none.
struct Answer {
  std::optional<CanonicalForm> form;
  std::string problem;
};

Answer answer_of_engine(Operation operation, const std::vector<Mesh>& meshes) {
  try {
    std::vector<Solid> solids;
    for (const Mesh& mesh : meshes) solids.emplace_back(mesh);
    const Solid result = combine_solids(operation, solids);
    Answer answer{result.canonical(), {}};
    if (topology(result.exact_mesh()).open_edges != 0) answer.problem = "the boundary is open; ";
    answer.problem += test::wrong_sources(result.exact_mesh(), result.sources(), meshes);
    return answer;
  } catch (const std::exception& e) {
    return {std::nullopt, std::string("the engine threw: ") + e.what()};
  }
}

/// CGAL's answer as text, found in a child process because CGAL may crash; nothing when it fails.
std::optional<std::string> answer_of_cgal(Operation operation, const std::vector<ExactMesh>& operands, Way way) {
  try {
    return in_child([&] { return nef_boolean(operation, operands, way).text(); });
  } catch (const OracleFailed& e) {
    std::cout << "oracle: " << e.what() << '\n';
    return std::nullopt;
  }
}

enum class Verdict { equal, different, oracle_failed };

/// Asks CGAL one way; and when it fails or contradicts the engine, the other ways. The engine is wrong only when no
/// way of CGAL that has an answer has the engine's answer; CGAL has failed when its ways contradict one another.
Verdict judge(Operation operation, const std::vector<ExactMesh>& operands, const std::string& found,
              std::string& expected) {
  bool contradicted = false;
  for (const Way way : {Way::in_order, Way::regularized, Way::backwards, Way::other_formula}) {
    const auto answer = answer_of_cgal(operation, operands, way);
    if (answer == found) return contradicted ? Verdict::oracle_failed : Verdict::equal;
    if (!answer) continue;
    contradicted = true;
    expected = *answer;
  }
  return contradicted ? Verdict::different : Verdict::oracle_failed;
}

void report(const test::Operands& operands, std::uint64_t seed, Operation operation, const std::string& problem) {
  std::string meshes;
  std::string files;
  for (std::size_t i = 0; i < operands.meshes.size(); ++i) {
    meshes += "\noperand " + std::to_string(i) + ":\n" + test::off_text(operands.meshes[i]);
    files +=
        ' ' + test::dump_off("seed-" + std::to_string(seed) + "-operand-" + std::to_string(i), {&operands.meshes[i]});
  }
  FAIL_CHECK("seed " << seed << " (" << operands.kind << "), " << name(operation) << ": " << problem << "\nwritten to"
                     << files << meshes);
}

void compare_operation(Operation operation, const test::Operands& operands, std::uint64_t seed, Tally& tally) {
  std::vector<ExactMesh> exact;
  for (const Mesh& mesh : operands.meshes) exact.push_back(test::exact(mesh));
  const Answer answer = answer_of_engine(operation, operands.meshes);
  std::string problem = answer.problem;
  std::string expected;
  const std::string found = answer.form ? answer.form->text() : std::string();
  const Verdict verdict = answer.form ? judge(operation, exact, found, expected) : Verdict::different;
  if (verdict == Verdict::different && answer.form) problem += "\nexpected:\n" + expected + "\nfound:\n" + found;
  if (!problem.empty()) {
    ++tally.different;
    return report(operands, seed, operation, problem);
  }
  if (verdict == Verdict::oracle_failed) {
    std::cout << "oracle failed: seed " << seed << ", " << name(operation) << '\n';
  }
  ++(verdict == Verdict::equal ? tally.equal : tally.oracle_failed);
}

}  // namespace

SeedRange seeds(SeedRange usual) {
  const char* text = std::getenv("STRATA_SEEDS");
  if (text == nullptr) return usual;
  char* end = nullptr;
  SeedRange range;
  range.first = std::strtoull(text, &end, 10);
  range.last = *end == '-' ? std::strtoull(end + 1, nullptr, 10) : range.first + 1;
  return range;
}

void compare_with_nef(const test::Operands& operands, std::uint64_t seed, Tally& tally) {
  CAPTURE(seed, operands.kind);
  for (const Operation operation : all_operations) {
    compare_operation(operation, operands, seed, tally);
  }
}

void print(const std::string& title, const Tally& tally) {
  std::cout << title << ": " << tally.equal + tally.different + tally.oracle_failed << " operations, " << tally.equal
            << " equal, " << tally.different << " different, " << tally.oracle_failed << " oracle failed\n";
}

}  // namespace strata::oracle
