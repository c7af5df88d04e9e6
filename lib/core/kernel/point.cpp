#include "core/kernel/point.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "core/exact/double_double.h"
#include "core/kernel/approximation.h"
#include "core/kernel/exact_evaluation.h"
#include "core/kernel/nearest.h"

namespace strata {
namespace {

bool has(const InputComplex::Indices& v, std::uint32_t x) { return v[0] == x || v[1] == x || v[2] == x; }

/// True if the bounds are below 2^-49 of the largest coordinate. Wide bounds make every later decision expensive, so
/// they are replaced by narrower ones. So are infinite bounds after overflow, which no later decision could use.
bool is_tight(const BoundedPoint& p) {
  const double size = std::max({std::abs(p[0].value), std::abs(p[1].value), std::abs(p[2].value), 0x1p-900});
  for (const Bounded& x : p)
    if (!std::isfinite(x.value) || !(x.error <= size * 0x1p-49)) return false;
  return true;
}

/// Coordinates that all vertices of an edge or face have in common: all points there have them, exactly. For vertices
/// that are doubles or sums of two doubles.
class CommonCoordinates {
 public:
  CommonCoordinates(const InputComplex& input, const SymbolicPoint& name) : input_(input) {
    const auto& id = name.id;
    switch (name.kind) {
      case SymbolicPoint::Kind::edge_edge:
        add({id[0], id[1]});
        add({id[2], id[3]});
        return;
      case SymbolicPoint::Kind::edge_face:
        add({id[0], id[1]});
        add_face(id[2]);
        return;
      case SymbolicPoint::Kind::three_faces:
        for (std::size_t i = 0; i < 3; ++i) add_face(id[i]);
        return;
      case SymbolicPoint::Kind::weighted:
        add_face(id[0]);
        return;
      case SymbolicPoint::Kind::input:
      case SymbolicPoint::Kind::free:
        return;
    }
  }

  [[nodiscard]] bool are_all() const { return known_[0] && known_[1] && known_[2]; }
  void put_into(RealPoint<DoubleDouble>& p) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (known_[i]) p[i] = value_[i];
  }

 private:
  void add(std::initializer_list<std::uint32_t> vertices) {
    const VertexPosition first = input_.place(*vertices.begin());
    std::array<bool, 3> common{true, true, true};
    for (const std::uint32_t v : vertices) {
      const VertexPosition place = input_.place(v);
      if (!place.has_doubles() && place.remainder == nullptr) return;
      for (std::size_t i = 0; i < 3; ++i)
        common[i] = common[i] && (*place.nearest)[i] == (*first.nearest)[i] && rest(place, i) == rest(first, i);
    }
    for (std::size_t i = 0; i < 3; ++i)
      if (common[i]) {
        known_[i] = true;
        value_[i] = DoubleDouble((*first.nearest)[i], rest(first, i), 0);
      }
  }
  static double rest(const VertexPosition& place, std::size_t axis) {
    return place.remainder != nullptr ? (*place.remainder)[axis] : 0;
  }
  void add_face(std::uint32_t f) {
    const auto v = input_.face(f);
    add({v[0], v[1], v[2]});
  }

  const InputComplex& input_;
  std::array<bool, 3> known_{};
  RealPoint<DoubleDouble> value_{};
};

/// A point in units of a lattice: in long integers if they can represent it.
HPoint<Integer> exact_in_units(const InputComplex& input, const Lattice& lattice, const Point& point) {
  auto p = in_integers(ExactEvaluation<LongInt>(input, lattice).point(point));
  return p ? *std::move(p) : ExactEvaluation<Integer>(input, lattice).point(point);
}

}  // namespace

bool named_on_face(const SymbolicPoint& name, std::uint32_t f, const InputComplex::Indices& v) {
  const auto& id = name.id;
  switch (name.kind) {
    case SymbolicPoint::Kind::input:
      return has(v, id[0]);
    case SymbolicPoint::Kind::edge_edge:
      return (has(v, id[0]) && has(v, id[1])) || (has(v, id[2]) && has(v, id[3]));
    case SymbolicPoint::Kind::edge_face:
      return id[2] == f || (has(v, id[0]) && has(v, id[1]));
    case SymbolicPoint::Kind::three_faces:
      return id[0] == f || id[1] == f || id[2] == f;
    case SymbolicPoint::Kind::weighted:
      return id[0] == f;
    case SymbolicPoint::Kind::free:
      return false;
  }
  return false;
}

bool named_on_edge(const SymbolicPoint& name, std::uint32_t a, std::uint32_t b) {
  const auto& id = name.id;
  const auto is = [&](std::uint32_t c, std::uint32_t d) { return (a == c && b == d) || (a == d && b == c); };
  switch (name.kind) {
    case SymbolicPoint::Kind::input:
      return id[0] == a || id[0] == b;
    case SymbolicPoint::Kind::edge_edge:
      return is(id[0], id[1]) || is(id[2], id[3]);
    case SymbolicPoint::Kind::edge_face:
      return is(id[0], id[1]);
    case SymbolicPoint::Kind::three_faces:
    case SymbolicPoint::Kind::weighted:
    case SymbolicPoint::Kind::free:
      return false;
  }
  return false;
}

bool named_on_line(const InputComplex& input, const SymbolicPoint& name, const SymbolicPoint& p,
                   const SymbolicPoint& q) {
  const auto& id = name.id;
  const auto on_edge = [&](std::size_t a, std::size_t b) {
    return named_on_edge(p, id[a], id[b]) && named_on_edge(q, id[a], id[b]);
  };
  switch (name.kind) {
    case SymbolicPoint::Kind::edge_edge:
      return on_edge(0, 1) || on_edge(2, 3);
    case SymbolicPoint::Kind::edge_face:
      return on_edge(0, 1);
    case SymbolicPoint::Kind::three_faces: {
      const auto in_plane = [&](std::uint32_t f) {
        const auto v = input.face(f);
        return named_on_face(p, f, v) && named_on_face(q, f, v);
      };
      return int{in_plane(id[0])} + int{in_plane(id[1])} + int{in_plane(id[2])} >= 2;
    }
    case SymbolicPoint::Kind::input:
    case SymbolicPoint::Kind::weighted:
    case SymbolicPoint::Kind::free:
      return false;
  }
  return false;
}

Point make_point(const InputComplex& input, const SymbolicPoint& name) {
  if (name.kind == SymbolicPoint::Kind::input)
    return {name, approximate_vertex<Bounded>(input, name.id[0]), approximate_vertex<DoubleDouble>(input, name.id[0])};
  Point p{name, {}, {}};
  const CommonCoordinates common(input, name);
  if (!common.are_all()) p.fine = approximate<DoubleDouble>(input, name);
  common.put_into(p.fine);
  for (std::size_t i = 0; i < 3; ++i) p.at[i] = p.fine[i].bounded();
  if (is_tight(p.at)) return p;
  const RationalPoint exact = exact_position(input, p);
  for (std::size_t i = 0; i < 3; ++i) {
    p.fine[i] = nearest_double_double(exact[i]);
    p.at[i] = p.fine[i].bounded();
  }
  return p;
}

RationalPoint exact_position(const InputComplex& input, const Point& point) {
  if (point.name.kind == SymbolicPoint::Kind::input)
    if (const RationalPoint* given = input.exact(point.name.id[0])) return *given;
  const Point* const one[] = {&point};
  const Ground ground(input, one);
  const HPoint<Integer> h = exact_in_units(input, ground.lattice(), point);
  const int unit = ground.lattice().unit();
  RationalPoint r;
  for (int i = 0; i < 3; ++i) {
    Integer n = h[i], d = h.w;
    if (unit > 0) n <<= static_cast<unsigned>(unit);
    if (unit < 0) d <<= static_cast<unsigned>(-unit);
    r[static_cast<std::size_t>(i)] = Rational(n, d);
  }
  return r;
}

InputComplex::Coordinates nearest_doubles(const InputComplex& input, const Point& point) {
  if (point.name.kind == SymbolicPoint::Kind::input) return input.vertex(point.name.id[0]);
  if (point.name.kind == SymbolicPoint::Kind::free) return {point.at[0].value, point.at[1].value, point.at[2].value};
  const auto& fine = point.fine;
  if (fine[0].rounds_to_value() && fine[1].rounds_to_value() && fine[2].rounds_to_value())
    return {fine[0].value, fine[1].value, fine[2].value};
  const RationalPoint exact = exact_position(input, point);
  return {to_nearest_double(exact[0]), to_nearest_double(exact[1]), to_nearest_double(exact[2])};
}

}  // namespace strata
