#include "core/io/apart.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace strata::io {
namespace {

/// The first byte of an answer.
enum class Answer : char { mesh, error, out_of_memory };

/// A descriptor that is closed with the object.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

/// Writes an answer into a pipe. Nothing is thrown: a parent that is gone wants no answer.
class Writer {
 public:
  explicit Writer(int descriptor) : descriptor_(descriptor) {}

  void bytes(const void* data, std::size_t count) {
    const char* at = static_cast<const char*>(data);
    while (count > 0) {
      const ssize_t written = ::write(descriptor_, at, count);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) ::_exit(1);
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
      const ssize_t got = ::read(descriptor_, at, count);
      if (got < 0 && errno == EINTR) continue;
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

/// Bytes of address space that this process has; 0 where the system does not say.
std::uint64_t address_space() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t pages = 0;
  statm >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void limit(int resource, std::uint64_t value) {
  rlimit both{};
  if (::getrlimit(static_cast<__rlimit_resource_t>(resource), &both) != 0) return;
  both.rlim_cur = std::min<rlim_t>(value, both.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

/// Handlers of this process are not for its child, which ends by what it is sent.
void forget_handlers() {
  for (const int signal : {SIGINT, SIGTERM, SIGALRM, SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGPIPE})
    std::signal(signal, SIG_DFL);
}

/// What the child does: nothing that it throws may get into the code that was forked.
[[noreturn]] void answer(int pipe, std::uint64_t used, const ReaderLimits& limits,
                         FunctionRef<MeshFile()> read) noexcept {
  forget_handlers();
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.seconds);
  ::alarm(30 + 4 * limits.seconds);                                  // it may wait for something without computing
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which reserve terabytes
  if (used > 0) limit(RLIMIT_AS, used + limits.bytes);
#else
  static_cast<void>(used);
#endif
  // What foreign code says on these is not for the caller's terminal.
  if (const int nowhere = ::open("/dev/null", O_RDWR); nowhere >= 0)
    for (const int stream : {0, 1, 2}) ::dup2(nowhere, stream);
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
  ::_exit(0);
}

/// Why a child gave no answer.
std::string reason_of(int status) {
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU || signal == SIGKILL || signal == SIGALRM)
    return "cannot be read: its reader took too long, or too much memory, and was stopped";
  if (signal != 0) return std::string("cannot be read: its reader was ended by a signal (") + ::strsignal(signal) + ")";
  return "cannot be read: its reader ended without an answer";
}

/// A child that is waited for, whatever happens.
class Child {
 public:
  explicit Child(pid_t number) : number_(number) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (number_ <= 0) return;
    ::kill(number_, SIGKILL);
    status();
  }
  int status() {
    int status = 0;
    while (::waitpid(number_, &status, 0) < 0 && errno == EINTR) {
    }
    number_ = 0;
    return status;
  }

 private:
  pid_t number_;
};

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
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw IoError(name, {}, std::string("cannot be read: ") + std::strerror(errno));
  Descriptor in(ends[0]), out(ends[1]);
  const std::uint64_t used = address_space();
  const pid_t number = ::fork();
  if (number < 0) throw IoError(name, {}, std::string("cannot be read: ") + std::strerror(errno));
  if (number == 0) answer(out.number(), used, limits, read);
  Child child(number);
  out.close();
  Reader answered(in.number(), limits.bytes);
  Answer kind{};
  MeshFile file;
  std::string reason;
  if (answered.bytes(&kind, 1)) {
    if (kind == Answer::mesh) file = read_mesh_file(answered);
    if (kind == Answer::error) answered.list(reason);
    if (kind == Answer::out_of_memory) reason = "cannot be read: its reader takes too much memory";
  }
  in.close();  // a child that would say more ends
  const int status = child.status();
  if (!answered.is_whole()) reason = reason_of(status);
  if (!reason.empty()) throw IoError(name, {}, reason);
  return file;
}

}  // namespace strata::io
