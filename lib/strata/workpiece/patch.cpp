#include "strata/workpiece/patch.h"

#include <unordered_map>

namespace strata {

Patch::Patch(const FaceTree& tree, const Box& tool) : bounds_(tree.bounds()) {
  Box reach = tool;
  reach.upper[0] = Box::infinity;
  std::unordered_map<const Corner*, std::uint32_t> numbers;
  tree.for_each_in(reach, [&](const WorkFace& face) {
    Carriers::Indices triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const CornerPointer& corner = face.corners()[i];
      const auto [at, is_new] = numbers.try_emplace(corner.get(), static_cast<std::uint32_t>(corners_.size()));
      triangle[i] = at->second;
      if (!is_new) continue;
      corners_.push_back(&corner);
      points_.push_back(corner->at);
      if (!corner->has_doubles())
        placed_.push_back(
            {at->second, corner->rational ? &*corner->rational : nullptr, corner->rational ? nullptr : &corner->meet});
    }
    faces_.push_back(&face);
    triangles_.push_back(triangle);
    planes_.push_back(face.plane().get());
  });
}

}  // namespace strata
