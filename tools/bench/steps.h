#pragma once
#include <cstddef>

namespace bench {

/// So many steps at most are taken by Booleans of solids, more by an incremental solid: as its header advises.
inline constexpr std::size_t few_steps = 30;

}  // namespace bench
