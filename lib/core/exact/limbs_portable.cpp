#include "core/exact/limbs_portable.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace strata::limbs::portable {
namespace {

/// The 64 highest bits of (high, low) * 2^bits, 0 <= bits <= 63.
Limb shifted(Limb high, Limb low, int bits) { return high << bits | (low >> 1) >> (63 - bits); }

bool is_less(TwoLimbs a, TwoLimbs b) { return a.high != b.high ? a.high < b.high : a.low < b.low; }

TwoLimbs sum(TwoLimbs a, TwoLimbs b) {
  const Limb low = a.low + b.low;
  return {a.high + b.high + (low < b.low), low};
}

TwoLimbs difference(TwoLimbs a, TwoLimbs b) { return {a.high - b.high - (a.low < b.low), a.low - b.low}; }

/// (2^128 - 1) / d - 2^64 for d with its highest bit set.
Limb reciprocal(Limb d) { return quotient({~d, ~Limb{0}}, d); }

/// Divides a window of three limbs by two. Moller and Granlund 2011, algorithms 4 to 6.
class TwoLimbDivisor {
 public:
  /// The highest bit of d is set.
  explicit TwoLimbDivisor(TwoLimbs d) : d_(d), reciprocal_(reciprocal(d.high)) {
    Limb p = d.high * reciprocal_ + d.low;
    if (p < d.low) {
      --reciprocal_;
      if (p >= d.high) {
        --reciprocal_;
        p -= d.high;
      }
      p -= d.high;
    }
    const TwoLimbs t = product(reciprocal_, d.low);
    p += t.high;
    if (p >= t.high) return;
    --reciprocal_;
    if (!is_less({p, t.low}, d)) --reciprocal_;
  }
  /// The quotient, or the highest limb where it has more than one.
  [[nodiscard]] Limb quotient_of(TwoLimbs n, Limb low) const {
    if (!is_less(n, d_)) return ~Limb{0};
    TwoLimbs q = sum(product(n.high, reciprocal_), n);
    TwoLimbs r = difference({n.low - q.high * d_.high, low}, d_);
    r = difference(r, product(d_.low, q.high));
    ++q.high;
    if (r.high >= q.low) {
      --q.high;
      r = sum(r, d_);
    }
    return is_less(r, d_) ? q.high : q.high + 1;
  }

 private:
  TwoLimbs d_;
  Limb reciprocal_;
};

/// a / d for one limb; a becomes the quotient, the remainder is returned.
Limb divide_by_limb(Limb* a, int n, Limb d) {
  const int bits = std::countl_zero(d);
  const Limb divisor = d << bits, inverse = reciprocal(divisor);
  Limb rest = shifted(0, a[n - 1], bits);
  for (int i = n - 1; i >= 0; --i) {
    const Limb next = shifted(a[i], i > 0 ? a[i - 1] : 0, bits);
    TwoLimbs q = sum(product(rest, inverse), {rest + 1, next});
    Limb r = next - q.high * divisor;
    if (r > q.low) {
      --q.high;
      r += divisor;
    }
    if (r >= divisor) {
      ++q.high;
      r -= divisor;
    }
    a[i] = q.high;
    rest = r;
  }
  return rest >> bits;
}

/// a -= q * b; returns what is to be taken from the limb above.
Limb subtract_multiple(Limb* a, const Limb* b, int m, Limb q) {
  Limb borrow = 0;
  for (int i = 0; i < m; ++i) {
    const TwoLimbs p = product(q, b[i]);
    const Limb low = p.low + borrow;
    borrow = p.high + (low < borrow) + (a[i] < low);
    a[i] -= low;
  }
  return borrow;
}

/// a becomes a mod b, which has m >= 2 limbs; the limbs of the quotient are given to `take(place, limb)`.
template <class Take>
void reduce(Limb* a, int n, const Limb* b, int m, Take take) {
  const int bits = std::countl_zero(b[m - 1]);
  const auto limb_below = [bits](const Limb* x, int end) {  // of x * 2^bits
    return shifted(x[end - 1], end > 1 ? x[end - 2] : 0, bits);
  };
  const TwoLimbDivisor divisor({limb_below(b, m), limb_below(b, m - 1)});
  for (int j = n - m; j >= 0; --j) {
    const Limb above = j + m < n ? a[j + m] : 0;
    const TwoLimbs high{shifted(above, a[j + m - 1], bits), limb_below(a, j + m)};
    Limb q = divisor.quotient_of(high, limb_below(a, j + m - 1));
    if (q != 0 && above < subtract_multiple(a + j, b, m, q)) {
      --q;
      add(a + j, a + j, m, b, m);
    }
    if (j + m < n) a[j + m] = 0;
    take(j, q);
  }
}

void remainder(Limb* a, int n, const Limb* b, int m) {
  if (m > 1) return reduce(a, n, b, m, [](int, Limb) {});
  const Limb rest = divide_by_limb(a, n, b[0]);
  std::fill_n(a, n, 0);
  a[0] = rest;
}

/// x' = a x - b y, y' = d y - c x; with `is_odd` the negated ones.
struct Cofactors {
  Limb a = 1, b = 0, c = 0, d = 1;
  bool is_odd = false;
};

/// Those that Euclid's algorithm has for all numbers that begin with these 62 bits. Knuth, 4.5.2, algorithm L.
Cofactors lehmer_cofactors(Limb x_top, Limb y_top) {
  auto x = static_cast<std::int64_t>(x_top), y = static_cast<std::int64_t>(y_top);
  std::int64_t a = 1, b = 0, c = 0, d = 1;
  bool is_odd = false;
  while (y + c != 0 && y + d != 0) {
    const std::int64_t q = (x + a) / (y + c);
    if (q != (x + b) / (y + d)) break;
    a = std::exchange(c, a - q * c);
    b = std::exchange(d, b - q * d);
    x = std::exchange(y, x - q * y);
    is_odd = !is_odd;
  }
  const auto size = [](std::int64_t k) { return static_cast<Limb>(k < 0 ? -k : k); };
  return {size(a), size(b), size(c), size(d), is_odd};
}

/// The limbs of p * x - q * y, one after the other.
class Difference {
 public:
  Difference(Limb p, Limb q) : p_(p), q_(q) {}
  Limb next(Limb x, Limb y) {
    TwoLimbs u = sum(product(p_, x), {0, u_}), v = sum(product(q_, y), {0, v_});
    u_ = u.high;
    v_ = v.high;
    const Limb r = u.low - v.low, result = r - borrow_;
    borrow_ = (u.low < v.low) | (r < borrow_);
    return result;
  }

 private:
  Limb p_, q_, u_ = 0, v_ = 0, borrow_ = 0;
};

void apply(const Cofactors& k, Limb* x, Limb* y, int n) {
  // With odd parity: x' = b y - a x, y' = c x - d y.
  Difference new_x = k.is_odd ? Difference(k.b, k.a) : Difference(k.a, k.b);
  Difference new_y = k.is_odd ? Difference(k.c, k.d) : Difference(k.d, k.c);
  for (int i = 0; i < n; ++i) {
    const Limb s = x[i], t = y[i];
    x[i] = k.is_odd ? new_x.next(t, s) : new_x.next(s, t);
    y[i] = k.is_odd ? new_y.next(s, t) : new_y.next(t, s);
  }
}

/// Of odd x and y.
Limb binary_gcd(Limb x, Limb y) {
  while (x != y) {
    if (x < y) std::swap(x, y);
    x -= y;
    x >>= std::countr_zero(x);
  }
  return x;
}

void trim(const Limb* x, int& n) {
  while (n > 0 && x[n - 1] == 0) --n;
}

}  // namespace

Limb quotient_by_halves(TwoLimbs n, Limb d) {
  constexpr Limb low_half = 0xffffffffU;
  const Limb high = d >> 32, low = d & low_half;
  const auto digit = [&](Limb rest, Limb next) {  // of (rest, next) / d, next a half
    Limb q = rest / high, r = rest % high;
    while (q > low_half || q * low > (r << 32 | next)) {
      --q;
      r += high;
      if (r > low_half) break;
    }
    return q;
  };
  const Limb q1 = digit(n.high, n.low >> 32);
  const Limb rest = (n.high << 32 | n.low >> 32) - q1 * d;
  return q1 << 32 | digit(rest, n.low & low_half);
}

Limb add(Limb* r, const Limb* a, int n, const Limb* b, int m) {
  Limb carry = 0;
  for (int i = 0; i < m; ++i) {
    const Limb s = a[i] + b[i], t = s + carry;
    carry = (s < b[i]) | (t < carry);
    r[i] = t;
  }
  for (int i = m; i < n; ++i) {
    r[i] = a[i] + carry;
    carry = r[i] < carry;
  }
  return carry;
}

void subtract(Limb* r, const Limb* a, int n, const Limb* b, int m) {
  Limb borrow = 0;
  for (int i = 0; i < m; ++i) {
    const Limb x = a[i], y = b[i], s = x - y;
    r[i] = s - borrow;
    borrow = (x < y) | (s < borrow);
  }
  for (int i = m; i < n; ++i) {
    const Limb x = a[i];
    r[i] = x - borrow;
    borrow = x < borrow;
  }
}

void multiply(Limb* r, const Limb* a, int n, const Limb* b, int m) {
  std::fill_n(r, n, 0);
  for (int j = 0; j < m; ++j) {
    Limb carry = 0;
    for (int i = 0; i < n; ++i) {
      const TwoLimbs p = sum(sum(product(a[i], b[j]), {0, r[i + j]}), {0, carry});
      r[i + j] = p.low;
      carry = p.high;
    }
    r[n + j] = carry;
  }
}

Limb shift_left(Limb* r, const Limb* a, int n, int bits) {
  const Limb out = a[n - 1] >> (64 - bits);
  for (int i = n - 1; i > 0; --i) r[i] = a[i] << bits | a[i - 1] >> (64 - bits);
  r[0] = a[0] << bits;
  return out;
}

void shift_right(Limb* r, const Limb* a, int n, int bits) {
  for (int i = 0; i + 1 < n; ++i) r[i] = a[i] >> bits | a[i + 1] << (64 - bits);
  r[n - 1] = a[n - 1] >> bits;
}

int compare(const Limb* a, const Limb* b, int n) {
  for (int i = n - 1; i >= 0; --i)
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  return 0;
}

void divide(Limb* quotient, Limb* remainder, const Limb* a, int n, const Limb* b, int m) {
  if (m == 1) {
    std::copy_n(a, n, quotient);
    remainder[0] = divide_by_limb(quotient, n, b[0]);
    return;
  }
  if (remainder != a) std::copy_n(a, n, remainder);
  reduce(remainder, n, b, m, [quotient](int place, Limb q) { quotient[place] = q; });
}

int gcd(Limb* r, Limb* a, int n, Limb* b, int m) {
  Limb *x = a, *y = b;  // of n and m limbs, x >= y
  const auto put_in_order = [&] {
    trim(x, n);
    trim(y, m);
    if (n > m || (n == m && compare(x, y, n) >= 0)) return;
    std::swap(x, y);
    std::swap(n, m);
  };
  put_in_order();
  while (n > 1 && m > 0) {
    const int bits = std::countl_zero(x[n - 1]);
    if (m + 1 == n) y[m] = 0;
    const Limb y_top = m + 1 >= n ? shifted(y[n - 1], y[n - 2], bits) : 0;
    const Cofactors k = lehmer_cofactors(shifted(x[n - 1], x[n - 2], bits) >> 2, y_top >> 2);
    if (k.b == 0) {
      remainder(x, n, y, m);
      n = m;
    } else {
      apply(k, x, y, n);
      m = n;
    }
    put_in_order();
  }
  if (m == 0) {
    std::copy_n(x, n, r);
    return n;
  }
  r[0] = binary_gcd(x[0] >> std::countr_zero(x[0]), y[0] >> std::countr_zero(y[0]));
  return 1;
}

}  // namespace strata::limbs::portable
