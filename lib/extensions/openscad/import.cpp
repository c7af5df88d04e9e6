#include "extensions/openscad/import.h"

#include <algorithm>
#include <array>
#include <utility>

#include "extensions/openscad/arguments.h"
#include "extensions/openscad/model_file.h"
#include "extensions/openscad/read_dxf.h"
#include "extensions/openscad/read_svg.h"
#include "extensions/openscad/tessellation.h"
#include "strata/io.h"

namespace strata::openscad {
namespace {

Part solid_in(const std::string& path, const std::string& name, const Arguments& arguments, const Options& options) {
  MeshFile file = read_mesh(path);
  ExactMesh mesh{std::move(file.mesh), std::move(file.exact)};
  Options checked = options;
  checked.progress = {};
  checked.input = InputClass::automatic;
  Solid solid;
  try {
    solid = Solid(mesh, checked);
  } catch (const InputError& error) {
    checked.input = InputClass::repair;
    solid = Solid(std::move(mesh.mesh), checked);
    arguments.note("repairs a mesh: " + describe(error.defects().front()));
  }
  return solid.is_empty() ? Part() : Part::of(Expression(std::move(solid), name), true);
}

planar::Region shape_in(const std::string& path, const std::string& extension, const Arguments& arguments) {
  const Resolution resolution = resolution_of(arguments);
  if (extension == "svg") {
    SvgPlacement placement;
    placement.dots_per_inch = arguments.number("dpi", 72);
    placement.is_centred = arguments.truth("center", false);
    placement.id = arguments.text("id", {});
    placement.layer = arguments.text("layer", {});
    SvgShapes shapes = read_svg(bytes_of(path), placement, resolution);
    for (const std::string& note : shapes.notes) arguments.note("of an SVG file: " + note);
    return std::move(shapes.region);
  }
  DxfPlacement placement;
  placement.layer = arguments.text("layer", {});
  const std::vector<double> origin = arguments.numbers("origin", {0, 0});
  placement.origin = {origin[0], origin[1]};
  placement.scale = arguments.number("scale", 1);
  DxfShapes shapes = read_dxf(bytes_of(path), placement, resolution);
  for (const std::string& note : shapes.notes) arguments.note("of a DXF file: " + note);
  return std::move(shapes.region);
}

}  // namespace

Part import(const SyntaxNode& node, const std::string& name, const CsgOptions& options, Report& report) {
  const Arguments arguments(node,
                            {"file", "layer", "convexity", "origin", "scale", "center", "dpi", "id", "width", "height",
                             "filename", "timestamp", "layername"},
                            report);
  if (arguments.text("file", {}).empty()) {
    arguments.note("without a file makes nothing");
    return {};
  }
  const std::string path = path_of_file(arguments, options), extension = extension_of(path);
  constexpr std::array<std::string_view, 6> meshes{"stl", "off", "obj", "ply", "3mf", "amf"};
  try {
    if (std::find(meshes.begin(), meshes.end(), extension) != meshes.end())
      return solid_in(path, name, arguments, options.evaluation);
    if (extension == "svg" || extension == "dxf") return Part::of(shape_in(path, extension, arguments));
  } catch (const IoError& error) {
    arguments.fail("file", std::string("is not read: ") + error.what());
  } catch (const InputError& error) {
    arguments.fail("file", "'" + arguments.text("file", {}) + "' bounds no solid: " + error.what());
  }
  arguments.fail("file", "is not supported: '" + arguments.text("file", {}) + "' is of another format");
}

}  // namespace strata::openscad
