#include "copy_floor.h"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <new>

namespace bench {
namespace {

/// Fresh pages from the system, given back at the end.
class Pages {
 public:
  explicit Pages(std::size_t bytes)
      : bytes_(bytes), start_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
    if (start_ == MAP_FAILED) throw std::bad_alloc();
  }
  ~Pages() { munmap(start_, bytes_); }
  Pages(const Pages&) = delete;
  Pages& operator=(const Pages&) = delete;
  [[nodiscard]] char* begin() const { return static_cast<char*>(start_); }

 private:
  std::size_t bytes_;
  void* start_;
};

double seconds_of_one_copy(std::span<const strata::MeshView> meshes, std::size_t bytes) {
  const auto start = std::chrono::steady_clock::now();
  const Pages pages(bytes);
  char* target = pages.begin();
  for (const strata::MeshView& mesh : meshes) {
    std::memcpy(target, mesh.vertices.data(), mesh.vertices.size_bytes());
    target += mesh.vertices.size_bytes();
    std::memcpy(target, mesh.triangles.data(), mesh.triangles.size_bytes());
    target += mesh.triangles.size_bytes();
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::size_t array_bytes(const strata::MeshView& mesh) {
  return mesh.vertices.size_bytes() + mesh.triangles.size_bytes();
}

double copy_floor(std::span<const strata::MeshView> meshes) {
  std::size_t bytes = 0;
  for (const strata::MeshView& mesh : meshes) bytes += array_bytes(mesh);
  if (bytes == 0) return 0;
  std::array<double, 5> seconds{};
  for (double& s : seconds) s = seconds_of_one_copy(meshes, bytes);
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

}  // namespace bench
