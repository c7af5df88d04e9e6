#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "operand_units.h"
#include "strata/carry_attributes.h"

namespace {

/// The faces that are listed, with the vertices that they use.
LoadedMesh part_of(const LoadedMesh& mesh, const std::vector<std::uint32_t>& faces) {
  LoadedMesh part;
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t f : faces)
    for (const std::uint32_t v : mesh.mesh.mesh.triangles[f]) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto number = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  };
  for (const std::uint32_t v : vertices) part.mesh.mesh.vertices.push_back(mesh.mesh.mesh.vertices[v]);
  for (const std::uint32_t f : faces) {
    const strata::Triangle& t = mesh.mesh.mesh.triangles[f];
    part.mesh.mesh.triangles.push_back({number(t[0]), number(t[1]), number(t[2])});
  }
  for (const strata::ExactVertex& e : mesh.mesh.exact)
    if (std::binary_search(vertices.begin(), vertices.end(), e.vertex))
      part.mesh.exact.push_back({number(e.vertex), e.position});
  part.attributes = strata::part_of(mesh.attributes, faces, vertices);
  return part;
}

}  // namespace

std::vector<LoadedMesh> objects_of(LoadedMesh mesh) {
  const strata::Channel* const channel = mesh.attributes.find(strata::channel_names::object);
  const auto* const object_of = channel == nullptr ? nullptr : std::get_if<std::vector<std::int32_t>>(&channel->values);
  std::vector<LoadedMesh> parts;
  if (object_of == nullptr) {
    parts.push_back(std::move(mesh));
    return parts;
  }
  std::map<std::int32_t, std::vector<std::uint32_t>> faces;
  for (std::size_t f = 0; f < object_of->size(); ++f) faces[(*object_of)[f]].push_back(static_cast<std::uint32_t>(f));
  for (const auto& [object, list] : faces) {
    LoadedMesh part = part_of(mesh, list);
    const std::string name = object < 0 ? std::string() : mesh.attributes.objects[static_cast<std::size_t>(object)];
    part.path = mesh.path + "#" + (name.empty() ? std::to_string(object) : name);
    part.unit = mesh.unit;
    part.argument = mesh.argument;
    parts.push_back(std::move(part));
  }
  return parts;
}
