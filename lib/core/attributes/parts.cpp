#include <algorithm>
#include <type_traits>
#include <utility>

#include "core/attributes/index_lists.h"
#include "strata/carry_attributes.h"

namespace strata {
namespace {

/// Blocks of `size` values.
template <class T>
std::vector<T> chosen(const std::vector<T>& values, std::span<const std::uint32_t> blocks, std::size_t size) {
  std::vector<T> result;
  result.reserve(blocks.size() * size);
  for (const std::uint32_t b : blocks)
    result.insert(result.end(), values.begin() + static_cast<std::ptrdiff_t>(b * size),
                  values.begin() + static_cast<std::ptrdiff_t>((b + 1) * size));
  return result;
}

}  // namespace

Attributes part_of(const Attributes& attributes, std::span<const std::uint32_t> faces,
                   std::span<const std::uint32_t> vertices) {
  Attributes part{{}, attributes.materials, attributes.images, attributes.objects, attributes.groups};
  for (const Channel& c : attributes.channels) {
    const std::size_t size = c.components * (c.element == Element::corner ? 3U : 1U);
    const auto blocks = c.element == Element::vertex ? vertices : faces;
    part.channels.push_back({c.name, c.element, c.interpolation, c.components, {}});
    part.channels.back().values =
        std::visit([&](const auto& v) -> ChannelValues { return chosen(v, blocks, size); }, c.values);
  }
  return part;
}

Attributes only(const Attributes& attributes, std::span<const std::string> names) {
  Attributes result;
  for (const Channel& c : attributes.channels)
    if (std::find(names.begin(), names.end(), c.name) != names.end()) result.channels.push_back(c);
  const auto refers_to = [&](IndexList list) {
    return std::any_of(result.channels.begin(), result.channels.end(),
                       [&](const Channel& c) { return list_of(c) == list; });
  };
  if (refers_to(IndexList::materials)) {
    result.materials = attributes.materials;
    result.images = attributes.images;
  }
  if (refers_to(IndexList::objects)) result.objects = attributes.objects;
  if (refers_to(IndexList::groups)) result.groups = attributes.groups;
  return result;
}

}  // namespace strata
