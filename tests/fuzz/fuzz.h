#pragma once
#include <tbb/global_control.h>

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>

namespace strata::fuzz {

/// Ends the program where a law does not hold: that is a finding.
inline void require(bool holds, const char* law) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", law);
  std::abort();
}

/// Aborts when an input takes more than 10 s of processor time, however long it takes by the clock.
class Limit {
 public:
  Limit() {
    sigevent abort{};
    abort.sigev_notify = SIGEV_SIGNAL;
    abort.sigev_signo = SIGABRT;
    require(timer_create(CLOCK_PROCESS_CPUTIME_ID, &abort, &timer_) == 0, "there is a timer");
  }
  void start() const { set(10); }
  void stop() const { set(0); }

 private:
  void set(std::time_t seconds) const {
    itimerspec time{};
    time.it_value.tv_sec = seconds;
    timer_settime(timer_, 0, &time, nullptr);
  }
  timer_t timer_{};
};

/// Calls `check(text)` on one thread, so that equal inputs take equal ways. Whatever it throws is a finding.
template <class Check>
int run(const std::uint8_t* data, std::size_t size, const Check& check) {
  static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  static const Limit limit;
  limit.start();
  check(std::string_view(reinterpret_cast<const char*>(data), size));
  limit.stop();
  return 0;
}

}  // namespace strata::fuzz

/// What libFuzzer and standalone_main.cpp call for every input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
