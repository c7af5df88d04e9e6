#pragma once

namespace tbb::info {

[[nodiscard]] inline int default_concurrency() { return 1; }

}  // namespace tbb::info
