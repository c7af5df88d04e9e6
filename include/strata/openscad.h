#pragma once
/// Models in the `.csg` format that OpenSCAD writes: solids as expressions, shapes in the plane as regions.
///
/// All functions may be called from many threads at once.
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "strata/expression.h"
#include "strata/file_path.h"
#include "strata/options.h"
#include "strata/planar.h"
#include "strata/transform.h"

namespace strata {

/// How models are read.
struct CsgOptions {
  Placement placement = Placement::exact;  ///< of what `multmatrix` and `resize` move
  /// The folder that files which a model names are looked for in; empty: no files are read. `read_csg_file` takes that
  /// of the model where this is empty.
  std::string folder;
  bool any_path = false;           ///< files may also be elsewhere than in the folder or beneath it
  std::vector<std::string> fonts;  ///< files of fonts that texts may name, besides those of the system
  Options evaluation;              ///< `threads`, `progress` and `cancel`, for what is evaluated when reading
};

/// A node that was evaluated when reading: one that is no Boolean operation of solids.
struct CsgNode {
  std::string name;
  std::size_t line = 0;
  double seconds = 0;
};

/// A model, and what was decided when reading it.
struct CsgModel {
  Expression expression;                ///< primitives are called after their kinds and lines: `cube_12`
  std::vector<std::string> notes;       ///< one sentence each: what was ignored, left out or taken as empty
  std::optional<planar::Region> shape;  ///< of a model in the plane; the expression is then the empty set
  std::vector<CsgNode> nodes;           ///< in the order of the file; of equal ones the first
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

/// Reads the flattened form that OpenSCAD writes with `openscad -o part.csg part.scad`. Numbers are the doubles nearest
/// to the decimals; primitives have the vertices that OpenSCAD gives them, in doubles, and so have arcs of offsets and
/// turned copies of extrusions. From there on everything is exact, unless the placement is Placement::rounded, which
/// rounds transformed coordinates. Boolean operations of solids become the expression; all other nodes (shapes in the
/// plane, extrusions, hulls, Minkowski sums, projections) are evaluated at once, equal ones once, independent ones in
/// parallel. Nodes that are not supported are errors where they contribute to the model; parts marked % or * do not,
/// and if one is marked ! only that one does. What every node means: lib/extensions/openscad/semantics.md. `name`
/// stands for the file in messages. Throws CsgError for the first error in the file, errors of syntax before others;
/// Cancelled. O(size of the text), and what the nodes take. Nothing is recursive. The same result for any number of
/// threads. Source: OpenSCAD User Manual.
[[nodiscard]] CsgModel read_csg(std::string_view text, std::string name, const CsgOptions& options);
[[nodiscard]] CsgModel read_csg(std::string_view text, std::string name, Placement placement = Placement::exact);

/// The same for a file. Throws IoError, too, when it cannot be read.
[[nodiscard]] CsgModel read_csg_file(const FilePath& path, const CsgOptions& options);
[[nodiscard]] CsgModel read_csg_file(const FilePath& path, Placement placement = Placement::exact);

/// A region as a drawing in DXF (AC1009, closed polylines): outer loops counter-clockwise, holes clockwise, coordinates
/// as the nearest doubles.
[[nodiscard]] std::string to_dxf(const planar::Region& region);

}  // namespace strata
