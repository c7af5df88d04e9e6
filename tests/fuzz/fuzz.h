#pragma once
#include <tbb/global_control.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace strata::fuzz {

/// Ends the program where a law does not hold: that is a finding.
inline void require(bool holds, const char* law) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", law);
  std::abort();
}

/// Calls `check(text)` on one thread, so that equal inputs take equal ways. Whatever it throws is a finding.
template <class Check>
int run(const std::uint8_t* data, std::size_t size, const Check& check) {
  static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  check(std::string_view(reinterpret_cast<const char*>(data), size));
  return 0;
}

}  // namespace strata::fuzz

/// What libFuzzer and standalone_main.cpp call for every input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
