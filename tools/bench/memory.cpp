#include "memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace bench {
namespace {

/// A line such as "VmHWM:  1234 kB" of the system's account of this process.
std::uint64_t status_bytes(std::string_view field) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word; status.ignore(std::numeric_limits<std::streamsize>::max(), '\n')) {
    if (word != field) continue;
    std::uint64_t kilobytes = 0;
    if (status >> kilobytes) return 1024 * kilobytes;
  }
  throw std::runtime_error("/proc/self/status does not tell the memory in use");
}

bool forget_peak() {
  std::ofstream file("/proc/self/clear_refs");
  file << '5' << std::flush;
  return static_cast<bool>(file);
}

}  // namespace

MemoryWatch::MemoryWatch() : before_(status_bytes(forget_peak() ? "VmRSS:" : "VmHWM:")) {}

Memory MemoryWatch::seen() const { return {before_, std::max(before_, status_bytes("VmHWM:"))}; }

}  // namespace bench
