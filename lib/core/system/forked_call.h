#pragma once
#include <cstdint>
#include <string>

#include "strata/function.h"

namespace strata::system {

/// A function that runs in a copy of this process, so that nothing in it can end this one, and answers through a pipe.
/// POSIX only.
class ForkedCall {
 public:
  struct Limits {
    std::uint64_t bytes;  ///< of address space, beside what this process has
    unsigned seconds;     ///< of processor time; of the clock, 30 more than four times as many
  };

  /// `function` gets the descriptor to write to. It must neither throw nor depend on other threads; it has no streams,
  /// no handlers of signals, and leaves no core file. Throws std::system_error when there is no process to be had.
  ForkedCall(const Limits& limits, FunctionRef<void(int)> function);
  ~ForkedCall();  ///< kills what runs
  ForkedCall(const ForkedCall&) = delete;
  ForkedCall& operator=(const ForkedCall&) = delete;

  /// The descriptor to read from.
  [[nodiscard]] int answer() const { return answer_; }
  /// Waits until the process has ended, which can say nothing more. How it ended: words that follow its name.
  [[nodiscard]] std::string end();

 private:
  void close_answer();
  int wait();

  int answer_ = -1;
  std::int64_t process_ = 0;  ///< 0: it has ended
};

}  // namespace strata::system
