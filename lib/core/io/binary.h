#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace strata::io {

/// The unsigned integer with a given number of bytes.
template <std::size_t Bytes>
using Bits = std::conditional_t<
    Bytes == 1, std::uint8_t,
    std::conditional_t<Bytes == 2, std::uint16_t, std::conditional_t<Bytes == 4, std::uint32_t, std::uint64_t>>>;

/// The bytes in reverse order.
template <class T>
[[nodiscard]] T swapped(T x) {
  if constexpr (sizeof(T) == 1) return x;
  if constexpr (sizeof(T) == 2) return __builtin_bswap16(x);
  if constexpr (sizeof(T) == 4) return __builtin_bswap32(x);
  if constexpr (sizeof(T) == 8) return __builtin_bswap64(x);
}

/// A number stored at `bytes` in the given byte order, at any alignment.
template <class T>
[[nodiscard]] T load(const char* bytes, std::endian order) {
  Bits<sizeof(T)> raw;
  std::memcpy(&raw, bytes, sizeof raw);
  return std::bit_cast<T>(order == std::endian::native ? raw : swapped(raw));
}

/// Stores a number at `bytes` in the given byte order. Returns the position after it.
template <class T>
char* store(char* bytes, T value, std::endian order) {
  const auto raw = std::bit_cast<Bits<sizeof(T)>>(value);
  const auto ordered = order == std::endian::native ? raw : swapped(raw);
  std::memcpy(bytes, &ordered, sizeof ordered);
  return bytes + sizeof ordered;
}

}  // namespace strata::io
