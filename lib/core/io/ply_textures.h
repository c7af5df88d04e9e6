#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/files_beside.h"
#include "strata/io.h"

namespace strata::io {

/// The channel of faces that tells which texture each has, from 0.
inline constexpr std::string_view ply_texture_numbers = "texnumber";

/// Gives a file a material for each of its textures, whose images are looked for beneath the folder; null: none are.
/// The channel "texnumber" of faces tells which one a face has and becomes "material"; without it all faces have the
/// first. Notes images that there are not; without any the file remains as it is.
void add_textures(MeshFile& file, const std::vector<std::string>& names, const std::filesystem::path* folder);

/// The textures of a mesh as PLY files have them: materials with images, each a comment in the header. Materials
/// without images, and looks and names of materials, are not kept.
class PlyTextures {
 public:
  /// None, unless there is a channel of texture coordinates, faces have materials with images, and the images can stand
  /// beside the file.
  PlyTextures(const Attributes& attributes, FilesBeside* beside);

  [[nodiscard]] bool empty() const { return images_.empty(); }
  /// Takes the place of the channel "material".
  [[nodiscard]] const Channel& numbers() const { return numbers_; }
  /// Writes the images, and returns the lines of the header.
  [[nodiscard]] std::string write() const;
  /// What of the materials is lost.
  void note(std::vector<std::string>& notes) const;

 private:
  const Attributes& attributes_;
  FilesBeside* beside_;
  std::vector<std::uint32_t> images_;  ///< per texture
  Channel numbers_;
};

}  // namespace strata::io
