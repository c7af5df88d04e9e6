#pragma once
#include <functional>

#include "verify/fuzz/question.h"

namespace fuzz {

/// As small a question as can be found for which `fails` holds still, given that it does for this one: fewer steps and
/// operands, solids with fewer parts and faces, rounder coordinates. `fails` must be false where operands are no
/// solids; when it has no time left, it is false for all.
[[nodiscard]] Question shrunken(Question question, const std::function<bool(const Question&)>& fails);

}  // namespace fuzz
