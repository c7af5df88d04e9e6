#pragma once
#include <cstddef>

namespace tbb {

/// There is one thread, whatever is asked for.
class global_control {
 public:
  enum parameter { max_allowed_parallelism };

  global_control(parameter, std::size_t) {}
};

}  // namespace tbb
