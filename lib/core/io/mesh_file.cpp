#include <algorithm>
#include <array>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "core/io/readers.h"
#include "core/io/sink.h"
#include "core/io/writers.h"
#include "strata/carry_attributes.h"
#include "strata/io.h"

namespace strata {
namespace {

using Name = std::pair<std::string_view, Format>;
constexpr std::array<Name, 15> names{Name{"stl", Format::stl},
                                     Name{"stl-ascii", Format::stl_ascii},
                                     Name{"obj", Format::obj},
                                     Name{"off", Format::off},
                                     Name{"xoff", Format::xoff},
                                     Name{"ply", Format::ply},
                                     Name{"ply-ascii", Format::ply_ascii},
                                     Name{"ply-big-endian", Format::ply_big_endian},
                                     Name{"3mf", Format::threemf},
                                     Name{"glb", Format::glb},
                                     Name{"gltf", Format::gltf},
                                     Name{"amf", Format::amf},
                                     Name{"vtk", Format::vtk},
                                     Name{"vtk-ascii", Format::vtk_ascii},
                                     Name{"msh", Format::msh}};

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

[[noreturn]] void fail_unknown(const std::string& name, const std::string& extension) {
  throw IoError(name, {},
                (extension.empty() ? std::string("unknown format: the name has no extension")
                                   : "unknown format '" + extension + "'") +
                    "; known are stl, obj, off, xoff, ply, 3mf, glb, gltf; vtk and msh for writing; amf" +
                    (io::can_read_other(".dae") ? ", fbx, dae and others" : "") + " for reading");
}

using ExactPositions = std::span<const ExactVertex>;

const Attributes no_attributes;

/// What is written, without its destination.
struct Content {
  MeshView mesh;
  ExactPositions exact = {};
  const Attributes* attributes = nullptr;
  Unit unit = Unit::none;
  bool strict = false;
};

Content content(MeshView mesh, ExactPositions exact, const WriteOptions& options) {
  return {mesh, exact, options.attributes, options.unit, options.strict};
}

void check(const Content& content, Format format, const std::string& name) {
  io::check_writable(content.mesh, name);
  if (format == Format::xoff) io::check_writable(content.exact, content.mesh.vertices.size(), name);
  if (content.attributes != nullptr)
    check_attributes(*content.attributes, content.mesh.vertices.size(), content.mesh.triangles.size());
}

io::Notes write_checked(const io::Target& target, Format format) {
  switch (format) {
    case Format::stl:
      return io::write_stl(target);
    case Format::stl_ascii:
      return io::write_stl_ascii(target);
    case Format::obj:
      return io::write_obj(target);
    case Format::off:
      return io::write_off(target);
    case Format::xoff:
      return io::write_xoff(target);
    case Format::ply:
    case Format::ply_ascii:
    case Format::ply_big_endian:
      return io::write_ply(target, format);
    case Format::threemf:
      return io::write_3mf(target);
    case Format::glb:
      return io::write_glb(target);
    case Format::gltf:
      return io::write_gltf(target);
    case Format::vtk:
    case Format::vtk_ascii:
      return io::write_vtk(target, format == Format::vtk_ascii);
    case Format::msh:
      return io::write_msh(target);
    case Format::amf:
    case Format::other:
      break;
  }
  throw IoError(target.name, {},
                "cannot write this format; stl, obj, off, xoff, ply, 3mf, glb, gltf, vtk and msh can be written");
}

io::Notes write(const Content& content, Format format, io::Sink& sink, const std::string& name,
                io::FilesBeside* beside = nullptr) {
  check(content, format, name);
  const Attributes& attributes = content.attributes != nullptr ? *content.attributes : no_attributes;
  io::Notes notes = write_checked({content.mesh, content.exact, attributes, content.unit, sink, name, beside}, format);
  if (content.strict && !notes.empty()) throw IoError(name, {}, "cannot be written without loss: " + notes.front());
  return notes;
}

}  // namespace

Format format_of(const FilePath& path) {
  const std::string extension = lower(std::filesystem::path(path.text()).extension().string());
  for (const auto& [word, format] : names)
    if (extension.starts_with('.') && extension.substr(1) == word) return format;
  return Format::other;
}

std::optional<Format> format_named(std::string_view word) {
  const std::string wanted = lower(std::string(word));
  for (const auto& [known, format] : names)
    if (wanted == known) return format;
  if (io::can_read_other(std::string(".").append(wanted))) return Format::other;
  return std::nullopt;
}

std::string_view name(Format format) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const Name& n) { return n.second == format; });
  return found == names.end() ? "other" : found->first;
}

bool can_read(Format format) { return format != Format::vtk && format != Format::vtk_ascii && format != Format::msh; }

bool can_write(Format format) { return format != Format::amf && format != Format::other; }

bool holds_floats(Format format) { return format == Format::stl || format == Format::glb || format == Format::gltf; }

MeshFile read_mesh(const FilePath& given, std::optional<Format> format) {
  const std::filesystem::path path(given.text());
  const Format chosen = format.value_or(format_of(path));
  // Opens the file first: a missing file is a different error than an unknown format.
  const io::File file(path);
  const std::string extension = path.extension().string();
  if (chosen == Format::other && !io::can_read_other(lower(extension))) fail_unknown(path.string(), extension);
  return io::read(file, chosen);
}

MeshFile read_mesh(std::string_view data, Format format, std::string name) {
  const std::string extension = std::filesystem::path(name).extension().string();
  if (format == Format::other && !io::can_read_other(lower(extension))) fail_unknown(name, extension);
  return io::read({std::move(name), data}, format);
}

MeshFile read_mesh(std::span<const std::byte> data, Format format, std::string name) {
  return read_mesh(std::string_view(reinterpret_cast<const char*>(data.data()), data.size()), format, std::move(name));
}

namespace {

io::Notes write_to_file(const std::filesystem::path& path, const Content& content, std::optional<Format> format) {
  const Format chosen = format.value_or(format_of(path));
  if (chosen == Format::other) fail_unknown(path.string(), path.extension().string());
  check(content, chosen, path.string());
  io::FileSink sink(path);
  io::FilesBeside beside(path);
  auto notes = write(content, chosen, sink, path.string(), &beside);
  sink.complete();
  beside.complete();
  beside.finish();
  sink.finish();
  return notes;
}

io::Notes write_to_stream(std::ostream& stream, const Content& content, Format format, const std::string& name) {
  check(content, format, name);
  io::StreamSink sink(stream, name);
  if (content.strict) {
    io::StringSink whole;
    auto notes = write(content, format, whole, name);
    sink.write(whole.take());
    sink.finish();
    return notes;
  }
  auto notes = write(content, format, sink, name);
  sink.finish();
  return notes;
}

std::string write_to_string(const Content& content, Format format) {
  io::StringSink sink;
  (void)write(content, format, sink, "memory");
  return sink.take();
}

Format format_in(const WriteOptions& options) {
  if (!options.format) throw std::invalid_argument("write_mesh: the options need a format where there is no path");
  return *options.format;
}

}  // namespace

using Notes = std::vector<std::string>;

Notes write_mesh(const FilePath& path, MeshView mesh, std::optional<Format> format) {
  return write_to_file(path.text(), {mesh}, format);
}

Notes write_mesh(const FilePath& path, const ExactMesh& mesh, std::optional<Format> format) {
  return write_to_file(path.text(), {mesh.mesh, mesh.exact}, format);
}

Notes write_mesh(const FilePath& path, MeshView mesh, const WriteOptions& options) {
  return write_to_file(path.text(), content(mesh, {}, options), options.format);
}

Notes write_mesh(const FilePath& path, const ExactMesh& mesh, const WriteOptions& options) {
  return write_to_file(path.text(), content(mesh.mesh, mesh.exact, options), options.format);
}

Notes write_mesh(std::ostream& stream, MeshView mesh, Format format, std::string name) {
  return write_to_stream(stream, {mesh}, format, name);
}

Notes write_mesh(std::ostream& stream, const ExactMesh& mesh, Format format, std::string name) {
  return write_to_stream(stream, {mesh.mesh, mesh.exact}, format, name);
}

Notes write_mesh(std::ostream& stream, const ExactMesh& mesh, const WriteOptions& options, std::string name) {
  return write_to_stream(stream, content(mesh.mesh, mesh.exact, options), format_in(options), name);
}

std::string to_string(MeshView mesh, Format format) { return write_to_string({mesh}, format); }

std::string to_string(const ExactMesh& mesh, Format format) { return write_to_string({mesh.mesh, mesh.exact}, format); }

std::string to_string(const ExactMesh& mesh, const WriteOptions& options) {
  return write_to_string(content(mesh.mesh, mesh.exact, options), format_in(options));
}

}  // namespace strata
