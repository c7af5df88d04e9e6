#pragma once
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "common/json_location.h"

/// Demands the name of one of these, as `name` writes it. Throws "'cut' is no operation; one of ...".
template <class Value, std::size_t count>
[[nodiscard]] Value read_choice(const JsonLocation& place, std::string_view what, const std::array<Value, count>& all) {
  std::vector<std::string_view> names;
  for (const Value value : all) names.emplace_back(name(value));
  return all[place.choice(what, names)];
}
