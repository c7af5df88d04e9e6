#include "core/exact/cpp_integer.h"

#include <algorithm>
#include <bit>
#include <boost/container/small_vector.hpp>
#include <utility>

#include "core/exact/limbs_portable.h"

namespace strata::detail {
namespace {

using Limb = std::uint64_t;
using Limbs = std::span<const Limb>;
using Scratch = boost::container::small_vector<Limb, 72>;

Limbs view(const Scratch& x) { return {x.data(), x.size()}; }
int size_of(Limbs x) { return static_cast<int>(x.size()); }

std::size_t zeros_of(Limbs x) {
  std::size_t i = 0;
  while (x[i] == 0) ++i;
  return 64 * i + static_cast<std::size_t>(std::countr_zero(x[i]));
}

bool is_bit(Limbs x) {
  return std::has_single_bit(x.back()) && std::all_of(x.begin(), x.end() - 1, [](Limb limb) { return limb == 0; });
}

/// x / 2^bits in at least `room` limbs; `size` becomes the number of those that count.
Scratch shifted_down(Limbs x, std::size_t bits, std::size_t room, int& size) {
  const Limbs rest = x.subspan(bits / 64);
  Scratch r(std::max(room, rest.size()));
  size = size_of(rest);
  if (bits % 64 == 0)
    std::copy(rest.begin(), rest.end(), r.begin());
  else
    limbs::portable::shift_right(r.data(), rest.data(), size, static_cast<int>(bits % 64));
  if (r[static_cast<std::size_t>(size) - 1] == 0) --size;
  return r;
}

/// Quotient and remainder of magnitudes, a >= b > 0.
void divide_magnitudes(Limbs a, Limbs b, Scratch& quotient, Scratch& remainder) {
  quotient.resize(a.size() - b.size() + 1);
  remainder.resize(a.size());
  limbs::portable::divide(quotient.data(), remainder.data(), a.data(), size_of(a), b.data(), size_of(b));
  remainder.resize(b.size());
}

bool is_shorter(Limbs a, Limbs b) { return a.size() < b.size(); }

}  // namespace

void assign(CppInteger& x, Limbs magnitude, bool is_negative) {
  while (!magnitude.empty() && magnitude.back() == 0) magnitude = magnitude.first(magnitude.size() - 1);
  auto& backend = x.backend();
  const auto size = static_cast<unsigned>(std::max<std::size_t>(magnitude.size(), 1));
  backend.resize(size, size);
  *backend.limbs() = 0;
  std::copy(magnitude.begin(), magnitude.end(), backend.limbs());
  backend.sign(is_negative && !magnitude.empty());
}

void divide(const CppInteger& a, const CppInteger& b, CppInteger& quotient, CppInteger& remainder) {
  const Limbs x = magnitude(a), y = magnitude(b);
  if (is_shorter(x, y)) {
    quotient = 0;
    remainder = a;
    return;
  }
  const bool is_negative = a.sign() < 0, differs = is_negative != (b.sign() < 0);
  Scratch q, r;
  divide_magnitudes(x, y, q, r);
  assign(quotient, view(q), differs);
  assign(remainder, view(r), is_negative);
}

CppInteger quotient(const CppInteger& a, const CppInteger& b) {
  const Limbs x = magnitude(a), y = magnitude(b);
  CppInteger result;
  if (is_shorter(x, y)) return result;
  Scratch q, r;
  divide_magnitudes(x, y, q, r);
  assign(result, view(q), (a.sign() < 0) != (b.sign() < 0));
  return result;
}

CppInteger remainder(const CppInteger& a, const CppInteger& b) {
  const Limbs x = magnitude(a), y = magnitude(b);
  if (is_shorter(x, y)) return a;
  Scratch q, r;
  divide_magnitudes(x, y, q, r);
  CppInteger result;
  assign(result, view(r), a.sign() < 0);
  return result;
}

CppInteger exact_quotient(const CppInteger& a, const CppInteger& b) {
  if (!is_power_of_two(b)) return quotient(a, b);
  CppInteger r = a;
  shift_down(r, trailing_zeros(b));
  return r;
}

CppInteger common_divisor(const CppInteger& a, const CppInteger& b) {
  if (a.sign() == 0) return abs(b);
  if (b.sign() == 0) return abs(a);
  const Limbs x = magnitude(a), y = magnitude(b);
  const std::size_t of_x = zeros_of(x), of_y = zeros_of(y), common = std::min(of_x, of_y);
  CppInteger result = 1;
  if (!is_bit(x) && !is_bit(y)) {
    const std::size_t room = std::max(x.size(), y.size());
    int n = 0, m = 0;
    Scratch p = shifted_down(x, of_x, room, n), q = shifted_down(y, of_y, room, m), r(room);
    if (n < m) {
      p.swap(q);
      std::swap(n, m);
    }
    const int size = limbs::portable::gcd(r.data(), p.data(), n, q.data(), m);
    assign(result, {r.data(), static_cast<std::size_t>(size)}, false);
  }
  return result <<= common;
}

std::size_t trailing_zeros(const CppInteger& x) { return zeros_of(magnitude(x)); }

bool is_power_of_two(const CppInteger& x) { return x.sign() > 0 && is_bit(magnitude(x)); }

void shift_down(CppInteger& x, std::size_t bits) {
  if (bits == 0 || x.sign() == 0) return;
  const bool is_negative = x.sign() < 0;
  x.backend().sign(false);
  x >>= bits;
  x.backend().sign(is_negative);
}

}  // namespace strata::detail
