#pragma once
#include <vector>

#include "core/kernel/input_complex.h"
#include "core/select/classifier.h"
#include "core/select/subdivide.h"
#include "strata/options.h"

namespace strata {

/// Labels the faces that meet no other: such a face lies on one side of every other operand, so any point of it
/// decides. One verdict per face; `drop` for the faces that are subdivided. Faces in regions without other surfaces
/// take the winding numbers of their region, if the oracle has cells. O(n) in streaming passes, in parallel. Throws
/// Cancelled.
[[nodiscard]] std::vector<Verdict> label(const InputComplex& input, const Subdivision& subdivision,
                                         const Classifier& classifier, const Monitor& monitor);

/// The same for one face.
[[nodiscard]] Verdict label(const InputComplex& input, std::uint32_t face, const Classifier& classifier);

/// The same for one operand that crosses itself, by the winding numbers of its patches. O(n).
[[nodiscard]] std::vector<Verdict> label(const InputComplex& input, const Subdivision& subdivision, const Rule& rule,
                                         const SheetWindings& windings);

}  // namespace strata
