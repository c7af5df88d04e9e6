#include <filesystem>
#include <utility>

#include "core/io/file.h"
#include "extensions/openscad/model.h"
#include "extensions/openscad/syntax.h"
#include "strata/openscad.h"

namespace strata {

CsgModel read_csg(std::string_view text, std::string name, const CsgOptions& options) {
  openscad::Report report(std::move(name));
  const auto nodes = openscad::parse(text, report);
  CsgModel model = openscad::model_of(nodes, options, report);
  model.notes = report.notes();
  return model;
}

CsgModel read_csg(std::string_view text, std::string name, Placement placement) {
  CsgOptions options;
  options.placement = placement;
  return read_csg(text, std::move(name), options);
}

CsgModel read_csg_file(const FilePath& path, const CsgOptions& options) {
  const io::File file(path.text());
  const io::FileBytes bytes(file);
  CsgOptions own = options;
  if (own.folder.empty()) {
    own.folder = std::filesystem::path(path.text()).parent_path().string();
    if (own.folder.empty()) own.folder = ".";
  }
  return read_csg(bytes.view(), file.name(), own);
}

CsgModel read_csg_file(const FilePath& path, Placement placement) {
  CsgOptions options;
  options.placement = placement;
  return read_csg_file(path, options);
}

}  // namespace strata
