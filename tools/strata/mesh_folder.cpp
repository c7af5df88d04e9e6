#include "mesh_folder.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "files.h"
#include "rounded_output.h"

void MeshFolder::check(const Settings& settings) {
  if (settings.output == "-") throw UsageError("several meshes cannot go to standard output; -o names a folder");
  if (!settings.output_format.empty()) (void)output_format(settings);
  std::error_code unknown;
  const std::filesystem::path folder = settings.output;
  if (!std::filesystem::exists(folder, unknown)) return;
  if (!std::filesystem::is_directory(folder, unknown))
    throw UsageError(fmt::format("{} is a file; -o names a folder for the meshes here", settings.output));
  if (!std::filesystem::is_empty(folder, unknown))
    throw UsageError(fmt::format("the folder {} is not empty: meshes of different runs would mix", settings.output));
}

MeshFolder::MeshFolder(const Settings& settings, std::string stem, std::size_t count)
    : settings_(settings),
      folder_(settings.output),
      stem_(std::move(stem)),
      extension_(settings.output_format.empty() ? "xoff" : settings.output_format),
      digits_(fmt::format("{}", count).size()) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw strata::IoError(settings.output, {}, fmt::format("cannot make the folder: {}", error.message()));
}

std::string MeshFolder::write(std::size_t number, const strata::ExactMesh& mesh, const strata::Attributes& attributes,
                              MeshContent content) const {
  std::string name = fmt::format("{}-{:0{}}.{}", stem_, number, digits_, extension_);
  Settings of_mesh = settings_;
  of_mesh.output = path(name);
  of_mesh.output_format.clear();
  of_mesh.tells_losses = number == 0;
  const strata::Format format = output_format(of_mesh);
  if (content == MeshContent::solid) {
    write_solid(of_mesh, format, mesh, attributes);
  } else {
    write_output(of_mesh, format, mesh, attributes);
  }
  return name;
}
