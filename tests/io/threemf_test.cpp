// 3MF: what is written is read again with all that it has; files that lead astray are refused.
#include <catch2/catch.hpp>
#include <string>

#include "attributed.h"
#include "core/io/zip_writer.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {

/// An archive with this model.
std::string archive(const std::string& model, const std::vector<std::pair<std::string, std::string>>& more = {}) {
  io::StringSink sink;
  io::ZipWriter zip(sink);
  zip.add("3D/3dmodel.model", model);
  for (const auto& [name, bytes] : more) zip.add(name, bytes);
  zip.finish();
  return sink.take();
}

std::string model(const std::string& resources, const std::string& build, const std::string& attributes = "") {
  return "<?xml version=\"1.0\"?><model " + attributes + "><resources>" + resources + "</resources><build>" + build +
         "</build></model>";
}

const std::string tetrahedron_mesh =
    "<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/>"
    "<vertex x='0' y='0' z='1'/></vertices><triangles><triangle v1='0' v2='2' v3='1'/>"
    "<triangle v1='0' v2='1' v3='3'/><triangle v1='1' v2='2' v3='3'/><triangle v1='2' v2='0' v3='3'/></triangles>"
    "</mesh>";

std::string object(int id, const std::string& content, const std::string& attributes = "") {
  return "<object id='" + std::to_string(id) + "' " + attributes + ">" + content + "</object>";
}

MeshFile read(const std::string& bytes) { return read_mesh(std::string_view(bytes), Format::threemf, "test"); }

std::string refused(const std::string& bytes) { return refusal(bytes, Format::threemf); }

}  // namespace

TEST_CASE("3MF keeps objects, materials, colours, textures and the unit", "[io][3mf]") {
  const MeshFile file = two_objects();
  const MeshFile again = read(written(file, Format::threemf));
  CHECK(again.mesh == file.mesh);
  CHECK(again.unit == Unit::inch);
  CHECK(again.notes.empty());
  CHECK(again.attributes.objects == file.attributes.objects);
  CHECK(again.attributes.materials == file.attributes.materials);
  CHECK(again.attributes.images == file.attributes.images);
  for (const char* name : {"material", "color", "object"}) {
    CAPTURE(name);
    CHECK(*again.attributes.find(name) == *file.attributes.find(name));
  }
  for (std::size_t f = 4; f < 8; ++f)
    for (std::size_t k = 0; k < 6; ++k)
      CHECK(value_at(again, "texcoord", f, k / 2, k % 2) == value_at(file, "texcoord", f, k / 2, k % 2));
}

TEST_CASE("3MF: objects that are not closed are written as one, so that the whole stays a solid", "[io][3mf]") {
  MeshFile file = two_objects();
  std::get<std::vector<std::int32_t>>(file.attributes.channels[3].values)[0] = 1;
  WriteOptions options;
  options.format = Format::threemf;
  options.attributes = &file.attributes;
  std::ostringstream stream;
  const auto notes = write_mesh(stream, ExactMesh{file.mesh, {}}, options);
  const MeshFile again = read(stream.str());
  CHECK(again.mesh == file.mesh);
  CHECK(again.attributes.find("object") == nullptr);
  CHECK(notes == std::vector<std::string>{"names of objects left out: 3MF cannot keep them"});
}

TEST_CASE("3MF components are placed by exact transforms", "[io][3mf]") {
  const std::string inner =
      "<components><component objectid='1' transform='2 0 0 0 1 0 0 0 1 10 0 0'/>"
      "<component objectid='1' transform='-1 0 0 0 1 0 0 0 1 0 0 0'/></components>";
  const std::string file = archive(model(object(1, tetrahedron_mesh, "name='part'") + object(2, inner),
                                         "<item objectid='2' transform='0 1 0 -1 0 0 0 0 1 0 0 0.5'/>", "unit='foot'"));
  const MeshFile read_file = read(file);
  REQUIRE(read_file.mesh.vertices.size() == 8);
  // (1,0,0): twice, 10 further, turned by 90 degrees about z, up by a half.
  CHECK(read_file.mesh.vertices[1] == Vertex{0, 12, 0.5});
  // Mirrored: triangles are turned round.
  CHECK(read_file.mesh.vertices[5] == Vertex{0, -1, 0.5});
  CHECK(read_file.mesh.triangles[4] == Triangle{4, 5, 6});
  CHECK(read_file.attributes.objects == std::vector<std::string>{"part", "part"});
  CHECK(read_file.unit == Unit::foot);
  CHECK(read_file.notes.empty());
}

TEST_CASE("3MF: a vertex that a transform rounds is told", "[io][3mf]") {
  const std::string file =
      archive(model(object(1, tetrahedron_mesh), "<item objectid='1' transform='1 0 0 0 1 0 0 0 1 1e17 0 0'/>"));
  const MeshFile read_file = read(file);
  REQUIRE(read_file.notes.size() == 1);
  CHECK(read_file.notes[0].find("1 of 4 vertices are rounded") == 0);
}

TEST_CASE("3MF: coordinates are the doubles that the decimals are nearest to", "[io][3mf]") {
  const Mesh mesh{{{0.1, -0.0, 5e-324}, {1e308, 1 / 3.0, 0}, {1, 2, 3}}, {{0, 1, 2}}};
  const MeshFile again = read(to_string(mesh, Format::threemf));
  CHECK(again.mesh == mesh);
  CHECK(std::signbit(again.mesh.vertices[0][1]));
}

TEST_CASE("3MF: what leads in circles, or nowhere, is refused by name", "[io][3mf]") {
  const auto component = [](int of) {
    return "<components><component objectid='" + std::to_string(of) + "'/></components>";
  };
  const std::string item = "<item objectid='2'/>";
  CHECK(refused(archive(model(object(1, component(2)) + object(2, component(1)), item)))
            .find("object 2 is a component of itself") != std::string::npos);
  CHECK(refused(archive(model(object(2, component(7)), item))).find("there is no object 7") != std::string::npos);
  std::string doubling = object(100, tetrahedron_mesh);
  for (int i = 101; i < 140; ++i)
    doubling += object(i, "<components><component objectid='" + std::to_string(i - 1) + "'/><component objectid='" +
                              std::to_string(i - 1) + "'/></components>");
  CHECK(refused(archive(model(doubling, "<item objectid='139'/>"))).find("unfold") != std::string::npos);
  CHECK(refused(archive("<!DOCTYPE a [<!ENTITY b \"c\">]>" + model("", ""))).find("document types") !=
        std::string::npos);
  CHECK(refused(archive(model("", "", "requiredextensions='b' xmlns:b='http://x/beamlattice/2017/02'")))
            .find("beamlattice") != std::string::npos);
  CHECK(refused(
            archive(model(
                object(1, "<mesh><vertices/><triangles>\n<triangle v1='0' v2='1' v3='2'/></triangles></mesh>"), item)))
            .find("3D/3dmodel.model, line 2: vertex index 0 is out of range") != std::string::npos);
  CHECK(refused(archive(model(object(2, tetrahedron_mesh, "pid='9' pindex='0'"), item))).find("the group 9") !=
        std::string::npos);
  CHECK(refused("PK").find("no 3MF file") != std::string::npos);
}

TEST_CASE("3MF: archives that unfold, lie or are damaged are refused", "[io][3mf]") {
  const std::string bomb(std::size_t{200} << 20, ' ');
  CHECK(refused(archive(bomb)).find("unpacks to more than") != std::string::npos);
  const std::string good = archive(model(object(2, tetrahedron_mesh), "<item objectid='2'/>"));
  REQUIRE(read(good).mesh == tetrahedron);
  for (std::size_t size = 0; size < good.size(); ++size) CHECK_FALSE(refused(good.substr(0, size)).empty());
  for (std::size_t i = 0; i < good.size(); ++i)
    for (const int bit : {0, 3, 7}) {
      std::string bad = good;
      bad[i] = static_cast<char>(bad[i] ^ (1 << bit));
      try {
        const Mesh mesh = read(bad).mesh;
        CHECK(mesh == tetrahedron);  // names, dates and the like
      } catch (const IoError&) {
      }
    }
}

TEST_CASE("3MF is the same for any number of threads, and strict where it loses nothing", "[io][3mf]") {
  const MeshFile file = two_objects();
  WriteOptions options;
  options.format = Format::threemf;
  options.attributes = &file.attributes;
  options.strict = true;
  CHECK(to_string(ExactMesh{file.mesh, {}}, options) == [&] {
    auto same = options;
    same.strict = false;
    return to_string(ExactMesh{file.mesh, {}}, same);
  }());
  options.format = Format::off;
  CHECK_THROWS_AS(to_string(ExactMesh{file.mesh, {}}, options), IoError);
}

// Catches: lists cut where a piece does not stand alone, items out of order or twice, errors that name another line.
TEST_CASE("3MF: long lists are read as short ones are, whatever stands between their elements", "[io][3mf]") {
  constexpr int count = 20'000;
  const auto vertex = [](int i, const std::string& end = "/>") {
    return "<vertex x='" + std::to_string(i) + "' y='0.5' z='-1'" + end + "\n";
  };
  /// Vertices 0 to count - 1, with `in_middle` before number count / 2, and a triangle of the last three.
  const auto with = [&](const std::string& in_middle, const std::string& end = "/>") {
    std::string vertices;
    for (int i = 0; i < count; ++i) vertices += (i == count / 2 ? in_middle : "") + vertex(i, end);
    return archive(
        model(object(1, "<mesh><vertices>" + vertices + "</vertices><triangles><triangle v1='19997' v2='19998' " +
                            "v3='19999'/></triangles></mesh>"),
              "<item objectid='1'/>"));
  };
  std::string others;
  for (int i = 0; i < count; ++i) others += vertex(-1 - i);
  const std::vector<std::string> nothing{"",
                                         "<!-- " + others + " -->",
                                         "<!-- <vertex/> </vertices> -->",
                                         "<?odd <vertex/>?>",
                                         "<![CDATA[" + others + "]]>",
                                         "text",
                                         "<other>" + others + "</other>",
                                         "<other a=\"" + others + "\"/>",
                                         "<other a='</vertices>'/>"};
  for (const std::string& in_middle : nothing) {
    CAPTURE(in_middle.substr(0, 40));
    const MeshFile file = read(with(in_middle));
    REQUIRE(file.mesh.vertices.size() == count);
    for (int i = 0; i < count; ++i)
      REQUIRE(file.mesh.vertices[static_cast<std::size_t>(i)] == Vertex{i + 0.0, 0.5, -1});
    CHECK(file.mesh.triangles == std::vector<Triangle>{{19'997, 19'998, 19'999}});
  }
  CHECK(read(with("", "></vertex>")).mesh.vertices.size() == count);
  CHECK_THAT(refused(with("<vertex x='1' y='2'/>")), Catch::EndsWith("line 10001: a vertex has not all of x, y and z"));
  CHECK_THAT(refused(with("<vertex x='1' y='2' z='?'/>")), Catch::Contains("line 10001"));
  CHECK_THAT(refused(with("<vertex x='1' y='2' z='3'>")), Catch::Contains("ends an element that was not started"));
  CHECK_THAT(refused(with("</vertices>")), Catch::Contains("ends an element that was not started"));
}
