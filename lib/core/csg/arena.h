#pragma once
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <span>

#include "strata/combine.h"
#include "strata/options.h"

namespace strata {

/// The threads that an evaluation may use.
class Arena {
 public:
  explicit Arena(int threads) : threads_(threads) {}

  /// What `work` returns, which is done by these threads and no others. May be called within other work.
  template <class Work>
  decltype(auto) execute(const Work& work) const {
    Single& single = of_this_thread();
    if (threads_ > 1 || single.is_entered) return tbb::task_arena(threads_).execute(work);
    const Entry entry(single.is_entered);
    return single.arena.execute(work);
  }

 private:
  /// An arena of one thread, which this thread keeps: to make one takes a microsecond. It has no place for a thread
  /// that comes back to it through another arena.
  struct Single {
    tbb::task_arena arena{1};
    bool is_entered = false;
  };

  static Single& of_this_thread() {
    static thread_local Single single;
    return single;
  }

  class Entry {
   public:
    explicit Entry(bool& is_entered) : is_entered_(is_entered) { is_entered_ = true; }
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;
    ~Entry() { is_entered_ = false; }

   private:
    bool& is_entered_;
  };

  int threads_;
};

/// As many threads as requested, at most as many as there are cores, and one where starting another takes longer than
/// the work.
[[nodiscard]] inline Arena arena_for(const Options& options, std::size_t faces = ~std::size_t{0}) {
  constexpr std::size_t few_faces = 1000;
  if (faces < few_faces) return Arena(1);
  const int cores = tbb::info::default_concurrency();
  const auto asked = static_cast<int>(std::min(options.threads, 1u << 16));
  return Arena(asked == 0 ? cores : std::min(asked, cores));
}

/// The number of faces of solids with double coordinates that have the same cost. Faces with rational vertices, and
/// faces that may cross others of their operand, take ten times as long or more.
[[nodiscard]] inline std::size_t worth_in_faces(std::span<const Operand> operands, InputClass input) {
  std::size_t worth = 0;
  for (const Operand& o : operands)
    worth += o.mesh.triangles.size() * (o.exact.empty() && input == InputClass::solid ? 1 : 10);
  return worth;
}

}  // namespace strata
