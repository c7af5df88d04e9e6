#include "case_file.h"

#include <cstdint>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

namespace bench {
namespace {

constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : path_(path), stream_(path, std::ios::binary) {
    if (!stream_) throw std::runtime_error(path_.string() + " cannot be opened");
  }

  /// A number of things to follow.
  std::size_t count() {
    std::int64_t number = 0;
    bytes(&number, sizeof number);
    if (number < 0 || number > most) throw std::runtime_error(path_.string() + " is no case file");
    return static_cast<std::size_t>(number);
  }

  template <typename Item>
  void items(std::vector<Item>& target, std::size_t number) {
    target.resize(number);
    bytes(target.data(), number * sizeof(Item));
  }

 private:
  void bytes(void* target, std::size_t number) {
    stream_.read(static_cast<char*>(target), static_cast<std::streamsize>(number));
    if (!stream_) throw std::runtime_error(path_.string() + " is truncated");
  }

  std::filesystem::path path_;
  std::ifstream stream_;
};

void write_count(std::ostream& stream, std::size_t count) {
  const auto number = static_cast<std::int64_t>(count);
  if (number > most) throw std::runtime_error("a case has more than 2^31 - 1 vertices or triangles");
  stream.write(reinterpret_cast<const char*>(&number), sizeof number);
}

template <typename Item>
void write_items(std::ostream& stream, const std::vector<Item>& items) {
  stream.write(reinterpret_cast<const char*>(items.data()), static_cast<std::streamsize>(items.size() * sizeof(Item)));
}

}  // namespace

std::vector<strata::Mesh> read_case(const std::filesystem::path& path) {
  Reader reader(path);
  std::vector<strata::Mesh> meshes(reader.count());
  for (strata::Mesh& mesh : meshes) {
    const std::size_t vertices = reader.count();
    const std::size_t triangles = reader.count();
    reader.items(mesh.vertices, vertices);
    reader.items(mesh.triangles, triangles);
  }
  return meshes;
}

void write_case(const std::filesystem::path& path, std::span<const strata::Mesh> meshes) {
  std::ofstream stream(path, std::ios::binary);
  write_count(stream, meshes.size());
  for (const strata::Mesh& mesh : meshes) {
    write_count(stream, mesh.vertices.size());
    write_count(stream, mesh.triangles.size());
    write_items(stream, mesh.vertices);
    write_items(stream, mesh.triangles);
  }
  stream.close();
  if (!stream) throw std::runtime_error(path.string() + " cannot be written");
}

}  // namespace bench
