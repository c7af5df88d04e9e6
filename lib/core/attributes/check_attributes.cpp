#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include "core/attributes/index_lists.h"
#include "strata/carry_attributes.h"

namespace strata {
namespace {

[[noreturn]] void refuse(const Channel& channel, const std::string& what) {
  throw std::invalid_argument("channel \"" + channel.name + "\": " + what);
}

std::size_t elements_of(const Channel& channel, std::size_t vertices, std::size_t faces) {
  switch (channel.element) {
    case Element::vertex:
      return vertices;
    case Element::corner:
      return 3 * faces;
    case Element::face:
      return faces;
  }
  return 0;
}

void check_values(const Channel& channel, std::size_t elements) {
  if (channel.components < 1 || channel.components > 4)
    refuse(channel, std::to_string(channel.components) + " components; there may be 1 to 4");
  const std::size_t count = std::visit([](const auto& v) { return v.size(); }, channel.values);
  if (count != elements * channel.components)
    refuse(channel, std::to_string(count) + " values; " + std::to_string(elements) + " elements of " +
                        std::to_string(channel.components) + " components have " +
                        std::to_string(elements * channel.components));
  if (std::holds_alternative<std::vector<std::int32_t>>(channel.values) &&
      channel.interpolation != Interpolation::nearest)
    refuse(channel, "integers of 32 bits can be interpolated as nearest only");
  if (std::holds_alternative<std::vector<std::uint8_t>>(channel.values) &&
      channel.interpolation == Interpolation::spherical)
    refuse(channel, "bytes are no directions");
}

/// Of a channel that refers to a list, if this has entries.
void check_indices(const Channel& channel, const Attributes& attributes) {
  const std::optional<IndexList> list = list_of(channel);
  if (!list) return;
  const std::size_t size = size_of(attributes, *list);
  if (size == 0) return;
  std::int32_t last = -1;
  for (const std::int32_t i : std::get<std::vector<std::int32_t>>(channel.values)) last = std::max(last, i);
  if (last >= 0 && static_cast<std::size_t>(last) >= size)
    refuse(channel, "index " + std::to_string(last) + " in a list of " + std::to_string(size));
}

}  // namespace

void check_attributes(const Attributes& attributes, std::size_t vertices, std::size_t faces) {
  std::set<std::string_view> names;
  for (const Channel& channel : attributes.channels) {
    if (channel.name.empty()) refuse(channel, "it has no name");
    if (!names.insert(channel.name).second) refuse(channel, "there are two of that name");
    check_values(channel, elements_of(channel, vertices, faces));
    check_indices(channel, attributes);
  }
  for (const Material& material : attributes.materials)
    if (material.image && *material.image >= attributes.images.size())
      throw std::invalid_argument("material \"" + material.name + "\": image " + std::to_string(*material.image) +
                                  " of " + std::to_string(attributes.images.size()));
}

}  // namespace strata
