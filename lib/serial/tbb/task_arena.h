#pragma once
#include <utility>

namespace tbb {

class task_arena {
 public:
  explicit task_arena(int /*threads*/ = 1) {}

  template <class Work>
  decltype(auto) execute(Work&& work) {
    return std::forward<Work>(work)();
  }
};

namespace this_task_arena {
[[nodiscard]] inline int max_concurrency() { return 1; }
}  // namespace this_task_arena

}  // namespace tbb
