#include "core/containers/box_pack.h"

#include <bit>
#include <cstring>

// Intrinsics: GCC 12 takes vectors apart that are wider than what all processors have, before it looks at a function's
// target.
#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#define STRATA_HAS_WIDE_VECTORS 1
#endif

namespace strata {
namespace {

using Masks = BoxPackTests::Masks;

/// BoxPackTests::pairs by the tests of one box and one lane. A part of each function that calls it, so that these tests
/// are, too: instructions beyond those of all processors are for functions that ask for them.
template <class Lanes>
[[gnu::always_inline]] inline std::uint32_t pairs_in(const BoxPack& a, const KeyPack& keys_of_a, const BoxPack& b,
                                                     const KeyPack& keys_of_b, const Box& bounds_of_b, Masks& masks) {
  const std::uint32_t own = Lanes::overlapping(a, bounds_of_b);
  for (std::uint32_t rest = own; rest != 0; rest &= rest - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rest));
    masks[i] = Lanes::overlapping(b, a.box(i));
    if (masks[i] != 0) masks[i] &= ~Lanes::with_common_key(keys_of_b, keys_of_a, i);
  }
  return own;
}

/// In two vectors of four keys, and four of two doubles, which every processor has.
struct Portable {
  using TwoDoubles [[gnu::vector_size(16)]] = double;
  using TwoBits [[gnu::vector_size(16)]] = std::int64_t;
  using FourKeys [[gnu::vector_size(16)]] = std::uint32_t;
  using FourBits [[gnu::vector_size(16)]] = std::int32_t;

  static std::uint32_t overlapping(const BoxPack& pack, const Box& box) {
    TwoBits all{};
    for (std::size_t k = 0; k < BoxPack::width; k += 2) {
      TwoBits met{std::int64_t{1} << k, std::int64_t{2} << k};
      for (std::size_t i = 0; i < 3; ++i) {
        TwoDoubles low, high;
        std::memcpy(&low, &pack.lower[i][k], sizeof low);
        std::memcpy(&high, &pack.upper[i][k], sizeof high);
        met &= (low <= box.upper[i]) & (high >= box.lower[i]);
      }
      all |= met;
    }
    return static_cast<std::uint32_t>(all[0] | all[1]);
  }

  static std::uint32_t with_common_key(const KeyPack& keys, const KeyPack& of, std::size_t lane) {
    FourBits low{}, high{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t own = of.key[i][lane];
      if (own == KeyPack::no_key) continue;
      for (std::size_t j = 0; j < 3; ++j) {
        FourKeys first, second;
        std::memcpy(&first, keys.key[j].data(), sizeof first);
        std::memcpy(&second, keys.key[j].data() + 4, sizeof second);
        low |= first == own;
        high |= second == own;
      }
    }
    const FourBits bits = (low & FourBits{1, 2, 4, 8}) | (high & FourBits{16, 32, 64, 128});
    return static_cast<std::uint32_t>((bits[0] | bits[1]) | (bits[2] | bits[3]));
  }

  static std::uint32_t pairs(const BoxPack& a, const KeyPack& keys_of_a, const BoxPack& b, const KeyPack& keys_of_b,
                             const Box& bounds_of_b, Masks& masks) {
    return pairs_in<Portable>(a, keys_of_a, b, keys_of_b, bounds_of_b, masks);
  }
};

#ifdef STRATA_HAS_WIDE_VECTORS
#define STRATA_AVX2 [[gnu::target("avx2")]]
#define STRATA_AVX512 [[gnu::target("avx512f,avx512vl")]]

/// In one vector of eight keys and two of four doubles.
struct Avx2 {
  STRATA_AVX2 static std::uint32_t overlapping(const BoxPack& pack, const Box& box) {
    std::uint32_t all = 0;
    for (std::size_t k = 0; k < BoxPack::width; k += 4) {
      __m256d met = _mm256_castsi256_pd(_mm256_set1_epi64x(-1));
      for (std::size_t i = 0; i < 3; ++i) {
        const __m256d low = _mm256_loadu_pd(&pack.lower[i][k]), high = _mm256_loadu_pd(&pack.upper[i][k]);
        met = _mm256_and_pd(met, _mm256_cmp_pd(low, _mm256_set1_pd(box.upper[i]), _CMP_LE_OQ));
        met = _mm256_and_pd(met, _mm256_cmp_pd(high, _mm256_set1_pd(box.lower[i]), _CMP_GE_OQ));
      }
      all |= static_cast<std::uint32_t>(_mm256_movemask_pd(met)) << k;
    }
    return all;
  }

  STRATA_AVX2 static std::uint32_t with_common_key(const KeyPack& keys, const KeyPack& of, std::size_t lane) {
    __m256i common = _mm256_setzero_si256();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t own = of.key[i][lane];
      if (own == KeyPack::no_key) continue;
      const __m256i all_own = _mm256_set1_epi32(static_cast<int>(own));
      for (std::size_t j = 0; j < 3; ++j) {
        __m256i key;
        std::memcpy(&key, keys.key[j].data(), sizeof key);
        common = _mm256_or_si256(common, _mm256_cmpeq_epi32(key, all_own));
      }
    }
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(common)));
  }

  STRATA_AVX2 static std::uint32_t pairs(const BoxPack& a, const KeyPack& keys_of_a, const BoxPack& b,
                                         const KeyPack& keys_of_b, const Box& bounds_of_b, Masks& masks) {
    return pairs_in<Avx2>(a, keys_of_a, b, keys_of_b, bounds_of_b, masks);
  }
};

/// In one vector of eight keys or doubles.
struct Avx512 {
  STRATA_AVX512 static std::uint32_t overlapping(const BoxPack& pack, const Box& box) {
    __mmask8 met = 0xff;
    for (std::size_t i = 0; i < 3; ++i) {
      const __m512d low = _mm512_loadu_pd(pack.lower[i].data()), high = _mm512_loadu_pd(pack.upper[i].data());
      met = _mm512_mask_cmp_pd_mask(met, low, _mm512_set1_pd(box.upper[i]), _CMP_LE_OQ);
      met = _mm512_mask_cmp_pd_mask(met, high, _mm512_set1_pd(box.lower[i]), _CMP_GE_OQ);
    }
    return met;
  }

  STRATA_AVX512 static std::uint32_t with_common_key(const KeyPack& keys, const KeyPack& of, std::size_t lane) {
    std::uint32_t common = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t own = of.key[i][lane];
      if (own == KeyPack::no_key) continue;
      const __m256i all_own = _mm256_set1_epi32(static_cast<int>(own));
      for (std::size_t j = 0; j < 3; ++j) {
        __m256i key;
        std::memcpy(&key, keys.key[j].data(), sizeof key);
        common |= _mm256_cmpeq_epi32_mask(key, all_own);
      }
    }
    return common;
  }

  STRATA_AVX512 static std::uint32_t pairs(const BoxPack& a, const KeyPack& keys_of_a, const BoxPack& b,
                                           const KeyPack& keys_of_b, const Box& bounds_of_b, Masks& masks) {
    return pairs_in<Avx512>(a, keys_of_a, b, keys_of_b, bounds_of_b, masks);
  }
};
#endif

template <class Lanes>
constexpr BoxPackTests tests_in{&Lanes::overlapping, &Lanes::pairs};

}  // namespace

std::span<const BoxPackTests> BoxPackTests::available() {
#ifdef STRATA_HAS_WIDE_VECTORS
  static constexpr BoxPackTests all[] = {tests_in<Portable>, tests_in<Avx2>, tests_in<Avx512>};
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("avx2")) return {all, 1};
  if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl")) return {all, 2};
  return all;
#else
  static constexpr BoxPackTests all[] = {tests_in<Portable>};
  return all;
#endif
}

}  // namespace strata
