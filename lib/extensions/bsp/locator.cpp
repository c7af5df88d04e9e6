#include <utility>
#include <vector>

#include "core/kernel/point.h"
#include "extensions/bsp/partition_data.h"
#include "extensions/scene/closed_face.h"
#include "extensions/scene/location.h"
#include "extensions/scene/scene_data.h"
#include "strata/bsp.h"

namespace strata::bsp {
namespace {

/// The faces of a scene's solid in each plane of its tree.
std::vector<std::vector<std::uint32_t>> faces_by_plane(const Scene& scene, std::uint32_t solid,
                                                       const HyperplaneTable<3>& table) {
  std::vector<std::vector<std::uint32_t>> faces(table.size());
  const ExactMesh& mesh = scene.solid(solid);
  for (std::uint32_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.mesh.triangles[t];
    const auto plane = table.find(plane_through(mesh.position(a), mesh.position(b), mesh.position(c)).hyperplane);
    if (plane) faces[*plane].push_back(input_complex_of(scene).first_face(solid) + t);
  }
  return faces;
}

}  // namespace

struct PartitionLocator::Data {
  struct Region {
    Partition<3> partition;
    std::vector<std::vector<std::uint32_t>> faces;  ///< by plane
  };

  Scene scene;
  std::vector<Region> regions;
};

PartitionLocator::PartitionLocator(Scene scene, const Monitor& monitor) {
  Data data{std::move(scene), {}};
  for (std::uint32_t s = 0; s < data.scene.solid_count(); ++s) {
    const Partition<3> partition = partition_of(data.scene.solid(s), monitor);
    data.regions.push_back({partition, faces_by_plane(data.scene, s, table_of(partition))});
  }
  data_ = Shared<Data>::make(std::move(data));
}

Location PartitionLocator::locate(const Vertex& q) const {
  Windings windings;
  std::vector<Contact> contacts;
  const Point point = Point::free(q);
  for (std::uint32_t s = 0; s < data_->regions.size(); ++s) {
    const auto& [partition, faces] = data_->regions[s];
    const Where where = partition.classify(q);
    if (where == Where::in) windings.add(s, 1);
    if (where != Where::on) continue;
    for (std::uint32_t plane = 0; plane < faces.size(); ++plane) {
      if (table_of(partition).side(plane, q) != Sign::zero) continue;
      for (const std::uint32_t face : faces[plane])
        if (is_on_closed_face(input_complex_of(data_->scene), face, point)) contacts.push_back({s, face});
    }
  }
  return location_of(std::move(windings), std::move(contacts));
}

}  // namespace strata::bsp
