#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

#include "about.h"
#include "strata/io.h"

namespace {

struct Row {
  std::string_view format;
  std::string_view coordinates;
  std::string_view what;
};

/// What is worth knowing about a format of meshes beside its name.
constexpr std::array<Row, 15> known{
    {{"stl", "floats", "binary; text is found when reading; corners, no shared vertices"},
     {"stl-ascii", "doubles", "text"},
     {"obj", "doubles", "text; polygons are triangulated"},
     {"off", "doubles", "text; normals, colours, texture coordinates"},
     {"xoff", "rationals", "text; exact results, faces with holes"},
     {"ply", "doubles", "binary, little endian; any channel"},
     {"ply-ascii", "doubles", "the same as text"},
     {"ply-big-endian", "doubles", "the same, big endian"},
     {"3mf", "doubles", "archive; units, objects, materials, colours, textures"},
     {"glb", "floats", "glTF 2.0; objects, materials, textures, normals"},
     {"gltf", "floats", "the same as JSON"},
     {"amf", "doubles", "units, objects, materials"},
     {"vtk", "doubles", "legacy VTK, binary; any channel"},
     {"vtk-ascii", "doubles", "legacy VTK, text"},
     {"msh", "doubles", "Gmsh 4.1, text"}}};

/// Formats of other things, which single verbs read and write.
constexpr std::array<std::array<std::string_view, 3>, 10> others{
    {{"wkt", "read, write", "polygons: planar, section, slice; with --exact rationals"},
     {"geojson", "read, write", "polygons: planar, section, slice"},
     {"svg", "read, write", "polygons: planar, section, slice; pictures: draw"},
     {"csv", "read, write", "points and rays: locate, ray; intervals; sections"},
     {"csg", "read", "models that OpenSCAD wrote: eval"},
     {"sgc", "read, write", "sets that need not be regular: topology"},
     {"bsp", "read", "binary space partitions: bsp"},
     {"glb", "write", "coloured pictures in space, of meshes: decompose, contacts, bsp"},
     {"png", "write", "pictures: draw, by rsvg-convert"},
     {"json", "read, write", "reports, steps of chain; jobs and records of batch are .jsonl"}}};

std::string_view use_of(strata::Format format) {
  if (!strata::can_write(format)) return "read";
  return strata::can_read(format) ? "read, write" : "write";
}

void print_row(std::string_view name, std::string_view use, std::string_view coordinates, std::string_view what) {
  fmt::print("{:15} {:12} {:10} {}\n", name, use, coordinates, what);
}

}  // namespace

ExitCode print_formats() {
  fmt::print("Meshes (--format, --input-format, or the extension of the name):\n");
  print_row("format", "", "numbers", "");
  for (int k = 0; static_cast<strata::Format>(k) != strata::Format::other; ++k) {
    const auto format = static_cast<strata::Format>(k);
    const std::string_view name = strata::name(format);
    Row row{name, "", ""};
    for (const Row& each : known)
      if (each.format == name) row = each;
    print_row(name, use_of(format), row.coordinates, row.what);
  }
  for (const std::string_view name : {"fbx", "dae", "x3d", "blend"})
    if (strata::format_named(name) == strata::Format::other)
      print_row(name, "read", "floats", "by assimp, in a process of its own");
  fmt::print("\nOther files:\n");
  for (const auto& [name, use, what] : others) print_row(name, use, "", what);
  return ExitCode::ok;
}
