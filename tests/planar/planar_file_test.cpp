#include <catch2/catch.hpp>
#include <cstdlib>

#include "planar/shapes.h"
#include "strata/planar.h"

using namespace strata;
using namespace strata::planar;

namespace {

constexpr PlanarFormat formats[] = {PlanarFormat::wkt, PlanarFormat::geojson, PlanarFormat::svg};

Region read_region(const std::string& text, PlanarFormat format) {
  return fill(read_planar(text, format, "text").loops);
}

/// The reason that reading gives, or nothing.
std::string refusal(const std::string& text, PlanarFormat format) {
  try {
    (void)read_planar(text, format, "text");
  } catch (const IoError& error) {
    return error.what();
  }
  return {};
}

std::string repeated(const std::string& text, int count) {
  std::string r;
  for (int i = 0; i < count; ++i) r += text;
  return r;
}

}  // namespace

// Catches: a digit lost, a hole turned the wrong way or given to another polygon, loops joined.
TEST_CASE("polygons of doubles survive every format", "[planar][property]") {
  planar::test::Random random(11);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    std::vector<planar::test::Loop> boxes;
    for (int k = 0; k < 6; ++k) {
      const double x = static_cast<double>(random() % 6) * 0.1, y = static_cast<double>(random() % 6) / 3;
      boxes.push_back(planar::test::box(x, y, x + 0.3, y + 1e-3 * static_cast<double>(1 + random() % 999)));
    }
    const Region region = fill({planar::test::loops(boxes), FillRule::even_odd});
    for (const PlanarFormat format : formats)
      REQUIRE(canonical_form(read_region(to_text(region, format), format)) == canonical_form(region));
  }
}

// Catches: quotients that are rounded on the way out or in.
TEST_CASE("polygons of rationals survive WKT", "[planar][property]") {
  planar::test::Random random(12);
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const Region region = fill(planar::test::in_thirds(planar::test::random_grid_loops(random, 7)));
    const std::string text = to_text(region, PlanarFormat::wkt, Coordinates::exact);
    REQUIRE(canonical_form(read_region(text, PlanarFormat::wkt)) == canonical_form(region));
  }
  const Region square = fill(planar::test::square(0, 0));
  CHECK_THROWS_AS(to_text(square, PlanarFormat::svg, Coordinates::exact), IoError);
  CHECK_THROWS_AS(to_text(square, PlanarFormat::geojson, Coordinates::exact), IoError);
}

TEST_CASE("nothing is written as nothing and read as such", "[planar][degenerate]") {
  for (const PlanarFormat format : formats) CHECK(read_region(to_text(Region(), format), format).empty());
  CHECK(read_planar("", PlanarFormat::wkt, "text").loops.size() == 0);
}

// Catches: a reader that calls itself for every level, without end.
TEST_CASE("files that are nested without end are refused", "[planar][degenerate]") {
  constexpr int levels = 1'000'000;
  CHECK_THAT(refusal(repeated("GEOMETRYCOLLECTION (", levels), PlanarFormat::wkt),
             Catch::Contains("nested too deeply"));
  CHECK_THAT(refusal(repeated("[", levels), PlanarFormat::geojson), Catch::Contains("nested"));
  const std::string collection =
      repeated("GEOMETRYCOLLECTION (", 100) + "POLYGON ((0 0, 1 0, 0 1))" + repeated(")", 100);
  CHECK(area(read_region(collection, PlanarFormat::wkt)) == Rational(1, 2));
}

// Catches: a reader that runs beyond the end, or takes a part for the whole.
TEST_CASE("every beginning of a file is read or refused with a reason", "[planar][property]") {
  const Region ring = difference(planar::test::square(0, 0, 3), planar::test::square(1, 1));
  for (const PlanarFormat format : formats) {
    const std::string text = to_text(ring, format);
    for (std::size_t n = 0; n < text.size(); ++n) {
      CAPTURE(n);
      try {
        (void)read_planar(text.substr(0, n), format, "text");
      } catch (const IoError& error) {
        REQUIRE_THAT(error.what(), Catch::Contains("text"));
      }
    }
  }
}

// Catches: sums that overflow become infinite coordinates, or are taken for the largest double.
TEST_CASE("relative coordinates whose sum is beyond all doubles are refused", "[planar][degenerate]") {
  const std::string start = "M0 0h1e308", reason = "text:2: a sum of relative coordinates is beyond all doubles";
  CHECK_THAT(refusal(start + "\nh1e308v1z", PlanarFormat::svg), Catch::Contains(reason));
  CHECK_THAT(refusal("m-1e308 0\nl-1e308,0 0 1z", PlanarFormat::svg), Catch::Contains(reason));
  CHECK_THAT(refusal("M0-1e308\nv-1e308h1z", PlanarFormat::svg), Catch::Contains(reason));
  CHECK(area(read_region("M-1e308 0h1e308h1e308v1H-1e308z", PlanarFormat::svg)) == 2 * to_rational(1e308));
  // Half an ulp beyond the largest double is beyond; a little less rounds to it.
  CHECK_THAT(refusal("M0 0\nh1.7976931348623157e308h9.9792015476736e291v1z", PlanarFormat::svg),
             Catch::Contains(reason));
  CHECK(refusal("M0 0h1.7976931348623157e308h9.979201547673598e291v1z", PlanarFormat::svg).empty());
}

// Catches: a view box of infinite width.
TEST_CASE("polygons across all doubles are written with finite numbers", "[planar][degenerate]") {
  const Region wide = fill(planar::test::loops({planar::test::box(-1.5e308, -1.5e308, 1.5e308, 1.5e308)}));
  for (const PlanarFormat format : formats) {
    const std::string text = to_text(wide, format);
    CHECK(text.find("inf") == std::string::npos);
    CHECK(canonical_form(read_region(text, format)) == canonical_form(wide));
  }
}

// Catches: negative zeros in some formats and not in others.
TEST_CASE("negative zero is written as the number zero", "[planar][degenerate]") {
  const Region negative = fill(planar::test::loops({{{-0.0, 0}, {1, -0.0}, {1, 1}}}));
  const Region third = read_region("POLYGON ((-0 1/3, 1/3 -0, 1 1))", PlanarFormat::wkt);
  for (const PlanarFormat format : formats) {
    CHECK(to_text(negative, format).find("-0") == std::string::npos);
    CHECK(to_text(third, format).find("-0") == std::string::npos);
  }
  CHECK(to_text(third, PlanarFormat::wkt, Coordinates::exact) == "POLYGON ((0 1/3,1/3 0,1 1,0 1/3))\n");
}

// Catches: paths found in comments, data and values of attributes; transformations behind a tab or a line end.
TEST_CASE("paths of SVG are elements, and transformations attributes", "[planar]") {
  const std::string square = "<path\td = 'M0 0h1v1h-1z' />";
  const std::string hidden = "<!-- " + square + " ' -->\n<![CDATA[" + square + "]]><?other version=\"1.0\"?>" +
                             "<g id=\"<path d='M0 0h5v5z'/> d=M\"><pathology d=\"M0 0h5v5z\"/>it's</g>";
  CHECK(read_region("<!DOCTYPE svg><svg>" + hidden + "</svg>", PlanarFormat::svg).empty());
  CHECK(area(read_region("<!DOCTYPE svg><svg>" + hidden + square + "</svg>", PlanarFormat::svg)) == 1);
  CHECK(area(read_region("<s:svg><s:path id='d' d=\"M0 0h1v1h-1z\"></s:path></s:svg>", PlanarFormat::svg)) == 1);
  for (const char* space : {" ", "\n", "\t"})
    CHECK_THAT(refusal("<svg><g" + (space + ("transform = 'scale(2)'>" + square)) + "</g></svg>", PlanarFormat::svg),
               Catch::Contains("transformations are not applied"));
  CHECK_THAT(refusal("<svg>\n<path d=M0/></svg>", PlanarFormat::svg),
             Catch::Contains("text:2: no XML: Error parsing element attribute"));
  CHECK_THAT(refusal("<svg>\n<!-- ", PlanarFormat::svg), Catch::Contains("text:2: no XML: Error parsing comment"));
  for (const std::string& unquoted : {std::string("<?it's?>"), "<?a x > " + square + " \" ?>",
                                      std::string("<!DOCTYPE svg [<!-- don't > --><!ENTITY a \"'>\"> <?b '?>]>")}) {
    CAPTURE(unquoted);
    CHECK(area(read_region(unquoted + "<svg>" + square + "</svg>" + unquoted, PlanarFormat::svg)) == 1);
  }
  CHECK_THAT(refusal("\n<!DOCTYPE svg [<!ENTITY a 'b'>", PlanarFormat::svg),
             Catch::Contains("text:2: no XML: Error parsing document type declaration"));
  CHECK_THAT(refusal("<svg>\n<g></svg>", PlanarFormat::svg),
             Catch::Contains("text:2: no XML: Start-end tags mismatch"));
  // Lines of a path are lines of the file; entities of XML are characters, others are not replaced.
  CHECK_THAT(refusal("<svg>\n<path d='M0 0\nh1\nx'/></svg>", PlanarFormat::svg),
             Catch::Contains("text:4: expected a path command"));
  CHECK(area(read_region("<svg><path d='M0&#32;0h1v1h-1&#x7a;'/></svg>", PlanarFormat::svg)) == 1);
  CHECK_THAT(refusal("<!DOCTYPE svg [<!ENTITY a 'M0 0h1v1z'>]><svg><path d='&a;'/></svg>", PlanarFormat::svg),
             Catch::Contains("found '&'"));
  // Elements may be nested as deep as they like.
  std::string deep = "<svg>";
  for (int i = 0; i < 100'000; ++i) deep += "<g>";
  deep += square;
  for (int i = 0; i < 100'000; ++i) deep += "</g>";
  CHECK(area(read_region(deep + "</svg>", PlanarFormat::svg)) == 1);
  const auto notes = read_planar("<svg><rect/><!-- <circle/> --><rect/></svg>", PlanarFormat::svg, "text").notes;
  CHECK(notes == std::vector<std::string>{"only paths are read: rect was left out"});
}

// Catches: shapes of a clip path or a symbol taken for drawn ones; what would change the drawn shape passed over in
// silence.
TEST_CASE("paths of SVG are drawn where they stand, or it is told", "[planar]") {
  const std::string square = "<path d='M0 0h1v1h-1z'/>", other = "<path d='M5 0h1v1h-1z'></path>";
  const auto read = [](const std::string& inside) {
    return read_planar("<svg viewBox='0 0 9 9'>" + inside + "</svg>", PlanarFormat::svg, "text");
  };
  for (const std::string name : {"defs", "symbol", "clipPath", "mask", "pattern", "marker", "s:defs"}) {
    CAPTURE(name);
    const std::string begin = "<" + name + " id='a'>", end = "</" + name + ">", empty = "<" + name + "/>";
    const PlanarFile file = read(begin + empty + other + begin + other + end + other + end + square + empty);
    CHECK(area(fill(file.loops)) == 1);
    CHECK(file.notes == std::vector<std::string>{"paths that are only defined and not drawn were left out"});
  }
  CHECK(read("<defs><rect transform='scale(2)'/></defs>" + square).notes.empty());
  CHECK(read("<use href='#a'/>").notes == std::vector<std::string>{"only paths are read: use was left out"});
  for (const std::string rule : {"fill-rule='evenodd'", "style='fill:red; fill-rule : evenodd'"})
    CHECK(read("<g " + rule + ">" + square + "</g>").notes ==
          std::vector<std::string>{"fill-rule evenodd is not applied: give the rule with the operation"});
  CHECK(read("<g fill-rule='nonzero' style=''>" + square + "</g>").notes.empty());
  CHECK(read("<g style='clip-path:url(#a)'>" + square + "</g>").notes ==
        std::vector<std::string>{"clip paths and masks are not applied"});
  CHECK_THAT(refusal("<svg><g style='fill:red;transform:scale(2)'>" + square + "</g></svg>", PlanarFormat::svg),
             Catch::Contains("transformations are not applied"));
  CHECK_THAT(refusal("<svg>\n<svg x='1'>" + square + "</svg></svg>", PlanarFormat::svg),
             Catch::Contains("text:2: svg elements inside of others are not placed"));
  CHECK(area(fill(read("<svg>" + square + "</svg>").loops)) == 1);
  CHECK(refusal("<svg/>" + ("<svg x='1'>" + square + "</svg>"), PlanarFormat::svg).empty());
}

TEST_CASE("a byte order mark is passed over", "[planar]") {
  const std::string mark = "\xEF\xBB\xBF";
  CHECK(area(read_region(mark + "POLYGON ((0 0, 1 0, 0 1))", PlanarFormat::wkt)) == Rational(1) / 2);
  CHECK(area(read_region(mark + R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]})",
                         PlanarFormat::geojson)) == Rational(1) / 2);
  CHECK(area(read_region(mark + "M0 0h1v1z", PlanarFormat::svg)) == Rational(1) / 2);
}

TEST_CASE("formats are told by extensions and names", "[planar]") {
  CHECK(planar_format_of("a/b.wkt") == PlanarFormat::wkt);
  CHECK(planar_format_of("b.GEOJSON") == planar_format_of("b.json"));
  CHECK(planar_format_named("svg") == PlanarFormat::svg);
  CHECK_FALSE(planar_format_of("b.off").has_value());
  CHECK_FALSE(planar_format_named("dxf").has_value());
}

// Catches: numbers read by another way than the nearest double; errors without their line; recursion.
TEST_CASE("GeoJSON is JSON: numbers are nearest doubles, errors have their line", "[planar]") {
  const auto corner = [](const std::string& x) {
    const PlanarFile file = read_planar(R"({"coordinates": [[[0, 0], [)" + x + R"(, 0], [0, 1]]], "type": "Polygon"})",
                                        PlanarFormat::geojson, "text");
    return file.loops.places.place[file.loops.vertices[1]][0];
  };
  for (const char* digits : {"0.1", "1e22", "9007199254740993", "18446744073709551617",
                             "123456789012345678901234567890", "2.2250738585072011e-308", "4.9e-324",
                             "1.7976931348623157e308", "0.500000000000000166533453693773481063544750213623046875"})
    CHECK(corner(digits) == std::strtod(digits, nullptr));
  CHECK_THAT(refusal("{\"type\": \"Polygon\",\n\"coordinates\": [[[0, 0],\n[1, ]]]}", PlanarFormat::geojson),
             Catch::Contains("text:3: no JSON"));
  CHECK_THAT(refusal("{\"type\": \"Polygon\",\n\"coordinates\": [[[0, 0],\n[1, \"2\"]]]}", PlanarFormat::geojson),
             Catch::Contains("text:3: expected a number"));
  CHECK_THAT(refusal("{\"type\": \"Polygon\",\n\"coordinates\": [[[0, 0], [1e999, 0]]]}", PlanarFormat::geojson),
             Catch::Contains("text:2: no JSON"));
  CHECK_THAT(refusal(std::string(1'000'000, '['), PlanarFormat::geojson), Catch::Contains("nested more than 512 deep"));
}
