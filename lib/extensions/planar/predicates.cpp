#include "extensions/planar/predicates.h"

#include <initializer_list>

#include "extensions/planar/exact_forms.h"

namespace strata::planar {
namespace {

/// Collects the inputs of a decision, and evaluates it in the narrowest sufficient integers.
class Evaluation {
 public:
  explicit Evaluation(const Places& places) : places_(places) {}

  void add_point(std::uint32_t p) {
    if (places_.is_meet(p)) {
      add_line(places_.meet(p).first);
      add_line(places_.meet(p).second);
      has_meet_ = true;
    } else if (places_.is_double(p)) {
      for (const double x : places_.place[p]) lattice_.add(x);
    } else {
      has_rational_ = true;
    }
  }
  void add_line(std::uint32_t l) {
    add_point(places_.lines[l].from);
    add_point(places_.lines[l].to);
  }

  /// sign_of(reader) for a polynomial of `degree` b + `extra` bits, sign included.
  template <class Decide>
  [[nodiscard]] Sign sign(int degree, int extra, const Decide& decide) const {
    if (has_rational_) return decide(Reader<Rational>(places_, lattice_));
    const int b = lattice_.bits(), bits = degree * b + extra;
    if (bits <= 128 && b < 63) return decide(Reader<WideInt<2>>(places_, lattice_));
    if (bits <= 256) return decide(Reader<WideInt<4>>(places_, lattice_));
    if (bits <= 512) return decide(Reader<WideInt<8>>(places_, lattice_));
    return decide(Reader<Integer>(places_, lattice_));
  }
  [[nodiscard]] bool has_meet() const { return has_meet_; }

 private:
  const Places& places_;
  Lattice lattice_;
  bool has_meet_ = false;
  bool has_rational_ = false;
};

using BoundedPair = std::array<Bounded, 2>;

BoundedPair bounded_pair(const Places& places, std::uint32_t p) {
  return {bounded(places, p, 0), bounded(places, p, 1)};
}

Bounded bounded_orientation(const BoundedPair& p, const BoundedPair& q, const BoundedPair& r) {
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

/// In doubles, with the bound of `filtered_orientation`: this, too, is a difference of products of differences.
int filtered_cross(const Places& places, const Line& l, const Line& m) {
  const PlanePoint &a = places.place[l.from], &b = places.place[l.to];
  const PlanePoint &c = places.place[m.from], &d = places.place[m.to];
  const double left = (b[0] - a[0]) * (d[1] - c[1]), right = (b[1] - a[1]) * (d[0] - c[0]), value = left - right;
  constexpr double factor = (3 + 16 * 0x1p-53) * 0x1p-53;
  const double bound = factor * (std::abs(left) + std::abs(right)) + 0x1p-1000;
  return static_cast<int>(value > bound) - static_cast<int>(-value > bound);
}

/// True for points with one coordinate in common.
bool are_level(const PlanePoint& p, const PlanePoint& q, std::size_t axis) { return p[axis] == q[axis]; }

/// True where doubles show it at once: both lines are horizontal, or both vertical.
bool are_level(const Places& places, const Line& l, const Line& m) {
  const PlanePoint &a = places.place[l.from], &b = places.place[l.to];
  const PlanePoint &c = places.place[m.from], &d = places.place[m.to];
  return (are_level(a, b, 0) && are_level(c, d, 0)) || (are_level(a, b, 1) && are_level(c, d, 1));
}

/// Decides where differences of coordinates are doubles.
std::optional<Sign> cross_by_differences(const Places& places, const Line& l, const Line& m) {
  if (std::max({l.from, l.to, m.from, m.to}) >= places.doubles()) return std::nullopt;
  PlanePoint u, v;
  for (std::size_t i = 0; i < 2; ++i) {
    const double a = places.place[l.to][i], b = places.place[l.from][i], c = places.place[m.to][i],
                 d = places.place[m.from][i];
    u[i] = a - b;
    v[i] = c - d;
    if (!is_exact_difference(a, b, u[i]) || !is_exact_difference(c, d, v[i])) return std::nullopt;
  }
  return compare_products(u[0], v[1], u[1], v[0]);
}

}  // namespace

namespace exact {

Sign side(const Places& places, std::uint32_t point, std::uint32_t line) {
  Evaluation e(places);
  e.add_point(point);
  e.add_line(line);
  return e.sign(e.has_meet() ? 4 : 2, e.has_meet() ? 7 : 4, [&](const auto& reader) {
    const auto l = reader.line(line);
    const auto p = reader.point(point);
    using Number = std::remove_cvref_t<decltype(p.x)>;
    return sign_of_integer(Number(l.a * p.x + l.b * p.y + l.c * p.w)) * sign_of_integer(p.w);
  });
}

Sign cross(const Places& places, std::uint32_t line, std::uint32_t other) {
  Evaluation e(places);
  e.add_line(line);
  e.add_line(other);
  return e.sign(2, 4, [&](const auto& reader) {
    const auto l = reader.line(line), m = reader.line(other);
    using Number = std::remove_cvref_t<decltype(l.a)>;
    return sign_of_integer(Number(l.a * m.b - l.b * m.a));
  });
}

Sign compare(const Places& places, std::uint32_t p, std::uint32_t q, std::size_t axis) {
  if (p == q) return Sign::zero;
  if (places.is_meet(p) && places.is_meet(q) && places.meet(p) == places.meet(q)) return Sign::zero;
  Evaluation e(places);
  e.add_point(p);
  e.add_point(q);
  return e.sign(5, 8, [&](const auto& reader) {
    const auto a = reader.point(p), b = reader.point(q);
    using Number = std::remove_cvref_t<decltype(a.x)>;
    const Number difference = axis == 0 ? Number(a.x * b.w - b.x * a.w) : Number(a.y * b.w - b.y * a.w);
    return sign_of_integer(difference) * sign_of_integer(a.w) * sign_of_integer(b.w);
  });
}

}  // namespace exact

Sign closer::side(const Places& places, std::uint32_t point, std::uint32_t line) {
  const auto [a, b] = places.lines[line];
  if (point == a || point == b) return Sign::zero;
  if (places.is_double(point) && places.is_double(a) && places.is_double(b)) {
    const PlanePoint &p = places.place[a], &q = places.place[b], &r = places.place[point];
    for (const std::size_t axis : {0, 1})
      if (are_level(p, q, axis) && are_level(p, r, axis)) return Sign::zero;
    if (const std::optional<Sign> sign = orientation_by_differences(p, q, r)) return *sign;
    return exact::side(places, point, line);
  }
  if (places.is_meet(point) && (places.meet(point).first == line || places.meet(point).second == line))
    return Sign::zero;
  const auto sign =
      bounded_orientation(bounded_pair(places, a), bounded_pair(places, b), bounded_pair(places, point)).sign();
  return sign ? *sign : exact::side(places, point, line);
}

Sign cross(const Places& places, std::uint32_t line, std::uint32_t other) {
  const Line l = places.lines[line], m = places.lines[other];
  if (l == m || (l.from == m.to && l.to == m.from)) return Sign::zero;
  if (std::max({l.from, l.to, m.from, m.to}) < places.doubles()) {
    if (const int orientation = filtered_cross(places, l, m); orientation != 0) return static_cast<Sign>(orientation);
    if (are_level(places, l, m)) return Sign::zero;
  }
  BoundedPair u, v;
  for (std::size_t i = 0; i < 2; ++i) {
    u[i] = bounded(places, l.to, i) - bounded(places, l.from, i);
    v[i] = bounded(places, m.to, i) - bounded(places, m.from, i);
  }
  if (const std::optional<Sign> sign = (u[0] * v[1] - u[1] * v[0]).sign()) return *sign;
  if (const std::optional<Sign> sign = cross_by_differences(places, l, m)) return *sign;
  return exact::cross(places, line, other);
}

}  // namespace strata::planar
