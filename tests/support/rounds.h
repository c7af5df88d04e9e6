#pragma once
#include <cstdint>

namespace strata::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

/// How many of `usual` random cases to try: a twentieth under a sanitizer, which is many times slower.
[[nodiscard]] constexpr std::uint64_t rounds(std::uint64_t usual) { return is_sanitized ? (usual + 19) / 20 : usual; }

}  // namespace strata::test
