#include "core/io/face_values.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/containers/huge_pages.h"

namespace strata::io {

void repeat_on_triangles(Channel& of_faces, const MeshFile& file) {
  const std::size_t n = of_faces.components, count = file.mesh.triangles.size();
  if (file.polygon_of_triangle.empty() && count > 0) return;
  std::visit(
      [&](auto& all) {
        std::decay_t<decltype(all)> values;
        resize_fresh(values, count * n);
        for (std::size_t t = 0; t < count; ++t) std::copy_n(&all[face_of(file, t) * n], n, &values[t * n]);
        all = std::move(values);
      },
      of_faces.values);
}

}  // namespace strata::io
