#include <algorithm>
#include <array>
#include <ostream>
#include <utility>

#include "core/io/readers.h"
#include "core/io/sink.h"
#include "core/io/writers.h"
#include "strata/io.h"

namespace strata {
namespace {

using Name = std::pair<std::string_view, Format>;
constexpr std::array<Name, 8> names{Name{"stl", Format::stl},
                                    Name{"stl-ascii", Format::stl_ascii},
                                    Name{"obj", Format::obj},
                                    Name{"off", Format::off},
                                    Name{"xoff", Format::xoff},
                                    Name{"ply", Format::ply},
                                    Name{"ply-ascii", Format::ply_ascii},
                                    Name{"ply-big-endian", Format::ply_big_endian}};

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

[[noreturn]] void fail_unknown(const std::string& name, const std::string& extension) {
  throw IoError(name, {},
                (extension.empty() ? std::string("unknown format: the name has no extension")
                                   : "unknown format '" + extension + "'") +
                    "; known are stl, obj, off, xoff, ply" +
                    (io::can_read_other(".glb") ? ", and glb, gltf, 3mf, fbx, dae and others for reading" : ""));
}

using ExactPositions = std::span<const ExactVertex>;

void check(MeshView mesh, ExactPositions exact, Format format, const std::string& name) {
  io::check_writable(mesh, name);
  if (format == Format::xoff) io::check_writable(exact, mesh.vertices.size(), name);
}

std::vector<std::string> write(MeshView mesh, ExactPositions exact, Format format, io::Sink& sink,
                               const std::string& name) {
  switch (format) {
    case Format::stl:
      return io::write_stl(mesh, sink, name);
    case Format::stl_ascii:
      io::write_stl_ascii(mesh, sink);
      break;
    case Format::obj:
      io::write_obj(mesh, sink);
      break;
    case Format::off:
      io::write_off(mesh, sink);
      break;
    case Format::xoff:
      io::write_xoff(mesh, exact, sink);
      break;
    case Format::ply:
      io::write_ply_binary(mesh, sink, false);
      break;
    case Format::ply_ascii:
      io::write_ply_ascii(mesh, sink);
      break;
    case Format::ply_big_endian:
      io::write_ply_binary(mesh, sink, true);
      break;
    case Format::other:
      throw IoError(name, {}, "cannot write this format; stl, obj, off, xoff and ply can be written");
  }
  return {};
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

std::vector<std::string> write_to_file(const std::filesystem::path& path, MeshView mesh, ExactPositions exact,
                                       std::optional<Format> format) {
  const Format chosen = format.value_or(format_of(path));
  if (chosen == Format::other) fail_unknown(path.string(), path.extension().string());
  check(mesh, exact, chosen, path.string());
  io::FileSink sink(path);
  auto notes = write(mesh, exact, chosen, sink, path.string());
  sink.finish();
  return notes;
}

std::vector<std::string> write_to_stream(std::ostream& stream, MeshView mesh, ExactPositions exact, Format format,
                                         const std::string& name) {
  check(mesh, exact, format, name);
  io::StreamSink sink(stream, name);
  auto notes = write(mesh, exact, format, sink, name);
  sink.finish();
  return notes;
}

std::string write_to_string(MeshView mesh, ExactPositions exact, Format format) {
  check(mesh, exact, format, "memory");
  io::StringSink sink;
  (void)write(mesh, exact, format, sink, "memory");
  return sink.take();
}

}  // namespace

std::vector<std::string> write_mesh(const FilePath& path, MeshView mesh, std::optional<Format> format) {
  return write_to_file(path.text(), mesh, {}, format);
}

std::vector<std::string> write_mesh(const FilePath& path, const ExactMesh& mesh, std::optional<Format> format) {
  return write_to_file(path.text(), mesh.mesh, mesh.exact, format);
}

std::vector<std::string> write_mesh(std::ostream& stream, MeshView mesh, Format format, std::string name) {
  return write_to_stream(stream, mesh, {}, format, name);
}

std::vector<std::string> write_mesh(std::ostream& stream, const ExactMesh& mesh, Format format, std::string name) {
  return write_to_stream(stream, mesh.mesh, mesh.exact, format, name);
}

std::string to_string(MeshView mesh, Format format) { return write_to_string(mesh, {}, format); }

std::string to_string(const ExactMesh& mesh, Format format) { return write_to_string(mesh.mesh, mesh.exact, format); }

}  // namespace strata
