#include "core/io/scene_mesh.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include "core/io/face_list.h"
#include "core/io/holds_for_all.h"
#include "core/io/scene_channels.h"

namespace strata::io {
namespace {

bool is_degenerate(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Keeps blocks of `block` values for which keep[i].
template <class T>
void keep_blocks(std::vector<T>& values, std::size_t block, const std::vector<bool>& keep) {
  std::size_t to = 0;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    for (std::size_t k = 0; k < block; ++k) values[to++] = values[i * block + k];
  }
  values.resize(to);
}

}  // namespace

void ScenePart::drop_degenerate(Tally& dropped, std::uint64_t first) {
  if (std::none_of(triangles.begin(), triangles.end(), is_degenerate)) return;
  std::vector<bool> keep(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    keep[i] = !is_degenerate(triangles[i]);
    if (!keep[i]) dropped.add(first + i);
  }
  keep_blocks(triangles, 1, keep);
  for (Channel& c : channels) {
    if (c.element == Element::vertex) continue;
    const std::size_t block = c.components * (c.element == Element::corner ? 3 : 1);
    std::visit([&](auto& values) { keep_blocks(values, block, keep); }, c.values);
  }
}

Channel on_vertices_if_possible(Channel channel, const ScenePart& part) {
  if (channel.element != Element::corner) return channel;
  const std::size_t n = channel.components;
  return std::visit(
      [&](auto& values) {
        auto of_vertices = std::decay_t<decltype(values)>(part.vertices.size() * n);
        const auto value_at = [&](std::size_t corner) {
          return values.begin() + static_cast<std::ptrdiff_t>(corner * n);
        };
        const auto value_of_vertex = [&](std::size_t corner) {
          const std::uint32_t v = part.triangles[corner / 3][corner % 3];
          return of_vertices.begin() + static_cast<std::ptrdiff_t>(v * n);
        };
        const std::size_t corners = 3 * part.triangles.size();
        // From last to first: of values that are equal but for a sign of zero the first counts.
        for (std::size_t corner = corners; corner-- > 0;) std::copy_n(value_at(corner), n, value_of_vertex(corner));
        const bool is_of_vertices = holds_for_all(corners, [&](std::size_t corner) {
          return std::equal(value_at(corner), value_at(corner + 1), value_of_vertex(corner));
        });
        if (!is_of_vertices) return std::move(channel);
        return Channel{channel.name, Element::vertex, channel.interpolation, channel.components,
                       std::move(of_vertices)};
      },
      channel.values);
}

SceneMesh::SceneMesh(std::uint64_t things, std::string name) : name_(std::move(name)) {
  constexpr std::uint64_t least = 4'000'000, ratio = 64;
  left_ = least + ratio * things;
}

void SceneMesh::count(std::uint64_t things) {
  if (things > left_)
    throw IoError(name_, {},
                  "copies of its objects unfold to more than 4 million and 64 times what it holds, which is refused");
  left_ -= things;
}

void SceneMesh::place(ScenePart& part, const ExactMap& map, std::int32_t object) {
  count(part.vertices.size() + part.triangles.size() + 1);
  placed_.push_back({&part, PointMap(map), object});
}

void SceneMesh::add_vertices(MeshFile& file) const {
  std::uint64_t rounded = 0;
  for (const Placed& placed : placed_) {
    if (placed.map.is_identity()) {
      file.mesh.vertices.insert(file.mesh.vertices.end(), placed.part->vertices.begin(), placed.part->vertices.end());
      continue;
    }
    for (const Vertex& p : placed.part->vertices) {
      bool is_rounded = false;
      const Vertex image = placed.map(p, is_rounded);
      if (!std::all_of(image.begin(), image.end(), [](double x) { return std::isfinite(x); }))
        throw IoError(name_, {}, "a transform moves a vertex beyond the range of doubles");
      file.mesh.vertices.push_back(image);
      rounded += is_rounded;
    }
  }
  if (rounded > 0)
    file.notes.push_back(std::to_string(rounded) + " of " + std::to_string(file.mesh.vertices.size()) +
                         " vertices are rounded to doubles: transforms of the scene move them");
}

void SceneMesh::add_triangles(MeshFile& file) const {
  std::uint32_t first = 0;
  for (const Placed& placed : placed_) {
    const bool mirrors = placed.map.mirrors();
    for (const Triangle& t : placed.part->triangles)
      file.mesh.triangles.push_back({first + t[0], first + t[mirrors ? 2 : 1], first + t[mirrors ? 1 : 2]});
    first += static_cast<std::uint32_t>(placed.part->vertices.size());
  }
}

/// A channel of objects is needed where there are several, or where the only one has a name.
void SceneMesh::add_objects(MeshFile& file) const {
  const bool is_plain = file.attributes.objects.empty() ||
                        (file.attributes.objects.size() == 1 && file.attributes.objects.front().empty());
  std::erase_if(file.attributes.channels, [](const Channel& c) { return c.name == channel_names::object; });
  if (is_plain) {
    file.attributes.objects.clear();
    return;
  }
  std::vector<std::int32_t> values;
  for (const Placed& placed : placed_) {
    const std::size_t first = values.size();
    values.resize(first + placed.part->triangles.size(), placed.object);
    for (const Channel& c : placed.part->channels)
      if (const auto* own = std::get_if<std::vector<std::int32_t>>(&c.values); own && c.name == channel_names::object)
        for (std::size_t i = 0; i < own->size(); ++i)
          values[first + i] = (*own)[i] < 0 ? -1 : placed.object + (*own)[i];
  }
  file.attributes.channels.push_back(
      {std::string(channel_names::object), Element::face, Interpolation::nearest, 1, std::move(values)});
}

/// True for one part that is not moved, and whose channels have different names.
bool SceneMesh::is_one_as_it_is() const {
  if (placed_.size() != 1 || !placed_.front().map.is_identity()) return false;
  std::set<std::string_view> names;
  const std::vector<Channel>& channels = placed_.front().part->channels;
  return std::all_of(channels.begin(), channels.end(), [&](const Channel& c) { return names.insert(c.name).second; });
}

void SceneMesh::finish(MeshFile& file) {
  std::uint64_t vertices = 0, triangles = 0;
  std::vector<PlacedChannels> parts;
  for (const Placed& placed : placed_) {
    vertices += placed.part->vertices.size();
    triangles += placed.part->triangles.size();
    parts.push_back({placed.part, &placed.map});
  }
  if (std::max(vertices, triangles) > most_items) throw IoError(name_, {}, "more than 2^32 - 2 vertices or triangles");
  if (is_one_as_it_is()) {
    ScenePart& part = *placed_.front().part;
    file.mesh.vertices = std::move(part.vertices);
    for (Channel& c : part.channels)
      if (c.name != channel_names::object) file.attributes.channels.push_back(std::move(c));
    add_objects(file);
    file.mesh.triangles = std::move(part.triangles);
    return;
  }
  file.mesh.vertices.reserve(vertices);
  file.mesh.triangles.reserve(triangles);
  add_vertices(file);
  add_triangles(file);
  file.attributes.channels = joined_channels(parts);
  add_objects(file);
}

}  // namespace strata::io
