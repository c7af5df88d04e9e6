#pragma once
/// What can go wrong, and how it is reported: defects of meshes, and every exception that Strata throws of its own.
///
/// InputError: the caller's mesh is not what was declared. IoError: a file. ParseError: a text. Cancelled: the caller
/// asked to stop. LogicError: a fault of Strata itself. Besides these std::invalid_argument (arguments that mean
/// nothing), std::length_error (more than 2^32 - 2 vertices or faces), std::overflow_error (coordinates beyond all
/// doubles) are thrown where a function says so, and std::bad_alloc by any that allocates. Functions that are given
/// solids or polygons throw std::runtime_error on a thread that rounds otherwise than to nearest or takes subnormal
/// numbers for zero. A function that throws leaves its arguments as they were. Exceptions of worker threads reach the
/// caller.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "strata/mesh.h"

namespace strata {

/// What can be wrong with a mesh that is to be a solid. The one vocabulary of library, command line and reports.
enum class DefectKind {
  non_finite_coordinate,     ///< a coordinate is infinite or no number
  index_out_of_range,        ///< a triangle names a vertex that does not exist
  degenerate_triangle,       ///< its corners are collinear, exactly
  duplicate_face,            ///< two triangles have the same corners
  open_edge,                 ///< an odd number of triangles meet in an edge
  inconsistent_orientation,  ///< as many triangles as needed meet in an edge, but do not run against each other
  self_intersection,         ///< two triangles meet other than in common edges and vertices
  inside_out,                ///< winding numbers other than 0 and 1: a shell is turned round, or within another one
  empty_mesh,                ///< no triangles where some are expected
};

/// error: the mesh is no solid. note: it is one, and this was resolved exactly on the way in.
enum class Severity { note, error };

/// How many defects of one kind are listed where nothing else is said; the others are counted.
inline constexpr std::size_t few_defects = 5;

/// One kind of defect: where it is (coordinates of a witness point, face numbers) and what would repair it.
struct Defect {
  DefectKind kind = DefectKind::empty_mesh;
  Severity severity = Severity::error;
  std::optional<Vertex> where;       ///< a point at the defect, in model units
  std::vector<std::uint32_t> faces;  ///< indices of the triangles concerned, from 0
  std::uint64_t count = 1;           ///< how many of this kind there are; only the first few are listed
  std::string message;               ///< one sentence
  std::string remedy;                ///< one sentence
};

[[nodiscard]] std::string_view name(DefectKind kind);      ///< "open edge"
[[nodiscard]] std::string_view name(Severity severity);    ///< "error"
[[nodiscard]] std::string describe(const Defect& defect);  ///< kind, message, coordinates, faces and remedy in one line

/// The caller's data is not what was declared. Carries every defect found. what() describes the first ones.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Defect> defects, std::size_t operand = 0);
  [[nodiscard]] const std::vector<Defect>& defects() const noexcept { return defects_; }
  [[nodiscard]] std::size_t operand() const noexcept { return operand_; }  ///< which operand, from 0

 private:
  std::vector<Defect> defects_;
  std::size_t operand_;
};

/// The caller's CancelToken was set while an operation ran. There is no result.
class Cancelled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An invariant of the library does not hold: a fault of Strata, or an operand that was declared to be what it is not
/// where this is not checked (`Solid::trusted`).
class LogicError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// A file that cannot be read or written, or does not hold what its format demands. what() is one sentence; what its
/// reason quotes has no control characters: "part.obj:12: expected a number for y, found 'abc'".
class IoError : public std::runtime_error {
 public:
  /// Where in the file: a line (text, from 1) or a byte (binary, from 0).
  struct Place {
    std::optional<std::uint64_t> line;
    std::optional<std::uint64_t> byte;
  };

  IoError(std::string path, Place place, std::string reason);

  [[nodiscard]] const std::string& path() const noexcept { return path_; }  ///< or the name given for a stream
  [[nodiscard]] std::optional<std::uint64_t> line() const noexcept { return place_.line; }
  [[nodiscard]] std::optional<std::uint64_t> byte() const noexcept { return place_.byte; }
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }  ///< what was expected, what was found

 private:
  std::string path_;
  Place place_;
  std::string reason_;
};

/// An error in a text that is no file, such as an expression. what() names the column.
class ParseError : public std::runtime_error {
 public:
  ParseError(const std::string& what, std::size_t position);
  [[nodiscard]] std::size_t position() const noexcept { return position_; }  ///< of the error: in bytes, from 0

 private:
  std::size_t position_;
};

}  // namespace strata
