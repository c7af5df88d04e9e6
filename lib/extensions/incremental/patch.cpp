#include "extensions/incremental/patch.h"

#include <unordered_map>

#include "core/cells/grid.h"

namespace strata {

namespace {

/// The region in which an evaluation may use faces near a tool: its grid may be too coarse to distinguish them from
/// those in the tool's box.
class Reach {
 public:
  Reach(const Box& solid_in_steps, const Box& tool) : grid_(lower(solid_in_steps, tool), upper(solid_in_steps, tool)) {
    tool_.lower = grid_.at(tool.lower);
    tool_.upper = grid_.at(tool.upper);
    tool_.upper[0] = Grid::extent;  // walks start beyond all faces
  }
  [[nodiscard]] bool operator()(const Box& box) const {
    return GridBox{grid_.at(box.lower), grid_.at(box.upper)}.overlaps(tool_);
  }

 private:
  static InputComplex::Coordinates lower(Box a, const Box& b) {
    a.include(b);
    return a.lower;
  }
  static InputComplex::Coordinates upper(Box a, const Box& b) {
    a.include(b);
    return a.upper;
  }

  Grid grid_;
  GridBox tool_;
};

}  // namespace

Patch::Patch(const FaceTree& tree, const Box& tool) : bounds_(tree.bounds()) {
  std::unordered_map<const IncrementalVertex*, std::uint32_t> numbers;
  tree.for_each_in(Reach(bounds_, tool), [&](const WorkFace& face) {
    InputComplex::Indices triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const IncrementalVertexPointer& corner = face.corners()[i];
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
