#include <algorithm>
#include <optional>

#include "support/recipe.h"

namespace strata::test {
namespace {

using Kind = Recipe::Kind;

std::vector<bool> used_steps(const Recipe& recipe) {
  std::vector<bool> used(recipe.steps.size(), false);
  used.back() = true;
  for (std::size_t n = recipe.steps.size(); n-- > 0;) {
    const Recipe::Step& step = recipe.steps[n];
    if (!used[n] || step.kind == Kind::solid) continue;
    used[step.first] = true;
    if (joins_two(step.kind)) used[step.second] = true;
  }
  return used;
}

/// The new number of an item that is in use, which is copied when it is met first.
template <class Item>
std::uint32_t moved(std::uint32_t old, const std::vector<Item>& from, std::vector<Item>& to,
                    std::vector<std::optional<std::uint32_t>>& numbers) {
  numbers.resize(from.size());
  if (!numbers[old]) {
    numbers[old] = static_cast<std::uint32_t>(to.size());
    to.push_back(from[old]);
  }
  return *numbers[old];
}

/// Without steps, solids and maps that the last step does not need.
Recipe pruned(const Recipe& recipe) {
  const std::vector<bool> used = used_steps(recipe);
  Recipe result;
  std::vector<std::uint32_t> step_numbers(recipe.steps.size());
  std::vector<std::optional<std::uint32_t>> solid_numbers, map_numbers;
  for (std::size_t n = 0; n < recipe.steps.size(); ++n) {
    if (!used[n]) continue;
    Recipe::Step step = recipe.steps[n];
    if (step.kind == Kind::solid) {
      step.first = moved(step.first, recipe.solids, result.solids, solid_numbers);
    } else {
      step.first = step_numbers[step.first];
      if (joins_two(step.kind)) step.second = step_numbers[step.second];
      if (step.kind == Kind::map) step.second = moved(step.second, recipe.maps, result.maps, map_numbers);
    }
    step_numbers[n] = static_cast<std::uint32_t>(result.steps.size());
    result.steps.push_back(step);
  }
  return result;
}

/// The recipe with one step left out: another one stands in its place.
Recipe replaced(Recipe recipe, std::uint32_t step, std::uint32_t by) {
  if (step + 1 == recipe.steps.size()) {
    recipe.steps.resize(by + 1);
    return pruned(recipe);
  }
  for (Recipe::Step& s : recipe.steps) {
    if (s.kind == Kind::solid) continue;
    if (s.first == step) s.first = by;
    if (joins_two(s.kind) && s.second == step) s.second = by;
  }
  return pruned(recipe);
}

std::optional<Recipe> smaller(const Recipe& recipe, const std::function<bool(const Recipe&)>& fails) {
  for (auto n = static_cast<std::uint32_t>(recipe.steps.size()); n-- > 0;) {
    const Recipe::Step& step = recipe.steps[n];
    if (step.kind == Kind::solid) continue;
    for (const std::uint32_t by : {step.first, joins_two(step.kind) ? step.second : step.first}) {
      Recipe candidate = replaced(recipe, n, by);
      if (is_bounded(candidate) && fails(candidate)) return candidate;
    }
  }
  return std::nullopt;
}

}  // namespace

Recipe shrunken(Recipe recipe, const std::function<bool(const Recipe&)>& fails) {
  while (auto less = smaller(recipe, fails)) recipe = std::move(*less);
  return recipe;
}

}  // namespace strata::test
