// Attributes through Booleans, expressions and chains of solids.
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "attributes/painted.h"
#include "csg/recipe_solids.h"
#include "support/random_recipe.h"
#include "support/rounds.h"
#include "support/shapes.h"
#include "support/touching.h"

using namespace strata;
using namespace strata::test;

namespace {

/// The largest error of the channel of places, in units in the last place of the largest coordinate.
double error_of_places(const Solid& solid) {
  const auto& values = values_of<double>(solid.attributes(), "place");
  double largest = 0, size = 0;
  for (std::size_t c = 0; c < 3 * solid.mesh().triangles.size(); ++c)
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = solid.mesh().vertices[solid.mesh().triangles[c / 3][c % 3]][i];
      largest = std::max(largest, std::abs(values[3 * c + i] - x));
      size = std::max(size, std::abs(x));
    }
  return size == 0 ? 0 : largest / (std::nextafter(size, HUGE_VAL) - size);
}

}  // namespace

// Catches: corners in the wrong order, a wrong source, a face merged over two sources.
TEST_CASE("in a Boolean of doubles the places of corners are those of the vertices", "[attributes][property]") {
  for (std::uint64_t seed = 0; seed < rounds(400); ++seed) {
    const Operands touching = seed % 2 == 0 ? touching_pair(seed) : touching_operands(seed);
    std::vector<Attributes> attributes(touching.meshes.size());
    std::vector<std::array<RationalPoint, 3>> faces;
    for (std::size_t n = 0; n < attributes.size(); ++n) {
      const Mesh& mesh = touching.meshes[n];
      attributes[n].channels = {places(mesh), identifiers(mesh, static_cast<std::int32_t>(faces.size()))};
      for (std::size_t f = 0; f < mesh.triangles.size(); ++f) faces.push_back(corners_of({mesh, {}}, f));
    }
    const auto operands = operands_of(touching.meshes, attributes);
    for (const Operation operation : all_operations) {
      CAPTURE(seed, touching.kind, name(operation));
      const BooleanResult r =
          combine(operation, std::span<const Operand>(operands), {.input = InputClass::solid, .exact_vertices = true});
      REQUIRE(has_its_places(r.mesh, r.attributes));
      const Solid solid = Solid::trusted({r.mesh, r.exact}, r.sources).with_attributes(r.attributes);
      REQUIRE(is_part_of_its_faces(solid, faces));
    }
  }
}

TEST_CASE("affine functions stay, and identifiers name their faces, through chains and expressions",
          "[attributes][property]") {
  for (std::uint64_t seed = 0; seed < rounds(150); ++seed) {
    CAPTURE(seed);
    const Recipe recipe = touching_recipe(seed, {.solids = 6, .leaves = 10, .depth = 6, .maps = false});
    std::vector<Solid> solids;
    std::vector<std::array<RationalPoint, 3>> faces;
    for (const ExactMesh& m : recipe.solids) {
      const Solid solid(m);
      Attributes attributes;
      attributes.channels = {places(solid.mesh()), identifiers(solid.mesh(), static_cast<std::int32_t>(faces.size()))};
      for (std::size_t f = 0; f < solid.mesh().triangles.size(); ++f)
        faces.push_back(corners_of(solid.exact_mesh(), f));
      solids.push_back(solid.with_attributes(std::move(attributes)));
    }
    const Solid at_once = expression_of(recipe, solids).evaluate();
    const Solid by_step = by_steps(recipe, solids);
    for (const Solid* s : {&at_once, &by_step}) {
      if (s->is_empty()) continue;
      REQUIRE(is_part_of_its_faces(*s, faces));
      REQUIRE(error_of_places(*s) <= (s == &at_once ? 1 : static_cast<double>(depth(recipe)) + 1));
    }
  }
}

// Catches: values that depend on the face from which a point of an edge is seen.
TEST_CASE("what is continuous on an operand stays so: no seam comes up", "[attributes][property]") {
  std::size_t shared = 0;
  for (std::uint64_t seed = 0; seed < rounds(200); ++seed) {
    const Operands touching = touching_pair(seed);
    Random random(seed);
    std::vector<Attributes> attributes;
    for (const Mesh& m : touching.meshes) {
      attributes.emplace_back();
      attributes.back().channels = {
          random_channel<float>(random, m, "texcoord", Element::vertex, Interpolation::linear, 2),
          random_channel<double>(random, m, "normal", Element::vertex, Interpolation::spherical, 3)};
    }
    const auto operands = operands_of(touching.meshes, attributes);
    const BooleanResult r =
        combine(Operation::union_, std::span<const Operand>(operands), {.input = InputClass::solid});
    const auto value_at = [&](const Channel& channel, std::size_t c) {
      return std::visit(
          [&](const auto& v) {
            const std::size_t at = channel.element == Element::corner ? c : r.mesh.triangles[c / 3][c % 3];
            return std::vector<double>(v.begin() + static_cast<std::ptrdiff_t>(at * channel.components),
                                       v.begin() + static_cast<std::ptrdiff_t>((at + 1) * channel.components));
          },
          channel.values);
    };
    for (const Channel& channel : r.attributes.channels) {
      std::map<std::array<std::uint32_t, 2>, std::vector<double>> known;  // per vertex and operand
      for (std::size_t c = 0; c < 3 * r.sources.size(); ++c) {
        const auto [at, is_new] = known.try_emplace({r.mesh.triangles[c / 3][c % 3], r.sources[c / 3].operand});
        if (is_new) at->second = value_at(channel, c);
        shared += !is_new;
        // Sheets of one operand that touch in a vertex have vertices of their own; lattice solids list them once.
        REQUIRE(at->second == value_at(channel, c));
      }
    }
  }
  CHECK(shared > 1000);
}

TEST_CASE("attributes are the same for any number of threads", "[attributes]") {
  Random random(5);
  const std::vector<Mesh> meshes{icosphere({0, 0, 0}, 1, 4), icosphere({0.3, 0.2, 0.1}, 1, 4),
                                 box({0, 0, 0}, {2, 2, 2})};
  std::vector<Attributes> attributes;
  for (const Mesh& m : meshes) {
    attributes.emplace_back();
    attributes.back().channels = {
        random_channel<float>(random, m, "texcoord", Element::corner, Interpolation::linear, 2),
        random_channel<float>(random, m, "normal", Element::vertex, Interpolation::spherical, 3),
        random_channel<std::int32_t>(random, m, "material", Element::face, Interpolation::nearest, 1)};
  }
  const auto operands = operands_of(meshes, attributes);
  for (const Operation operation : all_operations) {
    const BooleanResult one = combine(operation, std::span<const Operand>(operands), {.threads = 1});
    REQUIRE(!one.attributes.channels.empty());
    for (const unsigned threads : {2U, 8U}) {
      const BooleanResult more = combine(operation, std::span<const Operand>(operands), {.threads = threads});
      CHECK(more.mesh == one.mesh);
      CHECK(more.sources == one.sources);
      CHECK(more.attributes == one.attributes);
    }
  }
}

// Catches: early unions in another order than that of the operands, a representative other than the lowest.
TEST_CASE("of faces that coincide the first operand's speaks", "[attributes][degenerate][property]") {
  std::size_t coincident = 0;
  for (std::uint64_t seed = 0; seed < rounds(300); ++seed) {
    const Operands touching = touching_operands(seed);
    std::vector<Attributes> attributes;
    for (std::size_t n = 0; n < touching.meshes.size(); ++n) {
      attributes.emplace_back();
      attributes.back().channels = {identifiers(touching.meshes[n], 0)};
    }
    const auto operands = operands_of(touching.meshes, attributes);
    for (const Operation operation : all_operations) {
      CAPTURE(seed, touching.kind, name(operation));
      const BooleanResult r =
          combine(operation, std::span<const Operand>(operands), {.input = InputClass::solid, .exact_vertices = true});
      for (std::size_t t = 0; t < r.sources.size(); ++t) {
        const auto p = corners_of({r.mesh, r.exact}, t);
        RationalPoint middle;
        for (std::size_t i = 0; i < 3; ++i) middle[i] = (p[0][i] + p[1][i] + p[2][i]) / 3;
        for (std::uint32_t o = 0; o < operands.size(); ++o)
          for (std::size_t f = 0; f < touching.meshes[o].triangles.size(); ++f) {
            if (o == r.sources[t].operand) continue;
            const auto face = corners_of({touching.meshes[o], {}}, f);
            const bool all_in_plane = std::all_of(p.begin(), p.end(), [&](const RationalPoint& q) {
              const auto w = weights(face, q);
              for (std::size_t i = 0; i < 3; ++i)
                if (w[0] * face[0][i] + w[1] * face[1][i] + w[2] * face[2][i] != q[i]) return false;
              return true;
            });
            if (!all_in_plane || !is_in(face, middle)) continue;
            ++coincident;
            REQUIRE(r.sources[t].operand < o);
          }
      }
    }
  }
  CHECK(coincident > 100);
}

// Catches: operands 0 and 8 united before operand 1 comes, whose face coincides with one of operand 8.
TEST_CASE("of many united operands, too, the first one's coincident face speaks", "[attributes][degenerate]") {
  std::vector<Mesh> meshes{box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0.5}, {2, 1, 1})};
  for (int far = 1; far < 7; ++far) meshes.push_back(box({9.0 * far, 0, 0}, {9.0 * far + 1, 1, 1}));
  meshes.push_back(meshes.front());  // mirrored, so that the common wall has the same triangles
  for (Vertex& v : meshes.back().vertices) v[0] = 2 - v[0];
  for (Triangle& t : meshes.back().triangles) std::swap(t[1], t[2]);
  std::vector<Attributes> attributes;
  for (std::size_t n = 0; n < meshes.size(); ++n) {
    attributes.emplace_back();
    std::vector<std::int32_t> number(meshes[n].triangles.size(), static_cast<std::int32_t>(n));
    attributes.back().channels = {{"operand", Element::face, Interpolation::nearest, 1, std::move(number)}};
  }
  const auto operands = operands_of(meshes, attributes);
  const BooleanResult r = combine(Operation::union_, std::span<const Operand>(operands), {.input = InputClass::solid});
  const auto& number = values_of<std::int32_t>(r.attributes, "operand");
  std::size_t on_lid = 0;
  for (std::size_t t = 0; t < number.size(); ++t) {
    CHECK(number[t] == static_cast<std::int32_t>(r.sources[t].operand));
    const auto is_on_lid = [&](std::uint32_t v) {
      const Vertex& p = r.mesh.vertices[v];
      return p[2] == 1 && p[0] >= 1 && p[0] <= 2;
    };
    const Triangle& triangle = r.mesh.triangles[t];
    if (!std::all_of(triangle.begin(), triangle.end(), is_on_lid)) continue;
    ++on_lid;
    CHECK(number[t] == 1);
  }
  CHECK(on_lid >= 2);
}

TEST_CASE("a solid without attributes has none, and results of such have none", "[attributes]") {
  const Solid a = make_box({0, 0, 0}, {2, 2, 2}), b = make_box({1, 1, 1}, {3, 3, 3});
  CHECK(a.attributes().empty());
  CHECK((a | b).attributes().empty());
  const Solid p = painted(a.mesh(), 0);
  CHECK(p == a);
  CHECK_FALSE((p - b).attributes().empty());
  CHECK(p.with_attributes({}).attributes().empty());
}

TEST_CASE("what is divided, moved or taken apart keeps its attributes", "[attributes]") {
  const Solid a = painted(make_box({0, 0, 0}, {2, 2, 2}).mesh(), 0);
  const Solid two = a | painted(make_box({4, 0, 0}, {6, 2, 2}).mesh(), 100);
  SECTION("components") {
    const auto parts = two.components();
    REQUIRE(parts.size() == 2);
    for (const Solid& p : parts) CHECK(has_its_places(p.mesh(), p.attributes()));
    CHECK(values_of<std::int32_t>(parts[1].attributes(), "identifier").front() >= 100);
  }
  SECTION("a split by a plane, with a material for the cut") {
    Material steel;
    steel.name = "steel";
    const auto [behind, in_front] = a.split({{1, 2, 3}, Rational(Integer(13), Integer(3))}, {.cut_material = &steel});
    for (const Solid* half : {&behind, &in_front}) {
      REQUIRE_FALSE(half->is_empty());
      const auto& material = values_of<std::int32_t>(half->attributes(), "material");
      REQUIRE(half->attributes().materials == std::vector{steel});
      std::size_t cut = 0;
      for (std::size_t t = 0; t < material.size(); ++t) {
        CHECK(material[t] == (half->sources()[t].operand == 1 ? 0 : -1));
        cut += material[t] == 0;
        if (half->sources()[t].operand == 0)
          for (std::size_t k = 0; k < 3; ++k) {
            const auto& place = values_of<double>(half->attributes(), "place");
            for (std::size_t i = 0; i < 3; ++i)
              CHECK(place[9 * t + 3 * k + i] == half->mesh().vertices[half->mesh().triangles[t][k]][i]);
          }
      }
      CHECK(cut > 0);
    }
  }
  SECTION("sheets with copies of their own") {
    const Solid touching(edge_sharing_cells());
    Attributes attributes;
    attributes.channels = {places(touching.mesh())};
    const Solid separated = touching.with_attributes(attributes).separated();
    CHECK(has_its_places(separated.mesh(), separated.attributes()));
  }
  SECTION("maps") {
    const Transform mirror = Transform::scaling({-1, 2, 4});
    for (const Placement placement : {Placement::exact, Placement::rounded}) {
      const Solid image = two.transformed(mirror, placement);
      const auto& place = values_of<double>(image.attributes(), "place");
      for (std::size_t c = 0; c < 3 * image.mesh().triangles.size(); ++c) {
        const RationalPoint p = mirror({place[3 * c], place[3 * c + 1], place[3 * c + 2]});
        CHECK(p == image.exact_mesh().position(image.mesh().triangles[c / 3][c % 3]));
      }
    }
  }
}

TEST_CASE("normals are turned where a difference turns faces, and mapped as normals", "[attributes]") {
  const auto with_normals = [](const Solid& solid) {
    std::vector<double> values;
    for (std::size_t f = 0; f < solid.mesh().triangles.size(); ++f) {
      const auto [a, b, c] = corners_of(solid.exact_mesh(), f);
      const RationalPoint u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
      RationalPoint n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
      double size = 0;
      for (const Rational& x : n) size += std::pow(to_nearest_double(x), 2);
      for (int k = 0; k < 3; ++k)
        for (const Rational& x : n) values.push_back(to_nearest_double(x) / std::sqrt(size));
    }
    Attributes attributes;
    attributes.channels = {{"normal", Element::corner, Interpolation::spherical, 3, std::move(values)}};
    return solid.with_attributes(std::move(attributes));
  };
  const auto agree = [](const Solid& solid) {
    const auto& normal = values_of<double>(solid.attributes(), "normal");
    for (std::size_t f = 0; f < solid.mesh().triangles.size(); ++f) {
      const auto [a, b, c] = corners_of(solid.exact_mesh(), f);
      const RationalPoint u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
      const double n[] = {to_nearest_double(u[1] * v[2] - u[2] * v[1]), to_nearest_double(u[2] * v[0] - u[0] * v[2]),
                          to_nearest_double(u[0] * v[1] - u[1] * v[0])};
      const double size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      for (std::size_t i = 0; i < 9; ++i)
        if (std::abs(normal[9 * f + i] - n[i % 3] / size) > 1e-12) return false;
    }
    return true;
  };
  const Solid a = with_normals(make_sphere(1, 12)), b = with_normals(make_torus(1, 0.5, 9, 7));
  CHECK(agree(a - b));
  CHECK(agree(a ^ b));
  CHECK(agree((a - b).transformed(Transform::scaling({-1, 3, Rational(Integer(1), Integer(7))}))));
  CHECK(agree((a & b).rotated(Quaternion{1, 2, 3, 4})));
  // Faces of an operand without normals get their own.
  CHECK(agree(a - make_torus(1, 0.5, 9, 7)));
  CHECK(agree((Expression(a).transformed(Transform::scaling({1, -2, 3})) - Expression(b)).evaluate()));
}

TEST_CASE("cut faces have the material for cuts where they have none", "[attributes]") {
  Material steel, wood;
  steel.name = "steel";
  wood.name = "wood";
  const auto of = [](const Solid& solid, std::int32_t index, const Material& material) {
    Attributes attributes;
    attributes.materials = {material};
    attributes.channels = {{"material", Element::face, Interpolation::nearest, 1,
                            std::vector<std::int32_t>(solid.mesh().triangles.size(), index)}};
    return solid.with_attributes(std::move(attributes));
  };
  const Solid body = of(make_box({0, 0, 0}, {4, 4, 4}), 0, wood), plain = make_box({1, 1, 1}, {5, 2, 2});
  const Options options{.cut_material = &steel};
  const auto materials_by_operand = [](const Solid& s) {
    std::map<std::uint32_t, std::set<std::int32_t>> found;
    const auto& m = values_of<std::int32_t>(s.attributes(), "material");
    for (std::size_t t = 0; t < m.size(); ++t) found[s.sources()[t].operand].insert(m[t]);
    return found;
  };
  using Found = std::map<std::uint32_t, std::set<std::int32_t>>;
  CHECK(materials_by_operand(combine_solids(Operation::difference, {body, plain}, options)) ==
        Found{{0, {0}}, {1, {1}}});
  CHECK(materials_by_operand(combine_solids(Operation::intersection, {body, plain}, options)) ==
        Found{{0, {0}}, {1, {1}}});
  CHECK(materials_by_operand(combine_solids(Operation::union_, {body, plain}, options)) == Found{{0, {0}}, {1, {-1}}});
  CHECK(materials_by_operand(body - plain) == Found{{0, {0}}, {1, {-1}}});
  const Solid drill = of(plain, 0, steel);
  const Solid cut = combine_solids(Operation::difference, {body, drill}, {.cut_material = &wood});
  CHECK(materials_by_operand(cut) == Found{{0, {0}}, {1, {1}}});  // the drill's own
  CHECK(cut.attributes().materials == std::vector{wood, steel});
}

TEST_CASE("rounded results have attributes, within the range of those of their faces", "[attributes]") {
  for (std::uint64_t seed = 0; seed < rounds(60); ++seed) {
    CAPTURE(seed);
    const Operands touching = touching_pair(seed);
    Random random(seed);
    std::vector<Attributes> attributes;
    for (const Mesh& m : touching.meshes) {
      attributes.emplace_back();
      attributes.back().channels = {random_channel<float>(random, m, "t", Element::corner, Interpolation::linear, 1),
                                    identifiers(m, 0)};
    }
    const auto operands = operands_of(touching.meshes, attributes);
    Options options{.input = InputClass::solid};
    options.rounding =
        CoordinateGrid{CoordinateGrid::Format::float32, seed % 2 == 0 ? Rational(0) : Rational(Integer(1), Integer(3))};
    BooleanResult r;
    try {
      r = combine(Operation::symmetric_difference, std::span<const Operand>(operands), options);
    } catch (const std::invalid_argument&) {
      continue;  // beyond the grid
    }
    REQUIRE(r.rounding);
    if (r.mesh.triangles.empty()) continue;
    const auto& t = values_of<float>(r.attributes, "t");
    const auto& number = values_of<std::int32_t>(r.attributes, "identifier");
    for (std::size_t c = 0; c < t.size(); ++c) {
      const Source& s = r.sources[c / 3];
      REQUIRE(number[c / 3] == static_cast<std::int32_t>(s.face));
      const auto* v = &values_of<float>(attributes[s.operand], "t")[3 * s.face];
      REQUIRE(t[c] >= std::min({v[0], v[1], v[2]}));
      REQUIRE(t[c] <= std::max({v[0], v[1], v[2]}));
    }
  }
}

// Catches: the lowest face in place of the one that is kept.
TEST_CASE("of coinciding faces in a formula, that of the first operand that keeps it speaks", "[attributes]") {
  const Solid a = painted(make_box({0, 0, 0}, {2, 2, 2}).mesh(), 0);
  const Solid b = painted(make_box({0, 0, 0}, {2, 2, 2}).mesh(), 100);
  const Solid elsewhere = make_box({9, 9, 9}, {10, 10, 10}), around = make_box({-1, -1, -1}, {3, 3, 3});
  const auto identifiers_of = [](const Expression& e) {
    const auto v = values_of<std::int32_t>(e.evaluate().attributes(), "identifier");
    return std::pair(*std::min_element(v.begin(), v.end()), *std::max_element(v.begin(), v.end()));
  };
  const Expression x(a), y(b);
  CHECK(identifiers_of((x & Expression(elsewhere)) | y) == std::pair(100, 111));
  CHECK(identifiers_of((x & Expression(around)) | y) == std::pair(0, 11));
  CHECK(identifiers_of((x - Expression(around)) | y) == std::pair(100, 111));
  CHECK(identifiers_of(x & y) == std::pair(0, 11));
  CHECK(identifiers_of(y | x) == std::pair(100, 111));  // b is the first operand
  CHECK(identifiers_of(Expression(around) - (x | y)) == std::pair(-1, 11));
}

TEST_CASE("a sheet of an operand that changes nothing does not speak", "[attributes][degenerate]") {
  // a covers [0, 4]^3 and, once more, [1, 2]^3 within it; b takes away just that box.
  Mesh twice = box({0, 0, 0}, {4, 4, 4});
  const Mesh inner = box({1, 1, 1}, {2, 2, 2});
  for (const Triangle& t : inner.triangles) twice.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  twice.vertices.insert(twice.vertices.end(), inner.vertices.begin(), inner.vertices.end());
  Attributes of_a, of_b;
  of_a.channels = {identifiers(twice, 0)};
  of_b.channels = {identifiers(inner, 100)};
  const std::vector<Operand> operands{{twice, {}, false, &of_a}, {inner, {}, false, &of_b}};
  const BooleanResult r = combine(Operation::difference, std::span<const Operand>(operands));
  REQUIRE(r.mesh.triangles.size() == 24);
  for (const std::int32_t i : values_of<std::int32_t>(r.attributes, "identifier")) CHECK((i < 12 || i >= 100));
}

// Catches: corners that are turned round once too often or not at all where a map mirrors, values of another place.
TEST_CASE("solids that are rotated and mirrored as a whole keep what they carry", "[attributes]") {
  const Solid a = painted(make_box({-3, -1, -1}, {3, 1, 1}).mesh(), 0);
  const Solid b = painted(make_box({-1, -3, -2}, {1, 3, 2}).mesh(), 100);
  for (const int sign : {1, -1}) {
    CAPTURE(sign);
    const Transform map = Transform::rotation(Quaternion::of_angle({1, 2, 3}, 20)) * Transform::scaling({sign, 1, 1});
    for (const Expression& e : {Expression(a) | Expression(b), Expression(a) - Expression(b)}) {
      const Solid solid = e.transformed(map).evaluate();
      const Transform back = map.inverse();
      const auto& places = values_of<double>(solid.attributes(), "place");
      const auto& identifiers = values_of<std::int32_t>(solid.attributes(), "identifier");
      REQUIRE(identifiers.size() == solid.mesh().triangles.size());
      for (std::size_t t = 0; t < identifiers.size(); ++t) {
        const Source& s = solid.sources()[t];
        CHECK(identifiers[t] == static_cast<std::int32_t>(100 * s.operand + s.face));
        for (std::size_t k = 0; k < 3; ++k) {
          const RationalPoint p = back(solid.exact_mesh().position(solid.mesh().triangles[t][k]));
          for (std::size_t i = 0; i < 3; ++i) CHECK(places[9 * t + 3 * k + i] == to_nearest_double(p[i]));
        }
      }
    }
  }
}
