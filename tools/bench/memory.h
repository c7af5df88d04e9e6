#pragma once
#include <cstdint>

namespace bench {

/// Memory of this process, in bytes resident.
struct Memory {
  std::uint64_t before = 0;  ///< when watching began
  std::uint64_t peak = 0;    ///< the most since then
};

/// Watches the peak from now on. Where the system cannot forget earlier peaks (no /proc/self/clear_refs), an earlier
/// peak counts as `before`: what is found above it is then too little, never too much.
class MemoryWatch {
 public:
  MemoryWatch();
  [[nodiscard]] Memory seen() const;

 private:
  std::uint64_t before_;
};

}  // namespace bench
