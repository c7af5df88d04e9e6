// PLY: properties become channels, channels become properties, and what was written is read.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include "attributed.h"
#include "core/io/readers.h"
#include "random_channels.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {

constexpr Format encodings[] = {Format::ply, Format::ply_ascii, Format::ply_big_endian};
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string list = "property list uchar int vertex_indices\n";

std::string text_of(const std::string& vertex, const std::string& face, const std::string& data,
                    const std::string& faces = "1") {
  return "ply\nformat ascii 1.0\nelement vertex 4\n" + xyz + vertex + "element face " + faces + "\n" + list + face +
         "end_header\n" + data;
}

/// Four vertices at the corners of a square, each with the same words behind it.
std::string square(const std::string& words) {
  std::string text;
  for (const char* p : {"0 0 0", "1 0 0", "1 1 0", "0 1 0"}) text += std::string(p) + " " + words + "\n";
  return text;
}

template <class T>
std::vector<T> values(const MeshFile& file, std::string_view name) {
  const Channel* const c = file.attributes.find(name);
  REQUIRE(c != nullptr);
  REQUIRE(std::holds_alternative<std::vector<T>>(c->values));
  return std::get<std::vector<T>>(c->values);
}

std::string described(const MeshFile& file) {
  constexpr std::array<const char*, 3> elements{"vertex", "corner", "face"}, rules{"linear", "spherical", "nearest"};
  constexpr std::array<const char*, 4> types{"float", "double", "byte", "integer"};
  std::string text;
  for (const Channel& c : file.attributes.channels)
    text += c.name + ":" + elements[static_cast<std::size_t>(c.element)] + "," +
            rules[static_cast<std::size_t>(c.interpolation)] + "," + std::to_string(c.components) + "," +
            types[c.values.index()] + " ";
  return text;
}

/// Declares properties `names` of one type.
std::string properties(const std::string& type, std::initializer_list<const char*> names) {
  std::string text;
  for (const char* name : names) text.append("property ").append(type).append(" ").append(name).append("\n");
  return text;
}

}  // namespace

TEST_CASE("PLY: known names of properties make normals, texture coordinates and colours", "[io][ply]") {
  const auto read = [](const std::string& lines, const std::string& words) {
    return described(read_text(text_of(lines, "", square(words) + "3 0 1 2\n"), Format::ply));
  };
  CHECK(read(properties("float", {"nx", "ny", "nz"}), "0 0 1") == "normal:vertex,spherical,3,float ");
  CHECK(read(properties("double", {"nz", "nx", "ny"}), "0 0 1") == "normal:vertex,spherical,3,double ");
  for (const auto& [s, t] : {std::pair("s", "t"), std::pair("u", "v"), std::pair("texture_u", "texture_v")})
    CHECK(read(properties("float", {s, t}), "0 1") == "texcoord:vertex,linear,2,float ");
  CHECK(read(properties("uchar", {"red", "green", "blue"}), "1 2 3") == "color:vertex,linear,3,byte ");
  CHECK(read(properties("uchar", {"r", "g", "b", "a"}), "1 2 3 4") == "color:vertex,linear,4,byte ");
  CHECK(read(properties("float", {"diffuse_red", "diffuse_green", "diffuse_blue"}), "1 0 0.5") ==
        "color:vertex,linear,3,float ");
  // Parts that are missing, of several types, or integers that are no bytes make no such channel.
  CHECK(read(properties("float", {"nx", "ny"}), "0 1") == "nx:vertex,linear,1,float ny:vertex,linear,1,float ");
  CHECK(read(properties("float", {"s"}) + properties("double", {"t"}), "0 1") ==
        "s:vertex,linear,1,float t:vertex,linear,1,double ");
  CHECK(read(properties("ushort", {"red", "green", "blue"}), "1 2 3") ==
        "red:vertex,nearest,1,integer green:vertex,nearest,1,integer blue:vertex,nearest,1,integer ");
  CHECK(read(properties("uchar", {"red", "green", "blue"}) + properties("float", {"alpha"}), "1 2 3 0.5") ==
        "color:vertex,linear,3,byte alpha:vertex,linear,1,float ");
}

TEST_CASE("PLY: other properties are channels of one number, in a type that holds it", "[io][ply]") {
  const std::string lines = properties("char", {"i1"}) + properties("uchar", {"b"}) + properties("short", {"i2"}) +
                            properties("ushort", {"i3"}) + properties("int", {"i4"}) +
                            properties("uint", {"i5", "d5"}) + properties("float", {"f"}) + properties("double", {"d"});
  const MeshFile file = read_text(
      text_of(lines, "", square("-128 255 -32768 65535 -2147483648 2147483647 2147483648 0.1 nan") + "3 0 1 2\n"),
      Format::ply);
  CHECK(described(file) ==
        "i1:vertex,nearest,1,integer b:vertex,nearest,1,byte i2:vertex,nearest,1,integer i3:vertex,nearest,1,integer "
        "i4:vertex,nearest,1,integer i5:vertex,nearest,1,integer d5:vertex,nearest,1,double f:vertex,linear,1,float "
        "d:vertex,linear,1,double ");
  CHECK(values<std::int32_t>(file, "i4")[3] == std::numeric_limits<std::int32_t>::min());
  CHECK(values<std::int32_t>(file, "i5")[0] == std::numeric_limits<std::int32_t>::max());
  CHECK(values<double>(file, "d5")[0] == 2147483648.0);
  CHECK(values<float>(file, "f")[0] == 0.1F);
  CHECK(std::isnan(values<double>(file, "d")[2]));
  CHECK(file.notes.empty());
}

TEST_CASE("PLY: words that are no numbers of their types are 0, which is noted", "[io][ply]") {
  const std::string lines = properties("uchar", {"b"}) + properties("int", {"i"}) + properties("float", {"f"});
  const MeshFile file = read_text(
      text_of(lines, "", "0 0 0 256 1.5 red\n1 0 0 -1 2147483648 1e999\n1 1 0 7.0 +5 -inf\n0 1 0 1 1 1\n3 0 1 2\n"),
      Format::ply);
  CHECK(values<std::uint8_t>(file, "b") == std::vector<std::uint8_t>{0, 0, 7, 1});
  CHECK(values<std::int32_t>(file, "i") == std::vector<std::int32_t>{0, 0, 5, 1});
  CHECK(values<float>(file, "f") == std::vector<float>{0, 0, -std::numeric_limits<float>::infinity(), 1});
  CHECK(file.notes == std::vector<std::string>{"6 values of properties are no numbers of their types: taken for 0"});
}

TEST_CASE("PLY: triangles have what their polygon has, also where faces are left out", "[io][ply]") {
  const std::string face = properties("uchar", {"red", "green", "blue"}) + properties("int", {"material"}) +
                           "property list uchar float texcoord\n";
  const std::string faces =
      "3 0 1 2  1 2 3  5  6 0 0 1 0 1 1\n"
      "3 0 1 1  4 5 6  6  6 9 9 9 9 9 9\n"
      "4 0 1 2 3  7 8 9  7  8 0 0 1 0 1 1 0 1\n"
      "5 0 0 1 2 3  7 8 9  8  10 0 0 5 5 1 0 1 1 0 1\n"
      "3 2 3 0  0 0 1  9  4 1 1 0 1\n";
  for (const std::size_t piece : {std::size_t{1000}, std::size_t{1}}) {
    const std::string text = text_of("", face, square("") + faces, "5");
    const MeshFile file = io::read({"test", text, piece}, Format::ply);
    REQUIRE(file.polygon_of_triangle == std::vector<std::uint32_t>{0, 2, 2, 3, 3, 4});
    CHECK(values<std::int32_t>(file, "material") == std::vector<std::int32_t>{5, 7, 7, 8, 8, 9});
    CHECK(values<std::uint8_t>(file, "color") ==
          std::vector<std::uint8_t>{1, 2, 3, 7, 8, 9, 7, 8, 9, 7, 8, 9, 7, 8, 9, 0, 0, 1});
    for (std::size_t t = 0; t < 5; ++t)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 2; ++i)
          CHECK(value_at(file, "texcoord", t, k, i) == file.mesh.vertices[file.mesh.triangles[t][k]][i]);
    CHECK(value_at(file, "texcoord", 5, 0, 0) == 0);
    CHECK(all_notes(file.notes)
              .find("1 face without texcoord: its list there is of another length; the first is face 4") !=
          std::string::npos);
  }
}

TEST_CASE("PLY: faces that are all left out leave no values", "[io][ply]") {
  // Catches values of faces that are kept because no triangle has a polygon.
  const MeshFile file =
      read_text(text_of("", properties("int", {"material"}), square("") + "3 0 1 1 5\n"), Format::ply);
  CHECK(file.mesh.triangles.empty());
  CHECK(values<std::int32_t>(file, "material").empty());
}

TEST_CASE("PLY: what becomes no channel is noted, once for each kind", "[io][ply]") {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz + properties("float", {"q"}) +
      "property list uchar int rings\nelement face 1\n" + list + properties("float", {"q"}) +
      "property list uchar int a\nelement edge 1\nproperty int e\nelement user 1\nproperty int u\nend_header\n" +
      "0 0 0 1 0\n1 0 0 2 0\n0 1 0 3 1 7\n3 0 1 2 5 0\n1\n2\n";
  const MeshFile file = read_text(text, Format::ply);
  CHECK(values<float>(file, "q") == std::vector<float>{1, 2, 3});
  CHECK(file.notes == std::vector<std::string>{
                          "2 elements left out (neither vertices nor faces); the first is 'edge'",
                          "2 lists left out (neither of vertices nor of a channel on corners); the first is 'rings'"});
  CHECK(values<float>(file, "face_q") == std::vector<float>{5});
  const std::string twice = text_of(properties("float", {"q", "face_q"}), properties("float", {"q", "face_q", "q"}),
                                    square("1 2") + "3 0 1 2 3 4 5\n");
  CHECK(read_text(twice, Format::ply).notes ==
        std::vector<std::string>{"2 channels left out (another one has the name); the first is 'face_q'"});
  const std::string strips = "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz + "element face 1\n" + list +
                             properties("float", {"q"}) + "element tristrips 1\n" + list +
                             "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 5\n3 0 1 2\n";
  CHECK(read_text(strips, Format::ply).notes ==
        std::vector<std::string>{
            "1 property of faces left out (several elements of the file have faces); the first is 'q'"});
}

TEST_CASE("PLY: channels of any kind and name are read as they were written", "[io][ply][property]") {
  const auto seed = GENERATE(range(0U, 60U));
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  MeshFile file;
  file.mesh = random_soup(random, 3 + random() % 40, 1 + random() % 60);
  for (const char* name :
       {"x",        "nx",         "vertex_indices", "two words", "two_words", " blank ",    "normal",
        "texcoord", "s",          "color",          "red",       "color_0",   "face_color", "face_texcoord",
        "face_",    "vertex_red", "face_x",         "material",  "object",    "group",      "\xc3\xa9t\xc3\xa9",
        "#",        "list"})
    if (random() % 2 == 0) file.attributes.channels.push_back(random_channel(random, file.mesh, name));
  // As other programs know them.
  const Interpolation linear = Interpolation::linear;
  if (file.attributes.find("color") == nullptr)
    file.attributes.channels.push_back(random_channel<std::uint8_t>(random, file.mesh, "color", Element::face, linear,
                                                                    static_cast<std::uint32_t>(3 + random() % 2)));
  if (file.attributes.find("texcoord") == nullptr)
    file.attributes.channels.push_back(
        random_channel<float>(random, file.mesh, "texcoord", Element::corner, linear, 2));
  for (const Format format : encodings) {
    const std::string bytes = written(file, format);
    CAPTURE(name(format), bytes.substr(0, 1500));
    for (const std::size_t piece : {bytes.size(), std::size_t{100}, std::size_t{3}}) {
      const MeshFile again = io::read({"test", bytes, piece}, format);
      CHECK(again.mesh == file.mesh);
      CHECK(again.notes.empty());
      REQUIRE(again.attributes.channels.size() == file.attributes.channels.size());
      for (const Channel& c : file.attributes.channels) {
        CAPTURE(c.name);
        REQUIRE(again.attributes.find(c.name) != nullptr);
        CHECK(*again.attributes.find(c.name) == c);
      }
    }
  }
}

TEST_CASE("PLY: a file that is never whole in memory has the same channels", "[io][ply]") {
  std::mt19937_64 random(1);
  MeshFile file;
  file.mesh = random_soup(random, 300, 500);
  for (const char* name : {"a", "b", "c", "d"})
    file.attributes.channels.push_back(random_channel(random, file.mesh, name));
  const auto path = std::filesystem::temp_directory_path() / "strata-ply-pieces.ply";
  std::ofstream(path, std::ios::binary) << written(file, Format::ply);
  const auto again = io::read_binary_ply(io::File(path), 2000, path.parent_path());
  REQUIRE(again);
  for (const Channel& c : file.attributes.channels) CHECK(*again->attributes.find(c.name) == c);
  std::filesystem::remove(path);
}

TEST_CASE("PLY: usual channels are written under usual names, others are announced", "[io][ply]") {
  MeshFile file;
  file.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  file.attributes.channels = {
      {"color", Element::vertex, Interpolation::linear, 3, std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 8, 9}},
      {"speed", Element::vertex, Interpolation::spherical, 2, std::vector<float>{0, 0.5, 1, 2, 3, 4}},
      {"texcoord", Element::corner, Interpolation::linear, 2, std::vector<double>{0, 0, 1, 0, 0, 1}},
      {"material", Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>{3}}};
  CHECK(written(file, Format::ply_ascii) ==
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "comment channel 2 spherical speed\nproperty float speed_0\nproperty float speed_1\n"
        "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar double texcoord\n"
        "comment channel 1 nearest material\nproperty int material\nend_header\n"
        "0 0 0 1 2 3 0 0.5\n1 0 0 4 5 6 1 2\n0 1 0 7 8 9 3 4\n3 0 1 2 6 0 0 1 0 0 1 3\n");
}

// As MeshLab writes them.
TEST_CASE("PLY: colours, normals and numbers of vertices and of faces are both kept", "[io][ply]") {
  const std::string of_vertices = properties("float", {"nx", "ny", "nz"}) + properties("int", {"flags"}) +
                                  properties("uchar", {"red", "green", "blue", "alpha"}) +
                                  properties("float", {"quality", "s", "t"});
  const std::string of_faces = properties("uchar", {"red", "green", "blue", "alpha"}) + properties("int", {"flags"}) +
                               "property list uchar float texcoord\n" + properties("float", {"quality"}) +
                               properties("double", {"nx", "ny", "nz"});
  const MeshFile file =
      read_text(text_of(of_vertices, of_faces,
                        square("0 0 1 7 1 2 3 255 0.5 0 1") + "3 0 1 2 9 8 7 255 1 6 0 0 1 0 1 1 2.5 0 0 1\n"),
                Format::ply);
  CHECK(file.notes.empty());
  CHECK(described(file) ==
        "normal:vertex,spherical,3,float flags:vertex,nearest,1,integer color:vertex,linear,4,byte "
        "quality:vertex,linear,1,float texcoord:vertex,linear,2,float face_color:face,linear,4,byte "
        "face_flags:face,nearest,1,integer face_texcoord:corner,linear,2,float face_quality:face,linear,1,float "
        "face_normal:face,spherical,3,double ");
  CHECK(values<std::uint8_t>(file, "face_color") == std::vector<std::uint8_t>{9, 8, 7, 255});
  const std::string text = written(file, Format::ply_ascii);
  const std::string header = text.substr(0, text.find("end_header"));
  CHECK(header.substr(header.find("element face")) ==
        "element face 1\nproperty list uchar int vertex_indices\n"
        "comment channel 4 linear face_color\n" +
            properties("uchar", {"red", "green", "blue", "alpha"}) + "comment channel 1 nearest face_flags\n" +
            properties("int", {"flags"}) +
            "comment channel 2 linear face_texcoord\nproperty list uchar float texcoord\n"
            "comment channel 1 linear face_quality\n" +
            properties("float", {"quality"}) + "comment channel 3 spherical face_normal\n" +
            properties("double", {"nx", "ny", "nz"}));
  // Also without the comments, which other programs do not keep.
  std::string bare;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
    end = text.find('\n', at) + 1;
    if (text.compare(at, 7, "comment") != 0) bare += text.substr(at, end - at);
  }
  for (const std::string& form : {text, bare}) {
    const MeshFile again = read_text(form, Format::ply);
    REQUIRE(again.attributes.channels.size() == file.attributes.channels.size());
    for (const Channel& c : file.attributes.channels) {
      CAPTURE(c.name);
      REQUIRE(again.attributes.find(c.name) != nullptr);
      const Channel& other = *again.attributes.find(c.name);
      CHECK(other.values == c.values);
      CHECK((other.element == c.element && other.interpolation == c.interpolation));
    }
  }
}

TEST_CASE("PLY: where faces come first, vertices have the longer names", "[io][ply]") {
  const std::string text = "ply\nformat ascii 1.0\nelement face 1\n" + list + properties("uchar", {"r", "g", "b"}) +
                           "element vertex 3\n" + xyz + properties("uchar", {"r", "g", "b"}) +
                           "end_header\n3 0 1 2 1 2 3\n0 0 0 4 5 6\n1 0 0 4 5 6\n0 1 0 4 5 6\n";
  const MeshFile file = read_text(text, Format::ply);
  CHECK(described(file) == "color:face,linear,3,byte vertex_color:vertex,linear,3,byte ");
  const MeshFile again = read_text(written(file, Format::ply_ascii), Format::ply);
  for (const Channel& c : file.attributes.channels) CHECK(*again.attributes.find(c.name) == c);
}

TEST_CASE("PLY: comments that announce nothing sensible are comments", "[io][ply]") {
  for (const char* comment :
       {"channel", "channel 5 linear a", "channel 2 linear a", "channel 1 cubic a", "channel 1 linear",
        "channel 1 linear ", "channel one linear a", "channel 1 spherical  \xff"}) {
    CAPTURE(comment);
    const std::string text = text_of("comment " + std::string(comment) + "\nproperty uchar b\n",
                                     std::string("comment channel 3 linear c\n"), square("7") + "3 0 1 2\n");
    CHECK(described(read_text(text, Format::ply)) == "b:vertex,nearest,1,byte ");
  }
}

TEST_CASE("PLY: names of materials, objects and groups are lost, and names with line ends", "[io][ply]") {
  MeshFile file = two_objects();
  file.attributes.channels.push_back(
      {"a\nb", Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>(8, 1)});
  WriteOptions options;
  options.format = Format::ply;
  options.attributes = &file.attributes;
  std::ostringstream stream;
  CHECK(write_mesh(stream, ExactMesh{file.mesh, {}}, options) ==
        std::vector<std::string>{
            "channel a\nb left out: PLY cannot keep it", "materials left out: PLY cannot keep them",
            "images of textures left out: PLY cannot keep them", "names of objects left out: PLY cannot keep them"});
  const MeshFile again = read_text(stream.str(), Format::ply);
  file.attributes.channels.pop_back();
  for (const Channel& c : file.attributes.channels) CHECK(*again.attributes.find(c.name) == c);
}

TEST_CASE("PLY: textures are materials, if they are beneath the folder of the model", "[io][ply]") {
  const auto folder = std::filesystem::temp_directory_path() / "strata-ply-test";
  std::filesystem::create_directories(folder / "inner");
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name, std::ios::binary) << text;
  };
  write("my wood.png", "picture");
  const std::string body = text_of("", "property list uchar float texcoord\nproperty int texnumber\n",
                                   square("") + "3 0 1 2 6 0 0 1 0 1 1 1\n3 0 2 3 6 0 0 1 0 1 1 0\n3 0 1 3 0 9\n", "3");
  const std::string head = "ply\ncomment TextureFile my wood.png \ncomment TextureFile my wood.png\n";
  write("a.ply", head + body.substr(4));
  const MeshFile file = read_mesh(folder / "a.ply");
  REQUIRE(file.attributes.materials.size() == 2);
  CHECK(file.attributes.materials[1].image == 0U);
  REQUIRE(file.attributes.images.size() == 1);
  CHECK(file.attributes.images[0].bytes == bytes_of("picture"));
  CHECK(values<std::int32_t>(file, "material") == std::vector<std::int32_t>{1, 0, -1});
  CHECK(file.attributes.find("texnumber") == nullptr);
  write("inner/b.ply", "ply\ncomment TextureFile ../my wood.png\n" + body.substr(4));
  const MeshFile other = read_mesh(folder / "inner/b.ply");
  CHECK(other.attributes.images.empty());
  CHECK(other.attributes.materials.empty());
  CHECK(other.attributes.find("texnumber") != nullptr);
  CHECK(all_notes(other.notes).find("the image '../my wood.png' left out") != std::string::npos);
  CHECK(read_text(head + body.substr(4), Format::ply).attributes.materials.empty());
  std::filesystem::remove_all(folder);
}

TEST_CASE("PLY: materials with images are written as textures beside the file", "[io][ply]") {
  const Format format = GENERATE(Format::ply, Format::ply_ascii);
  const auto folder = std::filesystem::temp_directory_path() / "strata-ply-written";
  std::filesystem::create_directories(folder);
  MeshFile file = two_objects();
  file.attributes.materials[1].name = "wood";
  WriteOptions options;
  options.format = format;
  options.attributes = &file.attributes;
  const std::vector<std::string> notes = write_mesh(folder / "a b.ply", ExactMesh{file.mesh, {}}, options);
  CHECK(notes == std::vector<std::string>{"names of objects left out: PLY cannot keep them",
                                          "materials without textures left out: PLY cannot keep them",
                                          "names and looks of materials with textures left out: PLY cannot keep them"});
  const MeshFile again = read_mesh(folder / "a b.ply");
  CHECK(again.mesh == file.mesh);
  REQUIRE(again.attributes.images.size() == 1);
  CHECK(again.attributes.images[0].bytes == file.attributes.images[0].bytes);
  REQUIRE(again.attributes.materials.size() == 1);
  CHECK(again.attributes.materials[0].image == 0U);
  CHECK(values<std::int32_t>(again, "material") == std::vector<std::int32_t>{-1, -1, -1, -1, 0, 0, 0, 0});
  CHECK(*again.attributes.find("texcoord") == *file.attributes.find("texcoord"));
  // A channel that has the name of their numbers keeps it.
  file.attributes.channels.push_back(
      {"texnumber", Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>(8, 7)});
  (void)write_mesh(folder / "c.ply", ExactMesh{file.mesh, {}}, options);
  CHECK(values<std::int32_t>(read_mesh(folder / "c.ply"), "texnumber") == std::vector<std::int32_t>(8, 7));
  CHECK_FALSE(std::filesystem::exists(folder / "c-wood.png"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("PLY: a polygon with many corners and many values costs memory in proportion to the file", "[io][ply]") {
  // Catches values that are repeated on every triangle of a large polygon without a bound.
  constexpr std::size_t corners = 6000, channels = 1000;
  std::string head =
      "ply\nformat ascii 1.0\nelement vertex 4\n" + xyz + "element face 1\nproperty list int int vertex_indices\n";
  std::string face = std::to_string(corners);
  for (std::size_t i = 0; i < corners; ++i) face += " " + std::to_string(i % 4);
  for (std::size_t i = 0; i < channels; ++i) {
    head += "property int p" + std::to_string(i) + "\n";
    face += " 1";
  }
  const MeshFile file = read_text(head + "end_header\n" + square("") + face + "\n", Format::ply);
  CHECK(file.mesh.triangles.size() == corners - 2);
  CHECK(file.attributes.channels.empty());
  CHECK(all_notes(file.notes).find("channels of faces left out: triangles would have more than 4 million values") !=
        std::string::npos);
}
