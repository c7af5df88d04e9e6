#include "files.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <string_view>
#include <utility>

#include "common/tell.h"
#include "operand_units.h"
#include "strata/carry_attributes.h"
#include "threads.h"

namespace {

namespace fs = std::filesystem;
using strata::Format;

constexpr const char* writable =
    "stl, stl-ascii, obj, off, xoff, ply, ply-ascii, ply-big-endian, 3mf, glb, gltf, vtk, vtk-ascii, msh";

[[noreturn]] void fail_unwritable(std::string_view format) {
  throw UsageError(fmt::format("cannot write the format {}; these can be written: {}", format, writable));
}

void print_notes(const std::string& path, const std::vector<std::string>& notes, const Settings& settings) {
  if (settings.quiet) return;
  for (const std::string& note : notes) tell("strata: {}: note: {}\n", path, note);
}

void print_losses(const std::string& path, const std::vector<std::string>& notes, const Settings& settings) {
  if (settings.tells_losses) print_notes(path, notes, settings);
}

std::string read_all(std::istream& stream, const std::string& name) {
  constexpr std::size_t block = 1 << 20;
  std::string bytes;
  while (stream) {
    const std::size_t before = bytes.size();
    bytes.resize(before + block);
    stream.read(bytes.data() + before, block);
    bytes.resize(before + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw strata::IoError(name, {}, "read error");
  return bytes;
}

std::optional<Format> input_format(const Settings& settings) {
  if (settings.input_format.empty()) return {};
  const auto format = strata::format_named(settings.input_format);
  if (!format) throw UsageError("unknown input format: " + settings.input_format);
  return format;
}

// For formats that are not ours the reader goes by the extension, which the bytes' name supplies where asked for.
strata::MeshFile read_operand(const std::string& path, const Settings& settings) {
  const auto format = input_format(settings);
  if (path == "-") {
    const std::string bytes = read_all(std::cin, "standard input");
    return strata::read_mesh(std::string_view(bytes), *format, "stdin." + settings.input_format);
  }
  if (format == Format::other && fs::is_regular_file(path)) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw strata::IoError(path, {}, std::strerror(errno));
    const std::string bytes = read_all(file, path);
    return strata::read_mesh(std::string_view(bytes), *format, path + "." + settings.input_format);
  }
  return strata::read_mesh(path, format);
}

}  // namespace

std::vector<LoadedMesh> read_operands(const Settings& settings) {
  std::vector<LoadedMesh> operands;
  std::size_t argument = 0;
  for (const std::string& path : settings.operands) {
    strata::MeshFile file = on_threads(settings, [&] { return read_operand(path, settings); });
    print_notes(path, file.notes, settings);
    LoadedMesh mesh{path, {std::move(file.mesh), std::move(file.exact)}, std::move(file.polygon_of_triangle)};
    mesh.attributes = settings.attributes.chosen(std::move(file.attributes));
    mesh.unit = file.unit;
    mesh.argument = argument++;
    if (settings.objects)
      for (LoadedMesh& object : objects_of(std::move(mesh))) operands.push_back(std::move(object));
    else
      operands.push_back(std::move(mesh));
  }
  use_one_unit(operands, settings);
  return operands;
}

Settings with_unit_of(std::span<const LoadedMesh> operands, Settings settings) {
  if (!operands.empty()) settings.unit = strata::name(operands.front().unit);
  return settings;
}

Format output_format(const Settings& settings) {
  if (!settings.output_format.empty()) {
    const auto format = strata::format_named(settings.output_format);
    if (format && strata::can_write(*format)) return *format;
    fail_unwritable(settings.output_format);
  }
  if (settings.output == "-") return Format::stl;
  const Format format = strata::format_of(settings.output);
  if (strata::can_write(format)) return format;
  if (format != Format::other) fail_unwritable(strata::name(format));
  throw UsageError(
      fmt::format("cannot tell a format from {}; use --format with one of: {}", settings.output, writable));
}

void write_output(const Settings& settings, Format format, const strata::ExactMesh& mesh,
                  const strata::Attributes& attributes) {
  strata::WriteOptions options;
  options.format = format;
  if (!attributes.empty()) options.attributes = &attributes;
  options.unit = unit_in(settings);
  options.strict = settings.strict;
  if (settings.output == "-") {
    const auto write = [&] { return strata::write_mesh(std::cout, mesh, options, "standard output"); };
    print_losses("standard output", on_threads(settings, write), settings);
    if (!std::cout.flush()) throw strata::IoError("standard output", {}, std::strerror(errno));
  } else {
    const auto write = [&] { return strata::write_mesh(settings.output, mesh, options); };
    print_losses(settings.output, on_threads(settings, write), settings);
  }
}

void tell_what_is_not_carried(std::span<const LoadedMesh> operands, const Settings& settings) {
  if (settings.quiet) return;
  for (const LoadedMesh& operand : operands) {
    std::string names;
    for (const strata::Channel& c : operand.attributes.channels) names += (names.empty() ? "" : ", ") + c.name;
    if (!names.empty()) tell("strata: {}: note: {} left out: the result carries no attributes\n", operand.path, names);
  }
}

strata::Solid make_solid(std::span<const LoadedMesh> operands, std::size_t k, const Settings& settings) {
  try {
    strata::Solid solid(operands[k].mesh, settings.input);
    if (!settings.quiet)
      for (const strata::Defect& note : solid.notes())
        tell("strata: {}: {}\n", operands[k].path, strata::describe(note));
    return solid;
  } catch (const strata::InputError& error) {
    throw strata::InputError(error.defects(), k);
  }
}

strata::Solid with_attributes_of(const LoadedMesh& mesh, strata::Solid solid) {
  if (mesh.attributes.empty()) return solid;
  const std::array given{strata::AttributedMesh{mesh.mesh, &mesh.attributes}};
  return solid.with_attributes(strata::carry_attributes(given, solid.exact_mesh(), solid.sources()));
}

strata::Solid make_attributed_solid(std::span<const LoadedMesh> operands, std::size_t k, const Settings& settings) {
  return with_attributes_of(operands[k], make_solid(operands, k, settings));
}
