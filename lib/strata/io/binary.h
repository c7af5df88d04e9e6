#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

namespace strata::io {

/// A number stored at `bytes` in the given byte order, at any alignment.
template <class T>
[[nodiscard]] T load(const char* bytes, std::endian order) {
  char raw[sizeof(T)];
  std::memcpy(raw, bytes, sizeof(T));
  if (order != std::endian::native) std::reverse(raw, raw + sizeof(T));
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// Stores a number at `bytes` in the given byte order.
template <class T>
void store(char* bytes, T value, std::endian order) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (order != std::endian::native) std::reverse(raw, raw + sizeof(T));
  std::memcpy(bytes, raw, sizeof(T));
}

}  // namespace strata::io
