#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/kernel/exact_evaluation.h"
#include "core/kernel/predicates.h"
#include "kernel/scene.h"

using namespace strata;
using namespace strata::test;

namespace {

using Kind = SymbolicPoint::Kind;
using Exact = ExactEvaluation<Integer>;

constexpr std::array named_kinds{Kind::input, Kind::edge_edge, Kind::edge_face, Kind::three_faces, Kind::weighted};

int bits_of(const Integer& x) { return static_cast<int>(bit_length(x)); }

/// Vertices at the corners of the cube of b bits: every coordinate is plus or minus 2^b - 1, or nearly, or one.
struct Extremes {
  Extremes(Random& random, int b) {
    const double most = b <= 53 ? std::ldexp(1.0, b) - 1 : std::ldexp(0x1p53 - 1, b - 53);
    const auto coordinate = [&] {
      const double s = random.once_in(2) ? -1 : 1;
      return random.once_in(12) ? s : s * most;
    };
    for (int v = 0; v < 16; ++v) points.push_back({coordinate(), coordinate(), coordinate()});
    points.push_back({1, 1, 1});
    for (std::uint32_t f = 0; f < 8; ++f) {
      const auto corner = [&] { return static_cast<std::uint32_t>(random.below(16)); };
      faces.push_back({corner(), corner(), corner()});
    }
    input.add(points, faces);
    lattice.add(1);
    lattice.add(most);
  }
  std::vector<InputComplex::Coordinates> points;
  std::vector<InputComplex::Indices> faces;
  InputComplex input;
  Lattice lattice;
};

SymbolicPoint any_name(Random& random, Kind kind) {
  const auto v = [&] { return static_cast<std::uint32_t>(random.below(16)); };
  const auto f = [&] { return static_cast<std::uint32_t>(random.below(8)); };
  switch (kind) {
    case Kind::input:
      return SymbolicPoint::input(v());
    case Kind::edge_edge:
      return SymbolicPoint::edge_edge(v(), v(), v(), v());
    case Kind::edge_face:
      return SymbolicPoint::edge_face(v(), v(), f());
    case Kind::three_faces:
      return SymbolicPoint::three_faces(f(), f(), f());
    case Kind::weighted:
      return SymbolicPoint::weighted(
          f(), random.once_in(2) ? SymbolicPoint::weight_limit : static_cast<std::uint32_t>(random.below(4)));
    case Kind::free:
      break;
  }
  return {};
}

Point named(const SymbolicPoint& name) { return {name, {}, {}}; }

void check_width(const HPoint<Integer>& p, PointWidth width) {
  REQUIRE(bits_of(p.x) <= width.xyz);
  REQUIRE(bits_of(p.y) <= width.xyz);
  REQUIRE(bits_of(p.z) <= width.xyz);
  REQUIRE(p.w <= Integer(1) << width.w);
}

void check_width(const HPlane<Integer>& f, PlaneWidth width) {
  REQUIRE(bits_of(f.a) <= width.abc);
  REQUIRE(bits_of(f.b) <= width.abc);
  REQUIRE(bits_of(f.c) <= width.abc);
  REQUIRE(bits_of(f.d) <= width.d);
}

/// The closed forms of theory.md.
PointWidth closed_form(Kind kind, int b) {
  switch (kind) {
    case Kind::input:
    case Kind::free:
    case Kind::weighted:
      return {b, 0};  // weighted: b + 2t + 2, with t bits of weight, is checked apart
    case Kind::edge_edge:
      return {3 * b + 5, 2 * b + 5};
    case Kind::edge_face:
      return {4 * b + 8, 3 * b + 8};
    case Kind::three_faces:
      return {7 * b + 14, 6 * b + 12};
  }
  return {};
}

/// Evaluates with limbs of one width where they are enough, and with unbounded integers.
template <int Limbs, class Question>
void check_forced(const Extremes& e, int width, const Question& question) {
  if (width + 1 > 64 * Limbs || e.lattice.bits() >= 64 * Limbs) return;
  const auto wide = question(ExactEvaluation<WideInt<Limbs>>(e.input, e.lattice));
  REQUIRE(wide.sign() == sign_of_integer(question(Exact(e.input, e.lattice))));
}

template <class Question>
void check_value(const Extremes& e, int width, const Question& question) {
  REQUIRE(bits_of(question(Exact(e.input, e.lattice))) <= width);
  check_forced<2>(e, width, question);
  check_forced<4>(e, width, question);
  check_forced<8>(e, width, question);
  check_forced<16>(e, width, question);
  const LongInt found = question(ExactEvaluation<LongInt>(e.input, e.lattice));
  REQUIRE((found.is_lost() || found.sign() == sign_of_integer(question(Exact(e.input, e.lattice)))));
  REQUIRE((width > LongInt::bits / 2 || !found.is_lost()));
}

void check_points(Random& random, const Extremes& e, int b) {
  const Exact exact(e.input, e.lattice);
  for (const Kind kind : named_kinds) {
    const SymbolicPoint name = any_name(random, kind);
    check_width(exact.point(named(name)), width_of(name, b));
  }
  const PointWidth input{b, 0};
  check_width(exact.face(static_cast<std::uint32_t>(random.below(8))), width_of_plane(input, input, input));
}

void check_values(Random& random, const Extremes& e, int b) {
  const Exact exact(e.input, e.lattice);
  std::array<Point, 4> p;
  std::array<PointWidth, 4> w;
  for (std::size_t i = 0; i < 4; ++i) {
    do p[i] = named(any_name(random, random.pick(named_kinds)));
    while (exact.point(p[i]).w == 0);
    w[i] = width_of(p[i].name, b);
  }
  const PlaneWidth plane = width_of_plane(w[0], w[1], w[2]);
  check_width(plane_through(exact.point(p[0]), exact.point(p[1]), exact.point(p[2])), plane);
  check_value(e, width_of_value(plane, w[3]), [&](const auto& x) {
    return value_at(plane_through(x.point(p[0]), x.point(p[1]), x.point(p[2])), x.point(p[3]));
  });
  check_value(e, width_of_orientation(w[0], w[1], w[2]),
              [&](const auto& x) { return orientation(x.point(p[0]), x.point(p[1]), x.point(p[2]), 0, 1); });
  check_value(e, std::max(w[0].xyz + w[1].w, w[1].xyz + w[0].w) + 1, [&](const auto& x) {
    const auto q = x.point(p[0]), r = x.point(p[1]);
    using Int = std::decay_t<decltype(q.x)>;
    return Int(weighed(q.x, r) - weighed(r.x, q));
  });
}

PointWidth width(Kind kind, int b) { return width_of({kind, {0, SymbolicPoint::weight_limit - 1, 0, 0}}, b); }

}  // namespace

// Catches: a width function that forgets a term or a factor.
TEST_CASE("the width functions are the closed forms of the theory", "[kernel]") {
  const int b = GENERATE(1, 2, 24, 53, 85, 114, 2098);
  for (const Kind kind : named_kinds) {
    CAPTURE(b, static_cast<int>(kind));
    if (kind == Kind::weighted) {
      CHECK(width(kind, b).xyz == b + 50);
      CHECK(width(kind, b).w == 50);
      continue;
    }
    CHECK(width(kind, b).xyz == closed_form(kind, b).xyz);
    CHECK(width(kind, b).w == closed_form(kind, b).w);
  }
  const PointWidth input{b, 0}, lpi = width(Kind::edge_face, b), tpi = width(Kind::three_faces, b);
  const PlaneWidth face = width_of_plane(input, input, input);
  CHECK(face.abc == 2 * b + 3);
  CHECK(face.d == 3 * b + 5);
  CHECK(width_of_value(face, input) == 3 * b + 7);
  CHECK(width_of_value(face, width(Kind::edge_edge, b)) == 5 * b + 12);
  CHECK(width_of_value(face, lpi) == 6 * b + 15);
  CHECK(width_of_value(face, tpi) == 9 * b + 19);
  CHECK(width_of_orientation(input, input, input) == 2 * b + 5);
  CHECK(width_of_orientation(lpi, lpi, lpi) == 11 * b + 27);
  CHECK(width_of_orientation(tpi, tpi, tpi) == 20 * b + 43);
}

// Catches: a closed form that is too small; limbs that wrap where the widths say that they do not.
TEST_CASE("no integer outgrows its width, and every width that is enough gives the same sign", "[kernel][property]") {
  for (const int b : {1, 2, 3, 5, 8, 11, 12, 20, 24, 26, 39, 40, 41, 52, 53, 60, 81, 82, 83, 110, 167, 200, 336, 400}) {
    Random random(static_cast<std::uint64_t>(b));
    for (int i = 0; i < 40; ++i) {
      CAPTURE(b, i);
      const Extremes e(random, b);
      REQUIRE(e.lattice.bits() == b);
      for (int k = 0; k < 10; ++k) check_points(random, e, b);
      for (int k = 0; k < 10; ++k) check_values(random, e, b);
    }
  }
}
