#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "strata/strata.h"
#include "support/random.h"

/// Meshes with channels whose values tests can tell.
namespace strata::test {

/// Per corner its own position: linear, so that results have theirs.
[[nodiscard]] inline Channel places(const Mesh& mesh) {
  std::vector<double> values;
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) values.insert(values.end(), mesh.vertices[v].begin(), mesh.vertices[v].end());
  return {"place", Element::corner, Interpolation::linear, 3, std::move(values)};
}

/// Per face a number that no other face has.
[[nodiscard]] inline Channel identifiers(const Mesh& mesh, std::int32_t first) {
  std::vector<std::int32_t> values;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) values.push_back(first + static_cast<std::int32_t>(f));
  return {"identifier", Element::face, Interpolation::nearest, 1, std::move(values)};
}

/// A number of some size, or 0.
[[nodiscard]] inline double random_number(Random& random) {
  if (random.once_in(8)) return 0;
  return std::ldexp(random.unit() - 0.5, random.between(-6, 6));
}

template <class T>
[[nodiscard]] Channel random_channel(Random& random, const Mesh& mesh, std::string name, Element element,
                                     Interpolation rule, std::uint32_t components) {
  const std::size_t elements = element == Element::vertex   ? mesh.vertices.size()
                               : element == Element::corner ? 3 * mesh.triangles.size()
                                                            : mesh.triangles.size();
  std::vector<T> values;
  for (std::size_t i = 0; i < elements * components; ++i) {
    if constexpr (std::is_integral_v<T>)
      values.push_back(static_cast<T>(random.below(256)));
    else
      values.push_back(static_cast<T>(random_number(random)));
  }
  return {std::move(name), element, rule, components, std::move(values)};
}

[[nodiscard]] inline std::vector<Operand> operands_of(const std::vector<Mesh>& meshes,
                                                      const std::vector<Attributes>& attributes) {
  std::vector<Operand> operands;
  for (std::size_t n = 0; n < meshes.size(); ++n) operands.push_back({meshes[n], {}, false, &attributes[n]});
  return operands;
}

template <class T>
[[nodiscard]] const std::vector<T>& values_of(const Attributes& attributes, std::string_view name) {
  return std::get<std::vector<T>>(attributes.find(name)->values);
}

/// True when the channel of places has the positions of all corners, as rounded in the mesh.
[[nodiscard]] inline bool has_its_places(const Mesh& mesh, const Attributes& attributes) {
  const auto& values = values_of<double>(attributes, "place");
  for (std::size_t c = 0; c < 3 * mesh.triangles.size(); ++c)
    for (std::size_t i = 0; i < 3; ++i)
      if (values[3 * c + i] != mesh.vertices[mesh.triangles[c / 3][c % 3]][i]) return false;
  return true;
}

/// Barycentric coordinates in space, by least squares, which are those of the point if it is in the plane: another way
/// than the library's.
[[nodiscard]] inline std::array<Rational, 3> weights(const std::array<RationalPoint, 3>& t, const RationalPoint& p) {
  const auto minus = [](const RationalPoint& a, const RationalPoint& b) {
    return RationalPoint{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto dot = [](const RationalPoint& a, const RationalPoint& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const RationalPoint u = minus(t[1], t[0]), v = minus(t[2], t[0]), w = minus(p, t[0]);
  const Rational uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const Rational d = uu * vv - uv * uv;
  const Rational second = (wu * vv - wv * uv) / d, third = (wv * uu - wu * uv) / d;
  return {1 - second - third, second, third};
}

[[nodiscard]] inline std::array<RationalPoint, 3> corners_of(const ExactMesh& mesh, std::size_t face) {
  const Triangle& t = mesh.mesh.triangles[face];
  return {mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])};
}

/// With both channels above.
[[nodiscard]] inline Solid painted(const Mesh& mesh, std::int32_t first_identifier) {
  const Solid solid(mesh);
  Attributes attributes;
  attributes.channels = {places(solid.mesh()), identifiers(solid.mesh(), first_identifier)};
  return solid.with_attributes(std::move(attributes));
}

/// True if the point is in the triangle.
[[nodiscard]] inline bool is_in(const std::array<RationalPoint, 3>& face, const RationalPoint& p) {
  const auto w = weights(face, p);
  if (w[0] < 0 || w[1] < 0 || w[2] < 0) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (w[0] * face[0][i] + w[1] * face[1][i] + w[2] * face[2][i] != p[i]) return false;
  return true;
}

/// Every triangle is a part of the face that its identifier names.
[[nodiscard]] inline bool is_part_of_its_faces(const Solid& solid,
                                               const std::vector<std::array<RationalPoint, 3>>& faces) {
  const auto& numbers = values_of<std::int32_t>(solid.attributes(), "identifier");
  for (std::size_t t = 0; t < solid.mesh().triangles.size(); ++t)
    for (const RationalPoint& p : corners_of(solid.exact_mesh(), t))
      if (!is_in(faces.at(static_cast<std::size_t>(numbers[t])), p)) return false;
  return true;
}

}  // namespace strata::test
