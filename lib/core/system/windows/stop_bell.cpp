#include "core/system/stop_bell.h"

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "core/system/windows/api.h"

namespace strata::system {
namespace {

// Handlers of the console run on a thread of their own, so that they may lock.
std::mutex mutex;
std::condition_variable rung;
std::optional<StopBell::Why> why;
std::atomic<bool> was_stopped = false;

void send(StopBell::Why reason) {
  const std::lock_guard lock(mutex);
  why = reason;
  rung.notify_one();
}

// It serves once: what is not handled ends the process.
BOOL WINAPI handle(DWORD /*event*/) {
  if (was_stopped.exchange(true)) return FALSE;
  send(StopBell::Why::stop);
  return TRUE;
}

}  // namespace

StopBell::StopBell() {
  was_stopped = false;
  ::SetConsoleCtrlHandler(handle, FALSE);
  if (::SetConsoleCtrlHandler(handle, TRUE) == 0) fail("handler of the console");
}

void StopBell::ring() { send(Why::owner); }

std::optional<StopBell::Why> StopBell::wait(std::optional<std::chrono::milliseconds> time) {
  std::unique_lock lock(mutex);
  const auto is_rung = [] { return why.has_value(); };
  if (!time) {
    rung.wait(lock, is_rung);
  } else if (!rung.wait_for(lock, *time, is_rung)) {
    return std::nullopt;
  }
  const auto reason = why;
  why.reset();
  return reason;
}

}  // namespace strata::system
