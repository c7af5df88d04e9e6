#pragma once
#include <cstdint>
#include <vector>

#include "oracle/nef_cells.h"
#include "strata/mesh.h"

namespace strata::oracle {

/// Two to four small surfaces, open and closed, that love to touch: corners are integers, seldom halves, and often
/// those of the surfaces before; in every fifth scene some are boxes around the others. The same seed gives the same
/// scene on every machine.
struct RandomScene {
  explicit RandomScene(std::uint64_t seed);

  /// One mesh per surface; a surface may be two parts, which may cross. Triangles of every polygon, as a fan.
  [[nodiscard]] std::vector<Mesh> meshes() const;

  std::vector<PolygonSurface> parts;
  std::vector<std::size_t> first_part;  ///< per surface, and the count of parts
};

}  // namespace strata::oracle
