#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "openscad/csg_text.h"

using namespace strata;
using namespace strata::test;
using Catch::Contains;

namespace {

/// The font of the tests: a unit of its glyphs is a tenth of the size, and 0.09765625 of it between glyphs
/// (tools/generate/font.py).
const std::string blocks = STRATA_DATA_DIR "/fonts/blocks.ttf";
constexpr double step = 10 / 10.24;  ///< units of an advance at size 10

CsgModel read(const std::string& text, std::vector<std::string> fonts = {blocks}) {
  CsgOptions options;
  options.fonts = std::move(fonts);
  return read_csg(text, "test.csg", options);
}

/// A node of the text, of size 10, with further arguments.
std::string node(const std::string& text, const std::string& more = {}) {
  return "text(text = \"" + text + "\", size = 10, font = \"Strata Blocks\"" + (more.empty() ? "" : ", " + more) + ");";
}

std::string error(const std::string& model, std::vector<std::string> fonts = {blocks}) {
  try {
    (void)read(model, std::move(fonts));
    return {};
  } catch (const CsgError& e) {
    return e.reason();
  }
}

}  // namespace

#if STRATA_WITH_FONTS

namespace {

double area(const std::string& model) {
  const CsgModel made = read(model);
  return made.shape ? to_nearest_double(planar::area(*made.shape)) : 0;
}

/// The area between two abscissas, or two ordinates.
double area_within(const std::string& model, double left, double right) {
  return area("intersection() { " + model + " multmatrix([[1, 0, 0, " + std::to_string(left) +
              "], [0, 1, 0, -500], [0, 0, 1, 0], [0, 0, 0, 1]]) { square(size = [" + std::to_string(right - left) +
              ", 1000], center = false); } }");
}
double area_between(const std::string& model, double below, double above) {
  return area("intersection() { " + model + " multmatrix([[1, 0, 0, -500], [0, 1, 0, " + std::to_string(below) +
              "], [0, 0, 1, 0], [0, 0, 0, 1]]) { square(size = [1000, " + std::to_string(above - below) +
              "], center = false); } }");
}

std::string notes(const std::string& model) {
  std::string all;
  for (const std::string& n : read(model).notes) all += n + "\n";
  return all;
}

}  // namespace

TEST_CASE("texts have the glyphs of their font, with holes", "[text]") {
  CHECK(area(node("I")) == 20);
  CHECK(area(node("O")) == 84);
  CHECK(area(node("+")) == 36);  // contours that overlap
  CHECK(notes(node("IO+")).empty());
}

TEST_CASE("glyphs stand side by side, and overlapping ones are united", "[text]") {
  CHECK(area(node("II")) == 40);
  CHECK(area_within(node("II"), 4, 5 * step + 2.001) == Approx(20));
  CHECK(area(node("II", "spacing = 0.25")) == Approx((1.25 * step + 2) * 10));
  CHECK(area(node("I I")) == 40);
  CHECK(area_within(node("I I"), 10 * step - 1, 1000) == Approx(20));
}

TEST_CASE("kerning and ligatures are those of the font", "[text]") {
  CHECK(area(node("OI")) == Approx(84 + 10 * (10 * step + 2 - 10)));
  CHECK(area(node("fi")) == 64);
  CHECK(area(node("if")) == 16 + 16 - 4);
}

TEST_CASE("curves have an eighth of the sides of a circle and one more, at least two", "[text]") {
  // A triangle and the part of a parabola beside it.
  const auto with_lines = [](double n) { return 32 + 64. / 3 * (1 - 1 / (n * n)); };
  CHECK(area(node("D", "$fn = 3")) == Approx(with_lines(2)));
  CHECK(area(node("D", "$fn = 8")) == Approx(with_lines(2)));
  CHECK(area(node("D", "$fn = 16")) == Approx(with_lines(3)));
  CHECK(area(node("D", "$fn = 64")) == Approx(with_lines(9)));
  CHECK(area(node("D", "$fa = 12, $fs = 2")) == Approx(with_lines(4)));
}

TEST_CASE("texts are aligned by advances, and by heights in whole dots", "[text]") {
  CHECK(area_within(node("II", "halign = \"right\""), -10 * step, 0) == Approx(40));
  CHECK(area_within(node("II", "halign = \"center\""), -5 * step, 0) == Approx(20));
  CHECK(area_within(node("II", "halign = \"left\""), 0, 10 * step) == 40);
  // A dot is 64/1024 of a unit here; the height of 10 units is 1562.5 dots.
  const double ascent = 1563 * 64 / 10240.;
  CHECK(area_between(node("I", "valign = \"top\""), -ascent, 10 - ascent) == Approx(20));
  CHECK(area_between(node("I", "valign = \"center\""), -ascent / 2, 10 - ascent / 2) == Approx(20));
  CHECK(area_between(node("p", "valign = \"bottom\""), 4 * step - 4, 10) == Approx(20 + 16));
  CHECK(area_between(node("p"), -4, 0) == 8);
  CHECK_THAT(notes(node("I", "halign = \"middle\", valign = \"up\"")),
             Contains("has no halign 'middle'") && Contains("has no valign 'up'"));
}

TEST_CASE("texts run as their script does, or as they are told", "[text]") {
  const std::string alef_bet = "\u05d0\u05d1";
  CHECK(area(node(alef_bet)) == 16 + 32);
  CHECK(area_within(node(alef_bet), 0, 4.5) == Approx(32));
  CHECK(area_within(node(alef_bet, "direction = \"ltr\""), 0, 4.5) == Approx(16));
  CHECK(area_within(node("IO"), 0, 4) == 20);
  CHECK(area_within(node("IO", "direction = \"rtl\""), 0, 4) == Approx(30 + 6));
}

TEST_CASE("sizes are factors, also negative ones", "[text]") {
  const std::string small = "text(text = \"O\", size = 0.001, font = \"Strata Blocks\");";
  CHECK(area(small) == Approx(84e-8));
  const std::string turned = "text(text = \"I\", size = -10, font = \"Strata Blocks\");";
  CHECK(area(turned) == 20);
  CHECK(area_within(turned, -2, 0) == 20);
  CHECK(area_between(turned, -10, 0) == 20);
}

TEST_CASE("texts without ink make nothing, and say so", "[text]") {
  for (const std::string& text : {node(""), node(" "), std::string("text(text = \"I\", size = 0);")}) {
    CHECK(area(text) == 0);
    CHECK_THAT(notes(text), Contains("makes nothing"));
  }
}

TEST_CASE("what a font lacks is noted", "[text]") {
  CHECK(area(node("IQ")) == 20 + 16);
  CHECK_THAT(notes(node("IQ")), Contains("lacks: U+0051"));
  CHECK_THAT(notes("text(text = \"I\", font = \"No Such Font\");"),
             Contains("has a font that is not found: 'No Such Font'"));
}

// Caught: letters were looked up one by one, though HarfBuzz takes the glyphs of others for some, and joins letters
// with marks.
TEST_CASE("a character is missing if its glyph is", "[text]") {
  CHECK(notes(node("I\u00a0I")).empty());  // the glyph of a space
  CHECK(area(node("e\u0301")) == 20);
  CHECK(area_between(node("e\u0301"), 6, 8) == 4);  // the glyph of one letter, not a letter and a mark
  CHECK_THAT(notes(node("b\u0301I")), Contains("lacks: U+0062") && !Contains("U+0301"));
  CHECK_THAT(notes(node("p\u0302I")), Contains("lacks: U+0302") && !Contains("U+0070"));
}

TEST_CASE("marks stand where the font says", "[text]") {
  CHECK(notes(node("p\u0301")).empty());
  const double low = 6 + step, left = 3 * step - 3;  // outlines and places have different units
  CHECK(area_between(node("p\u0301"), low - 1e-3, low + 2.001) == Approx(4));
  CHECK(area_within("intersection() { " + node("p\u0301") +
                        " multmatrix([[1, 0, 0, -5], [0, 1, 0, 6.5], [0, 0, 1, 0], [0, 0, 0, 1]]) { square(20); } }",
                    left - 1e-3, left + 2.001) == Approx(4));
}

// Caught: all points of a curve were made before they were counted.
TEST_CASE("texts of too many corners are refused before they are made", "[text]") {
  CHECK_THAT(error(node("D", "$fn = 1e9")), Contains("too many corners"));
  CHECK_THAT(error(node(std::string(1000, 'D'), "$fn = 100000")), Contains("too many corners"));
  CHECK(error(node(std::string(1000, 'D'), "$fn = 1000")).empty());
}

TEST_CASE("texts that cannot be set are refused", "[text]") {
  CHECK_THAT(error(node("I\xff")), Contains("no character in UTF-8, at number 2"));
  CHECK_THAT(error(node("\xc0\x80")), Contains("no character in UTF-8, at number 1"));
  CHECK_THAT(error(node("I\xed\xa0\x80")), Contains("no character in UTF-8, at number 2"));
  CHECK_THAT(error("text(text = \"IIII\", size = 1.7e308, font = \"Strata Blocks\");"),
             Contains("size of text is too large"));
  CHECK_THAT(error("text(text = [1]);"), Contains("text"));
  CHECK_THAT(error(node("I"), {STRATA_DATA_DIR "/cube.off"}), Contains("there is no font in"));
  CHECK_THAT(error(node("I"), {"no/such/font.ttf"}), Contains("there is no font in"));
}

TEST_CASE("texts become solids", "[text]") {
  const CsgModel model = read("linear_extrude(height = 2, center = false) { " + node("O") + " }");
  CHECK(model.expression.evaluate().volume() == 168);
}

#else

TEST_CASE("texts are refused where fonts are not read", "[text]") {
  CHECK_THAT(error(node("I")), Contains("is not supported: this build reads no fonts"));
}

#endif
