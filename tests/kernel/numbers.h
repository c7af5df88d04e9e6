#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "support/random.h"

namespace strata::test {

/// Where coordinates come from: each family holds another trap.
enum class Family {
  small_integers,  ///< nearly everything is coplanar, collinear or concurrent
  one_ulp,         ///< small integers, some of them one ulp off
  floats,          ///< floats widened to doubles
  doubles,         ///< full mantissas around one
  spread,          ///< small integers times powers of two, up to 1000 apart
  far_apart,       ///< 1e-300 beside 1 and 1e300
  subnormal,       ///< small multiples of the smallest double, and the border of the normal ones
  underflowing,    ///< products of two vanish, times a huge third they do not
  huge,            ///< up to 1.7e308: differences overflow
  wild,            ///< any finite bits
};
inline constexpr int family_count = 10;

/// Coordinates of one family. Values repeat on purpose: half of all answers come from a small pool.
class Numbers {
 public:
  Numbers(Family family, Random& random) : family_(family), random_(random) {
    constexpr int spreads[] = {8, 20, 40, 70, 130, 250, 500, 1000};
    spread_ = spreads[random_.below(8)];
    for (int i = 0; i < 4; ++i) pool_.push_back(fresh());
  }

  double operator()() { return random_.once_in(2) ? random_.pick(pool_) : fresh(); }

 private:
  double small() { return random_.between(-4, 4); }
  double full() { return (random_.once_in(2) ? -1 : 1) * (1 + random_.unit()); }

  double fresh() {
    switch (family_) {
      case Family::small_integers:
        return small();
      case Family::one_ulp:
        return random_.once_in(3) ? std::nextafter(small(), small()) : small();
      case Family::floats:
        return static_cast<float>(full() * random_.between(0, 9));
      case Family::doubles:
        return full();
      case Family::spread:
        return small() * std::ldexp(1.0, random_.between(0, 2) * spread_ / 2);
      case Family::far_apart:
        return small() * random_.pick(std::array{1e-300, 1.0, 1e300});
      case Family::subnormal:
        return small() * (random_.once_in(3) ? 0x1p-1022 : 0x1p-1074);
      case Family::underflowing:
        return full() * std::ldexp(1.0, random_.once_in(3) ? 1000 : random_.between(-545, -520));
      case Family::huge:
        return random_.once_in(2) ? random_.between(-3, 3) * 0x1p1022 : full() * 0.85e308;
      case Family::wild:
        return any_bits();
    }
    return 0;
  }

  double any_bits() {
    for (;;) {
      const double x = std::bit_cast<double>(random_.next());
      if (std::isfinite(x)) return x;
    }
  }

  Family family_;
  Random& random_;
  int spread_ = 0;
  std::vector<double> pool_;
};

}  // namespace strata::test
