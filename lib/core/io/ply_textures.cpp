#include "core/io/ply_textures.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/io/folder_of_model.h"
#include "core/io/images.h"

namespace strata::io {
namespace {

constexpr std::string_view texture_numbers = "texnumber";

/// A material for each texture, and the images that there are. Returns false, and adds no materials, if there are none.
bool add_materials(MeshFile& file, const std::vector<std::string>& names, const std::filesystem::path* folder) {
  std::vector<std::filesystem::path> paths;
  std::vector<Material> materials(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    materials[i].name = std::filesystem::path(names[i]).stem().string();
    const auto path = file_beneath(folder, names[i]);
    if (!path) {
      file.notes.push_back(note_of_missing_image(names[i]));
      continue;
    }
    const auto known = std::find(paths.begin(), paths.end(), *path);
    materials[i].image = static_cast<std::uint32_t>(known - paths.begin());
    if (known != paths.end()) continue;
    paths.push_back(*path);
    file.attributes.images.push_back(read_image(*path));
  }
  if (!paths.empty()) file.attributes.materials = std::move(materials);
  return !paths.empty();
}

/// -1 for numbers that no texture has.
std::vector<std::int32_t> take_texture_numbers(MeshFile& file, std::size_t count) {
  auto& channels = file.attributes.channels;
  const auto numbers =
      std::find_if(channels.begin(), channels.end(), [](const Channel& c) { return c.name == texture_numbers; });
  auto* const values = numbers == channels.end() || numbers->element != Element::face || numbers->components != 1
                           ? nullptr
                           : std::get_if<std::vector<std::int32_t>>(&numbers->values);
  if (values == nullptr) return std::vector<std::int32_t>(file.mesh.triangles.size());
  std::vector<std::int32_t> materials = std::move(*values);
  channels.erase(numbers);
  for (std::int32_t& m : materials)
    if (m < 0 || static_cast<std::size_t>(m) >= count) m = -1;
  return materials;
}

}  // namespace

void add_textures(MeshFile& file, const std::vector<std::string>& names, const std::filesystem::path* folder) {
  if (names.empty() || folder == nullptr) return;
  if (file.attributes.find(channel_names::material) != nullptr) {
    file.notes.emplace_back("textures left out: the file has a channel 'material' of its own");
    return;
  }
  if (!add_materials(file, names, folder)) return;
  file.attributes.channels.push_back({std::string(channel_names::material), Element::face, Interpolation::nearest, 1,
                                      take_texture_numbers(file, names.size())});
}

}  // namespace strata::io
