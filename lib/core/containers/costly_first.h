#pragma once
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace strata {

/// Calls work(i) for all i < count, in parallel. Items of which one takes a good part of a thread's share are begun
/// first, so that no thread is left alone with one of them at the end. cost(i): in any unit; cheap.
template <class Cost, class Work>
void for_costly_first(std::size_t count, const Cost& cost, const Work& work) {
  constexpr std::size_t parts_of_share = 16;
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  std::size_t total = 0;
  for (std::size_t i = 0; i < count; ++i) total += cost(i);
  const std::size_t most = total / (parts_of_share * threads);
  std::vector<std::size_t> costly;
  for (std::size_t i = 0; threads > 1 && i < count; ++i)
    if (cost(i) > most) costly.push_back(i);
  if (costly.empty() || costly.size() == count) {
    tbb::parallel_for(std::size_t{0}, count, work);
    return;
  }
  std::stable_sort(costly.begin(), costly.end(), [&](std::size_t a, std::size_t b) { return cost(a) > cost(b); });
  tbb::parallel_invoke(
      [&] { tbb::parallel_for(std::size_t{0}, costly.size(), [&](std::size_t k) { work(costly[k]); }); },
      [&] {
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
          if (cost(i) <= most) work(i);
        });
      });
}

}  // namespace strata
