#include <utility>

#include "core/io/file.h"
#include "extensions/openscad/model.h"
#include "extensions/openscad/syntax.h"
#include "strata/openscad.h"

namespace strata {

CsgModel read_csg(std::string_view text, std::string name, Placement placement) {
  openscad::Report report(std::move(name));
  const auto nodes = openscad::parse(text, report);
  Expression expression = openscad::model_of(nodes, placement, report);
  return {std::move(expression), report.notes()};
}

CsgModel read_csg_file(const FilePath& path, Placement placement) {
  const io::File file(path.text());
  const io::FileBytes bytes(file);
  return read_csg(bytes.view(), file.name(), placement);
}

}  // namespace strata
