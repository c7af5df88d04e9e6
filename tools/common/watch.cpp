#include "common/watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>

#include "common/exit_code.h"
#include "common/tell.h"
#include "strata/errors.h"

namespace {

using strata::system::StopBell;
constexpr auto patience_with_engines = std::chrono::seconds(2);  // with an engine that was asked to stop

[[noreturn]] void leave(const std::string& reason) {
  tell("strata: {}; no result was written\n", reason);
  std::_Exit(static_cast<int>(ExitCode::stopped));
}

}  // namespace

Watch::Watch(double seconds) : seconds_(std::min(seconds, 1e9)) {
  thread_ = std::thread([this] { run(); });
}

Watch::~Watch() {
  bell_.ring();
  thread_.join();
}

void Watch::on_stop(OnStop action) {
  const std::lock_guard lock(mutex_);
  if (stopped_.is_cancelled()) throw strata::Cancelled(reason_);
  action_ = action;
}

void Watch::hold() {
  const std::lock_guard lock(mutex_);
  action_ = OnStop::hold;
}

std::string Watch::reason() {
  const std::lock_guard lock(mutex_);
  return reason_;
}

void Watch::run() {
  using Clock = std::chrono::steady_clock;
  using Milliseconds = std::chrono::milliseconds;
  bool timed = seconds_ > 0;
  auto end = Clock::now() + std::chrono::ceil<Milliseconds>(std::chrono::duration<double>(seconds_));
  while (true) {
    const auto left = std::max(std::chrono::ceil<Milliseconds>(end - Clock::now()), Milliseconds(0));
    const auto why = bell_.wait(timed ? std::optional(left) : std::nullopt);
    if (why == StopBell::Why::owner) return;
    if (why == StopBell::Why::stop) {
      stop("interrupted");
    } else if (timed && Clock::now() >= end) {
      if (stopped_.is_cancelled()) leave_if_still_asked();
      stop(fmt::format("time limit of {} s reached", seconds_));
    } else {
      continue;  // woken early
    }
    timed = stopped_.is_cancelled();
    end = Clock::now() + patience_with_engines;
  }
}

void Watch::stop(const std::string& reason) {
  const std::lock_guard lock(mutex_);
  if (stopped_.is_cancelled() || action_ == OnStop::finish) return;
  if (action_ == OnStop::leave) leave(reason);
  reason_ = reason;
  stopped_.cancel();
}

void Watch::leave_if_still_asked() {
  const std::lock_guard lock(mutex_);
  if (action_ == OnStop::ask) leave(reason_);
}
