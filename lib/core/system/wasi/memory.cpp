#include "core/system/memory.h"

namespace strata::system {

void prefer_huge_pages(void* /*memory*/, std::size_t /*bytes*/) {}

void keep_freed_memory() {}

std::uint64_t peak_bytes() { return 0; }

}  // namespace strata::system
