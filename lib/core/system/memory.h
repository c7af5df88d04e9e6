#pragma once
#include <cstddef>
#include <cstdint>

namespace strata::system {

/// Asks for huge pages for a large block of fresh memory. A hint without effect on results.
void prefer_huge_pages(void* memory, std::size_t bytes);

/// The largest amount of resident memory that this process had, in bytes.
[[nodiscard]] std::uint64_t peak_bytes();

}  // namespace strata::system
