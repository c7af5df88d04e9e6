#include "region_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include "files.h"
#include "rounded_output.h"

namespace {

bool has_groups(strata::Format format) {
  using strata::Format;
  constexpr std::array formats{Format::obj, Format::ply,       Format::ply_ascii, Format::ply_big_endian,
                               Format::vtk, Format::vtk_ascii, Format::msh};
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

}  // namespace

bool RegionFile::is_named(const Settings& settings) {
  std::error_code unknown;
  if (!strata::can_write(strata::format_of(settings.output)) || std::filesystem::is_directory(settings.output, unknown))
    return false;
  if (!has_groups(output_format(settings)))
    throw UsageError(settings.output +
                     ": the format has no groups to keep several meshes apart; -o names a folder here, or a file .obj, "
                     ".ply, .vtk or .msh");
  return true;
}

RegionFile::RegionFile(const Settings& settings) : settings_(settings), format_(output_format(settings)) {}

void RegionFile::add(const strata::ExactMesh& mesh, std::string name, MeshContent content) {
  RoundedOutput rounded;
  if (content == MeshContent::solid) rounded = rounded_output(mesh, {}, format_, settings_);
  const strata::ExactMesh& written = rounded.mesh ? *rounded.mesh : mesh;
  const auto group = static_cast<std::int32_t>(names_.size());
  for (const strata::Triangle& t : written.mesh.triangles) {
    all_.mesh.triangles.push_back({vertex(written, t[0]), vertex(written, t[1]), vertex(written, t[2])});
    group_.push_back(group);
  }
  if (rounded.strays) print_strays(*rounded.strays);
  names_.push_back(std::move(name));
}

std::uint32_t RegionFile::vertex(const strata::ExactMesh& mesh, std::uint32_t v) {
  const strata::RationalPoint position = mesh.position(v);
  const auto number = static_cast<std::uint32_t>(all_.mesh.vertices.size());
  const auto [place, is_new] = numbers_.try_emplace(position, number);
  if (!is_new) return place->second;
  const strata::Vertex& at = mesh.mesh.vertices[v];
  all_.mesh.vertices.push_back(at);
  for (std::size_t i = 0; i < 3; ++i)
    if (strata::to_rational(at[i]) != position[i]) {
      all_.exact.push_back({number, position});
      break;
    }
  return number;
}

void RegionFile::write() {
  strata::Attributes attributes;
  attributes.groups = names_;
  attributes.channels.push_back(
      {std::string(strata::channel_names::group), strata::Element::face, strata::Interpolation::nearest, 1, group_});
  write_output(settings_, format_, all_, attributes);
}
