// The mesh readers. STRATA_FUZZ_FORMAT is a member of strata::Format.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/io/readers.h"
#include "fuzz.h"
#include "io_error_law.h"
#include "strata/carry_attributes.h"

namespace strata::fuzz {
namespace {

constexpr Format tested = Format::STRATA_FUZZ_FORMAT;
constexpr const char* file_name = "fuzz";

using Bits = std::array<std::uint64_t, 3>;

/// Tells -0 from 0.
Bits bits_of(const Vertex& v) {
  return {std::bit_cast<std::uint64_t>(v[0]), std::bit_cast<std::uint64_t>(v[1]), std::bit_cast<std::uint64_t>(v[2])};
}

std::vector<Bits> bits_of(const std::vector<Vertex>& vertices) {
  std::vector<Bits> bits;
  for (const Vertex& v : vertices) bits.push_back(bits_of(v));
  return bits;
}

bool same(const std::vector<ExactVertex>& a, const std::vector<ExactVertex>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].vertex != b[i].vertex || a[i].position != b[i].position) return false;
  return true;
}

bool same(const Mesh& a, const Mesh& b) {
  return a.triangles == b.triangles && bits_of(a.vertices) == bits_of(b.vertices);
}

/// NaN is NaN.
bool same(const Channel& a, const Channel& b) {
  if (a.name != b.name || a.element != b.element || a.interpolation != b.interpolation ||
      a.components != b.components || a.values.index() != b.values.index())
    return false;
  return std::visit(
      [&](const auto& values) {
        const auto& others = std::get<std::decay_t<decltype(values)>>(b.values);
        return std::equal(values.begin(), values.end(), others.begin(), others.end(),
                          [](auto x, auto y) { return x == y || (x != x && y != y); });
      },
      a.values);
}

bool same(const Attributes& a, const Attributes& b) {
  return std::equal(a.channels.begin(), a.channels.end(), b.channels.begin(), b.channels.end(),
                    [](const Channel& x, const Channel& y) { return same(x, y); }) &&
         a.materials == b.materials && a.images == b.images && a.objects == b.objects && a.groups == b.groups;
}

/// Polygons that come to a vertex again may leave such triangles; as faces of their own they are left out.
bool has_equal_corners(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

void check_exact(const MeshFile& file) {
  for (std::size_t i = 0; i < file.exact.size(); ++i) {
    const ExactVertex& e = file.exact[i];
    require(i == 0 || file.exact[i - 1].vertex < e.vertex, "exact vertices are in order");
    require(e.vertex < file.mesh.vertices.size(), "exact vertices are vertices");
    const Vertex& rounded = file.mesh.vertices[e.vertex];
    bool differs = false;
    for (std::size_t k = 0; k < 3; ++k) {
      require(to_nearest_double(e.position[k]) == rounded[k], "the mesh has the nearest doubles");
      differs |= to_rational(rounded[k]) != e.position[k];
    }
    require(differs, "exact vertices are no doubles");
  }
}

/// The law of MeshFile.
void check(const MeshFile& file) {
  for (const Vertex& v : file.mesh.vertices)
    require(std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]), "coordinates are finite");
  for (const Triangle& t : file.mesh.triangles)
    for (const std::uint32_t v : t) require(v < file.mesh.vertices.size(), "indices are in range");
  const auto& polygons = file.polygon_of_triangle;
  require(polygons.empty() || polygons.size() == file.mesh.triangles.size(), "every triangle has a face, or none has");
  for (std::size_t i = 1; i < polygons.size(); ++i)
    require(polygons[i - 1] <= polygons[i], "triangles are in the order of the faces");
  for (const std::string& note : file.notes) require(!note.empty(), "notes say something");
  check_exact(file);
  check_attributes(file.attributes, file.mesh.vertices.size(), file.mesh.triangles.size());
}

struct Outcome {
  std::optional<MeshFile> file;
  std::string error;
};

Outcome read(std::string_view text, std::size_t piece) {
  try {
    return {io::read({file_name, text, piece}, tested), {}};
  } catch (const IoError& error) {
    check_error(error, file_name);
    return {std::nullopt, error.what()};
  }
}

bool same(const Outcome& a, const Outcome& b) {
  if (a.error != b.error || a.file.has_value() != b.file.has_value()) return false;
  return !a.file ||
         (same(a.file->mesh, b.file->mesh) && same(a.file->exact, b.file->exact) && a.file->notes == b.file->notes &&
          a.file->polygon_of_triangle == b.file->polygon_of_triangle && same(a.file->attributes, b.file->attributes));
}

/// The corners of all triangles: what STL keeps.
std::vector<Bits> corners(const Mesh& mesh) {
  std::vector<Bits> all;
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) all.push_back(bits_of(mesh.vertices[v]));
  return all;
}

bool are_floats(const Mesh& mesh) {
  for (const Vertex& v : mesh.vertices)
    for (const double x : v)
      if (std::abs(x) > 3e38 || static_cast<double>(static_cast<float>(x)) != x) return false;
  return true;
}

/// Requires that no triangle has equal corners.
void check_written(const MeshFile& file, Format format) {
  const std::string text = to_string(ExactMesh{file.mesh, file.exact}, format);
  const MeshFile again = read_mesh(std::string_view(text), format, "written");
  if (format == Format::stl || format == Format::stl_ascii) {
    require(corners(again.mesh) == corners(file.mesh), "STL keeps the corners");
    return;
  }
  require(same(again.mesh, file.mesh), "what is written reads back the same");
  require(format != Format::xoff || same(again.exact, file.exact), "exact vertices read back the same");
}

/// What is read of a scene is written as one, with what it carries, and read again.
void check_scene(const MeshFile& file) {
  WriteOptions options;
  options.format = tested == Format::amf ? Format::threemf : tested;
  options.attributes = &file.attributes;
  if (holds_floats(tested) && !are_floats(file.mesh)) return;
  const std::string text = to_string(ExactMesh{file.mesh, {}}, options);
  const MeshFile again = read_mesh(std::string_view(text), *options.format, "written");
  require(again.mesh.triangles.size() <= file.mesh.triangles.size(), "no triangles are added");
  if (tested == Format::threemf)
    require(again.mesh.triangles.size() == file.mesh.triangles.size(), "3MF keeps all triangles");
}

bool has_line(const Channel& c) {
  return std::none_of(c.name.begin(), c.name.end(), [](char x) { return static_cast<unsigned char>(x) < ' '; });
}

/// Channels that PLY and OFF read, they also keep, but those whose names are no line.
void check_channels(const MeshFile& file, Format format) {
  WriteOptions options;
  options.format = format;
  options.attributes = &file.attributes;
  const std::string text = to_string(ExactMesh{file.mesh, {}}, options);
  const MeshFile again = read_mesh(std::string_view(text), format, "written");
  require(same(again.mesh, file.mesh), "channels do not change the mesh");
  if (file.mesh.vertices.empty() || file.mesh.triangles.empty()) return;
  for (const Channel& c : file.attributes.channels) {
    const Channel* const other = again.attributes.find(c.name);
    require(!has_line(c) || (other != nullptr && same(c, *other)), "channels read back the same");
  }
}

void check_round_trip(MeshFile file) {
  if (std::none_of(file.mesh.triangles.begin(), file.mesh.triangles.end(), has_equal_corners)) {
    if (tested == Format::ply)
      for (const Format format : {Format::ply, Format::ply_ascii}) check_channels(file, format);
    if (tested == Format::off) check_channels(file, tested);
  }
  if (tested == Format::threemf || tested == Format::amf || holds_floats(tested)) {
    if (tested != Format::stl) return check_scene(file);
  }
  std::erase_if(file.mesh.triangles, has_equal_corners);
  if (tested == Format::stl) {
    check_written(file, Format::stl_ascii);
    if (are_floats(file.mesh)) check_written(file, Format::stl);
  } else if (tested == Format::ply) {
    check_written(file, Format::ply_ascii);
    check_written(file, Format::ply_big_endian);
  } else {
    check_written(file, tested);
  }
}

void check_reading(std::string_view text) {
  constexpr std::size_t few = 4096;
  Outcome whole = read(text, std::string_view::npos);
  require(same(whole, read(text, text.size() < few ? 5 : text.size() / 16)), "reading in pieces is reading");
  if (!whole.file) return;
  check(*whole.file);
  check_round_trip(std::move(*whole.file));
}

}  // namespace
}  // namespace strata::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return strata::fuzz::run(data, size, strata::fuzz::check_reading);
}
