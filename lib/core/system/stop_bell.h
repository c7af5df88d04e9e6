#pragma once
#include <chrono>
#include <memory>
#include <optional>

namespace strata::system {

/// Wakes a thread when the user asks this process to stop: Ctrl-C, SIGTERM, the end of a console. One per process at a
/// time. Only the first request rings: a second one ends the process. A closed pipe and a file that has its largest
/// size are write errors from then on, and no ends of the process.
class StopBell {
 public:
  enum class Why { stop, owner };

  StopBell();  ///< throws std::system_error
  /// Whoever has the bell may ring it, too.
  void ring();
  /// Until it rings; nothing where the time came first, or a little earlier. Without a time it waits for ever.
  [[nodiscard]] std::optional<Why> wait(std::optional<std::chrono::milliseconds> time);
};

}  // namespace strata::system
