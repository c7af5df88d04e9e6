#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "operand_units.h"

namespace {

using strata::Channel;
using strata::Element;

/// Values of the elements that are listed.
Channel values_at(const Channel& channel, const std::vector<std::uint32_t>& elements) {
  Channel part{channel.name, channel.element, channel.interpolation, channel.components, {}};
  std::visit(
      [&](const auto& values) {
        std::decay_t<decltype(values)> kept;
        for (const std::size_t e : elements)
          for (std::size_t k = 0; k < channel.components; ++k) kept.push_back(values[e * channel.components + k]);
        part.values = std::move(kept);
      },
      channel.values);
  return part;
}

/// The faces that are listed, with the vertices that they use.
LoadedMesh part_of(const LoadedMesh& mesh, const std::vector<std::uint32_t>& faces) {
  LoadedMesh part;
  std::vector<std::uint32_t> vertices, corners;
  for (const std::uint32_t f : faces)
    for (std::uint32_t k = 0; k < 3; ++k) {
      vertices.push_back(mesh.mesh.mesh.triangles[f][k]);
      corners.push_back(3 * f + k);
    }
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
  for (const Channel& c : mesh.attributes.channels)
    part.attributes.channels.push_back(values_at(c, c.element == Element::vertex   ? vertices
                                                    : c.element == Element::corner ? corners
                                                                                   : faces));
  return part;
}

}  // namespace

std::vector<LoadedMesh> objects_of(LoadedMesh mesh) {
  const Channel* const channel = mesh.attributes.find(strata::channel_names::object);
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
    part.attributes.materials = mesh.attributes.materials;
    part.attributes.images = mesh.attributes.images;
    part.attributes.objects = mesh.attributes.objects;
    part.attributes.groups = mesh.attributes.groups;
    part.unit = mesh.unit;
    part.argument = mesh.argument;
    parts.push_back(std::move(part));
  }
  return parts;
}
