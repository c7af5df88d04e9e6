#include <stdexcept>
#include <string>
#include <variant>

#include "core/io/scene_channels.h"
#include "core/io/writers.h"

namespace strata::io {
namespace {

[[noreturn]] void refuse(const std::string& channel, const char* what) {
  throw std::invalid_argument("write_mesh: the channel '" + channel + "' " + what);
}

/// Indices are -1, for none, or refer to something.
void check_indices(const Channel& c, std::size_t count) {
  const auto* const values = std::get_if<std::vector<std::int32_t>>(&c.values);
  if (values == nullptr) return;
  for (const std::int32_t v : *values)
    if (v < -1 || (v >= 0 && static_cast<std::size_t>(v) >= count))
      refuse(c.name, "has an index that refers to nothing");
}

}  // namespace

void check_attributes(MeshView mesh, const Attributes& attributes) {
  constexpr std::uint32_t most_components = 4;
  for (const Channel& c : attributes.channels) {
    if (c.components < 1 || c.components > most_components) refuse(c.name, "has not 1 to 4 components");
    const std::size_t count = count_of(c.element, mesh.vertices.size(), mesh.triangles.size()) * c.components;
    const std::size_t values = std::visit([](const auto& v) { return v.size(); }, c.values);
    if (values != count) refuse(c.name, "has not one value for each element of the mesh");
    if (c.name == channel_names::material) check_indices(c, attributes.materials.size());
    if (c.name == channel_names::object) check_indices(c, attributes.objects.size());
    if (c.name == channel_names::group && !attributes.groups.empty()) check_indices(c, attributes.groups.size());
  }
  for (const Material& m : attributes.materials)
    if (m.image && *m.image >= attributes.images.size())
      throw std::invalid_argument("write_mesh: the material '" + m.name + "' has an image that there is not");
}

}  // namespace strata::io
