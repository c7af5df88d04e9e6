#pragma once
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "strata/exact/failure.h"
#include "strata/mesh/mesh.h"

namespace strata {

/// What can be wrong with a mesh that is to be a solid. The one vocabulary of library, command line and reports.
enum class DefectKind {
  non_finite_coordinate,
  index_out_of_range,
  degenerate_triangle,
  duplicate_face,
  open_edge,
  inconsistent_orientation,
  self_intersection,
  inside_out,
  empty_mesh,
};

/// error: the mesh is no solid. note: it is one, and this was resolved exactly on the way in.
enum class Severity { note, error };

/// One defect: where it is (coordinates of a witness point, face numbers) and what would repair it.
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

/// The caller's data is not what was declared. Carries every defect found.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Defect> defects, std::size_t operand = 0);
  [[nodiscard]] const std::vector<Defect>& defects() const noexcept { return defects_; }
  [[nodiscard]] std::size_t operand() const noexcept { return operand_; }  ///< which operand, from 0

 private:
  std::vector<Defect> defects_;
  std::size_t operand_;
};

/// The caller's cancel token was set, or a limit was reached.
class Cancelled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace strata
