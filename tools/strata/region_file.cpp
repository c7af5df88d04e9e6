#include "region_file.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "files.h"
#include "rounded_output.h"
#include "strata/io.h"

bool RegionFile::is_named(const Settings& settings) {
  std::error_code unknown;
  return strata::can_write(strata::format_of(settings.output)) &&
         !std::filesystem::is_directory(settings.output, unknown);
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
