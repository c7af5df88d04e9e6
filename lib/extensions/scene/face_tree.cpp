#include "extensions/scene/face_tree.h"

#include <cmath>
#include <span>

#include "core/kernel/input_complex.h"
#include "extensions/scene/scene_data.h"

namespace strata {
namespace {

Box box_of(const InputComplex& input, std::span<const std::uint32_t> faces) {
  Box box;
  for (const std::uint32_t face : faces)
    for (const std::uint32_t v : input.face(face)) {
      const Vertex& p = input.vertex(v);
      Box at{p, p};
      if (input.exact(v) != nullptr)
        for (std::size_t i = 0; i < 3; ++i) {
          at.lower[i] = std::nextafter(p[i], -HUGE_VAL);
          at.upper[i] = std::nextafter(p[i], HUGE_VAL);
        }
      box.include(at);
    }
  return box;
}

}  // namespace

BoxTree tree_of_faces(const Scene& scene) {
  const InputComplex& input = input_complex_of(scene);
  return BoxTree::by_surface_area(input.face_count(),
                                  [&](std::span<const std::uint32_t> faces) { return box_of(input, faces); });
}

}  // namespace strata
