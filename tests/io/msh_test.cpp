// MSH: Gmsh 4.1 of a small mesh, with regions by groups, objects or materials.
#include <catch2/catch.hpp>
#include <sstream>
#include <string>

#include "attributed.h"
#include "tetrahedron.h"

using namespace strata;
using namespace strata::test;

namespace {

/// Two triangles, in the regions 5 and -1 of a channel.
MeshFile in_regions(const char* channel) {
  MeshFile file;
  file.mesh = {{{0, 0, 0}, {1, 0, 0}, {1, 2.5, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  file.attributes.channels = {{channel, Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>{5, -1}}};
  return file;
}

std::vector<std::string> notes_of(const MeshFile& file) {
  WriteOptions options;
  options.format = Format::msh;
  options.attributes = &file.attributes;
  std::ostringstream stream;
  return write_mesh(stream, ExactMesh{file.mesh, {}}, options);
}

}  // namespace

TEST_CASE("MSH has an entity and a physical name for each region, nodes once, elements by region", "[io][msh]") {
  CHECK(written(in_regions("group"), Format::msh) ==
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
        "$PhysicalNames\n2\n2 1 \"group -1\"\n2 2 \"group 5\"\n$EndPhysicalNames\n"
        "$Entities\n0 0 2 0\n1 0 0 0 1 2.5 0 1 1 0\n2 0 0 0 1 2.5 0 1 2 0\n$EndEntities\n"
        "$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 2.5 0\n0 1 0\n$EndNodes\n"
        "$Elements\n2 2 1 2\n2 1 2 1\n1 1 3 4\n2 2 2 1\n2 1 2 3\n$EndElements\n");
}

TEST_CASE("MSH: regions have the names of groups, else of objects, else of materials", "[io][msh]") {
  const std::vector<std::string> names{"0", "1", "2", "3", "4", "the \"fifth\"\nof all"};
  MeshFile file = in_regions("object");
  file.attributes.objects = names;
  const std::string named = "2 2 \"the 'fifth' of all\"\n";
  CHECK(written(file, Format::msh).find(named) != std::string::npos);
  CHECK(notes_of(file).empty());
  file.attributes.channels.push_back(
      {"material", Element::face, Interpolation::nearest, 1, std::vector<std::int32_t>{0, 0}});
  file.attributes.materials.resize(1);
  CHECK(written(file, Format::msh).find(named) != std::string::npos);
  CHECK(notes_of(file) == std::vector<std::string>{"channel material left out: MSH cannot keep it",
                                                   "materials left out: MSH cannot keep them"});
  file.attributes.channels[0].name = "group";
  file.attributes.groups = names;
  CHECK(written(file, Format::msh).find(named) != std::string::npos);
}

TEST_CASE("MSH without channels is one surface, and of no faces nothing", "[io][msh]") {
  const std::string text = to_string(tetrahedron, Format::msh);
  CHECK(text.find("$PhysicalNames\n1\n2 1 \"surface\"\n") != std::string::npos);
  CHECK(text.find("$Elements\n1 4 1 4\n2 1 2 4\n1 1 3 2\n") != std::string::npos);
  CHECK(to_string(Mesh{}, Format::msh) ==
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n0\n$EndPhysicalNames\n$Entities\n0 0 0 0\n$EndEntities\n"
        "$Nodes\n0 0 0 0\n$EndNodes\n$Elements\n0 0 1 0\n$EndElements\n");
  CHECK(refusal(text, Format::msh).find("can be written, but not be read") != std::string::npos);
}
