// What a format cannot keep is told, and never makes a file that cannot be read.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <sstream>
#include <string>

#include "attributed.h"

using namespace strata;
using namespace strata::test;

TEST_CASE("colours that are no numbers are left out of 3MF, and nothing else is", "[io]") {
  MeshFile file = two_objects();
  std::vector<float> colors(24, 0.5F);
  colors[7] = std::numeric_limits<float>::quiet_NaN();
  file.attributes.channels[1] = {"color", Element::vertex, Interpolation::linear, 3, colors};
  WriteOptions options;
  options.format = Format::threemf;
  options.attributes = &file.attributes;
  std::ostringstream stream;
  const auto notes = write_mesh(stream, ExactMesh{file.mesh, {}}, options);
  CHECK(std::any_of(notes.begin(), notes.end(),
                    [](const std::string& note) { return note.starts_with("channel color left out: there are "); }));
  const std::string bytes = stream.str();
  const MeshFile again = read_mesh(std::string_view(bytes), Format::threemf, "test");
  CHECK(again.mesh == file.mesh);
  CHECK(again.attributes.find("color") == nullptr);
  CHECK(again.attributes.find("texcoord") != nullptr);
}

TEST_CASE("channels with numbers that a format has no way to keep are left out, and this is told", "[io]") {
  const Format format = GENERATE(Format::gltf, Format::glb, Format::obj, Format::threemf);
  const double value =
      GENERATE(std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity(), 1e300);
  CAPTURE(name(format), value);
  MeshFile file = two_objects();
  std::get<std::vector<double>>(file.attributes.channels[2].values)[30] = value;
  const bool is_kept = value == 1e300 && !holds_floats(format);
  WriteOptions options;
  options.format = format;
  options.attributes = &file.attributes;
  std::ostringstream stream;
  const auto notes = write_mesh(stream, ExactMesh{file.mesh, {}}, options);
  const bool is_told = std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.starts_with("channel texcoord left out: there are numbers that ");
  });
  CHECK(is_told == !is_kept);
  const std::string bytes = stream.str();
  const MeshFile again = read_mesh(std::string_view(bytes), format, "test");
  CHECK(again.mesh == file.mesh);
  CHECK((again.attributes.find("texcoord") != nullptr) == is_kept);
  CHECK(again.attributes.find("color") != nullptr);
  options.strict = true;
  if (!is_kept) CHECK_THROWS_AS(to_string(ExactMesh{file.mesh, {}}, options), IoError);
}
