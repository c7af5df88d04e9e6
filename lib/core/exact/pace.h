#pragma once
#include <cstdint>

#include "strata/monitor.h"

namespace strata {

/// Looks at a monitor once in many steps of a loop whose steps are short. Used by one thread.
class Pace {
 public:
  explicit Pace(const Monitor& monitor) : monitor_(monitor) {}

  /// To be called at each step. Throws Cancelled as Monitor::check does.
  void step() {
    if (++steps_ % between_looks == 0) monitor_.check();
  }

 private:
  static constexpr std::uint32_t between_looks = 1 << 12;
  const Monitor& monitor_;
  std::uint32_t steps_ = 0;
};

}  // namespace strata
