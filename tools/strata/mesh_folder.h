#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

#include "region_file.h"
#include "settings.h"
#include "strata/mesh.h"

/// The folder that -o names, for several meshes of one kind: `piece-00.xoff`, `piece-01.xoff`, ..., in the format that
/// --format names, or XOFF, which keeps rationals.
class MeshFolder {
 public:
  /// Throws UsageError where -o names an existing file or a folder that is not empty: meshes of different runs would
  /// mix.
  static void check(const Settings& settings);

  /// Makes the folder. `count` meshes will be written. Throws strata::IoError.
  MeshFolder(const Settings& settings, std::string stem, std::size_t count);

  /// Writes one mesh, whole or not at all; returns the name of its file. What the format cannot keep of attributes is
  /// told of the first one. Throws strata::IoError.
  [[nodiscard]] std::string write(std::size_t number, const strata::ExactMesh& mesh,
                                  const strata::Attributes& attributes, MeshContent content) const;
  /// A file in the folder.
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  const Settings& settings_;
  std::filesystem::path folder_;
  std::string stem_, extension_;
  std::size_t digits_;
};
