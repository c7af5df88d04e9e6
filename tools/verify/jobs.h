#pragma once
#include <cstddef>
#include <functional>

namespace verify {

/// Calls work(0) .. work(count - 1), several at once. The first exception is thrown on when all have ended; what was
/// not begun by then is left out. `jobs` 0: as many as there are cores.
void for_each_in_jobs(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work);

}  // namespace verify
