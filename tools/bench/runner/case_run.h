#pragma once
#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "strata/options.h"

namespace bench {

/// Executes the operations of one run of a request in order, until the first that fails, and writes the mesh that each
/// leaves into the run's folder. Returns the run's part of the result. What goes wrong is in it; nothing is thrown but
/// std::bad_alloc.
///
/// Each solid stays exact from one operation to the next. What is written is rounded to doubles that bound a solid. Of
/// the options, `input` is the class of the meshes that are loaded.
[[nodiscard]] nlohmann::json execute(const nlohmann::json& run, const strata::Options& options);

/// Per operation, the length of the longest chain through it: Booleans each of which is the first operand of the next.
/// 0 for what is no Boolean.
[[nodiscard]] std::vector<std::size_t> chain_lengths(const nlohmann::json& operations);

}  // namespace bench
