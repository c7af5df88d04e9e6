#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/kernel/point.h"
#include "kernel/numbers.h"
#include "kernel/reference.h"
#include "support/rounds.h"

namespace strata::test {

/// A point of the kernel and its exact place, found without the kernel.
struct Known {
  Point point;
  RationalPoint place;
};

/// Two operands of random vertices and faces, with the exact places of the vertices kept beside them.
class Scene {
 public:
  Scene(Family family, bool rationals, std::uint64_t seed) : random(seed * 64 + static_cast<std::uint64_t>(family)) {
    Numbers number(family, random);
    for (Operand& operand : operands_) fill(operand, number, rationals);
    for (Operand& operand : operands_) input.add(operand.points, operand.faces, operand.exact);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] std::uint32_t any_vertex() { return static_cast<std::uint32_t>(random.below(places.size())); }
  [[nodiscard]] std::uint32_t any_face() { return static_cast<std::uint32_t>(random.below(corners.size())); }

  [[nodiscard]] RationalPlane plane(std::uint32_t f) const {
    const auto& c = corners[f];
    return {places[c[0]], places[c[1]], places[c[2]]};
  }

  /// Where the input complex of a name meet; none when they do not meet in one point.
  [[nodiscard]] std::optional<RationalPoint> place_of(const SymbolicPoint& name) const {
    const auto& id = name.id;
    switch (name.kind) {
      case SymbolicPoint::Kind::input:
        return places[id[0]];
      case SymbolicPoint::Kind::edge_edge:
        return line_meets_line(places[id[0]], places[id[1]], places[id[2]], places[id[3]]);
      case SymbolicPoint::Kind::edge_face:
        return line_meets_plane(places[id[0]], places[id[1]], plane(id[2]));
      case SymbolicPoint::Kind::three_faces:
        return planes_meet(plane(id[0]), plane(id[1]), plane(id[2]));
      case SymbolicPoint::Kind::weighted:
        return weighted_mean(plane(id[0]), id[1]);
      case SymbolicPoint::Kind::free:
        break;
    }
    return std::nullopt;
  }

  /// A name of a random kind; its input complex may not meet.
  SymbolicPoint any_name() {
    switch (random.below(6)) {
      case 0:
        return SymbolicPoint::input(any_vertex());
      case 1:
      case 2:
        return SymbolicPoint::edge_face(any_vertex(), any_vertex(), any_face());
      case 3:
        return SymbolicPoint::three_faces(any_face(), any_face(), any_face());
      case 4:
        return SymbolicPoint::weighted(any_face(), any_weight());
      default:
        return SymbolicPoint::edge_edge(any_vertex(), any_vertex(), any_vertex(), any_vertex());
    }
  }

  /// Random points of all kinds, one in eight free and near or on another one.
  std::vector<Known> known_points(int tries) {
    std::vector<Known> r;
    for (int i = 0; i < tries; ++i) {
      const SymbolicPoint name = any_name();
      const auto place = place_of(name);
      if (!place) continue;
      r.push_back({make_point(input, name), *place});
      if (random.once_in(8)) add_free(r);
    }
    return r;
  }

  Random random;
  InputComplex input;
  std::vector<RationalPoint> places;
  std::vector<InputComplex::Indices> corners;  ///< of faces, in global numbers

 private:
  struct Operand {
    std::vector<InputComplex::Coordinates> points;
    std::vector<InputComplex::Indices> faces;
    std::vector<ExactVertex> exact;
  };

  std::uint32_t any_weight() {
    return random.once_in(2) ? static_cast<std::uint32_t>(random.below(4))
                             : SymbolicPoint::weight_limit >> random.below(24);
  }

  void add_free(std::vector<Known>& known) {
    InputComplex::Coordinates p;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = to_nearest_double(random.pick(known).place[i]);
      if (!std::isfinite(p[i])) return;
    }
    known.push_back({Point::free(p), {to_rational(p[0]), to_rational(p[1]), to_rational(p[2])}});
  }

  void fill(Operand& operand, Numbers& number, bool rationals) {
    const auto first = static_cast<std::uint32_t>(places.size());
    for (std::uint32_t v = 0; v < 6; ++v) {
      if (rationals && v >= 2 && random.once_in(2)) {
        add_rational(operand, v, first);
      } else {
        add_doubles(operand, {number(), number(), number()});
      }
    }
    for (int i = 0; i < 5; ++i) {
      const auto corner = [&] { return static_cast<std::uint32_t>(random.below(6)); };
      operand.faces.push_back({corner(), corner(), corner()});
      const auto& f = operand.faces.back();
      corners.push_back({f[0] + first, f[1] + first, f[2] + first});
    }
  }

  void add_doubles(Operand& operand, const InputComplex::Coordinates& p) {
    operand.points.push_back(p);
    places.push_back({to_rational(p[0]), to_rational(p[1]), to_rational(p[2])});
  }

  /// A vertex on the line through two earlier ones, at halves, thirds or sevenths.
  void add_rational(Operand& operand, std::uint32_t v, std::uint32_t first) {
    const auto& p = places[first + random.below(v)];
    const auto& q = places[first + random.below(v)];
    const RationalPoint place = at_parameter(p, q, Rational(random.between(0, 7), random.pick(std::array{2, 3, 7})));
    for (const Rational& x : place)
      if (!std::isfinite(to_nearest_double(x))) return add_doubles(operand, {0, 0, 0});
    operand.exact.push_back({v, place});
    operand.points.push_back({to_nearest_double(place[0]), to_nearest_double(place[1]), to_nearest_double(place[2])});
    places.push_back(place);
  }

  std::array<Operand, 2> operands_;
};

/// How many scenes of a family a test takes: numbers of thousands of bits are dear. A tenth under a sanitizer.
inline int affordable(Family family, int scenes) {
  if (is_sanitized) scenes /= 10;
  switch (family) {
    case Family::wild:
    case Family::far_apart:
    case Family::underflowing:
      return scenes / 10 + 1;
    case Family::spread:
      return scenes * 2;
    case Family::small_integers:
    case Family::one_ulp:
    case Family::floats:
    case Family::doubles:
    case Family::subnormal:
    case Family::huge:
      return scenes;
  }
  return scenes;
}

}  // namespace strata::test
