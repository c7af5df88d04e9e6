#include "oracle/comparison.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>
#include <map>
#include <optional>

#include "oracle/isolated.h"
#include "oracle/nef.h"
#include "strata/bsp.h"
#include "strata/measure.h"
#include "strata/query.h"
#include "strata/solid.h"
#include "support/mesh_text.h"
#include "support/planes.h"
#include "support/transform.h"

namespace strata::oracle {
namespace {

/// An engine's answer, or why there is none.
struct Answer {
  std::optional<CanonicalForm> form;
  std::string problem;
};

Answer answer_of_engine(const Engine* engine, Operation operation, const std::vector<Mesh>& meshes) {
  try {
    std::vector<Solid> solids;
    for (const Mesh& mesh : meshes) solids.emplace_back(mesh);
    Options options;
    options.engine = engine;
    const Solid result = combine_solids(operation, solids, options);
    Answer answer{result.canonical(), {}};
    if (topology(result.exact_mesh()).open_edges != 0) answer.problem = "the boundary is open; ";
    answer.problem += test::wrong_sources(result.exact_mesh(), result.sources(), meshes);
    return answer;
  } catch (const std::exception& e) {
    return {std::nullopt, std::string("the engine threw: ") + e.what()};
  }
}

/// CGAL's answers to one question as text, each way asked when it is wanted first.
class Oracle {
 public:
  Oracle(Operation operation, const std::vector<Mesh>& meshes) : operation_(operation) {
    for (const Mesh& mesh : meshes) operands_.push_back(test::exact(mesh));
  }

  /// Nothing when CGAL fails.
  [[nodiscard]] const std::optional<std::string>& answer(Way way) {
    const auto [place, is_new] = answers_.try_emplace(way);
    if (is_new) place->second = ask(way);
    return place->second;
  }

 private:
  /// Asks in a child process, because CGAL may crash.
  [[nodiscard]] std::optional<std::string> ask(Way way) const {
    try {
      return in_child([&] { return nef_boolean(operation_, operands_, way).text(); });
    } catch (const OracleFailed& e) {
      std::cout << "oracle: " << e.what() << '\n';
      return std::nullopt;
    }
  }

  Operation operation_;
  std::vector<ExactMesh> operands_;
  std::map<Way, std::optional<std::string>> answers_;
};

enum class Verdict { equal, different, oracle_failed };

/// Asks CGAL one way; and when it fails or contradicts the engine, the other ways. The engine is wrong only when no
/// way of CGAL that has an answer has the engine's answer; CGAL has failed when its ways contradict one another.
Verdict judge(Oracle& oracle, const std::string& found, std::string& expected) {
  bool contradicted = false;
  for (const Way way : {Way::in_order, Way::regularized, Way::backwards, Way::other_formula}) {
    const auto& answer = oracle.answer(way);
    if (answer == found) return contradicted ? Verdict::oracle_failed : Verdict::equal;
    if (!answer) continue;
    contradicted = true;
    expected = *answer;
  }
  return contradicted ? Verdict::different : Verdict::oracle_failed;
}

void report(const test::Operands& operands, std::uint64_t seed, const std::string& what, const std::string& problem) {
  std::string meshes;
  std::string files;
  for (std::size_t i = 0; i < operands.meshes.size(); ++i) {
    meshes += "\noperand " + std::to_string(i) + ":\n" + test::off_text(operands.meshes[i]);
    files +=
        ' ' + test::dump_off("seed-" + std::to_string(seed) + "-operand-" + std::to_string(i), {&operands.meshes[i]});
  }
  FAIL_CHECK("seed " << seed << " (" << operands.kind << "), " << what << ": " << problem << "\nwritten to" << files
                     << meshes);
}

void compare_operation(Operation operation, const test::Operands& operands, std::uint64_t seed, Oracle& oracle,
                       Compared& compared) {
  const Answer answer = answer_of_engine(compared.engine, operation, operands.meshes);
  const std::string what = std::string(name(operation)) + " by " + compared.name;
  std::string problem = answer.problem;
  std::string expected;
  const std::string found = answer.form ? answer.form->text() : std::string();
  const Verdict verdict = answer.form ? judge(oracle, found, expected) : Verdict::different;
  if (verdict == Verdict::different && answer.form) problem += "\nexpected:\n" + expected + "\nfound:\n" + found;
  Tally& tally = compared.tally;
  if (!problem.empty()) {
    ++tally.different;
    return report(operands, seed, what, problem);
  }
  if (verdict == Verdict::oracle_failed) std::cout << "oracle failed: seed " << seed << ", " << what << '\n';
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

std::vector<Compared> all_engines() {
  return {{"arrangement", nullptr, {}}, {layer_engine.name, &layer_engine, {}}, {bsp_engine.name, &bsp_engine, {}}};
}

void compare_with_nef(const test::Operands& operands, std::uint64_t seed, std::vector<Compared>& engines) {
  CAPTURE(seed, operands.kind);
  for (const Operation operation : all_operations) {
    Oracle oracle(operation, operands.meshes);
    for (Compared& compared : engines) compare_operation(operation, operands, seed, oracle, compared);
  }
}

void print(const std::string& title, const Tally& tally) {
  std::cout << title << ": " << tally.equal + tally.different + tally.oracle_failed << " operations, " << tally.equal
            << " equal, " << tally.different << " different, " << tally.oracle_failed << " oracle failed\n";
}

}  // namespace strata::oracle
