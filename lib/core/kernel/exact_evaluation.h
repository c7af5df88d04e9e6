#pragma once
#include <algorithm>
#include <optional>
#include <span>

#include "core/exact/lattice.h"
#include "core/kernel/homogeneous.h"
#include "core/kernel/input_complex.h"
#include "core/kernel/point.h"

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
[[nodiscard]] PointWidth width_of(const SymbolicPoint& name, int b);
[[nodiscard]] PlaneWidth width_of_plane(PointWidth p, PointWidth q, PointWidth r);
[[nodiscard]] int width_of_value(PlaneWidth plane, PointWidth p);
[[nodiscard]] int width_of_orientation(PointWidth p, PointWidth q, PointWidth r);

/// The lattice of all input coordinates on which some points depend, and whether any of these is a rational that is not
/// the sum of two doubles. Such a sum is less than the power of two above the first double, which is the double nearest
/// to it.
class Ground {
 public:
  Ground(const InputComplex& input, std::span<const Point* const> points);

  [[nodiscard]] const Lattice& lattice() const { return lattice_; }
  [[nodiscard]] bool rational() const { return rational_; }

 private:
  void add_vertex(const InputComplex& input, std::uint32_t v);
  void add_face(const InputComplex& input, std::uint32_t f);

  Lattice lattice_;
  bool rational_ = false;
};

/// Evaluates points and planes in exact integers, in units of the lattice. Integers of a fixed number of bits represent
/// vertices that are doubles or sums of two doubles. The other integer types represent all vertices, or report that a
/// value is lost.
template <class Int>
class ExactEvaluation {
  static constexpr bool any_size = std::is_same_v<Int, Integer> || std::is_same_v<Int, LongInt>;

 public:
  ExactEvaluation(const InputComplex& input, const Lattice& lattice) : input_(input), lattice_(lattice) {}

  [[nodiscard]] HPoint<Int> vertex(std::uint32_t v) const {
    const VertexPosition place = input_.place(v);
    if (place.remainder != nullptr) return on_lattice(*place.nearest, *place.remainder);
    if constexpr (any_size) {
      if (place.meet != nullptr) return meet_of_planes(*place.meet);
      if (place.rational != nullptr) return on_lattice(of_this_type(input_.homogeneous(v)));
    }
    return on_lattice(*place.nearest);
  }

  [[nodiscard]] HPlane<Int> face(std::uint32_t f) const {
    if constexpr (any_size) {
      if (const SourcePlane* plane = input_.source_plane(f)) return on_lattice(of_this_type(plane->exact()));
    }
    const auto [a, b, c] = input_.face(f);
    return plane_through(vertex(a), vertex(b), vertex(c));
  }

  [[nodiscard]] HPoint<Int> point(const Point& p) const {
    const auto& id = p.name.id;
    switch (p.name.kind) {
      case SymbolicPoint::Kind::input:
        return vertex(id[0]);
      case SymbolicPoint::Kind::edge_edge:
        return edge_edge(vertex(id[0]), vertex(id[1]), vertex(id[2]), vertex(id[3]));
      case SymbolicPoint::Kind::edge_face:
        return meet(vertex(id[0]), vertex(id[1]), face(id[2]));
      case SymbolicPoint::Kind::three_faces:
        return meet(face(id[0]), face(id[1]), face(id[2]));
      case SymbolicPoint::Kind::weighted:
        return weighted(id[0], id[1]);
      case SymbolicPoint::Kind::free:
        return on_lattice(InputComplex::Coordinates{p.at[0].value, p.at[1].value, p.at[2].value});
    }
    return {};
  }

 private:
  [[nodiscard]] HPoint<Int> on_lattice(const InputComplex::Coordinates& p) const {
    return {lattice_.integer<Int>(p[0]), lattice_.integer<Int>(p[1]), lattice_.integer<Int>(p[2]), Int(1), true};
  }

  /// p + q, where every coordinate of the sum has the magnitude of p's.
  [[nodiscard]] HPoint<Int> on_lattice(const InputComplex::Coordinates& p, const InputComplex::Coordinates& q) const {
    const auto sum = [&](std::size_t i) { return Int(lattice_.integer<Int>(p[i]) + lattice_.integer<Int>(q[i])); };
    return {sum(0), sum(1), sum(2), Int(1), true};
  }

  [[nodiscard]] static decltype(auto) of_this_type(const HPoint<Integer>& p) {
    if constexpr (std::is_same_v<Int, Integer>)
      return p;
    else
      return HPoint<Int>{Int(p.x), Int(p.y), Int(p.z), Int(p.w), p.unit};
  }
  [[nodiscard]] static decltype(auto) of_this_type(const HPlane<Integer>& p) {
    if constexpr (std::is_same_v<Int, Integer>)
      return p;
    else
      return HPlane<Int>{Int(p.a), Int(p.b), Int(p.c), Int(p.d)};
  }

  [[nodiscard]] HPoint<Int> meet_of_planes(const MeetOfPlanes& p) const {
    const auto plane = [&](std::size_t i) -> decltype(auto) { return of_this_type(p.planes[i]->exact()); };
    return on_lattice(meet(plane(0), plane(1), plane(2)));
  }

  /// A point or plane given in units of 1.
  [[nodiscard]] HPoint<Int> on_lattice(HPoint<Int> p) const {
    const int unit = lattice_.unit();
    if (unit > 0) p.w = std::move(p.w) << unit;
    if (unit < 0)
      for (Int* x : {&p.x, &p.y, &p.z}) *x = std::move(*x) << -unit;
    p.unit = p.unit && unit <= 0;
    return p;
  }
  [[nodiscard]] HPlane<Int> on_lattice(HPlane<Int> p) const {
    const int unit = lattice_.unit();
    if (unit < 0) p.d = std::move(p.d) << -unit;
    if (unit > 0)
      for (Int* x : {&p.a, &p.b, &p.c}) *x = std::move(*x) << unit;
    return p;
  }

  /// Coplanar lines: the first coordinate axis along which their projections are not parallel gives a plane that cuts.
  [[nodiscard]] HPoint<Int> edge_edge(const HPoint<Int>& p, const HPoint<Int>& q, const HPoint<Int>& r,
                                      const HPoint<Int>& s) const {
    HPoint<Int> x;
    for (int axis = 0; axis < 3; ++axis) {
      x = meet(p, q, plane_along_axis(r, s, axis));
      if (is_lost(x.w) || sign_of_integer(x.w) != Sign::zero) break;
    }
    return x;
  }

  [[nodiscard]] HPoint<Int> weighted(std::uint32_t f, std::uint32_t t) const {
    const auto [a, b, c] = input_.face(f);
    const HPoint<Int> p = vertex(a), q = vertex(b), r = vertex(c);
    const Int tq = Int(static_cast<std::int64_t>(t)), tr = Int(static_cast<std::int64_t>(t) * t);
    const auto sum = [&](int i) {
      return Int(weighed(weighed(p[i], q), r) + tq * weighed(weighed(q[i], p), r) + tr * weighed(weighed(r[i], p), q));
    };
    const Int w = Int(1) + tq + tr;
    return {sum(0), sum(1), sum(2), weighed(weighed(weighed(w, p), q), r), false};
  }

  const InputComplex& input_;
  const Lattice& lattice_;
};

/// The values in integers of any size; none if one is lost.
[[nodiscard]] inline std::optional<HPoint<Integer>> in_integers(const HPoint<LongInt>& p) {
  if (p.x.is_lost() || p.y.is_lost() || p.z.is_lost() || p.w.is_lost()) return std::nullopt;
  return HPoint<Integer>{Integer(p.x), Integer(p.y), Integer(p.z), Integer(p.w), p.unit};
}
[[nodiscard]] inline std::optional<HPlane<Integer>> in_integers(const HPlane<LongInt>& p) {
  if (p.a.is_lost() || p.b.is_lost() || p.c.is_lost() || p.d.is_lost()) return std::nullopt;
  return HPlane<Integer>{Integer(p.a), Integer(p.b), Integer(p.c), Integer(p.d)};
}

}  // namespace strata
