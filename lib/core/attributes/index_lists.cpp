#include "core/attributes/index_lists.h"

#include <algorithm>
#include <string>
#include <utility>

namespace strata {
namespace {

std::size_t at(IndexList list) { return static_cast<std::size_t>(list); }

}  // namespace

std::optional<IndexList> list_of(const Channel& channel) {
  if (channel.components != 1 || !std::holds_alternative<std::vector<std::int32_t>>(channel.values))
    return std::nullopt;
  if (channel.name == channel_names::material) return IndexList::materials;
  if (channel.name == channel_names::object) return IndexList::objects;
  if (channel.name == channel_names::group) return IndexList::groups;
  return std::nullopt;
}

std::size_t size_of(const Attributes& attributes, IndexList list) {
  switch (list) {
    case IndexList::materials:
      return attributes.materials.size();
    case IndexList::objects:
      return attributes.objects.size();
    case IndexList::groups:
      return attributes.groups.size();
  }
  return 0;
}

JoinedLists::JoinedLists(std::span<const Attributes* const> all) : new_index_(all.size()) {
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (all[n] == nullptr) continue;
    const Attributes& a = *all[n];
    for (const IndexList list : all_index_lists)
      has_entries_[at(list)] = has_entries_[at(list)] || size_of(a, list) > 0;
    auto& [materials, objects, groups] = new_index_[n];
    Numbers images;
    for (const Image& image : a.images) images.push_back(images_.find_or_add(image));
    for (Material m : a.materials) {
      if (m.image) m.image = static_cast<std::uint32_t>(images[*m.image]);
      materials.push_back(materials_.find_or_add(std::move(m)));
    }
    for (const std::string& name : a.objects) objects.push_back(objects_.find_or_add(name));
    for (const std::string& name : a.groups) groups.push_back(groups_.find_or_add(name));
  }
}

std::int32_t JoinedLists::add(const Material& material) {
  has_entries_[at(IndexList::materials)] = true;
  return materials_.find_or_add(material);
}

bool JoinedLists::are_kept(std::size_t of, IndexList list) const {
  const Numbers& numbers = new_index_[of][at(list)];
  if (numbers.empty()) return !has_entries_[at(list)];
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i] != static_cast<std::int32_t>(i)) return false;
  return true;
}

std::int32_t JoinedLists::index(std::size_t of, IndexList list, std::int32_t index) {
  if (index < 0) return index;
  const Numbers& numbers = new_index_[of][at(list)];
  if (!numbers.empty()) return numbers[static_cast<std::size_t>(index)];
  return has_entries_[at(list)] ? index_of_number(list, index) : index;
}

std::int32_t JoinedLists::index_of_number(IndexList list, std::int32_t number) {
  const auto [known, is_new] = of_number_[at(list)].try_emplace(number, -1);
  if (!is_new) return known->second;
  const std::string name = std::to_string(number);
  switch (list) {
    case IndexList::materials: {
      Material material;
      material.name = name;
      known->second = materials_.find_or_add(material);
      break;
    }
    case IndexList::objects:
      known->second = objects_.find_or_add(name);
      break;
    case IndexList::groups:
      known->second = groups_.find_or_add(name);
      break;
  }
  return known->second;
}

void JoinedLists::move_to(Attributes& attributes) && {
  attributes.materials = std::move(materials_).take();
  attributes.images = std::move(images_).take();
  attributes.objects = std::move(objects_).take();
  attributes.groups = std::move(groups_).take();
}

}  // namespace strata
