#pragma once
#include <cstdint>

namespace strata {

/// Where an output triangle comes from: operand and face number there, both from 0.
struct Source {
  std::uint32_t operand = 0;
  std::uint32_t face = 0;
  friend bool operator==(const Source&, const Source&) = default;
};

}  // namespace strata
