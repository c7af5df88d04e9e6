#pragma once
#include <cstdint>

namespace strata::system {

/// Calls for a process that has just been forked. All are safe after a fork of a process with threads.

/// Ends with its parent (Linux), and leaves no core file.
void tie_to_parent();

/// Sets a limit (RLIMIT_AS, ...), soft and hard.
void limit_for_good(int resource, std::uint64_t value);

}  // namespace strata::system
