#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "tetrahedron.h"

using namespace strata;
namespace fs = std::filesystem;

namespace {

const fs::path* corpus() {
  static const char* const root = std::getenv("STRATA_CORPUS");
  static const fs::path path = root == nullptr ? "" : root;
  if (root == nullptr) WARN("STRATA_CORPUS is not set: the corpus was not read");
  return root == nullptr ? nullptr : &path;
}

bool is_sound(const MeshFile& file) {
  const auto& mesh = file.mesh;
  const auto& faces = file.polygon_of_triangle;
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                     [](const Vertex& p) {
                       return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
                     }) &&
         std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const Triangle& t) {
                       return std::max({t[0], t[1], t[2]}) < mesh.vertices.size();
                     }) &&
         (faces.empty() || faces.size() == mesh.triangles.size()) && std::is_sorted(faces.begin(), faces.end());
}

}  // namespace

TEST_CASE("Every mesh of the corpus is read, or refused with a reason", "[io][corpus]") {
  if (corpus() == nullptr) return;
  const std::set<std::string> extensions{".stl", ".obj", ".off", ".ply"};
  std::size_t read = 0, refused = 0;
  for (const auto& entry : fs::recursive_directory_iterator(*corpus())) {
    std::string extension = entry.path().extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(c));
    if (!entry.is_regular_file() || !extensions.contains(extension)) continue;
    CAPTURE(entry.path());
    try {
      const auto file = read_mesh(entry.path());
      ++read;
      CHECK(is_sound(file));
      CHECK(read_mesh(to_string(file.mesh, Format::obj), Format::obj, "again").mesh == file.mesh);
    } catch (const IoError& error) {
      ++refused;
      CHECK((error.line() || error.byte()));
    }
  }
  CHECK(read > 1000);
  CHECK(refused < read / 50);
}

TEST_CASE("PLY files of the corpus keep their channels when they are written and read again", "[io][corpus]") {
  if (corpus() == nullptr) return;
  std::size_t channels = 0;
  for (const auto& entry : fs::recursive_directory_iterator(*corpus())) {
    if (!entry.is_regular_file() || entry.path().extension() != ".ply") continue;
    CAPTURE(entry.path());
    MeshFile file;
    try {
      file = read_mesh(entry.path());
    } catch (const IoError&) {
      continue;
    }
    channels += file.attributes.channels.size();
    for (const Format format : {Format::ply, Format::ply_ascii, Format::ply_big_endian}) {
      WriteOptions options;
      options.format = format;
      options.attributes = &file.attributes;
      const MeshFile again = read_mesh(to_string(ExactMesh{file.mesh, {}}, options), format, "again");
      CHECK(again.mesh == file.mesh);
      if (file.mesh.triangles.empty()) continue;  // elements without records have no channels
      CHECK(again.attributes.channels.size() == file.attributes.channels.size());
      for (const Channel& c : file.attributes.channels) {
        CAPTURE(c.name);
        REQUIRE(again.attributes.find(c.name) != nullptr);
        CHECK(*again.attributes.find(c.name) == c);
      }
    }
  }
  CHECK(channels > 20);
}

TEST_CASE("Corrupted files of the corpus are refused with their line", "[io][corpus]") {
  if (corpus() == nullptr) return;
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(*corpus())) {
    if (!entry.path().filename().string().starts_with("corrupted_")) continue;
    CAPTURE(entry.path());
    ++files;
    try {
      (void)read_mesh(entry.path());
      FAIL_CHECK("accepted");
    } catch (const IoError& error) {
      CHECK(error.line());
    }
  }
  CHECK(files == 8);
}
