// New values against rational arithmetic: correctly rounded, all of them. Catches: a wrong weight, an error bound that
// is too small, double rounding to floats, ties, signs of what is turned over.
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "attributes/painted.h"
#include "core/exact/scaled_root.h"
#include "support/rounds.h"
#include "support/touching.h"

using namespace strata;
using namespace strata::test;

namespace {

template <class T>
T nearest(const Rational& x) {
  if constexpr (std::is_same_v<T, float>) return to_nearest_float(x);
  if constexpr (std::is_same_v<T, double>) return to_nearest_double(x);
  if constexpr (std::is_integral_v<T>) {  // halves to even
    const Integer floor = divide(numerator(x), denominator(x)).first;
    const Rational part = x - Rational(floor), half(Integer(1), Integer(2));
    const bool up = part > half || (part == half && !(floor % Integer(2)).is_zero());
    return static_cast<T>((up ? floor + Integer(1) : floor).to_int64());
  }
}

/// x / sqrt(square) to 300 binary digits more than it has.
Rational quotient(const Rational& x, const Rational& square) {
  if (x == 0) return 0;
  const Rational q = x * x / square;
  const long k = 300 + std::abs(binary_size(q));
  const Rational root = Rational(scaled_root(q, k), pow(Integer(2), static_cast<unsigned>(k)));
  return x < 0 ? -root : root;
}

struct Tally {
  std::size_t values = 0, wrong = 0, far = 0;
};

template <class T>
bool is_neighbour(T a, T b) {
  if constexpr (std::is_integral_v<T>)
    return std::abs(int{a} - int{b}) <= 1;
  else
    return std::nextafter(a, b) == b;
}

template <class T>
void compare(T value, T right, Tally& tally) {
  ++tally.values;
  if (value == right) return;
  ++tally.wrong;
  if (!is_neighbour(value, right)) ++tally.far;
}

/// All new corners of a channel on corners.
template <class T>
void compare(const std::vector<Mesh>& meshes, const std::vector<Attributes>& attributes, const BooleanResult& result,
             const std::string& name, Tally& tally) {
  const ExactMesh exact{result.mesh, result.exact};
  const Channel& channel = *result.attributes.find(name);
  const auto& values = std::get<std::vector<T>>(channel.values);
  const std::size_t n = channel.components;
  for (std::size_t c = 0; c < 3 * result.sources.size(); ++c) {
    const Source& s = result.sources[c / 3];
    const auto& of_source = values_of<T>(attributes[s.operand], name);
    const auto face = corners_of({meshes[s.operand], {}}, s.face);
    const RationalPoint p = exact.position(result.mesh.triangles[c / 3][c % 3]);
    if (std::find(face.begin(), face.end(), p) != face.end()) continue;
    const auto w = weights(face, p);
    std::vector<Rational> right(n);
    Rational square = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        right[i] += w[k] * Rational(static_cast<double>(of_source[(3 * s.face + k) * n + i]));
      square += right[i] * right[i];
    }
    const bool is_direction = channel.interpolation == Interpolation::spherical;
    if (is_direction && square == 0) continue;
    const auto out = corners_of(exact, c / 3);
    const auto second = weights(face, out[1]), first = weights(face, out[0]), third = weights(face, out[2]);
    const Rational turn =
        (second[1] - first[1]) * (third[2] - first[2]) - (third[1] - first[1]) * (second[2] - first[2]);
    for (std::size_t i = 0; i < n; ++i) {
      Rational x = is_direction ? quotient(right[i], square) : right[i];
      if (is_direction && turn < 0) x = -x;
      compare<T>(values[c * n + i], nearest<T>(x), tally);
    }
  }
}

}  // namespace

TEST_CASE("new values are correctly rounded", "[attributes][property]") {
  Tally doubles, floats, bytes, directions, float_directions;
  for (std::uint64_t seed = 0; seed < rounds(150); ++seed) {
    const Operands touching = touching_pair(seed);
    Random random(seed);
    std::vector<Attributes> attributes;
    for (const Mesh& m : touching.meshes) {
      const auto add = [&]<class T>(T, const char* name, Interpolation rule, std::uint32_t n) {
        attributes.back().channels.push_back(random_channel<T>(random, m, name, Element::corner, rule, n));
      };
      attributes.emplace_back();
      add(0.0, "double", Interpolation::linear, 2);
      add(0.0F, "float", Interpolation::linear, 2);
      add(std::uint8_t{0}, "byte", Interpolation::linear, 4);
      add(0.0, "direction", Interpolation::spherical, 3);
      add(0.0F, "float direction", Interpolation::spherical, 2);
    }
    const auto operands = operands_of(touching.meshes, attributes);
    for (const Operation operation : all_operations) {
      const BooleanResult result =
          combine(operation, std::span<const Operand>(operands), {.input = InputClass::solid, .exact_vertices = true});
      if (result.mesh.triangles.empty()) continue;
      CAPTURE(seed, touching.kind, name(operation));
      compare<double>(touching.meshes, attributes, result, "double", doubles);
      compare<float>(touching.meshes, attributes, result, "float", floats);
      compare<std::uint8_t>(touching.meshes, attributes, result, "byte", bytes);
      compare<double>(touching.meshes, attributes, result, "direction", directions);
      compare<float>(touching.meshes, attributes, result, "float direction", float_directions);
    }
  }
  for (const auto& [what, tally] :
       {std::pair("doubles", doubles), std::pair("floats", floats), std::pair("bytes", bytes),
        std::pair("directions", directions), std::pair("directions in floats", float_directions)}) {
    INFO(what);
    std::cout << "new values, " << what << ": " << tally.values << ", not nearest " << tally.wrong
              << ", off by more than a unit " << tally.far << '\n';
    CHECK(tally.values > 100);
    CHECK(tally.wrong == 0);
    CHECK(tally.far == 0);
  }
}
