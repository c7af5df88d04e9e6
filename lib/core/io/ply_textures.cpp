#include "core/io/ply_textures.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/io/folder_of_model.h"
#include "core/io/images.h"
#include "core/io/object_faces.h"

namespace strata::io {
namespace {

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
      std::find_if(channels.begin(), channels.end(), [](const Channel& c) { return c.name == ply_texture_numbers; });
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

PlyTextures::PlyTextures(const Attributes& attributes, FilesBeside* beside) : attributes_(attributes), beside_(beside) {
  const std::span<const std::int32_t> material_of = indices_of(attributes, channel_names::material);
  if (beside == nullptr || material_of.empty() || attributes.find(channel_names::texcoord) == nullptr ||
      attributes.find(ply_texture_numbers) != nullptr)
    return;
  std::vector<std::int32_t> texture_of;  // per material
  for (const Material& m : attributes.materials) {
    texture_of.push_back(m.image ? static_cast<std::int32_t>(images_.size()) : -1);
    if (m.image) images_.push_back(*m.image);
  }
  std::vector<std::int32_t> numbers;
  for (const std::int32_t m : material_of) numbers.push_back(m < 0 ? -1 : texture_of[static_cast<std::size_t>(m)]);
  numbers_ = {std::string(ply_texture_numbers), Element::face, Interpolation::nearest, 1, std::move(numbers)};
}

std::string PlyTextures::write() const {
  if (empty()) return {};
  const std::vector<std::string> names = write_beside(attributes_.images, *beside_);
  std::string lines;
  for (const std::uint32_t image : images_) lines += "comment TextureFile " + names[image] + "\n";
  return lines;
}

void PlyTextures::note(std::vector<std::string>& notes) const {
  if (images_.size() < attributes_.materials.size())
    notes.emplace_back("materials without textures left out: PLY cannot keep them");
  const auto is_more_than_an_image = [](const Material& m) {
    Material plain;
    plain.image = m.image;
    return m.image && m != plain;
  };
  if (std::ranges::any_of(attributes_.materials, is_more_than_an_image))
    notes.emplace_back("names and looks of materials with textures left out: PLY cannot keep them");
}

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
