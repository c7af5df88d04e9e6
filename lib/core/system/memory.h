#pragma once
#include <cstddef>
#include <cstdint>

namespace strata::system {

/// Asks for huge pages for a large block of fresh memory. A hint without effect on results.
void prefer_huge_pages(void* memory, std::size_t bytes);

/// For a program that soon ends: what is freed is kept for what is allocated next, which saves the first access to the
/// pages of fresh memory. Without effect where the C library has no such setting (it is glibc's).
void keep_freed_memory();

/// The largest amount of resident memory that this process had, in bytes.
[[nodiscard]] std::uint64_t peak_bytes();

}  // namespace strata::system
