#include "strata/io/mesh_file.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <ostream>
#include <utility>

#include "strata/io/readers.h"
#include "strata/io/sink.h"
#include "strata/io/writers.h"

namespace strata {
namespace {

using Name = std::pair<std::string_view, Format>;
constexpr std::array<Name, 7> names{Name{"stl", Format::stl},
                                    Name{"stl-ascii", Format::stl_ascii},
                                    Name{"obj", Format::obj},
                                    Name{"off", Format::off},
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
                    "; known are stl, obj, off, ply" +
                    (io::can_read_other(".glb") ? ", and glb, gltf, 3mf, fbx, dae and others for reading" : ""));
}

MeshFile with_emptiness_noted(MeshFile file) {
  if (file.mesh.triangles.empty()) file.notes.emplace_back("the file holds no faces");
  return file;
}

std::optional<MeshFile> read_piece_by_piece(const io::File& file, Format format, std::size_t piece) {
  if (file.size() <= piece) return {};
  if (format == Format::stl || format == Format::stl_ascii) return io::read_binary_stl(file, piece);
  if (format == Format::ply || format == Format::ply_ascii || format == Format::ply_big_endian)
    return io::read_binary_ply(file, piece);
  return {};
}

MeshFile read_bytes(const io::Input& input, Format format) {
  switch (format) {
    case Format::stl:
    case Format::stl_ascii:
      return io::read_stl(input);
    case Format::obj:
      return io::read_obj(input);
    case Format::off:
      return io::read_off(input);
    case Format::ply:
    case Format::ply_ascii:
    case Format::ply_big_endian:
      return io::read_ply(input);
    case Format::other:
      return io::read_other(input);
  }
  return {};
}

/// The first item that is not as it must be, or the end. In parallel as long as all are.
template <class Item, class IsGood>
auto find_bad(std::span<const Item> items, const IsGood& is_good) {
  std::atomic<bool> all = true;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, items.size(), 1 << 14), [&](const auto& range) {
    const auto part = items.subspan(range.begin(), range.size());
    if (!std::all_of(part.begin(), part.end(), is_good)) all = false;
  });
  return all ? items.end() : std::find_if_not(items.begin(), items.end(), is_good);
}

/// What no format can hold, or no reader would take back.
void check_writable(MeshView mesh, const std::string& name) {
  const auto [vertices, triangles] = mesh;
  const auto vertex = find_bad(
      vertices, [](const Vertex& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); });
  if (vertex != vertices.end())
    throw IoError(name, {}, "cannot write: vertex " + std::to_string(vertex - vertices.begin()) + " is not finite");
  const auto is_in_range = [&](std::uint32_t v) { return v < mesh.vertices.size(); };
  const auto triangle = find_bad(
      triangles, [&](const Triangle& t) { return is_in_range(t[0]) && is_in_range(t[1]) && is_in_range(t[2]); });
  if (triangle == triangles.end()) return;
  throw IoError(name, {},
                "cannot write: triangle " + std::to_string(triangle - triangles.begin()) + " uses vertex " +
                    std::to_string(*std::find_if_not(triangle->begin(), triangle->end(), is_in_range)) + " of " +
                    std::to_string(vertices.size()));
}

std::vector<std::string> write(MeshView mesh, Format format, io::Sink& sink, const std::string& name) {
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
      throw IoError(name, {}, "cannot write this format; stl, obj, off and ply can be written");
  }
  return {};
}

}  // namespace

namespace io {

MeshFile read(const Input& input, Format format) {
  try {
    if (input.data.empty()) fail("the file is empty");
    return with_emptiness_noted(read_bytes(input, format));
  } catch (const Malformed& malformed) {
    throw input.error(malformed);
  }
}

MeshFile read(const File& file, Format format, std::size_t piece) {
  if (auto mesh = read_piece_by_piece(file, format, piece)) return with_emptiness_noted(std::move(*mesh));
  const FileBytes bytes(file);
  return read(Input{file.name(), bytes.view(), piece}, format);
}

}  // namespace io

Format format_of(const std::filesystem::path& path) {
  const std::string extension = lower(path.extension().string());
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

MeshFile read_mesh(const std::filesystem::path& path, std::optional<Format> format) {
  const Format chosen = format.value_or(format_of(path));
  // Files that are not there are told apart from formats that are not known.
  const io::File file(path);
  if (chosen != Format::other) return io::read(file, chosen);
  if (io::FileBytes(file).view().empty()) throw IoError(path.string(), {}, "the file is empty");
  if (!io::can_read_other(lower(path.extension().string()))) fail_unknown(path.string(), path.extension().string());
  return with_emptiness_noted(io::read_other(path));
}

MeshFile read_mesh(std::string_view data, Format format, std::string name) {
  const std::string extension = std::filesystem::path(name).extension().string();
  if (format == Format::other && !io::can_read_other(lower(extension))) fail_unknown(name, extension);
  return io::read({std::move(name), data}, format);
}

MeshFile read_mesh(std::span<const std::byte> data, Format format, std::string name) {
  return read_mesh(std::string_view(reinterpret_cast<const char*>(data.data()), data.size()), format, std::move(name));
}

std::vector<std::string> write_mesh(const std::filesystem::path& path, MeshView mesh, std::optional<Format> format) {
  const Format chosen = format.value_or(format_of(path));
  if (chosen == Format::other) fail_unknown(path.string(), path.extension().string());
  check_writable(mesh, path.string());
  io::FileSink sink(path);
  auto notes = write(mesh, chosen, sink, path.string());
  sink.finish();
  return notes;
}

std::vector<std::string> write_mesh(std::ostream& stream, MeshView mesh, Format format, std::string name) {
  check_writable(mesh, name);
  io::StreamSink sink(stream, name);
  auto notes = write(mesh, format, sink, name);
  sink.finish();
  return notes;
}

std::string to_string(MeshView mesh, Format format) {
  check_writable(mesh, "memory");
  io::StringSink sink;
  (void)write(mesh, format, sink, "memory");
  return sink.take();
}

}  // namespace strata
