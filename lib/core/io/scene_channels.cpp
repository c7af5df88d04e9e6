#include "core/io/scene_channels.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace strata::io {
namespace {

bool is_color(const Channel& c) { return c.name.starts_with(channel_names::color); }
bool is_index(const Channel& c) { return c.interpolation == Interpolation::nearest; }

/// A channel without values that can hold those of both. Order of types: bytes, floats, doubles; integers with others
/// are doubles.
Channel joined_kind(const Channel& a, const Channel& b) {
  Channel kind{a.name, a.element, a.interpolation, std::max(a.components, b.components), {}};
  if (a.element != b.element) kind.element = Element::corner;
  if (a.values.index() == b.values.index()) {
    std::visit([&](const auto& v) { kind.values = std::decay_t<decltype(v)>(); }, a.values);
    return kind;
  }
  const auto is = [](const Channel& c, auto type) {
    return std::holds_alternative<std::vector<decltype(type)>>(c.values);
  };
  const bool floats = (is(a, 0.0F) || is(a, std::uint8_t{})) && (is(b, 0.0F) || is(b, std::uint8_t{}));
  if (floats)
    kind.values = std::vector<float>();
  else
    kind.values = std::vector<double>();
  return kind;
}

/// What elements have whose part does not have the channel, and colours without opacity.
template <class T>
T missing(const Channel& kind) {
  if (is_color(kind)) return std::is_same_v<T, std::uint8_t> ? T{255} : T{1};
  if constexpr (std::is_signed_v<T>)
    if (is_index(kind)) return T{-1};
  return T{0};
}

/// The element of a part whose value element `i` of the joined kind has.
std::size_t source_of(const ScenePart& part, Element from, Element to, std::size_t i) {
  if (from == to) return i;
  if (from == Element::face) return i / 3;
  return part.triangles[i / 3][i % 3];
}

/// In a mirrored part the second and the third corner of triangles change places.
std::size_t mirrored(std::size_t corner) {
  return corner % 3 == 1 ? corner + 1 : corner % 3 == 2 ? corner - 1 : corner;
}

template <class To, class From>
To converted(From x, bool color) {
  if constexpr (std::is_same_v<From, std::uint8_t> && !std::is_same_v<To, std::uint8_t>)
    if (color) return static_cast<To>(static_cast<To>(x) / static_cast<To>(255));
  return static_cast<To>(x);
}

template <class T>
void turn_normals(std::vector<T>& values, std::size_t first, const PointMap& map) {
  if constexpr (std::is_floating_point_v<T>)
    for (std::size_t i = first; i + 3 <= values.size(); i += 3) {
      const Vertex n = map.normal({values[i], values[i + 1], values[i + 2]});
      for (std::size_t k = 0; k < 3; ++k) values[i + k] = static_cast<T>(n[k]);
    }
}

template <class T>
void append_values(std::vector<T>& values, const Channel& kind, const PlacedChannels& placed) {
  const ScenePart& part = *placed.part;
  const std::size_t first = values.size();
  const std::size_t count = count_of(kind.element, part.vertices.size(), part.triangles.size());
  const auto found =
      std::find_if(part.channels.begin(), part.channels.end(), [&](const Channel& c) { return c.name == kind.name; });
  values.resize(first + count * kind.components, missing<T>(kind));
  if (found == part.channels.end()) return;
  const bool mirrors = placed.map->mirrors() && kind.element == Element::corner;
  std::visit(
      [&](const auto& from) {
        for (std::size_t i = 0; i < count; ++i) {
          const std::size_t source = source_of(part, found->element, kind.element, mirrors ? mirrored(i) : i);
          for (std::size_t k = 0; k < found->components; ++k)
            values[first + i * kind.components + k] =
                converted<T>(from[source * found->components + k], is_color(kind));
        }
      },
      found->values);
  if (kind.interpolation == Interpolation::spherical && kind.components == 3 && !placed.map->is_identity())
    turn_normals(values, first, *placed.map);
}

}  // namespace

std::size_t count_of(Element element, std::size_t vertices, std::size_t triangles) {
  return element == Element::vertex ? vertices : element == Element::corner ? 3 * triangles : triangles;
}

std::vector<Channel> joined_channels(const std::vector<PlacedChannels>& parts) {
  std::vector<Channel> joined;
  for (const PlacedChannels& placed : parts)
    for (const Channel& c : placed.part->channels) {
      const auto found = std::find_if(joined.begin(), joined.end(), [&](const Channel& j) { return j.name == c.name; });
      if (found == joined.end())
        joined.push_back(joined_kind(c, c));
      else
        *found = joined_kind(*found, c);
    }
  for (Channel& kind : joined)
    for (const PlacedChannels& placed : parts)
      std::visit([&](auto& values) { append_values(values, kind, placed); }, kind.values);
  return joined;
}

}  // namespace strata::io
