#include <atomic>
#include <new>

#include "strata/monitor.h"

namespace strata {
namespace {

using Flag = std::atomic<bool>;
static_assert(sizeof(Flag) <= sizeof(int) && alignof(Flag) <= alignof(int) && Flag::is_always_lock_free);

Flag& flag_in(std::byte* storage) { return *std::launder(reinterpret_cast<Flag*>(storage)); }
const Flag& flag_in(const std::byte* storage) { return *std::launder(reinterpret_cast<const Flag*>(storage)); }

}  // namespace

CancelToken::CancelToken() noexcept { new (flag_) Flag(false); }
void CancelToken::cancel() noexcept { flag_in(flag_).store(true, std::memory_order_relaxed); }
void CancelToken::reset() noexcept { flag_in(flag_).store(false, std::memory_order_relaxed); }
bool CancelToken::is_cancelled() const noexcept { return flag_in(flag_).load(std::memory_order_relaxed); }

}  // namespace strata
