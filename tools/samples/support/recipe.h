#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "strata/mesh.h"
#include "support/transform.h"

/// Boolean expressions as plain data, for anyone to evaluate in a way of their own.
namespace strata::test {

struct Recipe {
  enum class Kind : std::uint8_t { solid, union_, intersection, difference, symmetric_difference, complement, map };

  struct Step {
    Kind kind = Kind::solid;
    std::uint32_t first = 0;   ///< an earlier step; of `solid` the solid's number
    std::uint32_t second = 0;  ///< an earlier step; of `map` the map's number; else unused
  };

  std::vector<ExactMesh> solids;
  std::vector<Affine> maps;
  std::vector<Step> steps;  ///< the last one is the result; a step may be used several times
};

[[nodiscard]] inline bool joins_two(Recipe::Kind kind) {
  return kind == Recipe::Kind::union_ || kind == Recipe::Kind::intersection || kind == Recipe::Kind::difference ||
         kind == Recipe::Kind::symmetric_difference;
}

/// The value of the last step: `solid(number)`, `join(kind, value, value)`, `complement(value)`, `map(value, Affine)`.
/// Every step is asked for once. O(steps).
template <class Value, class Solid, class Join, class Complement, class Map>
[[nodiscard]] Value value_of(const Recipe& recipe, const Solid& solid, const Join& join, const Complement& complement,
                             const Map& map) {
  std::vector<Value> values;
  values.reserve(recipe.steps.size());
  for (const Recipe::Step& step : recipe.steps) {
    if (step.kind == Recipe::Kind::solid) {
      values.push_back(solid(step.first));
    } else if (step.kind == Recipe::Kind::complement) {
      values.push_back(complement(values[step.first]));
    } else if (step.kind == Recipe::Kind::map) {
      values.push_back(map(values[step.first], recipe.maps[step.second]));
    } else {
      values.push_back(join(step.kind, values[step.first], values[step.second]));
    }
  }
  return std::move(values.back());
}

[[nodiscard]] bool is_bounded(const Recipe& recipe);
[[nodiscard]] std::size_t solid_count(const Recipe& recipe);  ///< as often as they occur
[[nodiscard]] std::size_t depth(const Recipe& recipe);        ///< most steps above one another
[[nodiscard]] std::string text(const Recipe& recipe);         ///< "(s0 | ~s1) - m0(s2)"

/// The text, and all numbers that one needs to do it again.
[[nodiscard]] std::string full_text(const Recipe& recipe);

/// An equal recipe whose maps are on solids, and these are mapped: none is left.
[[nodiscard]] Recipe without_maps(const Recipe& recipe);

/// As few steps as can be found for which `fails` holds still, given that it does for `recipe`. What is tried has
/// bounded results only. O(steps^2) calls.
[[nodiscard]] Recipe shrunken(Recipe recipe, const std::function<bool(const Recipe&)>& fails);

}  // namespace strata::test
