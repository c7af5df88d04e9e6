// OFF: what the letters of the header announce, and colours behind faces, become channels and are written again.
#include <catch2/catch.hpp>
#include <limits>
#include <sstream>
#include <string>

#include "attributed.h"
#include "core/io/readers.h"
#include "random_channels.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {

Channel channel(const char* name, Element element, std::uint32_t components, ChannelValues values) {
  const bool is_normal = std::string_view(name) == channel_names::normal;
  return {name, element, is_normal ? Interpolation::spherical : Interpolation::linear, components, std::move(values)};
}

using Bytes = std::vector<std::uint8_t>;
using Floats = std::vector<float>;
using Doubles = std::vector<double>;

}  // namespace

TEST_CASE("OFF: normals, colours and texture coordinates stand in this order, whatever that of the letters",
          "[io][off]") {
  const std::string body =
      "\n3 1 0\n0 0 0 0 0 1 10 20 30 40 0.25 0.5\n1 0 0 0 1 0 1 2 3 4 1 0\n0 1 0 1 0 0 5 6 7 8 0 1\n3 0 1 2\n";
  for (const char* keyword : {"STCNOFF", "CNSTOFF", "NCSTOFF"}) {
    const MeshFile file = read_text(keyword + body, Format::off);
    CHECK(file.notes.empty());
    CHECK(file.attributes.channels ==
          std::vector<Channel>{channel("normal", Element::vertex, 3, Doubles{0, 0, 1, 0, 1, 0, 1, 0, 0}),
                               channel("texcoord", Element::vertex, 2, Doubles{0.25, 0.5, 1, 0, 0, 1}),
                               channel("color", Element::vertex, 4, Bytes{10, 20, 30, 40, 1, 2, 3, 4, 5, 6, 7, 8})});
  }
}

TEST_CASE("OFF: colours are bytes if all numbers are integers up to 255, else floats", "[io][off]") {
  const auto read = [](const std::string& a, const std::string& b, const std::string& c) {
    return read_text("COFF\n3 1 0\n0 0 0 " + a + "\n1 0 0 " + b + "\n0 1 0 " + c + "\n3 0 1 2\n", Format::off);
  };
  CHECK(read("1 0 0", "255 7 9", "0 0 0").attributes.channels[0] ==
        channel("color", Element::vertex, 3, Bytes{1, 0, 0, 255, 7, 9, 0, 0, 0}));
  CHECK(read("1 0 0", "0 0.5 1", "0 0 0").attributes.channels[0] ==
        channel("color", Element::vertex, 3, Floats{1, 0, 0, 0, 0.5, 1, 0, 0, 0}));
  CHECK(read("1 0 0", "0 256 1", "0 0 0").attributes.channels[0] ==
        channel("color", Element::vertex, 3, Floats{1, 0, 0, 0, 256, 1, 0, 0, 0}));
  CHECK(read("1 2 3", "4 5 6 7", "").attributes.channels[0] ==
        channel("color", Element::vertex, 4, Bytes{1, 2, 3, 255, 4, 5, 6, 7, 255, 255, 255, 255}));
  const MeshFile odd = read("1 2 3", "red", "1 2");
  CHECK(odd.attributes.channels[0] ==
        channel("color", Element::vertex, 3, Bytes{1, 2, 3, 255, 255, 255, 255, 255, 255}));
  CHECK(odd.notes ==
        std::vector<std::string>{
            "2 vertices with other numbers behind coordinates than the header says, left out; the first is "
            "vertex 1 (counted from 0)"});
}

TEST_CASE("OFF: colours behind faces are those of their triangles", "[io][off]") {
  const std::string head = "OFF\n4 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const std::string faces = "3 0 1 2 9 8 7 # red\n4 0 1 2 3 1 2 3 4\n3 1 1 2 5 5 5\n3 0 2 3\n";
  for (const std::size_t piece : {std::size_t{1000}, std::size_t{1}}) {
    const std::string text = head + faces;
    const MeshFile file = io::read({"test", text, piece}, Format::off);
    CHECK(file.attributes.channels ==
          std::vector<Channel>{
              channel("color", Element::face, 4, Bytes{9, 8, 7, 255, 1, 2, 3, 4, 1, 2, 3, 4, 255, 255, 255, 255})});
  }
  const MeshFile others = read_text(head + "3 0 1 2 5\n3 0 1 2 5\n3 0 1 2 1 2\n3 0 1 2 a b c\n", Format::off);
  CHECK(others.attributes.channels.empty());
  CHECK(others.notes ==
        std::vector<std::string>{
            "2 faces with an index into a map of colours, which is left out; the first is face 0 (counted from 0)",
            "2 faces with other numbers behind corners than a colour, left out; the first is face 2 (counted from 0)"});
  const MeshFile both = read_text("COFF\n3 1 0\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2 1 2 3\n", Format::off);
  CHECK(both.attributes.channels.size() == 1);
  CHECK(both.notes == std::vector<std::string>{"colours of faces left out: vertices have some"});
}

TEST_CASE("OFF: channels that it knows are read as they were written", "[io][off][property]") {
  const auto seed = GENERATE(range(0U, 60U));
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  MeshFile file;
  file.mesh = random_soup(random, 3 + random() % 40, 1 + random() % 60);
  const auto maybe = [&](Channel c) {
    if (random() % 3 > 0) file.attributes.channels.push_back(std::move(c));
  };
  const auto element = random() % 2 == 0 ? Element::vertex : Element::face;
  const auto components = static_cast<std::uint32_t>(3 + random() % 2);
  maybe(random_channel<double>(random, file.mesh, "normal", Element::vertex, Interpolation::spherical, 3));
  maybe(random_channel<double>(random, file.mesh, "texcoord", Element::vertex, Interpolation::linear, 2));
  if (random() % 2 == 0)
    maybe(random_channel<float>(random, file.mesh, "color", element, Interpolation::linear, components));
  else
    maybe(random_channel<std::uint8_t>(random, file.mesh, "color", element, Interpolation::linear, components));
  const std::string text = written(file, Format::off);
  CAPTURE(text.substr(0, 1000));
  for (const std::size_t piece : {text.size(), std::size_t{100}, std::size_t{3}}) {
    const MeshFile again = io::read({"test", text, piece}, Format::off);
    CHECK(again.mesh == file.mesh);
    CHECK(again.notes.empty());
    REQUIRE(again.attributes.channels.size() == file.attributes.channels.size());
    for (const Channel& c : file.attributes.channels) CHECK(*again.attributes.find(c.name) == c);
  }
}

TEST_CASE("OFF: the letters are those of what is written, and floats have points", "[io][off]") {
  MeshFile file;
  file.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  file.attributes.channels = {
      {"normal", Element::vertex, Interpolation::spherical, 3, Floats{0, 0, 1, 0, 0, 1, 0, 0, 1}},
      {"color", Element::vertex, Interpolation::linear, 3, Floats{1, 0, 0.5, 1, 1, 1, 0, 0, -2}},
      {"texcoord", Element::corner, Interpolation::linear, 2, Floats{0, 0, 1, 0, 0, 1}}};
  WriteOptions options;
  options.format = Format::off;
  options.attributes = &file.attributes;
  std::ostringstream stream;
  CHECK(write_mesh(stream, ExactMesh{file.mesh, {}}, options) ==
        std::vector<std::string>{"channel texcoord left out: OFF cannot keep it"});
  CHECK(stream.str() ==
        "CNOFF\n3 1 0\n0 0 0 0 0 1 1.0 0.0 0.5\n1 0 0 0 0 1 1.0 1.0 1.0\n0 1 0 0 0 1 0.0 0.0 -2.0\n3 0 1 2\n");
}

TEST_CASE("OFF: colours that are no floats are left out, with a note", "[io][off]") {
  MeshFile file;
  file.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  WriteOptions options;
  options.format = Format::off;
  options.attributes = &file.attributes;
  for (const ChannelValues& values :
       {ChannelValues(Doubles{1, 0, 1e300}), ChannelValues(std::vector<std::int32_t>{1, 2, 3})}) {
    const auto how = std::holds_alternative<Doubles>(values) ? Interpolation::linear : Interpolation::nearest;
    file.attributes.channels = {{"color", Element::face, how, 3, values}};
    std::ostringstream stream;
    CHECK(write_mesh(stream, ExactMesh{file.mesh, {}}, options) ==
          std::vector<std::string>{"channel color left out: OFF cannot keep it"});
    CHECK(stream.str() == "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  }
}
