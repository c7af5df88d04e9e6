#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <optional>
#include <string>

#include "corpus/corpus.h"
#include "strata/check.h"
#include "strata/errors.h"
#include "strata/io.h"
#include "strata/measure.h"

namespace strata::test {
namespace {

/// What became of a file on its way to a solid.
struct Reception {
  std::optional<std::uint64_t> error_line;  ///< of a read error in a text file
  bool readable = false;
  bool accepted = false;
  bool checked = false;  ///< `check` finds no error
  MeshFile file;
  std::vector<Defect> defects;
  std::string message;
};

bool has_error(const std::vector<Defect>& defects) {
  return std::any_of(defects.begin(), defects.end(), [](const Defect& d) { return d.severity == Severity::error; });
}

/// Never throws anything but what the library has no right to throw.
Reception receive(const std::filesystem::path& path) {
  Reception reception;
  try {
    reception.file = read_mesh(path);
    reception.readable = true;
    const auto found = check(reception.file.mesh);
    reception.checked = !has_error(found);
    for (const Defect& defect : found) reception.message += describe(defect) + "; ";
    static_cast<void>(Solid(reception.file.mesh).volume());
    reception.accepted = true;
  } catch (const IoError& e) {
    reception.message = e.what();
    reception.error_line = e.line();
  } catch (const InputError& e) {
    reception.message = e.what();
    reception.defects = e.defects();
  }
  return reception;
}

bool names(const std::vector<Defect>& defects, std::string_view wanted) {
  return std::any_of(defects.begin(), defects.end(), [&](const Defect& d) { return name(d.kind) == wanted; });
}

/// Vertices close to each other are no defect. The one file of this kind is inside out besides (its volume is -5, and
/// the index flags it): that alone is refused, and repair turns it over without merging anything.
void check_close_vertices(const Reception& reception) {
  for (const Defect& defect : reception.defects) {
    CAPTURE(describe(defect));
    CHECK((defect.severity == Severity::note || defect.kind == DefectKind::inside_out));
  }
  const Solid solid(reception.file.mesh, InputClass::repair);
  CHECK(within(solid.volume(), 5, Rational(1, 1'000'000)));
  CHECK(solid.volume() == -volume(ExactMesh{reception.file.mesh, {}}));
}

/// The column `strata` says in words what is right; every wording is known here.
void check_reception(const std::string& wanted, const Reception& reception) {
  if (wanted == "read error with line (exit 3)") {
    CHECK_FALSE(reception.readable);
    CHECK(reception.error_line.has_value());
  } else if (wanted.starts_with("accepted after triangulation")) {
    CHECK(reception.accepted);
    CHECK_FALSE(reception.file.notes.empty());
  } else if (wanted == "accepted: size 5, boundary size 22") {
    REQUIRE(reception.accepted);
    const Solid solid(reception.file.mesh);
    CHECK(solid.volume() == 5);
    CHECK(solid.area() == Approx(22).epsilon(1e-12));
  } else if (wanted.starts_with("accepted: close is not equal")) {
    check_close_vertices(reception);
  } else if (wanted.starts_with("refused: ")) {
    CHECK_FALSE(reception.accepted);
    CHECK(names(reception.defects, wanted.substr(9)));
  } else if (wanted == "check: solid") {
    CHECK(reception.checked);
  } else if (wanted == "check: not a solid") {
    CHECK_FALSE(reception.checked);
  } else {
    FAIL_CHECK("a wording that this test does not know: " << wanted);
  }
}

}  // namespace

TEST_CASE("files are accepted or refused as the validity table says", "[corpus][validity]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  for (const Row& row : read_csv(*root / "expected/input_validity.csv")) {
    CAPTURE(row.at("file"), row.at("strata"));
    try {
      const Reception reception = receive(*root / row.at("file"));
      CAPTURE(reception.message);
      check_reception(row.at("strata"), reception);
    } catch (const std::exception& e) {
      FAIL_CHECK("threw: " << e.what());
    }
  }
}

TEST_CASE("every bad file is read, or refused with a message, and nothing crashes", "[corpus][validity]") {
  const auto root = corpus_or_skip();
  if (!root) return;
  std::size_t files = 0;
  std::size_t accepted = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*root / "bad")) {
    if (!entry.is_regular_file()) continue;
    CAPTURE(entry.path().string());
    try {
      const Reception reception = receive(entry.path());
      CHECK((reception.accepted || !reception.message.empty()));
      accepted += reception.accepted;
    } catch (const std::exception& e) {
      FAIL_CHECK("threw: " << e.what());
    }
    ++files;
  }
  std::cout << "bad files: " << files << ", of which " << accepted << " are solids all the same\n";
  CHECK(files > 0);
}

}  // namespace strata::test
