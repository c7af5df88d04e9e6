#pragma once
#include "extensions/scene/origin.h"
#include "extensions/scene/scene.h"

namespace strata {

/// A point from which the scene is likely to have few layers and few cuts, and that lies on no plane of a face, which
/// is checked exactly: no face is flat. The same for any number of threads.
///
/// A few places inside and outside are judged by how many faces stand one behind the other on some rays to faces, all
/// in doubles and among some of the faces. The best one then moves by small exact steps until it is on no plane. For an
/// empty scene it is (0, 0, 0). O(vertices + faces), a small part of what a decomposition costs. Throws
/// std::invalid_argument where no step is on no plane, which takes planes that fill the range of doubles.
[[nodiscard]] Origin choose_origin(const Scene& scene);

}  // namespace strata
