#if !defined(_WIN32)
#include <sys/stat.h>
#include <unistd.h>
#endif

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>

#include "core/system/program.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;
namespace fs = std::filesystem;

namespace {

/// A directory of its own for every test, removed at the end.
struct Scratch {
  fs::path path = fs::temp_directory_path() / ("strata_io_" + std::to_string(system::process_number()));
  Scratch() { fs::create_directories(path); }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
  }
};

/// True where permissions do not bind: for root, and on Windows, which has others.
bool may_all() {
#if defined(_WIN32)
  return true;
#else
  return ::geteuid() == 0;
#endif
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

template <class Action>
std::string message(const Action& action) {
  try {
    action();
  } catch (const IoError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("Files are written beside the target and renamed when complete", "[io][files]") {
  const Scratch scratch;
  for (const char* file : {"a.stl", "a.obj", "a.off", "a.ply"}) {
    write_mesh(scratch.path / file, tetrahedron);
    CHECK(read_mesh(scratch.path / file).mesh.triangles.size() == 4);
  }
  CHECK(scratch.files() == 4);
}

TEST_CASE("A write that fails leaves the old file and nothing else", "[io][files]") {
  const Scratch scratch;
  const auto path = scratch.path / "a.stl";
  write_mesh(path, tetrahedron);
  const std::string before = text_of(path);
  Mesh huge = tetrahedron;
  huge.vertices[0][0] = 1e300;
  CHECK_THROWS_AS(write_mesh(path, huge), IoError);
  CHECK(text_of(path) == before);
  CHECK(scratch.files() == 1);
}

#if !defined(_WIN32)
TEST_CASE("Links are followed and permissions are kept", "[io][files]") {
  const Scratch scratch;
  const auto path = scratch.path / "a.obj", link = scratch.path / "b.obj";
  std::ofstream(path) << "v 0 0 0\n";
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("a.obj", link);
  write_mesh(link, tetrahedron);
  CHECK(fs::is_symlink(link));
  CHECK(read_mesh(path).mesh == tetrahedron);
  CHECK(fs::status(path).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}
#endif

TEST_CASE("Paths that cannot be read are told apart", "[io][files]") {
  const Scratch scratch;
  std::ofstream(scratch.path / "empty.obj");
  std::ofstream(scratch.path / "what.xyzzy") << "?";
  const auto reading = [&](const char* file) { return message([&] { (void)read_mesh(scratch.path / file); }); };
  CHECK(reading("none.obj").find("No such file") != std::string::npos);
  CHECK(reading("none.xyzzy").find("No such file") != std::string::npos);
  CHECK(reading(".").find("is a directory") != std::string::npos);
  CHECK(reading("empty.obj").find("is empty") != std::string::npos);
  CHECK(reading("what.xyzzy").find("unknown format '.xyzzy'") != std::string::npos);
  if (may_all()) return;
  fs::permissions(scratch.path / "empty.obj", fs::perms::none);
  CHECK(reading("empty.obj").find("Permission denied") != std::string::npos);
}

#if !defined(_WIN32)
TEST_CASE("A pipe is read to its end, however long it is", "[io][files]") {
  const Scratch scratch;
  const auto path = scratch.path / "pipe.off";
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  std::string text = "OFF\n40000 1 0\n";
  for (int i = 0; i < 40'000; ++i) text.append(std::to_string(i)).append(" 1 2\n");
  std::thread writer([&] { std::ofstream(path, std::ios::binary) << text << "3 0 1 39999"; });
  const Mesh mesh = read_mesh(path).mesh;
  writer.join();
  CHECK(mesh.vertices.size() == 40'000);
  CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 39'999}});
}
#endif

TEST_CASE("Paths that cannot be written are told apart", "[io][files]") {
  const Scratch scratch;
  const auto writing = [&](const fs::path& path) {
    return message([&] { write_mesh(path, tetrahedron, Format::obj); });
  };
  CHECK(writing(scratch.path).find("is a directory") != std::string::npos);
  CHECK(writing(scratch.path / "no" / "a.obj").find("No such file") != std::string::npos);
  if (fs::exists("/dev/full")) CHECK(writing("/dev/full").find("No space left") != std::string::npos);
  CHECK(message([&] { write_mesh(scratch.path / "a.xyzzy", tetrahedron); }).find("unknown format") !=
        std::string::npos);
  CHECK(scratch.files() == 0);
  if (may_all()) return;
  write_mesh(scratch.path / "a.obj", tetrahedron);
  fs::permissions(scratch.path / "a.obj", fs::perms::owner_read);
  CHECK(writing(scratch.path / "a.obj").find("Permission denied") != std::string::npos);
}

TEST_CASE("Other formats are read through assimp, with a note and the transforms of the scene", "[io][files]") {
  if (!format_named("dae")) {
    WARN("built without assimp: other formats were not read");
    CHECK(message([&] { (void)read_text("{}", Format::other, "scene.gltf"); }).find("unknown format") !=
          std::string::npos);
    return;
  }
  const std::string gltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
    "nodes":[{"mesh":0,"translation":[10,0,0],"scale":[-1,1,1]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
  const auto file = read_text(gltf, Format::other, "scene.gltf");
  CHECK(file.mesh.vertices == std::vector<Vertex>{{10, 0, 0}, {9, 0, 0}, {10, 1, 0}});
  CHECK(file.mesh.triangles == std::vector<Triangle>{{2, 1, 0}});  // the mirror turns it around
  CHECK(all_notes(file.notes).find("floats") != std::string::npos);
  CHECK_THROWS_AS(read_text("no gltf", Format::other, "scene.gltf"), IoError);
}
