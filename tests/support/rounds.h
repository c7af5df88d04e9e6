#pragma once
#include <cstdint>

namespace strata::test {

/// How many of `usual` random cases to try: a twentieth under a sanitizer, which is many times slower.
[[nodiscard]] constexpr std::uint64_t rounds(std::uint64_t usual) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return (usual + 19) / 20;
#else
  return usual;
#endif
}

}  // namespace strata::test
