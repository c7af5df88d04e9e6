#pragma once
#include "core/exact/lattice.h"
#include "extensions/planar/places.h"

namespace strata::planar {

/// Exact coordinates of points and lines in a ring of numbers: WideInt, Integer (doubles on a lattice) or Rational.
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

template <>
inline Rational Reader<Rational>::coordinate(std::uint32_t given, std::size_t axis) const {
  return places_.is_double(given) ? to_rational(places_.place[given][axis]) : places_.rational(given)[axis];
}

}  // namespace strata::planar
