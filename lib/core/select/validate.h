#pragma once
#include <string>
#include <vector>

#include "core/select/extract.h"
#include "core/select/rule.h"
#include "core/select/subdivide.h"

namespace strata {

/// What does not hold of the pieces of faces that are subdivided; empty: nothing.
///
/// Of all pieces: faces are listed by increasing number; corners are three points of the face's list; points represent
/// themselves; a side is marked as boundary exactly where no other piece of the face, turned alike, has it. Of a
/// sample: pieces turn as the face does, or the other way where they are turned, and lie in its plane. O(n log n).
[[nodiscard]] std::vector<std::string> validate(const InputComplex& input, const Subdivision& subdivision);

/// What does not hold of the verdicts on whole faces; empty: nothing. There is one for each face, `drop` for
/// those that are subdivided. O(n).
[[nodiscard]] std::vector<std::string> validate(const InputComplex& input, const std::vector<Verdict>& verdicts,
                                                const Subdivision& subdivision);

/// What does not hold of a boundary; empty: nothing.
///
/// Of all triangles: corners are three vertices, the source is a face. Vertices are listed by increasing number and
/// represent themselves. Of a sample: triangles have positive area and lie on their source, and vertices are distinct.
/// That the edge chain is zero is ensured in all builds, where the caller's operands can be blamed
/// (core/csg/boolean.cpp). O(n).
[[nodiscard]] std::vector<std::string> validate(const InputComplex& input, const Boundary& boundary);

}  // namespace strata
