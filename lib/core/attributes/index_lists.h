#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "strata/attributes.h"

namespace strata {

/// The lists of Attributes that channels refer to.
enum class IndexList : std::uint8_t { materials, objects, groups };

inline constexpr std::array all_index_lists{IndexList::materials, IndexList::objects, IndexList::groups};

/// The list to which a channel refers: by its name, one integer per element. None: its values are what they are.
[[nodiscard]] std::optional<IndexList> list_of(const Channel& channel);

[[nodiscard]] std::size_t size_of(const Attributes& attributes, IndexList list);

/// A list without equal entries.
template <class T>
class UniqueList {
 public:
  /// The index of an entry, which is added if there is no equal one. O(1), expected.
  std::int32_t find_or_add(T item) {
    const auto [first, last] = by_hash_.equal_range(hash_of(item));
    for (auto i = first; i != last; ++i)
      if (items_[static_cast<std::size_t>(i->second)] == item) return i->second;
    const auto index = static_cast<std::int32_t>(items_.size());
    by_hash_.emplace(hash_of(item), index);
    items_.push_back(std::move(item));
    return index;
  }
  [[nodiscard]] std::vector<T> take() && { return std::move(items_); }

 private:
  static std::size_t hash_of(const std::string& name) { return std::hash<std::string_view>()(name); }
  static std::size_t hash_of(const Material& m) {
    return hash_of(m.name) ^ std::hash<double>()(m.color[0] + 3 * m.color[1] + 9 * m.color[2]);
  }
  static std::size_t hash_of(const Image& image) { return hash_of(image.name) ^ image.bytes.size(); }

  std::vector<T> items_;
  std::unordered_multimap<std::size_t, std::int32_t> by_hash_;
};

/// The lists of several attributes as one each, and what becomes of indices.
class JoinedLists {
 public:
  /// Null attributes have no lists.
  explicit JoinedLists(std::span<const Attributes* const> all);

  /// Adds a material, if there is no equal one, and returns its index.
  std::int32_t add(const Material& material);

  /// True when all indices into a list of one of the attributes are the same in the joined list.
  [[nodiscard]] bool are_kept(std::size_t of, IndexList list) const;
  /// The index in the joined list. Negative numbers stay.
  [[nodiscard]] std::int32_t index(std::size_t of, IndexList list, std::int32_t index);

  /// Puts the lists into attributes.
  void move_to(Attributes& attributes) &&;

 private:
  using Numbers = std::vector<std::int32_t>;

  std::int32_t index_of_number(IndexList list, std::int32_t number);

  UniqueList<Material> materials_;
  UniqueList<Image> images_;
  UniqueList<std::string> objects_, groups_;
  std::array<bool, 3> has_entries_{};
  std::vector<std::array<Numbers, 3>> new_index_;                            ///< per attributes, list and entry
  std::array<std::unordered_map<std::int32_t, std::int32_t>, 3> of_number_;  ///< entries made from numbers
};

}  // namespace strata
