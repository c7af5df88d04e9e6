#include <catch2/catch.hpp>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "corpus/corpus.h"
#include "strata/io/io_error.h"
#include "strata/mesh/defect.h"

namespace strata::test {
namespace {

bool has_flag(const Row& row, const std::string& flag) {
  return (' ' + row.at("flags") + ' ').find(' ' + flag + ' ') != std::string::npos;
}

/// Rows of the index that are solids with a number of faces in [lowest, highest), every content once.
std::vector<Row> solid_rows(const std::filesystem::path& root, std::size_t lowest, std::size_t highest) {
  std::vector<Row> rows;
  std::set<std::string> seen;
  for (const Row& row : read_csv(root / "INDEX.csv")) {
    if (!has_flag(row, "SOLID") || !seen.insert(row.at("blob")).second) continue;
    const std::size_t faces = std::stoul(row.at("nF"));
    if (faces >= lowest && faces < highest) rows.push_back(row);
  }
  return rows;
}

/// How many files went which way; the three add up to all.
struct Outcome {
  std::size_t ran = 0;
  std::size_t refused = 0;     ///< inside out
  std::size_t unreadable = 0;  ///< malformed as well
};

void check_laws(const Solid& x) {
  CHECK((x - x).is_empty());
  CHECK((x ^ x).is_empty());
  CHECK((x | x).canonical() == x.canonical());
}

void run_row(const std::filesystem::path& root, const Row& row, Outcome& outcome) {
  try {
    const Mesh mesh = load(root, row.at("path"));
    const InputClass input = has_flag(row, "SELF_INT") ? InputClass::overlapping : InputClass::solid;
    check_laws(Solid(mesh, input));
    ++outcome.ran;
  } catch (const IoError& e) {
    CAPTURE(e.what());
    CHECK_FALSE(row.at("note").empty());
    std::cout << "unreadable: " << row.at("path") << ": " << e.what() << '\n';
    ++outcome.unreadable;
  } catch (const InputError& e) {
    CAPTURE(e.what());
    CHECK((has_flag(row, "INSIDE_OUT") || !row.at("note").empty()));
    std::cout << "refused: " << row.at("path") << ": " << e.what() << '\n';
    ++outcome.refused;
  } catch (const std::exception& e) {
    FAIL_CHECK("threw: " << e.what());
  }
}

void run(std::size_t lowest, std::size_t highest) {
  const auto root = corpus_or_skip();
  if (!root) return;
  Outcome outcome;
  for (const Row& row : solid_rows(*root, lowest, highest)) {
    CAPTURE(row.at("path"), row.at("nF"));
    run_row(*root, row, outcome);
  }
  std::cout << "solids of " << lowest << " to " << highest << " faces: " << outcome.ran << " ran, " << outcome.refused
            << " refused, " << outcome.unreadable << " unreadable\n";
}

}  // namespace

// Catches: coincident faces that are kept, dropped or doubled, on every kind of real mesh.
TEST_CASE("X - X and X ^ X are empty and X | X is X, for small solids", "[corpus][laws]") { run(0, 5'000); }

TEST_CASE("X - X and X ^ X are empty and X | X is X, for large solids", "[corpus][laws][slow]") {
  run(5'000, 200'001);
}

}  // namespace strata::test
