#include <catch2/catch.hpp>
#include <random>
#include <sstream>

#include "random_complex.h"
#include "strata/complex.h"
#include "strata/errors.h"
#include "support/rounds.h"

namespace strata::complex {
namespace {

std::string text_of(const SelectiveComplex& s) {
  std::ostringstream out;
  write_sgc(out, s);
  return out.str();
}

SelectiveComplex from_text(const std::string& text) {
  std::istringstream in(text);
  return read_sgc(in, "test.sgc");
}

std::string complaint(const std::string& text) {
  try {
    (void)from_text(text);
  } catch (const IoError& error) {
    return error.what();
  }
  return "none";
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), with);
}

}  // namespace

TEST_CASE("complexes survive files, and equal sets give equal files", "[complex][file][property]") {
  for (const int dimension : {2, 3})
    for (std::uint32_t seed = 0; seed < test::rounds(dimension == 2 ? 500 : 150); ++seed) {
      CAPTURE(dimension, seed);
      RandomComplexes random(dimension, seed);
      const SelectiveComplex s = random.next(4);
      const std::string text = text_of(s);
      REQUIRE(from_text(text) == s);
      REQUIRE(text_of(from_text(text)) == text);
    }
}

TEST_CASE("a triangle in space is written as documented", "[complex][file]") {
  const std::vector<Vertex> corners{{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}};
  CHECK(text_of(simplex(3, corners)) ==
        "SGC 1\ndimension 3\nvertices 3\n0 0 0 1\n0 1/2 0 1\n1 0 0 1\nedges 3\n0 1 1\n0 2 1\n1 2 1\n"
        "faces 1\n0 0 1 R0 L1 R2\nvolumes 1\n0\nisolated 0\nend\n");
}

TEST_CASE("files that are no complex are refused with the place", "[complex][file]") {
  const std::vector<Vertex> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::string good = text_of(simplex(3, corners));
  CAPTURE(good);
  CHECK(complaint(good) == "none");
  CHECK(complaint("OFF\n") == "test.sgc:1: expected 'SGC', found 'OFF'");
  CHECK(complaint(replaced(good, "0 0 0 1", "nan 0 0 1")) ==
        "test.sgc:4: expected an integer or a fraction, found 'nan'");
  CHECK(complaint(replaced(good, "0 0 0 1", "1/0 0 0 1")) ==
        "test.sgc:4: expected an integer or a fraction, found '1/0'");
  CHECK(complaint(replaced(good, "0 0 0 1", "0 0 0 2")) == "test.sgc:4: expected a mark, 0 or 1, found '2'");
  CHECK(complaint(replaced(good, "0 0 0 1", "5 0 0 1")) ==
        "test.sgc: vertex 1: vertices are not in lexicographic order");
  CHECK(complaint(replaced(good, "edges 6\n0 1 1", "edges 6\n1 1 1")) ==
        "test.sgc: edge 0: an edge needs a lower and a higher vertex");
  CHECK(complaint(replaced(good, "L0", "R0")).starts_with("test.sgc: face"));
  CHECK(complaint(replaced(good, "L0", "L77")) == "test.sgc: face 1: there is no such edge");
  CHECK(complaint(replaced(good, "end", "")) == "test.sgc:24: the file ends too early");
  CHECK(complaint(replaced(good, "volumes 2\n0\n1\n", "volumes 2\n0\n1\n0\n")).starts_with("test.sgc:2"));
  CHECK(complaint(replaced(good, "volumes 2\n0\n1\n", "volumes 3\n0\n1\n0\n")) ==
        "test.sgc: volume 2: a bounded volume has no faces");
  CHECK(complaint(good + "\n# more\nend\n") == "test.sgc:27: expected the end of the file, found 'end'");
  const std::string point = text_of(simplex(3, std::vector<Vertex>{{0, 0, 0}}));
  CHECK(complaint(replaced(point, "isolated 1\nV0 0\n", "isolated 2\nV0 0\nV0 0\n")) ==
        "test.sgc: vertex 0: a cell is isolated twice");
}

// Catches: an order of vertices by rounded places.
TEST_CASE("vertices that round to the same first coordinate are in the order of their places", "[complex][file]") {
  const std::string head = "SGC 1\ndimension 2\nvertices 2\n", tail = "edges 0\nfaces 1\n0 V0 V1\nend\n";
  const std::string low = "1/3 1 0 1\n", high = "1000000000000000000000000001/3000000000000000000000000000 0 0 1\n";
  CHECK(complaint(head + low + high + tail) == "none");
  CHECK(complaint(head + high + low + tail) == "test.sgc: vertex 1: vertices are not in lexicographic order");
}

// Catches: a reader that trusts its numbers.
TEST_CASE("a file with a changed number is read or refused with a reason", "[complex][file][property]") {
  std::size_t refused = 0;
  for (std::uint32_t seed = 0; seed < test::rounds(600); ++seed) {
    CAPTURE(seed);
    RandomComplexes random(seed % 2 == 0 ? 3 : 2, seed % 10);
    std::mt19937 choose(seed);
    std::string text = text_of(random.next(3));
    std::vector<std::size_t> digits;
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] >= '0' && text[i] <= '9') digits.push_back(i);
    for (std::uint32_t k = 0; k <= seed % 3; ++k)
      text[digits[choose() % digits.size()]] = static_cast<char>('0' + choose() % 10);
    CAPTURE(text);
    const std::string what = complaint(text);
    REQUIRE((what == "none" || what.starts_with("test.sgc")));
    refused += what != "none" ? 1 : 0;
  }
  CHECK(3 * refused > test::rounds(600));
}

TEST_CASE("faces that cross are refused", "[complex][file]") {
  const std::string crossing =
      "SGC 1\ndimension 3\nvertices 6\n-1 0 -1 1\n-1 0 1 1\n0 -1 0 1\n0 1 0 1\n1 0 -1 1\n1 0 1 1\n"
      "edges 6\n0 1 1\n0 4 1\n1 4 1\n2 3 1\n2 5 1\n3 5 1\nfaces 2\n"
      "0 0 1 L0 R1 L2\n0 0 1 L3 R4 L5\nvolumes 1\n0\nisolated 0\nend\n";
  CHECK(complaint(crossing).find("volume 0: cells meet otherwise than they say") != std::string::npos);
}

}  // namespace strata::complex
