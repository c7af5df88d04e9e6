// Operands with different attributes, lists, wrong input, degenerate places and values.
#include <bit>
#include <catch2/catch.hpp>
#include <limits>

#include "attributes/painted.h"
#include "strata/surface.h"
#include "support/shapes.h"

using namespace strata;
using namespace strata::test;
using Catch::Contains;
using Bytes = std::vector<std::uint8_t>;
using Floats = std::vector<float>;
using Doubles = std::vector<double>;
using Integers = std::vector<std::int32_t>;

namespace {

const Mesh left = box({0, 0, 0}, {1, 1, 1}), right = box({2, 0, 0}, {3, 1, 1});  // 8 vertices and 12 faces each

Attributes with(Channel channel) {
  Attributes attributes;
  attributes.channels = {std::move(channel)};
  return attributes;
}

template <class T>
Channel constant(std::string name, Element element, std::vector<T> value, Interpolation rule = Interpolation::nearest) {
  const std::size_t elements = element == Element::vertex ? 8 : element == Element::face ? 12 : 36;
  std::vector<T> values;
  for (std::size_t e = 0; e < elements; ++e) values.insert(values.end(), value.begin(), value.end());
  return {std::move(name), element, rule, static_cast<std::uint32_t>(value.size()), std::move(values)};
}

/// Of the union of the two boxes, that are apart.
Attributes joined(const Attributes& a, const Attributes& b) {
  const std::vector<Operand> operands{{left, {}, false, &a}, {right, {}, false, &b}};
  return combine(Operation::union_, std::span<const Operand>(operands)).attributes;
}

/// The values of the first and of the last element.
template <class T>
std::pair<std::vector<T>, std::vector<T>> ends(const Attributes& a, std::string_view name) {
  const Channel& c = *a.find(name);
  const auto& v = std::get<std::vector<T>>(c.values);
  const auto n = static_cast<std::ptrdiff_t>(c.components);
  return {{v.begin(), v.begin() + n}, {v.end() - n, v.end()}};
}

void refused(Channel channel, const char* why) {
  const std::string name = channel.name;
  const Attributes a = with(std::move(channel));
  CHECK_THROWS_WITH(Solid(left).with_attributes(a), Contains("\"" + name + "\"") && Contains(why));
  const std::vector<Operand> operands{{left, {}, false, &a}};
  CHECK_THROWS_AS(combine(Operation::union_, std::span<const Operand>(operands)), std::invalid_argument);
}

}  // namespace

TEST_CASE("attributes that do not fit are refused by name", "[attributes]") {
  refused({"none", Element::face, Interpolation::nearest, 0, Integers{}}, "0 components");
  refused({"five", Element::face, Interpolation::nearest, 5, Integers(60)}, "5 components");
  refused({"short", Element::vertex, Interpolation::linear, 2, Floats(15)}, "15 values");
  refused({"long", Element::corner, Interpolation::linear, 1, Floats(37)}, "37 values");
  refused({"vertex", Element::corner, Interpolation::linear, 1, Floats(8)}, "8 values");
  refused(constant<std::int32_t>("int", Element::face, {1}, Interpolation::linear), "nearest only");
  refused(constant<std::uint8_t>("byte", Element::face, {1}, Interpolation::spherical), "no directions");
  refused({"", Element::face, Interpolation::nearest, 1, Integers(12)}, "no name");
  Attributes twice = with(constant<float>("a", Element::face, {1}));
  twice.channels.push_back(twice.channels.front());
  CHECK_THROWS_WITH(Solid(left).with_attributes(twice), Contains("\"a\""));
  Attributes beyond = with(constant<std::int32_t>("material", Element::face, {1}));
  beyond.materials.resize(1);
  CHECK_THROWS_WITH(Solid(left).with_attributes(beyond), Contains("\"material\"") && Contains("index 1"));
  Attributes image;
  image.materials.resize(1);
  image.materials[0].image = 0;
  CHECK_THROWS_AS(Solid(left).with_attributes(image), std::invalid_argument);
}

TEST_CASE("an operand without a channel has the value that says so", "[attributes]") {
  const auto missing = [](Channel channel) { return joined({}, with(std::move(channel))); };
  CHECK(ends<float>(missing(constant<float>("texcoord", Element::corner, {.5F, .25F}, Interpolation::linear)),
                    "texcoord") == std::pair(Floats{0, 0}, Floats{.5F, .25F}));
  CHECK(ends<std::int32_t>(missing(constant<std::int32_t>("material", Element::face, {4})), "material") ==
        std::pair(Integers{-1}, Integers{4}));
  CHECK(ends<std::uint8_t>(missing(constant<std::uint8_t>("color", Element::vertex, {1, 2, 3})), "color") ==
        std::pair(Bytes{255, 255, 255}, Bytes{1, 2, 3}));
  CHECK(ends<float>(missing(constant<float>("color", Element::vertex, {0, 0, 0, .5F}, Interpolation::linear)),
                    "color") == std::pair(Floats{1, 1, 1, 1}, Floats{0, 0, 0, .5F}));
  const auto normal =
      ends<double>(missing(constant<double>("normal", Element::face, {0, 0, 1}, Interpolation::spherical)), "normal");
  CHECK(std::abs(normal.first[0]) + std::abs(normal.first[1]) + std::abs(normal.first[2]) == 1);
}

TEST_CASE("channels of one name become one that holds all values", "[attributes]") {
  SECTION("types") {
    const auto of = [](auto a, auto b) {
      return joined(with(constant<decltype(a)>("x", Element::face, {a})),
                    with(constant<decltype(b)>("x", Element::face, {b})));
    };
    CHECK(ends<float>(of(.5F, std::uint8_t{7}), "x") == std::pair(Floats{.5F}, Floats{7}));
    CHECK(ends<double>(of(.5F, std::int32_t{1 << 30}), "x") == std::pair(Doubles{.5}, Doubles{1 << 30}));
    CHECK(ends<double>(of(.1, std::uint8_t{7}), "x") == std::pair(Doubles{.1}, Doubles{7}));
    CHECK(ends<std::int32_t>(of(std::uint8_t{200}, std::int32_t{-5}), "x") == std::pair(Integers{200}, Integers{-5}));
  }
  SECTION("colors") {
    const Attributes a = joined(with(constant<std::uint8_t>("color", Element::vertex, {255, 0, 51})),
                                with(constant<float>("color", Element::vertex, {.5F, 0, 0, .25F})));
    CHECK(ends<float>(a, "color") == std::pair(Floats{1, 0, .2F, 1}, Floats{.5F, 0, 0, .25F}));
  }
  SECTION("elements and rules") {
    const Attributes a = joined(with(constant<float>("x", Element::vertex, {2}, Interpolation::linear)),
                                with(constant<float>("x", Element::face, {3}, Interpolation::nearest)));
    CHECK(a.find("x")->element == Element::corner);
    CHECK(a.find("x")->interpolation == Interpolation::nearest);
    CHECK(ends<float>(a, "x") == std::pair(Floats{2}, Floats{3}));
  }
  SECTION("on vertices as long as corners agree") {
    const Attributes a = joined(with(constant<float>("x", Element::vertex, {2}, Interpolation::linear)), {});
    CHECK(a.find("x")->element == Element::vertex);
    CHECK(std::get<Floats>(a.find("x")->values).size() == 16);
    const Solid red =
        Solid(left).with_attributes(with(constant<float>("x", Element::vertex, {1}, Interpolation::linear)));
    const Solid blue = make_box({0.5, 0.5, 0.5}, {2, 2, 2});
    CHECK((red - blue).attributes().find("x")->element == Element::corner);
  }
}

TEST_CASE("lists are joined without equal entries, and indices follow", "[attributes]") {
  Attributes a = with(constant<std::int32_t>("material", Element::face, {1})), b = a;
  Material wood, steel, glass;
  wood.name = "wood";
  steel.name = "steel";
  steel.image = 0;
  glass.name = "glass";
  a.materials = {wood, steel};
  a.images = {{"steel.png", "image/png", {std::byte{1}}}};
  b.materials = {glass, steel, wood};
  b.materials[1].image = 1;  // the same picture
  b.images = {{"glass.png", "image/png", {std::byte{1}}}, a.images[0]};
  const Attributes both = joined(a, b);
  REQUIRE(both.materials.size() == 3);
  CHECK(both.images == std::vector{a.images[0], b.images[0]});
  CHECK(both.materials == std::vector{wood, steel, glass});
  CHECK(ends<std::int32_t>(both, "material") == std::pair(Integers{1}, Integers{1}));

  SECTION("numbers beside a list become names") {
    Attributes named = with(constant<std::int32_t>("group", Element::face, {0}));
    named.groups = {"front"};
    const Attributes numbered = with(constant<std::int32_t>("group", Element::face, {7}));
    const Attributes groups = joined(numbered, named);
    CHECK(groups.groups == std::vector<std::string>{"front", "7"});
    CHECK(ends<std::int32_t>(groups, "group") == std::pair(Integers{1}, Integers{0}));
    CHECK(ends<std::int32_t>(joined(numbered, numbered), "group") == std::pair(Integers{7}, Integers{7}));
  }
  SECTION("only some channels") {
    const Attributes some = only(both, std::vector<std::string>{"group"});
    CHECK(some.empty());
    CHECK(only(both, std::vector<std::string>{"material"}) == both);
  }
}

// Catches: interpolation where the value is known, loss of the bits of a NaN.
TEST_CASE("corners that were there keep their bits", "[attributes][degenerate]") {
  Random random(1);
  Channel channel = random_channel<double>(random, left, "x", Element::corner, Interpolation::linear, 1);
  auto& values = std::get<Doubles>(channel.values);
  values[0] = std::bit_cast<double>(0x7ff8'0000'dead'beefU);
  values[1] = -0.0;
  values[2] = std::numeric_limits<double>::denorm_min();
  values[5] = HUGE_VAL;
  Channel direction = channel;
  direction.name = "n";
  direction.interpolation = Interpolation::spherical;  // not of length 1: not touched even so
  Attributes a = with(channel);
  a.channels.push_back(direction);
  const Mesh corner = box({0.5, 0.5, 0.5}, {2, 2, 2});
  const std::vector<Operand> operands{{left, {}, false, &a}, {corner, {}}};
  const BooleanResult r = combine(Operation::difference, std::span<const Operand>(operands));
  std::size_t kept = 0;
  for (const char* name : {"x", "n"})
    for (std::size_t c = 0; c < 3 * r.sources.size(); ++c) {
      if (r.sources[c / 3].operand != 0) continue;
      const Triangle& source = left.triangles[r.sources[c / 3].face];
      for (std::size_t k = 0; k < 3; ++k) {
        if (left.vertices[source[k]] != r.mesh.vertices[r.mesh.triangles[c / 3][c % 3]]) continue;
        ++kept;
        CHECK(std::bit_cast<std::uint64_t>(values_of<double>(r.attributes, name)[c]) ==
              std::bit_cast<std::uint64_t>(values[3 * r.sources[c / 3].face + k]));
      }
    }
  CHECK(kept > 20);
}

TEST_CASE("a NaN does not reach the opposite side", "[attributes][degenerate]") {
  const Mesh t = tetrahedron({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  Doubles values(12);
  for (std::size_t c = 0; c < 12; ++c) {
    const Vertex& p = t.vertices[t.triangles[c / 3][c % 3]];
    values[c] = p[2] > 0 ? std::numeric_limits<double>::quiet_NaN() : 7 + p[0];
  }
  const Attributes a = with({"x", Element::corner, Interpolation::linear, 1, values});
  const Mesh cutter = box({1, -1, -1}, {5, 5, 5});
  const std::vector<Operand> operands{{t, {}, false, &a}, {cutter, {}}};
  const BooleanResult r = combine(Operation::difference, std::span<const Operand>(operands));
  const auto& x = values_of<double>(r.attributes, "x");
  std::size_t numbers = 0, nans = 0;
  for (std::size_t c = 0; c < x.size(); ++c) {
    if (r.sources[c / 3].operand != 0) continue;
    const Vertex& p = r.mesh.vertices[r.mesh.triangles[c / 3][c % 3]];
    CHECK(std::isnan(x[c]) == (p[2] > 0));
    if (p[2] == 0) CHECK(x[c] == 7 + p[0]);
    (p[2] > 0 ? nans : numbers) += 1;
  }
  CHECK((numbers > 0 && nans > 0));
}

TEST_CASE("values at needles, huge and tiny places are right", "[attributes][degenerate]") {
  for (const double scale : {1.0, 0x1p-500, 0x1p500, 0x1p-1000, 0x1p1000})
    for (const double thin : {1.0, 0x1p-60}) {
      CAPTURE(scale, thin);
      Mesh a = box({0, 0, 0}, {3, 3, 3}), b = box({1, 1, 1}, {5, 2, 7});
      for (Mesh* m : {&a, &b})
        for (Vertex& v : m->vertices) v = {v[0] * scale, v[1] * scale * thin, v[2] * scale};
      const Attributes of_a = with(places(a)), of_b = with(places(b));
      const std::vector<Operand> operands{{a, {}, false, &of_a}, {b, {}, false, &of_b}};
      for (const Operation operation : all_operations) {
        const BooleanResult r = combine(operation, std::span<const Operand>(operands));
        REQUIRE_FALSE(r.mesh.triangles.empty());
        CHECK(has_its_places(r.mesh, r.attributes));
      }
    }
}

TEST_CASE("empty operands and results have channels without values", "[attributes][degenerate]") {
  const Mesh none;
  const Attributes a = with(places(left)), of_none = with(places(none));
  const std::vector<Operand> operands{{none, {}, false, &of_none}, {left, {}, false, &a}};
  CHECK(has_its_places(left, combine(Operation::union_, std::span<const Operand>(operands)).attributes));
  const BooleanResult empty = combine(Operation::intersection, std::span<const Operand>(operands));
  REQUIRE(empty.attributes.channels.size() == 1);
  CHECK(values_of<double>(empty.attributes, "place").empty());
  CHECK(combine(Operation::union_, std::span<const Operand>()).attributes.empty());
}

TEST_CASE("what tells its sources carries attributes by a call", "[attributes]") {
  SECTION("a mesh that crosses itself, resolved") {
    Mesh mesh = box({0, 0, 0}, {2, 2, 2});
    const Mesh other = box({1, 1, 1}, {3, 3, 3});
    for (Triangle t : other.triangles) mesh.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    const Attributes a = with(places(mesh));
    const Solid whole = resolve({mesh, {}});
    const Attributes carried =
        carry_attributes(std::array{AttributedMesh{ExactMeshView(mesh, {}), &a}}, whole.exact_mesh(), whole.sources());
    CHECK(has_its_places(whole.mesh(), carried));
    const Operand operand{mesh, {}, false, &a};
    const BooleanResult r = combine(Operation::union_, {&operand, 1}, {.input = InputClass::overlapping});
    CHECK(has_its_places(r.mesh, r.attributes));
  }
  SECTION("a soup with a hole: the filling has values of a face beside it") {
    Mesh open = left;
    open.triangles.pop_back();
    const Attributes a = with(places(open));
    const Operand operand{open, {}, false, &a};
    const BooleanResult r = combine(Operation::union_, {&operand, 1}, {.input = InputClass::soup});
    REQUIRE(r.mesh.triangles.size() == 12);
    for (const double x : values_of<double>(r.attributes, "place")) CHECK((x >= 0 && x <= 1));
  }
  SECTION("surfaces") {
    const Attributes a = with(places(left));
    const Solid solid = Solid(left).with_attributes(a);
    const Surface cut(Mesh{{{.5, -1, -1}, {.5, 3, -1}, {.5, -1, 3}}, {{0, 1, 2}}});
    const std::array cuts{cut};
    const auto pieces = split(solid, cuts);
    REQUIRE(pieces.size() == 2);
    for (const Solid& piece : pieces) {
      const auto& x = values_of<double>(piece.attributes(), "place");
      for (std::size_t t = 0; t < piece.sources().size(); ++t)
        for (std::size_t k = 0; k < 9; ++k)
          CHECK(x[9 * t + k] ==
                (piece.sources()[t].operand == 0 ? piece.mesh().vertices[piece.mesh().triangles[t][k / 3]][k % 3] : 0));
    }
  }
  SECTION("sources that there are not") {
    const Attributes a = with(places(left));
    const std::array operands{AttributedMesh{ExactMeshView(left, {}), &a}};
    std::vector<Source> sources(12);
    CHECK_THROWS_AS(carry_attributes(operands, ExactMeshView(left, {}), {sources.data(), 11}), std::invalid_argument);
    sources[3].face = 12;
    CHECK_THROWS_AS(carry_attributes(operands, ExactMeshView(left, {}), sources), std::invalid_argument);
    sources[3] = {1, 0};
    CHECK_THROWS_AS(carry_attributes(operands, ExactMeshView(left, {}), sources), std::invalid_argument);
    sources[3] = {0, 3};
    Mesh wrong = left;
    wrong.triangles[5][1] = 8;
    CHECK_THROWS_AS(carry_attributes(operands, ExactMeshView(wrong, {}), sources), std::invalid_argument);
    CHECK_THROWS_AS(carry_attributes(operands, ExactMeshView(left, std::array{ExactVertex{8, {}}}), sources),
                    std::invalid_argument);
  }
  SECTION("a face with a vertex that there is not, which a soup may have") {
    Mesh soup = left;
    soup.triangles.push_back({0, 1, 8});
    Attributes a = with({"x", Element::vertex, Interpolation::linear, 1, Floats(8, 1)});
    const Attributes b = with(constant<float>("x", Element::corner, {2}, Interpolation::linear));
    const std::vector<Operand> operands{{soup, {}, false, &a}, {right, {}, false, &b}};
    const BooleanResult r =
        combine(Operation::union_, std::span<const Operand>(operands), {.input = InputClass::repair});
    CHECK(ends<float>(r.attributes, "x") == std::pair(Floats{1}, Floats{2}));
  }
}
