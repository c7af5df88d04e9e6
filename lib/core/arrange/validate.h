#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/arrange/triangulation.h"

namespace strata {

/// What a triangulation is made of.
struct TriangulationParts {
  const FacePoints& points;
  std::span<const Triangulation::Triangle> triangles;
  std::span<const Triangulation::Note> notes;
};

/// What does not hold of the triangulation of a face along its constraints, numbered as in the list; empty: nothing.
///
/// Triangles turn left; neighbours share a side; sides without a neighbour lie on the edges of the face and run once
/// around it (so the triangles cover the face once); the sides that carry a constraint lead from its tail to its head,
/// in line. Exact; O(n log n) for n triangles and notes.
[[nodiscard]] std::vector<std::string> validate(const TriangulationParts& triangulation,
                                                std::span<const Constraint> constraints);
[[nodiscard]] inline std::vector<std::string> validate(const Triangulation& t,
                                                       std::span<const Constraint> constraints) {
  return validate(TriangulationParts{t.points(), t.triangles(), t.notes()}, constraints);
}

}  // namespace strata
