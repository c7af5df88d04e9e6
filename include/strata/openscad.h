#pragma once
/// Models in the `.csg` format that OpenSCAD writes, as expressions.
///
/// All functions may be called from many threads at once.
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "strata/expression.h"
#include "strata/file_path.h"

namespace strata {

/// A model: the solid as an expression over its primitives, and what was decided when reading it.
struct CsgModel {
  Expression expression;           ///< primitives are called after their kinds and lines: `cube_12`
  std::vector<std::string> notes;  ///< one sentence each: what was ignored, left out or taken as empty
};

/// A text that is no .csg file, or uses what is not supported. what() is "part.csg:12:5: hull is not supported, ...".
class CsgError : public std::runtime_error {
 public:
  CsgError(std::string file, std::size_t line, std::size_t column, std::string reason);

  [[nodiscard]] const std::string& file() const noexcept { return file_; }  ///< the name that was given
  [[nodiscard]] std::size_t line() const noexcept { return line_; }         ///< from 1
  [[nodiscard]] std::size_t column() const noexcept { return column_; }     ///< in bytes, from 1
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }

 private:
  std::string file_;
  std::size_t line_, column_;
  std::string reason_;
};

/// Reads the flattened form that OpenSCAD writes with `openscad -o part.csg part.scad`: cube, sphere, cylinder and
/// polyhedron under multmatrix, union, difference, intersection and group; colours and `render` are ignored. Numbers
/// are the doubles nearest to the decimals; primitives have the vertices that OpenSCAD gives them, in doubles; from
/// there on everything is exact, unless `placement` is Placement::rounded, which rounds transformed coordinates. Other
/// nodes (hull, minkowski, extrusions, imports, two-dimensional ones) are errors where they contribute to the model;
/// parts marked % or * do not, and if one is marked ! only that one does. Which nodes are empty sets:
/// lib/extensions/openscad/semantics.md. `name` stands for the file in messages. Throws CsgError for the first error in
/// the file, errors of syntax before others. O(size of the text), plus O(n log n) for the primitives, of which equal
/// ones are made once. Source: OpenSCAD User Manual.
[[nodiscard]] CsgModel read_csg(std::string_view text, std::string name, Placement placement = Placement::exact);

/// The same for a file. Throws IoError, too, when it cannot be read.
[[nodiscard]] CsgModel read_csg_file(const FilePath& path, Placement placement = Placement::exact);

}  // namespace strata
