// glTF and GLB: what is written is read again; accessors of all kinds; files that lead astray are refused.
#include <tbb/task_arena.h>

#include <bit>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "attributed.h"
#include "core/io/binary.h"
#include "core/io/folder_of_model.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {

std::string refused(const std::string& text) { return refusal(text, Format::gltf); }
MeshFile read(const std::string& text, Format format = Format::gltf) {
  return read_mesh(std::string_view(text), format, "test");
}

std::string floats(std::initializer_list<float> values) {
  std::string bytes(values.size() * 4, '\0');
  char* at = bytes.data();
  for (const float value : values) at = io::store(at, value, std::endian::little);
  return bytes;
}

/// A document with one mesh; `members` follow the asset.
std::string document(const std::string& bytes, const std::string& views, const std::string& accessors,
                     const std::string& meshes, const std::string& nodes, const std::string& more = "") {
  return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + std::to_string(bytes.size()) +
         R"(,"uri":"data:application/octet-stream;base64,)" + io::base64(bytes) + R"("}],"bufferViews":[)" + views +
         R"(],"accessors":[)" + accessors + R"(],"meshes":[)" + meshes + R"(],"nodes":[)" + nodes + "]" + more + "}";
}

const std::string three_points = floats({0, 0, 0, 1, 0, 0, 0, 1, 0});

std::string triangle(const std::string& nodes, const std::string& more = "") {
  return document(three_points, R"({"buffer":0,"byteLength":36})",
                  R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})",
                  R"({"primitives":[{"attributes":{"POSITION":0}}]})", nodes, more);
}

}  // namespace

TEST_CASE("glTF keeps objects, materials, colours, textures and images", "[io][gltf]") {
  const Format format = GENERATE(Format::gltf, Format::glb);
  const MeshFile file = two_objects();
  const MeshFile again = read(written(file, format), format);
  CHECK(again.mesh == file.mesh);
  CHECK(again.notes.empty());
  CHECK(again.attributes.objects == file.attributes.objects);
  CHECK(again.attributes.materials == file.attributes.materials);
  CHECK(again.attributes.images == file.attributes.images);
  for (const char* name : {"material", "object"}) {
    CAPTURE(name);
    CHECK(*again.attributes.find(name) == *file.attributes.find(name));
  }
  for (std::size_t f = 0; f < 8; ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 2; ++i)
        CHECK(value_at(again, "texcoord", f, k, i) == value_at(file, "texcoord", f, k, i));
      for (std::size_t i = 0; i < 4; ++i) CHECK(value_at(again, "color", f, k, i) == value_at(file, "color", f, k, i));
    }
  // Once more: nothing changes any more.
  CHECK(written(again, format) == written(read(written(again, format), format), format));
}

TEST_CASE("glTF: objects that share edges stay one mesh with their names", "[io][gltf]") {
  MeshFile file = two_objects();
  auto& object = std::get<std::vector<std::int32_t>>(file.attributes.channels[3].values);
  object = {0, 1, 1, 0, 0, 0, 0, 0};
  const MeshFile again = read(written(file, Format::glb), Format::glb);
  CHECK(again.mesh.vertices.size() == 8);
  REQUIRE(again.attributes.find("object") != nullptr);
  CHECK(again.attributes.objects == file.attributes.objects);
}

TEST_CASE("glTF: transforms of nodes are exact, and mirrored meshes turned round", "[io][gltf]") {
  const MeshFile file =
      read(triangle(R"({"children":[1,2],"translation":[0.5,0,0]},{"mesh":0,"scale":[-2,1,1],"name":"a"},)"
                    R"({"mesh":0,"matrix":[0,1,0,0,-1,0,0,0,0,0,1,0,0,0,0.25,1],"name":"b"})"));
  REQUIRE(file.mesh.vertices.size() == 6);
  CHECK(file.mesh.vertices[1] == Vertex{-1.5, 0, 0});
  CHECK(file.mesh.triangles[0] == Triangle{0, 2, 1});
  CHECK(file.mesh.vertices[4] == Vertex{0.5, 1, 0.25});
  CHECK(file.mesh.triangles[1] == Triangle{3, 4, 5});
  CHECK(file.attributes.objects == std::vector<std::string>{"a", "b"});
  CHECK(file.notes.empty());
}

TEST_CASE("glTF: accessors may be sparse, of integers, interleaved, or nothing but zeros", "[io][gltf]") {
  const std::string sparse = document(
      three_points + std::string("\x02\0\0\0", 4) + floats({7, 8, 9}),
      R"({"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":1},{"buffer":0,"byteOffset":40,"byteLength":12})",
      R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":2}}})",
      R"({"primitives":[{"attributes":{"POSITION":0}}]})", R"({"mesh":0})");
  CHECK(read(sparse).mesh.vertices[2] == Vertex{7, 8, 9});
  // Signed bytes, each point padded to four: as they are, and as 127ths.
  const std::string points("\0\0\0\0\x7f\0\0\0\0\x7f\0\0", 12);
  for (const bool normalized : {false, true}) {
    const std::string text =
        document(points, R"({"buffer":0,"byteLength":12,"byteStride":4})",
                 std::string(R"({"bufferView":0,"componentType":5120,"count":3,"type":"VEC3","normalized":)") +
                     (normalized ? "true}" : "false}"),
                 R"({"primitives":[{"attributes":{"POSITION":0}}]})", R"({"mesh":0})",
                 R"(,"extensionsRequired":["KHR_mesh_quantization"])");
    const MeshFile file = read(text);
    CHECK(file.mesh.vertices[1] == Vertex{normalized ? 1.0 : 127.0, 0, 0});
    CHECK(file.notes.empty() == !normalized);  // 127ths are no doubles
  }
}

TEST_CASE("glTF: strips and fans are triangles", "[io][gltf]") {
  const std::string points = floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  const auto with_mode = [&](int mode) {
    return read(document(
        points, R"({"buffer":0,"byteLength":48})", R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})",
        R"({"primitives":[{"attributes":{"POSITION":0},"mode":)" + std::to_string(mode) + "}]}", R"({"mesh":0})"));
  };
  CHECK(with_mode(5).mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
  CHECK(with_mode(6).mesh.triangles == std::vector<Triangle>{{1, 2, 0}, {2, 3, 0}});
  CHECK(with_mode(1).notes[0] == "1 lists of points and lines ignored");
}

TEST_CASE("glTF: vertices at one place become one, seams are on corners", "[io][gltf]") {
  const std::string bytes = floats({0, 0, 0,   1, 0, 0,   0,  1,  0,   1,   0,  0, 1, 1, 0, 0, 1, 0,  //
                                    0, 0, .25, 0, 0, .25, .5, .5, .75, .75, .5, .5});
  const MeshFile file = read(document(
      bytes, R"({"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":48})",
      R"({"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"},{"bufferView":1,"componentType":5126,"count":6,"type":"VEC2"})",
      R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1}}]})", R"({"mesh":0})"));
  CHECK(file.mesh.vertices.size() == 4);
  CHECK(file.mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
  REQUIRE(file.attributes.find("texcoord")->element == Element::corner);
  CHECK(value_at(file, "texcoord", 0, 2, 1) == 0.75);
  CHECK(value_at(file, "texcoord", 1, 2, 1) == 0.5);
}

// Large enough for several threads, and for several parts of the vertices.
TEST_CASE("glTF: a large mesh with seams comes back as it was, for any number of threads", "[io][gltf]") {
  constexpr std::uint32_t side = 200;
  MeshFile file;
  for (std::uint32_t i = 0; i <= side; ++i)
    for (std::uint32_t j = 0; j <= side; ++j) file.mesh.vertices.push_back({double(i), double(j), double(i * j % 7)});
  for (std::uint32_t i = 0; i < side; ++i)
    for (std::uint32_t j = 0; j < side; ++j) {
      const std::uint32_t v = i * (side + 1) + j;
      file.mesh.triangles.push_back({v, v + side + 1, v + 1});
      file.mesh.triangles.push_back({v + 1, v + side + 1, v + side + 2});
    }
  std::vector<float> places, levels;
  for (std::size_t t = 0; t < file.mesh.triangles.size(); ++t)
    for (const std::uint32_t v : file.mesh.triangles[t]) {
      places.push_back(static_cast<float>(v));
      levels.push_back(static_cast<float>(t / 1000 % 3));  // seams of many kinds, most vertices have none
    }
  const bool has_seams = GENERATE(true, false);
  file.attributes.channels.push_back({"place", Element::corner, Interpolation::linear, 1, std::move(places)});
  if (has_seams)
    file.attributes.channels.push_back({"level", Element::corner, Interpolation::linear, 1, std::move(levels)});
  std::vector<std::string> texts;
  for (const int threads : {1, 2}) {
    tbb::task_arena arena(threads);
    arena.execute([&] {
      texts.push_back(written(file, Format::glb));
      const MeshFile again = read(texts.back(), Format::glb);
      CHECK(again.mesh == file.mesh);
      const Channel& place = *again.attributes.find("place");
      REQUIRE(place.element == Element::vertex);
      for (std::uint32_t v = 0; v < file.mesh.vertices.size(); ++v)
        REQUIRE(std::get<std::vector<float>>(place.values)[v] == static_cast<float>(v));
      if (has_seams) CHECK(*again.attributes.find("level") == file.attributes.channels[1]);
    });
  }
  CHECK(texts[0] == texts[1]);
}

TEST_CASE("glTF: what leads in circles, or nowhere, is refused by name", "[io][gltf]") {
  const auto says = [](const std::string& text, const char* what) {
    CAPTURE(text, refused(text));
    CHECK(refused(text).find(what) != std::string::npos);
  };
  says(triangle(R"({"mesh":0,"children":[0]})", R"(,"scenes":[{"nodes":[0]}])"), "nodes[0]: is a child of itself");
  says(triangle(R"({"mesh":3})"), "meshes: has no element 3");
  says(triangle(R"({"mesh":0,"matrix":[1,2]})"), "nodes[0].matrix: has not 16 numbers");
  says(triangle(R"({"mesh":0})", R"(,"extensionsRequired":["KHR_draco_mesh_compression"])"),
       "KHR_draco_mesh_compression");
  std::string chain;
  for (int i = 1; i < 1000; ++i) chain += R"({"children":[)" + std::to_string(i) + "]},";
  says(triangle(chain + R"({"mesh":0})"), "nested more than 200 deep");
  std::string doubling;
  for (int i = 1; i < 60; ++i) doubling += R"({"children":[)" + std::to_string(i) + "," + std::to_string(i) + "]},";
  says(triangle(doubling + R"({"mesh":0})"), "unfold");
  says(document(three_points, R"({"buffer":0,"byteLength":36})",
                R"({"bufferView":0,"componentType":5126,"count":4000000000,"type":"VEC3"})",
                R"({"primitives":[{"attributes":{"POSITION":0}}]})", R"({"mesh":0})"),
       "accessors[0]: exceeds its part");
  says(document(three_points, R"({"buffer":0,"byteLength":36})",
                R"({"componentType":5126,"count":4000000000,"type":"VEC3"})",
                R"({"primitives":[{"attributes":{"POSITION":0}}]})", R"({"mesh":0})"),
       "unfold to more than 8 million");
  says(std::string(5000, '['), "nested more than 100 deep");
  says(R"({"asset":{"version":"1.0"}})", "version '1.0'");
  says("{\"asset\":", "malformed");
  std::string glb = to_string(tetrahedron, Format::glb);
  for (std::size_t size = 1; size < glb.size(); ++size)
    CHECK_THROWS_AS(read(glb.substr(0, size), Format::glb), IoError);
}

TEST_CASE("glTF reads no file that is not beneath the folder of the model", "[io][gltf]") {
  const auto folder = std::filesystem::temp_directory_path() / "strata-gltf-test";
  std::filesystem::create_directories(folder / "model/inner");
  std::ofstream(folder / "outside.bin", std::ios::binary) << three_points;
  std::ofstream(folder / "model/inner/a b.bin", std::ios::binary) << three_points;
  std::error_code ignored;
  std::filesystem::create_symlink(folder / "outside.bin", folder / "model/link.bin", ignored);
  const auto with_uri = [&](const std::string& uri) {
    std::string text = triangle(R"({"mesh":0})");
    const std::size_t first = text.find("data:"), last = text.find('"', first);
    text.replace(first, last - first, uri);
    std::ofstream(folder / "model/model.gltf") << text;
    return folder / "model/model.gltf";
  };
  CHECK(read_mesh(with_uri("inner/a%20b.bin")).mesh.triangles.size() == 1);
  CHECK(read_mesh(with_uri("inner/../inner/a b.bin")).mesh.triangles.size() == 1);
  for (const std::string& uri :
       {std::string("../outside.bin"), (folder / "outside.bin").generic_string(), std::string("link.bin"),
        std::string("%2e%2e/outside.bin"), std::string("inner"), std::string("https://x/y.bin")}) {
    CAPTURE(uri);
    CHECK_THROWS_WITH(read_mesh(with_uri(uri)), Catch::Contains("beneath the folder of the model"));
  }
  std::filesystem::remove_all(folder);
}

TEST_CASE("glTF tells what it rounds", "[io][gltf]") {
  MeshFile file = two_objects();
  file.mesh.vertices[1][0] = 0.1;
  WriteOptions options;
  options.format = Format::glb;
  options.attributes = &file.attributes;
  options.unit = Unit::inch;
  std::ostringstream stream;
  const auto notes = write_mesh(stream, ExactMesh{file.mesh, {}}, options);
  REQUIRE(notes.size() == 2);
  CHECK(notes[0].find("1 of 8 vertices were rounded: glTF holds floats only") == 0);
  CHECK(notes[1] == "the unit (inch) left out: glTF cannot keep it");
}
