#include "strata/shared.h"

#include <atomic>
#include <new>

namespace strata::detail {
namespace {

using Count = std::atomic<std::size_t>;
static_assert(sizeof(Count) == sizeof(std::size_t) && alignof(Count) == alignof(std::size_t));

Count& count_in(std::byte* storage) { return *std::launder(reinterpret_cast<Count*>(storage)); }

}  // namespace

Counted::Counted() noexcept { new (uses_) Count(1); }
Counted::~Counted() = default;

void Counted::retain() const noexcept { count_in(uses_).fetch_add(1, std::memory_order_relaxed); }

void Counted::release() const noexcept {
  // What other threads did with the value comes before its end.
  if (count_in(uses_).fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

bool Counted::has_one_handle() const noexcept { return count_in(uses_).load(std::memory_order_acquire) == 1; }

}  // namespace strata::detail
