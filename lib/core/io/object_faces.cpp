#include "core/io/object_faces.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>

#include "core/attributes/index_lists.h"
#include "core/containers/huge_pages.h"

namespace strata::io {
namespace {

/// A directed edge as an undirected one, and which way it went.
struct Side {
  std::uint32_t low, high;
  std::int32_t way;
};

bool is_closed(std::span<const Triangle> triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      sides.push_back(a < b ? Side{a, b, 1} : Side{b, a, -1});
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });
  std::int64_t balance = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    balance += sides[i].way;
    const bool is_last =
        i + 1 == sides.size() || sides[i + 1].low != sides[i].low || sides[i + 1].high != sides[i].high;
    if (is_last && balance != 0) return false;
  }
  return true;
}

/// Numbers the vertices of the faces anew, in order.
void take_vertices(MeshView mesh, ObjectFaces& object, std::vector<std::uint32_t>& number) {
  for (const std::uint32_t f : object.faces)
    object.vertices.insert(object.vertices.end(), mesh.triangles[f].begin(), mesh.triangles[f].end());
  std::sort(object.vertices.begin(), object.vertices.end());
  object.vertices.erase(std::unique(object.vertices.begin(), object.vertices.end()), object.vertices.end());
  for (std::size_t i = 0; i < object.vertices.size(); ++i) number[object.vertices[i]] = static_cast<std::uint32_t>(i);
  for (const std::uint32_t f : object.faces) {
    const Triangle& t = mesh.triangles[f];
    object.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
}

}  // namespace

std::span<const std::int32_t> numbers_of(const Attributes& attributes, std::string_view channel) {
  const Channel* const c = attributes.find(channel);
  if (c == nullptr || c->element != Element::face || c->components != 1) return {};
  const auto* const values = std::get_if<std::vector<std::int32_t>>(&c->values);
  return values == nullptr ? std::span<const std::int32_t>() : *values;
}

std::span<const std::int32_t> indices_of(const Attributes& attributes, std::string_view channel) {
  const Channel* const c = attributes.find(channel);
  const auto list = c == nullptr ? std::nullopt : list_of(*c);
  return list && size_of(attributes, *list) > 0 ? numbers_of(attributes, channel) : std::span<const std::int32_t>();
}

std::vector<ObjectFaces> closed_objects(MeshView mesh, const Attributes& attributes) {
  const auto object_of = indices_of(attributes, channel_names::object);
  std::map<std::int32_t, ObjectFaces> by_index;
  for (std::size_t f = 0; f < object_of.size(); ++f)
    by_index[object_of[f]].faces.push_back(static_cast<std::uint32_t>(f));
  if (by_index.size() < 2) return {};
  std::vector<ObjectFaces> objects;
  std::vector<std::uint32_t> number(mesh.vertices.size());
  for (auto& [index, object] : by_index) {
    if (index >= 0) object.name = attributes.objects[static_cast<std::size_t>(index)];
    take_vertices(mesh, object, number);
    if (!is_closed(object.triangles)) return {};
    objects.push_back(std::move(object));
  }
  return objects;
}

ObjectFaces one_object(MeshView mesh, const Attributes& attributes) {
  ObjectFaces object;
  resize_fresh(object.faces, mesh.triangles.size());
  resize_fresh(object.vertices, mesh.vertices.size());
  std::iota(object.faces.begin(), object.faces.end(), 0U);
  std::iota(object.vertices.begin(), object.vertices.end(), 0U);
  object.triangles.reserve(mesh.triangles.size());
  prefer_huge_pages(object.triangles.data(), mesh.triangles.size_bytes());
  object.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
  const auto object_of = indices_of(attributes, channel_names::object);
  const bool is_one =
      !object_of.empty() && object_of[0] >= 0 &&
      std::all_of(object_of.begin(), object_of.end(), [&](std::int32_t o) { return o == object_of[0]; });
  if (is_one) object.name = attributes.objects[static_cast<std::size_t>(object_of[0])];
  return object;
}

}  // namespace strata::io
