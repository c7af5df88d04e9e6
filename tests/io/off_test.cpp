#include <catch2/catch.hpp>

#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {
const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
}  // namespace

TEST_CASE("OFF is read with all the headers that are in use", "[io][off]") {
  for (const char* header :
       {"OFF\n4 4 6\n", "OFF 4 4 0\n", "OFF\r\n\r\n# made by hand\r\n4 4 # no edges\r\n", "4 4 6\n", "OFF4 4 0\n",
        "COFF\n4 4 0\n", "NOFF 4 4 0\n", "STCNOFF\n4 4 0\n", "# c\nOFF\n4\n4\n0\n"}) {
    CAPTURE(header);
    CHECK(read_text(header + vertices + faces, Format::off).mesh == tetrahedron);
  }
}

TEST_CASE("Colours in an OFF file are no part of its mesh", "[io][off]") {
  const auto file = read_text(
      "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0.5 0.5 0.5 1\n0 1 0 0 0 0 0\n3 0 1 2 0.1 0.2 0.3\n", Format::off);
  CHECK(file.mesh == Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
}

TEST_CASE("Malformed OFF is refused with its line", "[io][off]") {
  const auto line = [](const std::string& text) { return refused_line(text, Format::off); };
  CHECK(line("FOO\n4 4 6\n") == 1);
  CHECK(line("OFF\n4 x 6\n") == 2);
  CHECK(line("OFF\n-4 4 6\n") == 2);
  CHECK(line("OFF\n4 4 0\n" + vertices) == 7);
  CHECK(line("OFF\n4 1 0\n" + vertices + "3 0 1 4\n") == 7);
  CHECK(line("OFF\n4 1 0\n" + vertices + "3 0 1 -1\n") == 7);
  CHECK(line("OFF\n4 1 0\n" + vertices + "3 0 1\n") == 8);
  CHECK(line("OFF\n4 1 0\n" + vertices + "3 0 1 1.5\n") == 7);
  CHECK(line("OFF\n3 1 0\n" + vertices + "3 0 1 2\n") == 6);
  CHECK(line("nOFF\n3\n4 1 0\n") == 1);
  CHECK(line("4OFF\n4 1 0\n") == 1);
  CHECK(line("OFF BINARY\n") == 1);
}

TEST_CASE("Counts that no file of this size can keep are refused before memory is asked for", "[io][off]") {
  CHECK(refusal("OFF\n4000000000 1 0\n0 0 0\n", Format::off).find("room for") != std::string::npos);
  CHECK(refusal("OFF\n1 4000000000 0\n0 0 0\n", Format::off).find("room for") != std::string::npos);
  CHECK(refusal("OFF\n1 1 0\n0 0 0\n4000000000 0 0\n", Format::off).find("room for") != std::string::npos);
}
