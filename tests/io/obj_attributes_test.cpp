// OBJ: texture coordinates, normals, colours, groups, objects and materials are read, written, and read again.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include "attributed.h"
#include "core/io/readers.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {

struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / "strata-obj-test";
  Folder() { std::filesystem::create_directories(path / "inner"); }
  ~Folder() { std::filesystem::remove_all(path); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
  }
};

}  // namespace

TEST_CASE("OBJ keeps all that it has beside a library of materials", "[io][obj]") {
  const Folder folder;
  MeshFile file = two_objects();
  file.attributes.materials[1].name = "wood";
  file.attributes.groups = {"front", "back side"};
  file.attributes.channels.push_back(
      {"group", Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>{0, 0, 1, 1, 1, 0, 0, 1}});
  file.attributes.channels[1].components = 3;
  std::get<std::vector<std::uint8_t>>(file.attributes.channels[1].values).resize(24);
  std::vector<double> normals(72);
  for (std::size_t i = 0; i < 72; i += 3) normals[i + i % 9 / 3] = i < 36 ? 1 : -1;
  file.attributes.channels.push_back({"normal", Element::corner, Interpolation::spherical, 3, normals});
  WriteOptions options;
  options.attributes = &file.attributes;
  CHECK(write_mesh(folder.path / "a.obj", file.mesh, options).empty());
  const MeshFile again = read_mesh(folder.path / "a.obj");
  CHECK(again.mesh == file.mesh);
  CHECK(again.notes.empty());
  CHECK(again.attributes.materials[0] == file.attributes.materials[0]);
  CHECK(again.attributes.materials[1].image == 0U);
  CHECK(again.attributes.images[0].bytes == file.attributes.images[0].bytes);
  CHECK(again.attributes.objects == std::vector<std::string>{"left", "right <&>"});
  CHECK(again.attributes.groups == file.attributes.groups);
  for (const Channel& c : file.attributes.channels) {
    CAPTURE(c.name);
    CHECK(*again.attributes.find(c.name) == c);
  }
}

TEST_CASE("OBJ: corners of polygons and relative indices have what the file says, in pieces too", "[io][obj]") {
  std::string text =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1 5\nf 1 2 3\nusemtl a\nf 1/1 2/2 3/3 4/4\n"
      "g x y\nf -4/-1 -3/-2 -2/-3\n";
  for (const std::size_t piece : {std::size_t{1000}, std::size_t{8}}) {
    const MeshFile file = io::read({"test", text, piece}, Format::obj);
    REQUIRE(file.mesh.triangles.size() == 4);
    for (std::size_t k = 0; k < 3; ++k) CHECK(value_at(file, "texcoord", 0, k, 0) == 0);
    for (std::size_t t = 1; t < 3; ++t)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 2; ++i)
          CHECK(value_at(file, "texcoord", t, k, i) == file.mesh.vertices[file.mesh.triangles[t][k]][i]);
    CHECK(value_at(file, "texcoord", 3, 0, 1) == 1);
    CHECK(*file.attributes.find("material") ==
          Channel{"material", Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>{-1, 0, 0, 0}});
    CHECK(*file.attributes.find("group") ==
          Channel{"group", Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>{-1, -1, -1, 0}});
    CHECK(file.attributes.groups == std::vector<std::string>{"x y"});
  }
  const MeshFile astray = read_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nf 1/1 2/2 3/3\n", Format::obj);
  CHECK(astray.notes == std::vector<std::string>{"2 corners have no texcoord: there is none of that index"});
}

TEST_CASE("OBJ: a library is read beneath the folder only; what is damaged in it is left out", "[io][obj]") {
  const Folder folder;
  folder.write(
      "inner/a.mtl",
      "Kd 1 0 0\nnewmtl my red\nKd 0.5 0.25 x\nKd 0.5 0.25 0\nd 0.5\nmap_Kd -s 1 1 1 ../outside.png\nmap_Kd pic.png\n");
  folder.write("inner/pic.png", "picture");
  const std::string mesh = "usemtl my red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  folder.write("a.obj", "mtllib inner/a.mtl\n" + mesh);
  const MeshFile file = read_mesh(folder.path / "a.obj");
  REQUIRE(file.attributes.materials.size() == 1);
  CHECK(file.attributes.materials[0].color == std::array<double, 4>{0.5, 0.25, 0, 0.5});
  CHECK(file.attributes.images[0].bytes == bytes_of("picture"));
  CHECK(file.notes.size() == 1);
  folder.write("inner/b.obj", "mtllib ../a.obj\nmtllib /etc/passwd\n" + mesh);
  const MeshFile other = read_mesh(folder.path / "inner/b.obj");
  CHECK(other.notes.size() == 2);
  CHECK(other.attributes.materials[0].name == "my red");
}

TEST_CASE("OBJ: a library that stands there is replaced only if all files are complete", "[io][obj]") {
  // Catches a library that is replaced while the mesh is not: a strict error, a name that cannot be written.
  const Folder folder;
  const MeshFile file = two_objects();
  folder.write("a.mtl", "mine");
  folder.write("a-wood.png", "mine, too");
  const auto text_of = [&](const char* name) {
    std::ifstream stream(folder.path / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  WriteOptions options;
  options.attributes = &file.attributes;
  options.unit = Unit::inch;
  options.strict = true;
  CHECK_THROWS_AS(write_mesh(folder.path / "a.obj", file.mesh, options), IoError);
  CHECK_FALSE(std::filesystem::exists(folder.path / "a.obj"));
  CHECK(text_of("a.mtl") == "mine");
  CHECK(text_of("a-wood.png") == "mine, too");
  options.strict = false;
  std::filesystem::create_directories(folder.path / "b.mtl");
  folder.write("b-wood.png", "mine, too");
  CHECK_THROWS_AS(write_mesh(folder.path / "b.obj", file.mesh, options), IoError);
  CHECK_FALSE(std::filesystem::exists(folder.path / "b.obj"));
  CHECK(text_of("b-wood.png") == "mine, too");
  CHECK(write_mesh(folder.path / "a.obj", file.mesh, options).size() == 2);
  CHECK(text_of("a.mtl").find("newmtl") == 0);
  CHECK(text_of("a-wood.png") == "\x89PNG, or so");
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path)) files += entry.is_regular_file();
  CHECK(files == 4);
}

TEST_CASE("Numbers of a list that there is not are no error, and told where a format cannot keep them", "[io]") {
  MeshFile file;
  file.mesh = tetrahedron;
  for (const char* name : {"material", "object", "group"})
    file.attributes.channels.push_back(
        {name, Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>{7, 7, -3, 0}});
  const std::string all = "channels material, object, group left out: ";
  for (const Format format : {Format::obj, Format::threemf, Format::glb, Format::off, Format::stl_ascii, Format::ply,
                              Format::vtk, Format::msh}) {
    CAPTURE(name(format));
    WriteOptions options;
    options.format = format;
    options.attributes = &file.attributes;
    std::ostringstream stream;
    const std::string notes = all_notes(write_mesh(stream, ExactMesh{file.mesh, {}}, options));
    if (format == Format::ply || format == Format::vtk)
      CHECK(notes.empty());
    else if (format == Format::msh)
      CHECK(notes.find("channels material, object left out") != std::string::npos);
    else
      CHECK(notes.find(all) != std::string::npos);
  }
  file.attributes.groups = {"one"};
  CHECK_THROWS_AS(written(file, Format::obj), std::invalid_argument);
}
