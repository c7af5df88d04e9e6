#pragma once
/// Programs: this one, those beside it, and those that it starts.
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace strata::system {

/// The file of this program.
[[nodiscard]] std::filesystem::path own_program();
/// The number of this process, which no other one has at the same time.
[[nodiscard]] std::uint64_t process_number();
[[nodiscard]] bool is_program(const std::filesystem::path& path);
/// Between the folders of the environment variable PATH.
extern const char path_separator;
/// What the names of program files end with: ".exe", or nothing.
extern const char* const program_suffix;

/// What is to be started, and what it may take.
struct Command {
  std::vector<std::string> words;     ///< a program's path, or its name, which is looked for in PATH; its arguments
  std::filesystem::path folder = {};  ///< where it runs; empty: where this process does
  std::filesystem::path output =
      {};                            ///< the file that takes its standard output, new or emptied; empty: nobody sees it
  std::filesystem::path error = {};  ///< the same for standard error; both may be the same file
  double seconds = 0;                ///< of processor time; 0: no limit
  std::uint64_t bytes = 0;           ///< of address space (POSIX), of memory (Windows); 0: no limit
};

struct ProcessEnd {
  bool crashed = false;  ///< by a signal (POSIX), by an exception (Windows)
  int code = 0;          ///< the exit code; the number of the signal; the code of the exception
  std::uint64_t peak_bytes = 0;
};

/// A program that runs: without a shell, with nothing on standard input, in a group of its own, which ends with this
/// process (Linux, Windows). A program that cannot be started ends with code 127.
class Process {
 public:
  /// Throws std::system_error when there is no process to be had. Safe to call from many threads.
  explicit Process(const Command& command);
  ~Process();  ///< kills what runs
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// How it ended; nothing while it runs.
  [[nodiscard]] std::optional<ProcessEnd> end();
  /// Until it has ended.
  ProcessEnd wait();
  /// Ends the program, and all that it has started.
  void kill();

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

/// A name for the code of a program that crashed.
[[nodiscard]] std::string name_of_crash(int code);

/// Runs a program in place of this one, with its streams and its exit code. Returns only when that fails; `errno` says
/// why. `arguments` begin with the program's name and end with a null pointer.
void become(const std::filesystem::path& program, char* const* arguments);

}  // namespace strata::system
