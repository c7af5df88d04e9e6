#include "core/io/ply_store.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

#include "core/containers/huge_pages.h"
#include "core/io/corner_finder.h"
#include "core/io/face_values.h"
#include "core/io/scene_channels.h"
#include "core/io/tally.h"

namespace strata::io {
namespace {

template <class T>
using Values = std::vector<T>;

/// Integers of 32 bits where these hold all values.
void narrow(Channel& c) {
  const auto& doubles = std::get<Values<double>>(c.values);
  const auto fits = [](double x) { return x <= std::numeric_limits<std::int32_t>::max(); };
  if (!std::all_of(doubles.begin(), doubles.end(), fits)) return;
  Values<std::int32_t> integers;
  integers.reserve(doubles.size());
  for (const double x : doubles) integers.push_back(static_cast<std::int32_t>(x));
  c.values = std::move(integers);
}

/// Gives the triangles of a file what its records have.
class ChannelJoiner {
 public:
  ChannelJoiner(const PlyPlan& plan, PlyStore& store, const std::vector<PlyPiece>& pieces,
                std::vector<ListStart> starts, MeshFile& file)
      : plan_(plan), store_(store), pieces_(pieces), starts_(std::move(starts)), file_(file) {}

  void add(std::uint64_t bytes) {
    const bool has_room = values_on_triangles() <= most_values(bytes);
    for (std::size_t c = 0; c < plan_.channels.size(); ++c) {
      Channel channel = plan_.channels[c].channel;
      if (channel.element != Element::vertex && !has_room) continue;
      if (channel.element == Element::corner)
        std::visit([&](auto& values) { copy_corners(c, channel, values); }, channel.values);
      else
        take(c, channel);
      if (plan_.channels[c].is_unsigned) narrow(channel);
      file_.attributes.channels.push_back(std::move(channel));
    }
    if (!has_room)
      file_.notes.emplace_back(
          "channels of faces left out: triangles would have more than 4 million values and 16 for each byte");
  }

 private:
  /// Triangles of one polygon repeat its values.
  static std::uint64_t most_values(std::uint64_t bytes) { return 4'000'000 + 16 * bytes; }

  [[nodiscard]] std::uint64_t values_on_triangles() const {
    std::uint64_t count = 0;
    for (const auto& [c, _] : plan_.channels)
      if (c.element != Element::vertex) count += c.components * count_of(c.element, 0, triangle_count());
    return count;
  }
  [[nodiscard]] std::size_t triangle_count() const { return file_.mesh.triangles.size(); }

  /// Stores the values of a channel on vertices or faces.
  void take(std::size_t number, Channel& channel) {
    channel.values = std::move(store_.values[number]);
    if (channel.element == Element::face) repeat_on_triangles(channel, file_);
  }

  template <class T>
  void copy_corners(std::size_t number, const Channel& channel, Values<T>& values) {
    resize_fresh(values, 3 * triangle_count() * channel.components);
    std::vector<Tally> missing(pieces_.size());
    tbb::parallel_for(std::size_t{0}, pieces_.size(), [&](std::size_t p) {
      missing[p] = copy_corners_of(p, pieces_[p].values[number], channel.components, values);
    });
    Tally all;
    for (const Tally& some : missing) all.add(some);
    all.note(file_, "face", "faces", ("without " + channel.name + ": its list there is of another length").c_str());
  }

  /// Returns the faces whose lists have not as many values as corners need; zeros stay there.
  template <class T>
  Tally copy_corners_of(std::size_t p, const PlyCornerValues& lists, std::size_t components, Values<T>& values) const {
    const PlyPiece& piece = pieces_[p];
    const auto& from = std::get<Values<T>>(lists.values);
    Tally missing;
    CornerFinder finder;
    std::size_t t = starts_[p].triangle, first = 0, list = 0;
    for (std::size_t f = 0; f < piece.ends.size(); ++f) {
      const std::size_t corners = piece.ends[f] - first;
      const bool is_whole = lists.ends[f] - list == corners * components;
      if (!is_whole) missing.add(starts_[p].face + f);
      if (is_whole) finder.start(corners, [&](std::size_t i) { return piece.corners[first + i]; });
      for (; t < starts_[p + 1].triangle && face_of(file_, t) == starts_[p].face + f; ++t)
        for (std::size_t k = 0; k < 3 && is_whole; ++k)
          std::copy_n(&from[list + finder.corner_at(file_.mesh.triangles[t][k]) * components], components,
                      &values[(3 * t + k) * components]);
      first = piece.ends[f];
      list = lists.ends[f];
    }
    return missing;
  }

  const PlyPlan& plan_;
  PlyStore& store_;
  const std::vector<PlyPiece>& pieces_;
  std::vector<ListStart> starts_;  ///< per piece, and the end
  MeshFile& file_;
};

}  // namespace

PlyStore::PlyStore(const PlyPlan& plan) {
  for (const PlyChannel& c : plan.channels) values.push_back(c.channel.values);
}

void PlyStore::make_room(const PlyElementPlan& element) {
  const std::uint64_t count = element.element->count;
  if (element.role == PlyRole::points) resize_fresh(vertices, count);
  for (const PlyUse& use : element.uses)
    if (use.kind == PlyUse::Kind::value && use.component == 0)
      std::visit([&](auto& v) { resize_fresh(v, count * use.components); }, values[use.channel]);
}

PlyPiece::PlyPiece(const PlyPlan& plan) {
  if (!plan.has_corners) return;
  for (const PlyChannel& c : plan.channels) values.push_back({c.channel.values, {}});
}

MeshFile join_ply(const PlyPlan& plan, PlyStore& store, std::vector<PlyPiece>& pieces, std::vector<std::string> notes,
                  std::uint64_t bytes, const std::string& name) {
  MeshFile file;
  file.notes = std::move(notes);
  file.mesh.vertices = std::move(store.vertices);
  std::vector<FaceList> faces;
  std::vector<ListStart> starts{{}};
  std::uint64_t no_numbers = 0;
  for (PlyPiece& piece : pieces) {
    starts.push_back({starts.back().face + piece.faces.count(), starts.back().triangle + piece.faces.triangle_count()});
    faces.push_back(std::move(piece.faces));
    no_numbers += piece.no_numbers;
  }
  gather_faces(faces, file, name);
  ChannelJoiner(plan, store, pieces, std::move(starts), file).add(bytes);
  if (no_numbers > 0)
    file.notes.push_back(std::to_string(no_numbers) +
                         " values of properties are no numbers of their types: taken for 0");
  file.notes.insert(file.notes.end(), plan.notes.begin(), plan.notes.end());
  return file;
}

}  // namespace strata::io
