#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace verify {

/// What a process may take.
struct Limits {
  double seconds = 20;                           ///< by the clock
  std::uint64_t bytes = std::uint64_t{4} << 30;  ///< of address space; 0: no limit
};

/// How a process ended.
struct ChildEnd {
  enum class How { exited, crashed, timed_out };
  How how = How::exited;
  int code = 0;       ///< exit status, or as in strata::system::ProcessEnd
  std::string error;  ///< the end of what it wrote to standard error
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
};

/// Runs a command to its end, in a process group of its own, which is killed when time is over, and with the caller.
/// Nothing on standard input; standard output is thrown away. `folder` is where it runs; a file for standard error is
/// made there. A command that cannot be started exits with 127. Safe to call from many threads.
/// Throws std::system_error when there is no process to be had.
[[nodiscard]] ChildEnd run_child(const std::vector<std::string>& command, const Limits& limits,
                                 const std::filesystem::path& folder);

}  // namespace verify
