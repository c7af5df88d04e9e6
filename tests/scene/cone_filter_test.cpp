#include "extensions/scene/cone_filter.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "core/kernel/input_complex.h"
#include "core/kernel/predicates.h"
#include "extensions/scene/pieces.h"
#include "extensions/scene/signed_covering.h"
#include "support/random.h"

using namespace strata;

namespace {

using Point3 = InputComplex::Coordinates;

/// Does the segment from o to q meet the closed face, and does it go through its inside and on? Exact.
struct Meets {
  bool closed = false, inside = false;
};

Meets meets(const Point3& o, const std::array<Point3, 3>& f, const Point3& q) {
  const Sign start = orient3d(f[0], f[1], f[2], o), end = orient3d(f[0], f[1], f[2], q);
  Meets m{start * end != Sign::positive, start * end == Sign::negative};
  for (std::size_t i = 0; i < 3; ++i) {
    // Seen from o, q is on the inner side of the edge.
    const Sign side = orient3d(o, f[i], f[(i + 1) % 3], q) * orient3d(o, f[i], f[(i + 1) % 3], f[(i + 2) % 3]);
    m.closed = m.closed && side != Sign::negative;
    m.inside = m.inside && side == Sign::positive;
  }
  return m;
}

}  // namespace

// Catches: a bound that is too small, edges turned outwards, a scale that is not taken out.
TEST_CASE("what floats tell of a cone is true", "[layers][property]") {
  test::Random random(8);
  int decided = 0;
  constexpr int rounds = 60'000;
  for (int n = 0; n < rounds; ++n) {
    const double size = std::ldexp(1.0, random.between(-30, 0)), place = std::ldexp(1.0, random.between(-90, 90));
    const auto coordinate = [&] { return (random.unit() * 2 - 1); };
    const Point3 o{place * coordinate(), place * coordinate(), place * coordinate()};
    const Point3 centre{o[0] + place * coordinate(), o[1] + place * coordinate(), o[2] + place * coordinate()};
    std::array<Point3, 3> f;
    for (auto& p : f)
      for (std::size_t i = 0; i < 3; ++i) p[i] = centre[i] + place * size * coordinate();
    // Near a point of the face, an edge or a corner, a little before or beyond.
    const double a = random.once_in(3) ? 0 : random.unit(), b = random.once_in(3) ? 0 : random.unit() * (1 - a);
    const double along = 1 + (random.once_in(2) ? 1 : -1) * std::ldexp(1.0, -random.between(1, 52));
    const double aside = std::ldexp(random.unit() - .5, -random.between(1, 52)) * place * size;
    Point3 q;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = f[0][i] + a * (f[1][i] - f[0][i]) + b * (f[2][i] - f[0][i]);
      q[i] = o[i] + (x - o[i]) * along + (i == 0 ? aside : 0);
    }
    const double scale = place * (1 + random.unit());
    const Meets exact = meets(o, f, q);
    CAPTURE(n);
    switch (ConeFilter(o, f, scale).ask(cone_ray(o, q, scale))) {
      case ConeFilter::Answer::passes:
        REQUIRE(!exact.closed);
        ++decided;
        break;
      case ConeFilter::Answer::crosses:
        REQUIRE(exact.inside);
        ++decided;
        break;
      case ConeFilter::Answer::unknown:
        break;
    }
  }
  CHECK(decided > rounds / 20);
}
