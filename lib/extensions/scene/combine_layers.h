#pragma once
#include "extensions/scene/layer_decomposition.h"
#include "strata/options.h"

namespace strata {

/// Combines two decompositions about a common origin, each of one solid: faces that meet are split along each other,
/// each piece is judged by the winding numbers that the two coverings give about the origin, and what stays is put in
/// layers again. The result's boundary is its scene's solid 0; as a point set it does not depend on the origin. Throws
/// std::invalid_argument (different origins, not one solid each), Cancelled.
[[nodiscard]] LayerDecomposition combine(const LayerDecomposition& a, const LayerDecomposition& b, Operation operation,
                                         const Options& options = {});

}  // namespace strata
