#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <functional>

#include "strata/select/operation.h"

namespace strata {

/// What the caller declares about the operands.
enum class InputClass {
  solid,        ///< closed, winding numbers 0 and 1: the edge chain is checked, self-intersection is not searched
  overlapping,  ///< closed, may cross itself: resolved completely; inside is winding number > 0
  repair,       ///< a soup: weld equal vertices, drop duplicate and degenerate faces, orient; then as overlapping
};

inline constexpr std::array all_input_classes{InputClass::solid, InputClass::overlapping, InputClass::repair};

/// As it is written in files and on the command line: solid, overlapping, repair.
[[nodiscard]] constexpr const char* name(InputClass input) {
  constexpr std::array names{"solid", "overlapping", "repair"};
  return names[static_cast<std::size_t>(input)];
}

/// What computes a result. Both are exact and have the same solid as a point set, from mathematics of their own.
enum class Engine {
  arrangement,  ///< cells, overlaps, arrangements: untouched faces come out as they went in. For all sizes
  bsp,          ///< merged binary space partitions (bsp/theory.md): some thousand faces. Merges facets in one plane
};

inline constexpr std::array all_engines{Engine::arrangement, Engine::bsp};

/// As on the command line: arrangement, bsp.
[[nodiscard]] constexpr const char* name(Engine engine) {
  constexpr std::array names{"arrangement", "bsp"};
  return names[static_cast<std::size_t>(engine)];
}

struct Options {
  InputClass input = InputClass::solid;
  Engine engine = Engine::arrangement;        ///< formulas are evaluated by the arrangement only
  unsigned threads = 0;                       ///< 0: all cores. The result does not depend on it.
  bool exact_vertices = false;                ///< fill BooleanResult::exact (rationals; costs time per new vertex)
  std::function<void(double)> progress = {};  ///< called with a fraction 0..1, from any thread, never concurrently
  const std::atomic<bool>* cancel = nullptr;  ///< set to true to stop: throws Cancelled within milliseconds
};

}  // namespace strata
