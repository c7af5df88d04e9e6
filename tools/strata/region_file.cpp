#include "region_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include "common/tell.h"
#include "files.h"
#include "rounded_output.h"
#include "strata/carry_attributes.h"

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

void RegionFile::add(const strata::ExactMesh& mesh, const strata::Attributes& attributes, std::string name,
                     MeshContent content) {
  RoundedOutput rounded{.attributes = attributes, .mesh = {}, .report = {}, .strays = {}};
  if (content == MeshContent::solid) rounded = rounded_output(mesh, attributes, format_, settings_);
  Part part{rounded.mesh ? std::move(*rounded.mesh) : mesh, std::move(rounded.attributes)};
  const auto group = static_cast<std::int32_t>(names_.size());
  for (const strata::Triangle& t : part.mesh.mesh.triangles) {
    sources_.push_back(
        {static_cast<std::uint32_t>(parts_.size()), static_cast<std::uint32_t>(sources_.size() - first_face_of_part_)});
    all_.mesh.triangles.push_back({vertex(part.mesh, t[0]), vertex(part.mesh, t[1]), vertex(part.mesh, t[2])});
    group_.push_back(group);
  }
  first_face_of_part_ = sources_.size();
  if (rounded.strays) print_strays(*rounded.strays);
  names_.push_back(std::move(name));
  parts_.push_back(std::move(part));
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

/// What all parts carry, but for groups.
strata::Attributes RegionFile::carried() const {
  std::vector<strata::AttributedMesh> operands;
  bool is_empty = true;
  for (const Part& part : parts_) {
    operands.push_back({part.mesh, &part.attributes});
    is_empty = is_empty && part.attributes.empty();
  }
  if (is_empty) return {};
  strata::Attributes attributes = strata::carry_attributes(operands, all_, sources_);
  const std::size_t count = attributes.channels.size();
  std::erase_if(attributes.channels, [](const strata::Channel& c) { return c.name == strata::channel_names::group; });
  if (attributes.channels.size() < count && !settings_.quiet)
    tell("strata: {}: note: groups of operands left out: the meshes are groups here\n", settings_.output);
  return attributes;
}

void RegionFile::write() {
  strata::Attributes attributes = carried();
  attributes.groups = names_;
  attributes.channels.push_back(
      {std::string(strata::channel_names::group), strata::Element::face, strata::Interpolation::nearest, 1, group_});
  write_output(settings_, format_, all_, attributes);
}
