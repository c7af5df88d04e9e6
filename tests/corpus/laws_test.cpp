#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "corpus/corpus.h"
#include "strata/errors.h"

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

/// Files flagged SOLID (a statement about edges) that the validity table knows to be none: their shells overlap.
std::set<std::string> overlapping_shells(const std::filesystem::path& root) {
  std::set<std::string> files;
  for (const Row& row : read_csv(root / "expected/input_validity.csv")) {
    if (row.at("strata") == "check: not a solid") files.insert(row.at("file"));
  }
  return files;
}

/// How many files went which way; ran, refused and unreadable add up to all.
struct Outcome {
  std::size_t ran = 0;
  std::size_t crossing = 0;    ///< of these, found to cross themselves on the way and run again as overlapping
  std::size_t refused = 0;     ///< inside out
  std::size_t unreadable = 0;  ///< malformed as well
};

void check_laws(const Solid& x) {
  const Solid difference = x - x;
  const Solid exclusion = x ^ x;
  const Solid both = x | x;
  CHECK(difference.is_empty());
  CHECK(exclusion.is_empty());
  CHECK(both.canonical() == x.canonical());
}

bool crosses_itself(const InputError& error) {
  return std::any_of(error.defects().begin(), error.defects().end(),
                     [](const Defect& d) { return d.kind == DefectKind::self_intersection; });
}

/// The index has the volume in 12 digits; where shells overlap, it counts the common part twice, and where polygons are
/// not planar, it follows its own triangulation.
void check_volume(const Row& row, const Solid& x, InputClass input) {
  const Rational expected = *exact_number(row.at("volume"));
  CHECK(x.is_empty() == (expected == 0));
  if (input == InputClass::solid && row.at("tri_only") == "1")
    CHECK(within(x.volume(), expected, Rational(1, 1'000'000)));
}

void check_mesh(const Row& row, const Mesh& mesh, InputClass input) {
  const Solid x(mesh, input);
  CHECK_FALSE(has_flag(row, "INSIDE_OUT"));
  check_volume(row, x, input);
  check_laws(x);
}

/// The index has not searched all large files for crossings. The engine names those that it comes across.
void check_mesh_or_overlapping(const Row& row, const Mesh& mesh, InputClass input, Outcome& outcome) {
  try {
    check_mesh(row, mesh, input);
  } catch (const InputError& e) {
    if (input == InputClass::overlapping || !row.at("self_int_pairs").empty() || !crosses_itself(e)) throw;
    std::cout << "crosses itself: " << row.at("path") << ": " << e.what() << '\n';
    check_mesh(row, mesh, InputClass::overlapping);
    ++outcome.crossing;
  }
}

void run_row(const std::filesystem::path& root, const Row& row, InputClass input, Outcome& outcome) {
  const std::string& path = row.at("path");
  try {
    check_mesh_or_overlapping(row, load(root, path), input, outcome);
    ++outcome.ran;
  } catch (const IoError& e) {
    CAPTURE(e.what());
    CHECK(row.at("note").find("faces with <3 corners") != std::string::npos);
    std::cout << "unreadable: " << path << ": " << e.what() << '\n';
    ++outcome.unreadable;
  } catch (const InputError& e) {
    CAPTURE(e.what());
    CHECK(has_flag(row, "INSIDE_OUT"));
    std::cout << "refused: " << path << ": " << e.what() << '\n';
    ++outcome.refused;
  } catch (const std::exception& e) {
    FAIL_CHECK("threw: " << e.what());
  }
}

void run(std::size_t lowest, std::size_t highest) {
  const auto root = corpus_or_skip();
  if (!root) return;
  Outcome outcome;
  const std::set<std::string> overlapping = overlapping_shells(*root);
  for (const Row& row : solid_rows(*root, lowest, highest)) {
    CAPTURE(row.at("path"), row.at("nF"));
    const bool crossing = has_flag(row, "SELF_INT") && !has_flag(row, "INSIDE_OUT");
    const bool resolve = crossing || overlapping.contains(row.at("path"));
    run_row(*root, row, resolve ? InputClass::overlapping : InputClass::solid, outcome);
  }
  std::cout << "solids of " << lowest << " to " << highest << " faces: " << outcome.ran << " ran (" << outcome.crossing
            << " as overlapping after a crossing was found), " << outcome.refused << " refused, " << outcome.unreadable
            << " unreadable\n";
}

}  // namespace

// Catches: coincident faces that are kept, dropped or doubled, on every kind of real mesh.
TEST_CASE("X - X and X ^ X are empty and X | X is X, for small solids", "[corpus][laws]") { run(0, 5'000); }

TEST_CASE("X - X and X ^ X are empty and X | X is X, for large solids", "[corpus][laws][slow]") { run(5'000, 200'001); }

}  // namespace strata::test
