#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "strata/io.h"

namespace strata::io {

/// Gives a file a material for each of its textures, whose images are looked for beneath the folder; null: none are.
/// The channel "texnumber" of faces tells which one a face has and becomes "material"; without it all faces have the
/// first. Notes images that there are not; without any the file remains as it is.
void add_textures(MeshFile& file, const std::vector<std::string>& names, const std::filesystem::path* folder);

}  // namespace strata::io
