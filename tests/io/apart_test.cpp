#include "core/io/apart.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "core/io/readers.h"

using namespace strata;
using io::limits_for;
using io::read_apart;

namespace {

MeshFile sample() {
  MeshFile file;
  file.mesh = {{{0.1, -0.0, 1e-310}, {1, 0, 0}, {0, 1e300, 0}}, {{0, 1, 2}}};
  file.polygon_of_triangle = {7};
  file.notes = {"", std::string(100'000, 'x'), "the last one"};
  return file;
}

std::string reason_of(FunctionRef<MeshFile()> read, const io::ReaderLimits& limits = limits_for(0)) {
  try {
    static_cast<void>(read_apart("part.dae", limits, read));
  } catch (const IoError& error) {
    CHECK(error.path() == "part.dae");
    return error.reason();
  }
  return "nothing";
}

/// Calls itself without an end that a compiler could see.
struct Recursion {
  std::atomic<bool> is_at_end = false;
  std::size_t operator()(std::size_t depth) {  // NOLINT(misc-no-recursion): that is the point
    std::array<std::size_t, 500> frame{};
    frame[depth % frame.size()] = is_at_end ? depth : (*this)(depth + 1);
    return frame[is_at_end ? 0 : depth % frame.size()];
  }
};

}  // namespace

TEST_CASE("a mesh comes back from another process as it was", "[io]") {
  const MeshFile file = read_apart("a", limits_for(0), sample);
  CHECK(file.mesh == sample().mesh);
  CHECK(std::signbit(file.mesh.vertices[0][1]));
  CHECK(file.polygon_of_triangle == sample().polygon_of_triangle);
  CHECK(file.notes == sample().notes);
}

TEST_CASE("a large mesh comes back from another process", "[io]") {
  const MeshFile file = read_apart("a", limits_for(0), [] {
    MeshFile large;
    large.mesh.vertices.assign(1'000'000, Vertex{1, 2, 3});
    return large;
  });
  CHECK(file.mesh.vertices == std::vector<Vertex>(1'000'000, Vertex{1, 2, 3}));
}

TEST_CASE("nothing in a foreign reader ends this process", "[io]") {
  CHECK(reason_of([]() -> MeshFile { throw IoError("part.dae", {}, "no faces"); }) == "no faces");
  CHECK(reason_of([]() -> MeshFile { throw std::runtime_error("odd"); }) == "cannot be read: odd");
  CHECK(reason_of([]() -> MeshFile { throw std::bad_alloc(); }).find("too much memory") != std::string::npos);
  CHECK(reason_of([]() -> MeshFile { throw 3; }) == "cannot be read");
  CHECK(reason_of([]() -> MeshFile { std::abort(); }).find("Aborted") != std::string::npos);
  CHECK(reason_of([]() -> MeshFile { std::_Exit(0); }).find("without an answer") != std::string::npos);
  CHECK(reason_of([]() -> MeshFile {
          std::raise(SIGKILL);
          return {};
        }).find("stopped") != std::string::npos);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE("a foreign reader has limits of stack, memory and time", "[io]") {
  CHECK(reason_of([]() -> MeshFile {
          MeshFile file;
          file.polygon_of_triangle.push_back(static_cast<std::uint32_t>(Recursion{}(0)));
          return file;
        }).find("Segmentation fault") != std::string::npos);
  CHECK(reason_of([]() -> MeshFile {
          std::vector<std::vector<char>> all;
          for (;;) all.emplace_back(std::size_t{1} << 24, 'x');
        }).find("too much memory") != std::string::npos);
  CHECK(reason_of(
            []() -> MeshFile {
              const std::atomic<bool> is_at_end = false;
              while (!is_at_end) {
              }
              return {};
            },
            {std::size_t{1} << 29, 1})
            .find("took too long") != std::string::npos);
}

// Locks of the sanitizers' allocator that other threads hold at a fork stay locked in the child.
TEST_CASE("foreign readers run beside other threads", "[io]") {
  std::vector<std::thread> threads;
  std::vector<int> right(8);
  for (std::size_t i = 0; i < right.size(); ++i)
    threads.emplace_back([&right, i] {
      for (int k = 0; k < 10; ++k) {
        right[i] += read_apart("a", limits_for(0), sample).mesh == sample().mesh ? 1 : 0;
        right[i] += reason_of([]() -> MeshFile { std::abort(); }).find("Aborted") != std::string::npos ? 1 : 0;
      }
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(right == std::vector<int>(right.size(), 20));
}
#endif

namespace {

/// A directory of its own, removed at the end.
struct Scratch {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("strata_apart_" + std::to_string(::getpid()));
  Scratch() { std::filesystem::create_directories(path); }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

constexpr const char* tetrahedron_with_a_node_in_itself =
    R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION"
source="#p"/></vertices><triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1</p></triangles>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node id="n"><instance_node url="#n"/>
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene>
</COLLADA>)";

/// A triangle whose coordinates are in another file.
std::string gltf(const std::string& buffer) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":)"
         R"([{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
         R"("min":[0,0,0],"max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
         buffer + R"("}]})";
}

void write_floats(const std::filesystem::path& path) {
  const float coordinates[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(coordinates), sizeof coordinates);
}

void write_text(const std::filesystem::path& path, const std::string& text) { std::ofstream(path) << text; }

}  // namespace

TEST_CASE("a model that contains itself is an error that names the file", "[io]") {
  if (!io::can_read_other(".dae")) return;
  const Scratch folder;
  const std::filesystem::path path = folder.path / "cycle.dae";
  write_text(path, tetrahedron_with_a_node_in_itself);
  CHECK_THROWS_AS(read_mesh(path.string()), IoError);
}

TEST_CASE("a model reads files beneath its folder, and no others", "[io]") {
  if (!io::can_read_other(".gltf")) return;
  const Scratch folder;
  const std::filesystem::path inside = folder.path / "models" / "parts";
  std::filesystem::create_directories(inside);
  write_floats(inside / "beneath.bin");
  write_floats(folder.path / "models" / "beside.bin");
  write_floats(folder.path / "above.bin");
  std::filesystem::create_symlink(folder.path / "above.bin", folder.path / "models" / "link.bin");
  const std::filesystem::path model = folder.path / "models" / "model.gltf";
  const auto reads = [&](const std::string& buffer) {
    write_text(model, gltf(buffer));
    try {
      return read_mesh(model.string()).mesh.triangles.size() == 1;
    } catch (const IoError&) {
      return false;
    }
  };
  CHECK(reads("beside.bin"));
  CHECK(reads("parts/beneath.bin"));
  CHECK_FALSE(reads("../above.bin"));
  CHECK_FALSE(reads("parts/../../above.bin"));
  CHECK_FALSE(reads((folder.path / "above.bin").string()));
  CHECK_FALSE(reads("link.bin"));
  REQUIRE(::mkfifo((folder.path / "models" / "pipe.bin").c_str(), 0600) == 0);
  CHECK_FALSE(reads("pipe.bin"));
  write_text(model, gltf("beside.bin"));
  std::filesystem::create_symlink(model, folder.path / "models" / "parts" / "linked.gltf");
  CHECK_THROWS_AS(read_mesh((inside / "linked.gltf").string()), IoError);  // its buffer is not beneath this folder
}
