#include "core/system/memory.h"

#include "core/system/windows/api.h"
// After <windows.h>, which it needs.
#include <psapi.h>

namespace strata::system {

void prefer_huge_pages(void* /*memory*/, std::size_t /*bytes*/) {}

void keep_freed_memory() {}

std::uint64_t peak_bytes() {
  PROCESS_MEMORY_COUNTERS counters = {};
  counters.cb = sizeof counters;
  return ::K32GetProcessMemoryInfo(::GetCurrentProcess(), &counters, sizeof counters) != 0
             ? std::uint64_t{counters.PeakWorkingSetSize}
             : 0;
}

}  // namespace strata::system
