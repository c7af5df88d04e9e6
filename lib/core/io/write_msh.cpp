#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/io/losses.h"
#include "core/io/object_faces.h"
#include "core/io/text_lines.h"
#include "core/io/writers.h"

namespace strata::io {
namespace {

/// Faces with one index in the channel that makes regions.
struct Region {
  std::string name;
  std::vector<std::uint32_t> faces;
};

/// The channel that divides the faces into regions: groups, else objects, else materials.
std::string_view region_channel(const Attributes& attributes) {
  for (const std::string_view name : {channel_names::group, channel_names::object, channel_names::material})
    if (!numbers_of(attributes, name).empty()) return name;
  return {};
}

std::vector<Region> regions_of(const Target& target) {
  const Attributes& a = target.attributes;
  const std::string_view channel = region_channel(a);
  const auto index = numbers_of(a, channel);
  std::map<std::int32_t, Region> by_index;
  for (std::size_t f = 0; f < target.mesh.triangles.size(); ++f)
    by_index[index.empty() ? 0 : index[f]].faces.push_back(static_cast<std::uint32_t>(f));
  std::vector<Region> regions;
  for (auto& [i, region] : by_index) {
    const auto n = static_cast<std::size_t>(i);
    if (i >= 0 && channel == channel_names::group && n < a.groups.size()) region.name = a.groups[n];
    if (i >= 0 && channel == channel_names::object && n < a.objects.size()) region.name = a.objects[n];
    if (i >= 0 && channel == channel_names::material && n < a.materials.size()) region.name = a.materials[n].name;
    if (region.name.empty()) region.name = channel.empty() ? "surface" : std::string(channel) + " " + std::to_string(i);
    std::replace(region.name.begin(), region.name.end(), '"', '\'');
    std::replace(region.name.begin(), region.name.end(), '\n', ' ');
    regions.push_back(std::move(region));
  }
  return regions;
}

std::string box_of(MeshView mesh) {
  Vertex low{0, 0, 0}, high{0, 0, 0};
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = v == 0 ? mesh.vertices[v][k] : std::min(low[k], mesh.vertices[v][k]);
      high[k] = v == 0 ? mesh.vertices[v][k] : std::max(high[k], mesh.vertices[v][k]);
    }
  std::string text(2 * longest_line(""), '\0');
  char* at = append_line(text.data(), "", low);
  at[-1] = ' ';
  at = append_line(at, "", high);
  text.resize(static_cast<std::size_t>(at - text.data()) - 1);
  return text;
}

}  // namespace

Notes write_msh(const Target& target) {
  const MeshView mesh = target.mesh;
  Sink& sink = target.sink;
  const std::vector<Region> regions = regions_of(target);
  const std::string count = std::to_string(regions.size()), vertices = std::to_string(mesh.vertices.size()),
                    faces = std::to_string(mesh.triangles.size()), box = box_of(mesh);
  sink.write("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n" + count + "\n");
  for (std::size_t r = 0; r < regions.size(); ++r)
    sink.write("2 " + std::to_string(r + 1) + " \"" + regions[r].name + "\"\n");
  sink.write("$EndPhysicalNames\n$Entities\n0 0 " + count + " 0\n");
  for (std::size_t r = 1; r <= regions.size(); ++r)
    sink.write(std::to_string(r) + " " + box + " 1 " + std::to_string(r) + " 0\n");
  sink.write(
      "$EndEntities\n$Nodes\n" +
      std::string(regions.empty() ? "0 0 0 0\n" : "1 " + vertices + " 1 " + vertices + "\n2 1 0 " + vertices + "\n"));
  if (!regions.empty()) {
    write_texts(sink, mesh.vertices.size(),
                [](std::size_t v, std::string& text) { text += std::to_string(v + 1) + "\n"; });
    write_blocks(sink, mesh.vertices.size(), longest_line(""),
                 [&](std::size_t v, char* at) { return append_line(at, "", mesh.vertices[v]); });
  }
  sink.write("$EndNodes\n$Elements\n" + count + " " + faces + " 1 " + faces + "\n");
  std::size_t first = 1;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const std::vector<std::uint32_t>& list = regions[r].faces;
    sink.write("2 " + std::to_string(r + 1) + " 2 " + std::to_string(list.size()) + "\n");
    write_texts(sink, list.size(), [&](std::size_t i, std::string& text) {
      const Triangle& t = mesh.triangles[list[i]];
      text += std::to_string(first + i) + " " + std::to_string(t[0] + std::uint64_t{1}) + " " +
              std::to_string(t[1] + std::uint64_t{1}) + " " + std::to_string(t[2] + std::uint64_t{1}) + "\n";
    });
    first += list.size();
  }
  sink.write("$EndElements\n");
  Notes notes;
  const std::string_view channel = region_channel(target.attributes);
  note_losses(notes, target.attributes, target.unit, "MSH",
              {.objects = channel == channel_names::object, .groups = channel == channel_names::group},
              [&](const Channel& c) { return c.name == channel; });
  return notes;
}

}  // namespace strata::io
