#pragma once
#include <array>
#include <optional>
#include <random>
#include <vector>

#include "strata/complex.h"
#include "strata/errors.h"

namespace strata::complex {

/// Random sets whose parts love to touch: corners are from a small grid, some of it not of doubles' nice kind.
class RandomComplexes {
 public:
  RandomComplexes(int dimension, std::uint32_t seed) : dimension_(dimension), random_(seed) {}

  [[nodiscard]] int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  [[nodiscard]] Vertex corner() {
    static constexpr std::array<double, 5> steps{0, 1, 2, 3, 0.1};
    const auto step = [&] { return steps[static_cast<std::size_t>(below(below(4) == 0 ? 5 : 4))]; };
    return {step(), step(), dimension_ == 2 ? 0.0 : step()};
  }

  [[nodiscard]] SelectiveComplex simplex() {
    while (true) {
      std::vector<Vertex> corners(1 + static_cast<std::size_t>(below(dimension_ + 1)));
      for (Vertex& c : corners) c = corner();
      try {
        return complex::simplex(dimension_, corners, below(2) == 0 ? Border::closed : Border::open);
      } catch (const InputError&) {  // not independent
      }
    }
  }

  /// A few simplices in a formula of all operations.
  [[nodiscard]] SelectiveComplex next(int simplices) {
    SelectiveComplex result = simplex();
    for (int i = 1; i < simplices; ++i) {
      const SelectiveComplex other = simplex();
      switch (below(5)) {
        case 0:
        case 1:
          result = result | other;
          break;
        case 2:
          result = result ^ other;
          break;
        case 3:
          result = result - other;
          break;
        default:
          result = below(3) == 0 ? ~result & other : result | other;
      }
    }
    return below(6) == 0 ? ~result : result;
  }

 private:
  int dimension_;
  std::mt19937 random_;
};

}  // namespace strata::complex
