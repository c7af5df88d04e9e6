#pragma once
#include "core/exact/lattice.h"
#include "extensions/planar/places.h"

namespace strata::planar {

/// Exact coordinates of points and lines in a ring of numbers: WideInt or Integer (doubles on a lattice).
/// Widths in bits for b-bit lattice coordinates, theory.md, section 2: line forms b+1, b+1, 2b+1; meets 3b+3, 3b+3,
/// 2b+3.

/// The point (x / w, y / w).
template <class Number>
struct PointForm {
  Number x, y, w;
};

/// a x + b y + c, positive to the left of the line.
template <class Number>
struct LineForm {
  Number a, b, c;
};

/// Exact numbers of given points: on a lattice that contains the doubles concerned.
template <class Number>
class Reader {
 public:
  Reader(const Places& places, const Lattice& lattice) : places_(places), lattice_(lattice) {}

  [[nodiscard]] Number coordinate(std::uint32_t given, std::size_t axis) const {
    return lattice_.template integer<Number>(places_.place[given][axis]);
  }
  [[nodiscard]] LineForm<Number> line(std::uint32_t l) const {
    const auto [p, q] = places_.lines[l];
    const Number px = coordinate(p, 0), py = coordinate(p, 1), qx = coordinate(q, 0), qy = coordinate(q, 1);
    return {py - qy, qx - px, px * qy - qx * py};
  }
  [[nodiscard]] PointForm<Number> point(std::uint32_t p) const {
    if (!places_.is_meet(p)) return {coordinate(p, 0), coordinate(p, 1), Number(1)};
    const LineForm<Number> l = line(places_.meet(p).first), m = line(places_.meet(p).second);
    return {l.b * m.c - m.b * l.c, l.c * m.a - m.c * l.a, l.a * m.b - m.a * l.b};
  }

 private:
  const Places& places_;
  const Lattice& lattice_;
};

/// Where given points are rational: forms are multiples, by positive numbers, of those above, so that they are integers
/// and nothing is brought to lowest terms.
template <>
class Reader<Rational> {
 public:
  Reader(const Places& places, const Lattice& /*unused*/) : places_(places) {}

  [[nodiscard]] LineForm<Integer> line(std::uint32_t l) const {
    const PointForm<Integer> p = given(places_.lines[l].from), q = given(places_.lines[l].to);
    return {p.y * q.w - q.y * p.w, q.x * p.w - p.x * q.w, p.x * q.y - q.x * p.y};
  }
  [[nodiscard]] PointForm<Integer> point(std::uint32_t p) const {
    if (!places_.is_meet(p)) return given(p);
    const LineForm<Integer> l = line(places_.meet(p).first), m = line(places_.meet(p).second);
    return {l.b * m.c - m.b * l.c, l.c * m.a - m.c * l.a, l.a * m.b - m.a * l.b};
  }

 private:
  [[nodiscard]] PointForm<Integer> given(std::uint32_t p) const {
    if (!places_.is_double(p)) return form(places_.rational(p).exact());
    return form({to_rational(places_.place[p][0]), to_rational(places_.place[p][1])});
  }
  [[nodiscard]] static PointForm<Integer> form(const RationalPlacement& p) {
    const Integer x = numerator(p[0]), y = numerator(p[1]);
    Integer v = denominator(p[0]), w = denominator(p[1]);
    if (v == w) return {x, y, std::move(w)};
    return {x * w, y * v, v * w};
  }

  const Places& places_;
};

}  // namespace strata::planar
