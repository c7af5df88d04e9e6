// AMF: objects, volumes, materials, colours and constellations; files that lead astray are refused.
#include <catch2/catch.hpp>
#include <string>

#include "attributed.h"
#include "core/io/zip_writer.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {

std::string vertex(const std::string& x, const std::string& y, const std::string& z, const std::string& more = "") {
  return "<vertex><coordinates><x>" + x + "</x><y>" + y + "</y><z>" + z + "</z></coordinates>" + more + "</vertex>";
}

std::string triangle(int a, int b, int c) {
  return "<triangle><v1>" + std::to_string(a) + "</v1><v2>" + std::to_string(b) + "</v2><v3>" + std::to_string(c) +
         "</v3></triangle>";
}

const std::string points = "<vertices>" + vertex("0", "0", "0") + vertex("1", "0", "0") + vertex("0", "1", "0") +
                           vertex("0", "0", "1") + "</vertices>";
const std::string half = triangle(0, 2, 1) + triangle(0, 1, 3), other_half = triangle(1, 2, 3) + triangle(2, 0, 3);
const std::string mesh = "<mesh>" + points + "<volume>" + half + other_half + "</volume></mesh>";

std::string amf(const std::string& content, const std::string& unit = "") {
  return "<?xml version=\"1.0\"?><amf" + (unit.empty() ? "" : " unit='" + unit + "'") + ">" + content + "</amf>";
}

MeshFile read(const std::string& text) { return read_text(text, Format::amf); }
std::string refused(const std::string& text) { return refusal(text, Format::amf); }

}  // namespace

TEST_CASE("AMF is read as text and in an archive, with its unit", "[io][amf]") {
  const std::string text = amf("<object id='0'>" + mesh + "</object>", "feet");
  CHECK(read(text).mesh == tetrahedron);
  CHECK(read(text).unit == Unit::foot);
  CHECK(read(amf("<object id='0'>" + mesh + "</object>")).unit == Unit::millimeter);
  io::StringSink sink;
  io::ZipWriter zip(sink);
  zip.add("part.amf", text);
  zip.finish();
  CHECK(read(sink.take()).mesh == tetrahedron);
  CHECK(refused(amf("", "parsec")).find("unknown unit 'parsec'") != std::string::npos);
}

TEST_CASE("AMF: volumes have materials, wherever these stand; objects have names", "[io][amf]") {
  const std::string volumes = "<mesh>" + points + "<volume materialid='7'>" + half +
                              "</volume><volume materialid='none'>" + other_half + "</volume></mesh>";
  const MeshFile file = read(amf("<object id='0'><metadata type='name'>left &amp; right</metadata>" + volumes +
                                 "</object><material id='7'><metadata "
                                 "type='name'>red</metadata><color><r>1</r><g>0.5</g><b>0</b></color></material>"));
  REQUIRE(file.attributes.materials.size() == 1);
  CHECK(file.attributes.materials[0].name == "red");
  CHECK(file.attributes.materials[0].color == std::array<double, 4>{1, 0.5, 0, 1});
  CHECK(file.attributes.objects == std::vector<std::string>{"left & right"});
  CHECK(*file.attributes.find("material") ==
        Channel{"material", Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>{0, 0, -1, -1}});
}

TEST_CASE("AMF: vertices without a colour are white where others have one", "[io][amf]") {
  const std::string colored = "<vertices>" + vertex("0", "0", "0") +
                              vertex("1", "0", "0", "<color><r>1</r><g>0</g><b>0</b><a>0.5</a></color>") +
                              vertex("0", "1", "0") + "</vertices>";
  const MeshFile file =
      read(amf("<object id='0'><mesh>" + colored + "<volume>" + triangle(0, 1, 2) + "</volume></mesh></object>"));
  CHECK(*file.attributes.find("color") == Channel{"color", Element::vertex, Interpolation::linear, 4,
                                                  std::vector<float>{1, 1, 1, 1, 1, 0, 0, 0.5F, 1, 1, 1, 1}});
}

TEST_CASE("AMF: constellations move objects exactly; what is in one stands nowhere else", "[io][amf]") {
  const std::string instances =
      "<constellation id='9'><instance objectid='0'><deltax>0.5</deltax></instance>"
      "<instance objectid='0'><deltay>-3</deltay></instance></constellation>";
  const MeshFile file = read(amf("<object id='0'>" + mesh + "</object>" + instances));
  REQUIRE(file.mesh.vertices.size() == 8);
  CHECK(file.mesh.vertices[1] == Vertex{1.5, 0, 0});
  CHECK(file.mesh.vertices[6] == Vertex{0, -2, 0});
}

TEST_CASE("AMF that leads astray is refused with the reason", "[io][amf]") {
  const auto object = [](const std::string& content) { return amf("<object id='0'>" + content + "</object>"); };
  CHECK(refused("<stl/>").find("expected <amf>") != std::string::npos);
  CHECK(refused(amf("<object id='0'/><object id='0'/>")).find("two objects have the id '0'") != std::string::npos);
  // Catches readers that give the vertices of the first mesh's colours to both.
  CHECK(refused(object(mesh + mesh)).find("an object has two meshes") != std::string::npos);
  CHECK(refused(object("<mesh>" + points + "<volume>" + triangle(0, 1, 4) + "</volume></mesh>")).find("out of range") !=
        std::string::npos);
  CHECK(refused(object("<mesh><vertices><vertex><coordinates><x>0</x></coordinates></vertex></vertices></mesh>"))
            .find("not all of x, y and z") != std::string::npos);
  const std::string turned = "<constellation id='1'><instance objectid='0'><rx>90</rx></instance></constellation>";
  CHECK(refused(amf("<object id='0'>" + mesh + "</object>" + turned)).find("turned") != std::string::npos);
  const std::string circle =
      "<constellation id='1'><instance objectid='2'/></constellation>"
      "<constellation id='2'><instance objectid='1'/></constellation>"
      "<constellation id='3'><instance objectid='1'/></constellation>";
  CHECK(refused(amf(circle)).find("contain themselves") != std::string::npos);
  CHECK(refused(amf("<constellation id='1'><instance objectid='5'/></constellation>")).find("no object '5'") !=
        std::string::npos);
}
