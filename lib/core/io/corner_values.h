#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <vector>

#include "core/io/writers.h"

namespace strata::io {

/// Numbers of different values, in order of first use.
template <class Value>
class Numbered {
 public:
  std::uint32_t number_of(const Value& value) {
    const auto [place, is_new] = numbers_.try_emplace(value, static_cast<std::uint32_t>(values_.size()));
    if (is_new) values_.push_back(value);
    return place->second;
  }
  /// The same. `last` is the number last found at a vertex, or 0: most corners there have the same value, which is then
  /// not searched for.
  std::uint32_t number_of(const Value& value, std::uint32_t& last) {
    using Bytes = std::array<unsigned char, sizeof(Value)>;  // -0 is not 0
    const bool is_same = last < values_.size() && std::bit_cast<Bytes>(values_[last]) == std::bit_cast<Bytes>(value);
    if (!is_same) last = number_of(value);
    return last;
  }
  [[nodiscard]] const std::vector<Value>& values() const { return values_; }

 private:
  struct Hash {
    std::size_t operator()(const Value& value) const {
      std::uint64_t hash = 0;
      const auto* bytes = reinterpret_cast<const unsigned char*>(value.data());
      for (std::size_t i = 0; i < sizeof(Value); i += 4) {
        std::uint32_t word = 0;
        std::memcpy(&word, bytes + i, sizeof word);
        hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 29U;
      }
      return hash;
    }
  };
  std::unordered_map<Value, std::uint32_t, Hash> numbers_;
  std::vector<Value> values_;
};

/// Where the values of a corner are in a channel. Requires that the channel fits the mesh.
[[nodiscard]] inline std::size_t element_of_corner(const Channel& c, const Triangle& t, std::size_t face,
                                                   std::size_t corner) {
  return c.element == Element::vertex ? t[corner] : c.element == Element::corner ? 3 * face + corner : face;
}

/// Component k of an element, as a double; of bytes of a colour, as they are.
[[nodiscard]] inline double value_of(const Channel& c, std::size_t element, std::size_t k) {
  return std::visit([&](const auto& v) { return static_cast<double>(v[element * c.components + k]); }, c.values);
}

}  // namespace strata::io
