#include "core/attributes/carry.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/attributes/carried_channel.h"

namespace strata {
namespace {

constexpr std::int32_t no_material = -1;

/// Writes what depends on the places of corners, for the parts of source faces. Parts of one face come one after the
/// other, and most of their corners are corners of several of them: those are copied.
class PartWriter {
 public:
  PartWriter(const TriangleOrigins& origins, std::span<const std::unique_ptr<CarriedChannel>> channels)
      : origins_(origins), channels_(channels) {}

  void write(std::uint32_t triangle) {
    const Source& s = origins_.sources()[triangle];
    if (!source_ || *source_ != s) {
      source_ = s;
      frame_.emplace(origins_.points_of(s.operand), origins_.source_corners(s));
      written_.clear();
    }
    for (std::size_t k = 0; k < 3; ++k) write_corner(triangle, k);
  }

 private:
  struct Written {
    std::uint32_t vertex = 0;
    bool is_turned = false;
    std::size_t corner = 0;
  };
  static constexpr std::size_t most_written = 16;  // a search through more takes longer than it saves

  void write_corner(std::uint32_t triangle, std::size_t k) {
    const std::uint32_t vertex = origins_.result().triangles[triangle][k];
    const std::size_t corner = 3 * std::size_t{triangle} + k;
    const bool is_turned = origins_.is_turned(triangle);
    for (const Written& w : written_)
      if (w.vertex == vertex && w.is_turned == is_turned)
        return for_each_channel([&](CarriedChannel& c) { c.copy_corner(corner, w.corner); });
    if (written_.size() == most_written) written_.erase(written_.begin());
    written_.push_back({vertex, is_turned, corner});
    if (const auto same = source_corner_at(vertex))
      return for_each_channel([&](CarriedChannel& c) { c.write_corner(corner, *same, *frame_); });
    const FaceFrame::Place place(*frame_, origins_.points(), vertex);
    for_each_channel([&](CarriedChannel& c) { c.write_corner(corner, place, *frame_); });
  }

  [[nodiscard]] std::optional<std::size_t> source_corner_at(std::uint32_t vertex) const {
    const MeshPoints& points = origins_.points_of(source_->operand);
    const Triangle& corners = origins_.source_corners(*source_);
    for (std::size_t k = 0; k < 3; ++k)
      if (MeshPoints::are_equal(origins_.points(), vertex, points, corners[k])) return k;
    return std::nullopt;
  }

  template <class Visit>
  void for_each_channel(const Visit& visit) {
    for (const auto& c : channels_)
      if (c->needs_places()) visit(*c);
  }

  const TriangleOrigins& origins_;
  std::span<const std::unique_ptr<CarriedChannel>> channels_;
  std::optional<Source> source_;
  std::optional<FaceFrame> frame_;
  std::vector<Written> written_;
};

template <class Body>
void for_each_range(std::size_t count, std::size_t at_once, const Monitor& monitor, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, at_once), [&](const auto& range) {
    monitor.check();
    body(range.begin(), range.end());
  });
}

/// The material channel, with one value per face.
void require_faces(const Channel& form) {
  if (form.element != Element::face || list_of(form) != IndexList::materials)
    throw std::invalid_argument("channel \"material\": with a material for cut faces it must be one integer per face");
}

void put_cut_material(std::int32_t material, const TriangleOrigins& origins, CutFaces cut_faces, Channel& channel) {
  auto& values = std::get<std::vector<std::int32_t>>(channel.values);
  for (std::size_t t = 0; t < values.size(); ++t) {
    const bool is_later = cut_faces == CutFaces::of_later_operands && origins.sources()[t].operand > 0;
    if (values[t] == no_material && (is_later || origins.is_turned(t))) values[t] = material;
  }
}

std::vector<const Attributes*> attributes_of(std::span<const AttributedMesh> operands) {
  std::vector<const Attributes*> all;
  for (const AttributedMesh& o : operands) {
    if (o.attributes != nullptr)
      check_attributes(*o.attributes, o.mesh.mesh.vertices.size(), o.mesh.mesh.triangles.size());
    all.push_back(o.attributes);
  }
  return all;
}

}  // namespace

Attributes carry(std::span<const AttributedMesh> operands, ExactMeshView result, std::span<const Source> sources,
                 const CarryRules& rules, const Monitor& monitor) {
  const Material* const cut_material = rules.cut_material;
  JoinedLists lists(attributes_of(operands));
  JoinedChannels joined(operands, lists);
  std::int32_t material = no_material;
  if (cut_material != nullptr) {
    if (cut_material->image) throw std::invalid_argument("the material for cut faces has an image");
    material = lists.add(*cut_material);
    if (joined.find(channel_names::material) == nullptr)
      joined.add({std::string(channel_names::material), Element::face, Interpolation::nearest, 1,
                  std::vector<std::int32_t>{}});
    require_faces(joined.find(channel_names::material)->form);
  }
  Attributes carried;
  std::move(lists).move_to(carried);
  if (joined.channels().empty()) return carried;

  TriangleOrigins origins(operands, result, sources, rules.may_turn, monitor);
  const bool have_directions = std::any_of(joined.channels().begin(), joined.channels().end(), [](const auto& c) {
    return c.form.interpolation == Interpolation::spherical;
  });
  if (rules.may_turn && (have_directions || cut_material != nullptr)) origins.find_turned_parts(monitor);

  std::vector<std::unique_ptr<CarriedChannel>> channels;
  for (const JoinedChannel& j : joined.channels()) channels.push_back(CarriedChannel::make(j, origins));
  for_each_range(sources.size(), 1 << 13, monitor, [&](std::size_t first, std::size_t last) {
    for (const auto& c : channels) c->write_triangles(first, last);
  });
  if (std::any_of(channels.begin(), channels.end(), [](const auto& c) { return c->needs_places(); }))
    for_each_range(origins.parts().size(), 64, monitor, [&](std::size_t first, std::size_t last) {
      PartWriter writer(origins, channels);
      for (std::size_t i = first; i < last; ++i) writer.write(origins.parts()[i]);
    });
  for (const auto& c : channels) carried.channels.push_back(c->finish());
  if (cut_material != nullptr)
    for (Channel& c : carried.channels)
      if (c.name == channel_names::material) put_cut_material(material, origins, rules.cut_faces, c);
  return carried;
}

}  // namespace strata
