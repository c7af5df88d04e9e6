#pragma once
#include <vector>

#include "strata/solid.h"

namespace strata {

/// What a solid consists of.
struct Solid::Data {
  ExactMesh boundary;
  std::vector<Source> sources;
  std::vector<Defect> notes;
  Shared<Attributes> attributes = {};  ///< null: none
};

}  // namespace strata
