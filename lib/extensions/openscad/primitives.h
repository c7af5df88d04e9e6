#pragma once
#include <map>
#include <optional>
#include <vector>

#include "extensions/openscad/report.h"
#include "extensions/openscad/syntax.h"
#include "strata/solid.h"

namespace strata::openscad {

/// The largest number of corners of a sphere or cylinder.
inline constexpr std::size_t most_corners = 10'000'000;

/// Constructs cubes, spheres and cylinders as OpenSCAD does. Equal ones share one solid. Nullopt and a note for one
/// that has no volume or is not finite. Throws CsgError for arguments of wrong kinds, and for circles that are too fine
/// or too small.
class Primitives {
 public:
  explicit Primitives(Report& report) : report_(report) {}

  std::optional<Solid> cube(const SyntaxNode& node);
  std::optional<Solid> sphere(const SyntaxNode& node);
  std::optional<Solid> cylinder(const SyntaxNode& node);

 private:
  std::optional<Solid> nothing(const SyntaxNode& node, const char* because);
  void require_corners(const SyntaxNode& node, std::size_t sides, std::size_t rings) const;
  template <class Make>
  Solid shared(std::vector<double> key, const Make& make);

  Report& report_;
  std::map<std::vector<double>, Solid> solids_;  ///< by their parameters; the first number is the kind
};

}  // namespace strata::openscad
