#include "captured_text.h"

#include <fmt/format.h>

std::string captured_text(std::size_t size,
                          strata::FunctionRef<std::string(std::size_t offset, std::size_t size)> part) {
  constexpr std::size_t most = 4096;  // of the beginning, and of the end
  if (size <= 2 * most) return part(0, size);
  return fmt::format("{}\n[{} bytes]\n{}", part(0, most), size - 2 * most, part(size - most, most));
}
