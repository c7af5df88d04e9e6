#include "core/io/apart.h"

#include <cerrno>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/system/file.h"
#include "core/system/forked_call.h"

namespace strata::io {
namespace {

/// The first byte of an answer.
enum class Answer : char { mesh, error, out_of_memory };

/// Writes an answer into a pipe. Nothing is thrown: a parent that is gone wants no answer.
class Writer {
 public:
  explicit Writer(int descriptor) : descriptor_(descriptor) {}

  void bytes(const void* data, std::size_t count) {
    const char* at = static_cast<const char*>(data);
    while (count > 0) {
      const std::ptrdiff_t written = system::write(descriptor_, at, count);
      if (written <= 0) std::_Exit(1);
      at += written;
      count -= static_cast<std::size_t>(written);
    }
  }
  template <class T>
  void list(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    number(values.size());
    bytes(values.data(), values.size() * sizeof(T));
  }
  void number(std::uint64_t x) { bytes(&x, sizeof x); }
  void text(const std::string& s) {
    number(s.size());
    bytes(s.data(), s.size());
  }

 private:
  int descriptor_;
};

/// Reads an answer; `is_whole` tells whether all that was asked for was there. Lists of more than `most` bytes are not.
class Reader {
 public:
  Reader(int descriptor, std::uint64_t most) : descriptor_(descriptor), most_(most) {}

  bool bytes(void* data, std::size_t count) {
    char* at = static_cast<char*>(data);
    while (is_whole_ && count > 0) {
      const std::ptrdiff_t got = system::read(descriptor_, at, count);
      if (got <= 0) {
        is_whole_ = false;
      } else {
        at += got;
        count -= static_cast<std::size_t>(got);
      }
    }
    return is_whole_;
  }
  std::uint64_t number() {
    std::uint64_t x = 0;
    return bytes(&x, sizeof x) ? x : 0;
  }
  template <class List>
  void list(List& values) {
    const std::uint64_t count = number();
    is_whole_ = is_whole_ && count <= most_ / sizeof(values[0]);
    if (!is_whole_) return;
    values.resize(count);
    bytes(values.data(), count * sizeof(values[0]));
  }
  [[nodiscard]] bool is_whole() const { return is_whole_; }

 private:
  int descriptor_;
  std::uint64_t most_;
  bool is_whole_ = true;
};

void write_mesh_file(Writer& out, const MeshFile& file) {
  out.list(file.mesh.vertices);
  out.list(file.mesh.triangles);
  out.list(file.polygon_of_triangle);
  out.number(file.notes.size());
  for (const std::string& note : file.notes) out.text(note);
}

MeshFile read_mesh_file(Reader& in) {
  MeshFile file;
  in.list(file.mesh.vertices);
  in.list(file.mesh.triangles);
  in.list(file.polygon_of_triangle);
  for (std::uint64_t left = in.number(); left > 0 && in.is_whole(); --left) in.list(file.notes.emplace_back());
  return file;
}

/// What the child does.
void answer(int pipe, FunctionRef<MeshFile()> read) {
  Writer out(pipe);
  Answer kind = Answer::mesh;
  try {
    const MeshFile file = read();
    out.bytes(&kind, 1);
    write_mesh_file(out, file);
  } catch (const IoError& error) {
    kind = Answer::error;
    out.bytes(&kind, 1);
    out.text(error.reason());
  } catch (const std::bad_alloc&) {
    kind = Answer::out_of_memory;
    out.bytes(&kind, 1);
  } catch (const std::exception& error) {
    kind = Answer::error;
    out.bytes(&kind, 1);
    out.text(std::string("cannot be read: ") + error.what());
  } catch (...) {
    kind = Answer::error;
    out.bytes(&kind, 1);
    out.text("cannot be read");
  }
}

}  // namespace

ReaderLimits limits_for(std::size_t file_bytes) {
  constexpr std::size_t least_bytes = std::size_t{1} << 29, bytes_per_byte = 200, megabyte = 1 << 20;
  constexpr unsigned least_seconds = 8, seconds_per_megabyte = 2;
  constexpr std::size_t largest = std::size_t{1} << 40;
  const std::size_t megabytes = std::min(file_bytes, largest) / megabyte;
  return {least_bytes + bytes_per_byte * std::min(file_bytes, largest),
          least_seconds + seconds_per_megabyte * static_cast<unsigned>(megabytes)};
}

MeshFile read_apart(const std::string& name, const ReaderLimits& limits, FunctionRef<MeshFile()> read) {
  try {
    system::ForkedCall child({limits.bytes, limits.seconds}, [&](int pipe) { answer(pipe, read); });
    Reader answered(child.answer(), limits.bytes);
    Answer kind{};
    MeshFile file;
    std::string reason;
    if (answered.bytes(&kind, 1)) {
      if (kind == Answer::mesh) file = read_mesh_file(answered);
      if (kind == Answer::error) answered.list(reason);
      if (kind == Answer::out_of_memory) reason = "cannot be read: its reader takes too much memory";
    }
    const std::string end = child.end();
    if (!answered.is_whole()) reason = "cannot be read: its reader " + end;
    if (!reason.empty()) throw IoError(name, {}, reason);
    return file;
  } catch (const std::system_error& error) {
    throw IoError(name, {}, std::string("cannot be read: ") + error.what());
  }
}

}  // namespace strata::io
