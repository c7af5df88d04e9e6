#include "oracle/comparison.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>
#include <optional>

#include "oracle/nef.h"
#include "strata/csg/solid.h"
#include "strata/mesh/measure.h"
#include "support/mesh_text.h"
#include "support/planes.h"
#include "support/transform.h"

namespace strata::oracle {
namespace {

std::string_view operation_name(Operation operation) {
  switch (operation) {
    case Operation::unite: return "union";
    case Operation::intersect: return "intersection";
    case Operation::subtract: return "difference";
    case Operation::exclude: return "xor";
  }
  return {};
}

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

std::optional<CanonicalForm> answer_of_cgal(Operation operation, const std::vector<NefSolid>& solids) {
  try {
    return canonical_form(nef_combine(operation, solids).facets());
  } catch (const OracleFailed& e) {
    std::cout << "oracle failed: " << e.what() << '\n';
    return std::nullopt;
  }
}

void report(const test::Operands& operands, std::uint64_t seed, Operation operation, const std::string& problem) {
  std::string meshes;
  std::string files;
  for (std::size_t i = 0; i < operands.meshes.size(); ++i) {
    meshes += "\noperand " + std::to_string(i) + ":\n" + test::off_text(operands.meshes[i]);
    files += ' ' + test::dump_off("seed-" + std::to_string(seed) + "-operand-" + std::to_string(i), {&operands.meshes[i]});
  }
  FAIL_CHECK("seed " << seed << " (" << operands.kind << "), " << operation_name(operation) << ": " << problem
                     << "\nwritten to" << files << meshes);
}

void compare_operation(Operation operation, const test::Operands& operands, const std::vector<NefSolid>& nefs,
                       std::uint64_t seed, Tally& tally) {
  const auto expected = answer_of_cgal(operation, nefs);
  const Answer answer = answer_of_engine(operation, operands.meshes);
  std::string problem = answer.problem;
  if (answer.form && expected && *answer.form != *expected) {
    problem += "\nexpected:\n" + expected->text() + "\nfound:\n" + answer.form->text();
  }
  if (!problem.empty()) {
    ++tally.different;
    report(operands, seed, operation, problem);
  } else {
    ++(expected ? tally.equal : tally.oracle_failed);
  }
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
  std::vector<NefSolid> nefs;
  try {
    for (const Mesh& mesh : operands.meshes) nefs.emplace_back(test::exact(mesh));
  } catch (const OracleFailed& e) {
    std::cout << "oracle failed on an operand of seed " << seed << ": " << e.what() << '\n';
    tally.oracle_failed += 4;
    return;
  }
  for (const Operation operation :
       {Operation::unite, Operation::intersect, Operation::subtract, Operation::exclude}) {
    compare_operation(operation, operands, nefs, seed, tally);
  }
}

void print(const std::string& title, const Tally& tally) {
  std::cout << title << ": " << tally.equal + tally.different + tally.oracle_failed << " operations, " << tally.equal
            << " equal, " << tally.different << " different, " << tally.oracle_failed << " oracle failed\n";
}

}  // namespace strata::oracle
