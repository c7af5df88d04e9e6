#pragma once
#include <chrono>
#include <string>

#include "strata/combine.h"

namespace strata {

/// Adds the time since the last lap to a profile.
class Stopwatch {
 public:
  explicit Stopwatch(Profile& profile) : profile_(profile) {}

  void lap(std::string stage) {
    const auto now = Clock::now();
    profile_.seconds.emplace_back(std::move(stage), std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Profile& profile_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace strata
