#pragma once
#include <cstdint>

#include "strata/mesh.h"

namespace bench {

/// Numbers that are the same on every machine, unlike those of the standard library's distributions.
/// Source: splitmix64, Steele, Lea and Flood 2014.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  [[nodiscard]] double uniform(double low, double high);
  [[nodiscard]] strata::Vertex in_box(double low, double high);  ///< all three coordinates from one interval

 private:
  std::uint64_t state_;
};

}  // namespace bench
