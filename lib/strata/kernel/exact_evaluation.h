#pragma once
#include <algorithm>
#include <span>

#include "strata/exact/lattice.h"
#include "strata/kernel/carriers.h"
#include "strata/kernel/homogeneous.h"
#include "strata/kernel/point.h"

namespace strata {

/// Bits of the integers of a homogeneous point: |x|, |y|, |z| < 2^xyz and w <= 2^w. theory.md, "Widths".
struct PointWidth {
  int xyz = 0;
  int w = 0;
};

/// Bits of the integers of a plane: |a|, |b|, |c| < 2^abc and |d| < 2^d.
struct PlaneWidth {
  int abc = 0;
  int d = 0;
};

/// Widths on a lattice of `b` bits.
[[nodiscard]] PointWidth width_of(const PointName& name, int b);
[[nodiscard]] PlaneWidth width_of_plane(PointWidth p, PointWidth q, PointWidth r);
[[nodiscard]] int width_of_value(PlaneWidth plane, PointWidth p);
[[nodiscard]] int width_of_turn(PointWidth p, PointWidth q, PointWidth r);

/// The lattice of all input coordinates behind some points, and whether any of them is rational.
class Ground {
 public:
  Ground(const Carriers& carriers, std::span<const Point* const> points);

  [[nodiscard]] const Lattice& lattice() const { return lattice_; }
  [[nodiscard]] bool rational() const { return rational_; }

 private:
  void add_vertex(const Carriers& carriers, std::uint32_t v);
  void add_face(const Carriers& carriers, std::uint32_t f);

  Lattice lattice_;
  bool rational_ = false;
};

/// Evaluates points and planes in exact integers, in units of the lattice.
template <class Int>
class ExactEvaluation {
 public:
  ExactEvaluation(const Carriers& carriers, const Lattice& lattice) : carriers_(carriers), lattice_(lattice) {}

  [[nodiscard]] HPoint<Int> vertex(std::uint32_t v) const {
    if constexpr (std::is_same_v<Int, Integer>) {
      if (const MeetOfPlanes* place = carriers_.meet(v)) return on_lattice(place->exact());
      if (const RationalPoint* p = carriers_.exact(v)) return rational(*p);
    }
    return on_lattice(carriers_.vertex(v));
  }

  [[nodiscard]] HPlane<Int> face(std::uint32_t f) const {
    if constexpr (std::is_same_v<Int, Integer>) {
      if (const SourcePlane* plane = carriers_.source_plane(f)) return on_lattice(plane->exact());
    }
    const auto [a, b, c] = carriers_.face(f);
    return plane_through(vertex(a), vertex(b), vertex(c));
  }

  [[nodiscard]] HPoint<Int> point(const Point& p) const {
    const auto& id = p.name.id;
    switch (p.name.kind) {
      case PointName::Kind::input:
        return vertex(id[0]);
      case PointName::Kind::edge_edge:
        return edge_edge(vertex(id[0]), vertex(id[1]), vertex(id[2]), vertex(id[3]));
      case PointName::Kind::edge_face:
        return meet(vertex(id[0]), vertex(id[1]), face(id[2]));
      case PointName::Kind::three_faces:
        return meet(face(id[0]), face(id[1]), face(id[2]));
      case PointName::Kind::weighted:
        return weighted(id[0], id[1]);
      case PointName::Kind::free:
        return on_lattice({p.at[0].value, p.at[1].value, p.at[2].value});
    }
    return {};
  }

 private:
  [[nodiscard]] HPoint<Int> on_lattice(const Carriers::Coordinates& p) const {
    return {lattice_.integer<Int>(p[0]), lattice_.integer<Int>(p[1]), lattice_.integer<Int>(p[2]), Int(1), true};
  }

  /// p / 2^unit over a common denominator.
  [[nodiscard]] HPoint<Int> rational(const RationalPoint& p) const {
    Integer w = 1;
    for (const Rational& x : p) w = lcm(w, denominator(x));
    std::array<Integer, 3> n;
    for (std::size_t i = 0; i < 3; ++i) n[i] = numerator(p[i]) * (w / denominator(p[i]));
    HPoint<Integer> r = on_lattice({n[0], n[1], n[2], w, false});
    r.unit = r.w == 1;
    return r;
  }

  /// A point or plane given in units of 1.
  [[nodiscard]] HPoint<Integer> on_lattice(HPoint<Integer> p) const {
    const int unit = lattice_.unit();
    if (unit > 0) p.w <<= static_cast<unsigned>(unit);
    if (unit < 0)
      for (Integer* x : {&p.x, &p.y, &p.z}) *x <<= static_cast<unsigned>(-unit);
    return p;
  }
  [[nodiscard]] HPlane<Integer> on_lattice(HPlane<Integer> p) const {
    const int unit = lattice_.unit();
    if (unit < 0) p.d <<= static_cast<unsigned>(-unit);
    if (unit > 0)
      for (Integer* x : {&p.a, &p.b, &p.c}) *x <<= static_cast<unsigned>(unit);
    return p;
  }

  /// Coplanar lines: the first coordinate axis along which they are not seen as parallel gives a plane that cuts.
  [[nodiscard]] HPoint<Int> edge_edge(const HPoint<Int>& p, const HPoint<Int>& q, const HPoint<Int>& r,
                                      const HPoint<Int>& s) const {
    HPoint<Int> x;
    for (int axis = 0; axis < 3; ++axis) {
      x = meet(p, q, plane_along_axis(r, s, axis));
      if (sign_of_integer(x.w) != Sign::zero) break;
    }
    return x;
  }

  [[nodiscard]] HPoint<Int> weighted(std::uint32_t f, std::uint32_t t) const {
    const auto [a, b, c] = carriers_.face(f);
    const HPoint<Int> p = vertex(a), q = vertex(b), r = vertex(c);
    const Int tq = Int(static_cast<std::int64_t>(t)), tr = Int(static_cast<std::int64_t>(t) * t);
    const auto sum = [&](int i) {
      return Int(weighed(weighed(p[i], q), r) + tq * weighed(weighed(q[i], p), r) + tr * weighed(weighed(r[i], p), q));
    };
    const Int w = Int(1) + tq + tr;
    return {sum(0), sum(1), sum(2), weighed(weighed(weighed(w, p), q), r), false};
  }

  const Carriers& carriers_;
  const Lattice& lattice_;
};

}  // namespace strata
