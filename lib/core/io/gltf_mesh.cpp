#include "core/io/gltf_mesh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <numeric>
#include <span>
#include <utility>
#include <variant>

#include "core/containers/fresh_array.h"
#include "core/containers/hash_index.h"
#include "core/containers/huge_pages.h"
#include "core/containers/point_hash.h"
#include "core/io/scene_channels.h"

namespace strata::io {
namespace {

constexpr std::size_t triangle_list = 4, triangle_strip = 5, triangle_fan = 6;

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t grain = 1 << 14;

std::vector<Triangle> triangles_of(const std::vector<std::uint32_t>& v, std::size_t mode) {
  std::vector<Triangle> triangles;
  if (mode == triangle_list) {
    resize_fresh(triangles, v.size() / 3);
    tbb::parallel_for(Range(0, triangles.size(), grain), [&](const Range& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) triangles[i] = {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
    });
    return triangles;
  }
  triangles.reserve(v.size());
  if (mode == triangle_strip)
    for (std::size_t i = 0; i + 3 <= v.size(); ++i) triangles.push_back({v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]});
  if (mode == triangle_fan)
    for (std::size_t i = 1; i + 2 <= v.size(); ++i) triangles.push_back({v[i], v[i + 1], v[0]});
  return triangles;
}

/// The channel that an attribute of vertices becomes; no name if it becomes none.
std::string channel_name(const std::string& attribute) {
  const auto numbered = [&](std::string_view start, std::string_view name) {
    const std::string number = attribute.substr(start.size());
    return std::string(name) + (number == "0" ? "" : number);
  };
  if (attribute == "NORMAL") return std::string(channel_names::normal);
  if (attribute.starts_with("TEXCOORD_")) return numbered("TEXCOORD_", channel_names::texcoord);
  if (attribute.starts_with("COLOR_")) return numbered("COLOR_", channel_names::color);
  return attribute.starts_with("_") ? attribute.substr(1) : std::string();
}

/// Values of the vertices that are used, in their order. Textures count from the upper left in glTF.
Channel channel_of(std::string name, const GltfNumbers& numbers, const std::vector<std::uint32_t>& used) {
  Channel channel{
      std::move(name), Element::vertex, Interpolation::linear, static_cast<std::uint32_t>(numbers.components), {}};
  const std::size_t n = numbers.components;
  const auto fill = [&](auto values, const auto& convert) {
    values.reserve(used.size() * n);
    for (const std::uint32_t v : used)
      for (std::size_t k = 0; k < n; ++k)
        values.push_back(static_cast<typename decltype(values)::value_type>(convert(numbers.values[v * n + k], k)));
    channel.values = std::move(values);
  };
  const auto divided = [&](double x, std::size_t) { return x / numbers.divisor; };
  const auto plain = [](double x, std::size_t) { return x; };
  if (channel.name == channel_names::normal) channel.interpolation = Interpolation::spherical;
  if (channel.name.starts_with(channel_names::texcoord) && n == 2)
    fill(std::vector<double>(),
         [&](double x, std::size_t k) { return k == 1 ? 1 - x / numbers.divisor : x / numbers.divisor; });
  else if (numbers.kind == GltfNumbers::Kind::bytes)
    fill(std::vector<std::uint8_t>(), plain);
  else if (numbers.kind == GltfNumbers::Kind::integers &&
           std::all_of(numbers.values.begin(), numbers.values.end(), [](double x) { return x < 0x1p31; }))
    fill(std::vector<std::int32_t>(), plain), channel.interpolation = Interpolation::nearest;
  else if (numbers.kind == GltfNumbers::Kind::floats)
    fill(std::vector<float>(), plain);
  else if (numbers.kind == GltfNumbers::Kind::integers)
    fill(std::vector<double>(), plain);
  else
    fill(std::vector<float>(), divided);
  return channel;
}

/// A list of triangles with the vertices that it uses.
class ListReader {
 public:
  ListReader(const GltfValue& list, GltfBuffers& buffers, const Attributes& attributes, GltfTally& tally)
      : list_(list), buffers_(buffers), attributes_(attributes), tally_(tally) {}

  /// Normalized integers are not yet divided: `divisor` tells by what.
  ScenePart read(double& divisor) {
    const GltfValue vertices = list_.at("attributes");
    const std::size_t position = vertices.at("POSITION").index();
    const GltfNumbers& points = buffers_.accessor(position);
    if (points.components != 3) vertices.refuse("positions have not 3 components");
    divisor = points.divisor;
    std::vector<std::uint32_t> corners = corners_of(points.count);
    const std::vector<std::uint32_t> used = number_used(corners, points.count);
    ScenePart part;
    buffers_.use(3 * used.size());
    part.vertices.reserve(used.size());
    for (const std::uint32_t v : used)
      part.vertices.push_back({points.values[3 * v], points.values[3 * v + 1], points.values[3 * v + 2]});
    part.triangles = triangles_of(corners, list_.index_or("mode", triangle_list));
    add_channels(part, vertices, points.count, used);
    add_material(part);
    tally_.targets = tally_.targets || list_.has("targets");
    return part;
  }

 private:
  std::vector<std::uint32_t> corners_of(std::size_t count) {
    if (list_.has("indices")) return buffers_.indices(list_.at("indices").index(), count);
    buffers_.use(count);
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0U);
    return all;
  }

  /// Numbers the vertices that corners use, in order; returns which they are.
  static std::vector<std::uint32_t> number_used(std::vector<std::uint32_t>& corners, std::size_t count) {
    std::vector<std::uint8_t> is_used(count);
    tbb::parallel_for(Range(0, corners.size(), grain), [&](const Range& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        std::atomic_ref(is_used[corners[i]]).store(1, std::memory_order_relaxed);
    });
    std::vector<std::uint32_t> used(static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), 1)));
    if (used.size() == count) {
      std::iota(used.begin(), used.end(), 0U);
      return used;
    }
    std::vector<std::uint32_t> number(count);
    for (std::uint32_t v = 0, next = 0; v < count; ++v) {
      if (is_used[v] == 0) continue;
      used[next] = v;
      number[v] = next++;
    }
    for (std::uint32_t& v : corners) v = number[v];
    return used;
  }

  void add_channels(ScenePart& part, const GltfValue& vertices, std::size_t count,
                    const std::vector<std::uint32_t>& used) {
    for (const auto& [attribute, unused] : vertices.json().items()) {
      if (attribute == "POSITION") continue;
      std::string name = channel_name(attribute);
      if (name.empty()) {
        tally_.other_attributes = true;
        continue;
      }
      const GltfNumbers& numbers = buffers_.accessor(vertices.at(attribute.c_str()).index());
      if (numbers.count != count) vertices.refuse("has not one '" + attribute.substr(0, 32) + "' for each position");
      buffers_.use(used.size() * numbers.components);
      part.channels.push_back(channel_of(std::move(name), numbers, used));
    }
  }

  void add_material(ScenePart& part) const {
    if (!list_.has("material")) return;
    const auto material = static_cast<std::int32_t>(list_.at("material").index_below(attributes_.materials.size()));
    part.channels.push_back({std::string(channel_names::material), Element::face, Interpolation::nearest, 1,
                             std::vector<std::int32_t>(part.triangles.size(), material)});
  }

  const GltfValue& list_;
  GltfBuffers& buffers_;
  const Attributes& attributes_;
  GltfTally& tally_;
};

/// All parts in one, with all their vertices.
ScenePart joined(const std::vector<ScenePart>& parts) {
  ScenePart all;
  const PointMap same(ExactMap::identity());
  std::vector<PlacedChannels> placed;
  for (const ScenePart& part : parts) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const Triangle& t : part.triangles) all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    placed.push_back({&part, &same});
  }
  all.channels = joined_channels(placed);
  return all;
}

/// Values of vertices, for those of which `first` lists one each; or of corners, where vertices that become one differ.
template <class T>
void merge_values(Channel& channel, std::vector<T>& values, const ScenePart& part,
                  const std::vector<std::uint32_t>& number, const std::vector<std::uint32_t>& first) {
  const std::size_t n = channel.components;
  bool is_seamless = true;
  for (std::size_t v = 0; is_seamless && v < number.size(); ++v)
    is_seamless = std::equal(&values[v * n], &values[v * n] + n, &values[first[number[v]] * n]);
  std::vector<T> merged;
  const auto append = [&](std::size_t v) { merged.insert(merged.end(), &values[v * n], &values[v * n] + n); };
  if (is_seamless) {
    for (const std::uint32_t v : first) append(v);
  } else {
    merged.reserve(3 * part.triangles.size() * n);
    for (const Triangle& t : part.triangles)
      for (const std::uint32_t v : t) append(v);
    channel.element = Element::corner;
  }
  values = std::move(merged);
}

/// Finds for each vertex the first one at its place. A hash deals vertices out to parts that fit into a core's cache.
class FirstAtPlaces {
 public:
  explicit FirstAtPlaces(const std::vector<Vertex>& vertices) : vertices_(vertices) {
    bits_ = std::min(most_bits, static_cast<int>(std::bit_width(vertices.size() / part_size)));
  }

  std::vector<std::uint32_t> find() {
    deal();
    resize_fresh(first_, vertices_.size());
    tbb::parallel_for(std::size_t{0}, ends_.size() - 1, [&](std::size_t i) {
      find_in({dealt_.begin() + ends_[i], dealt_.begin() + ends_[i + 1]});
    });
    return std::move(first_);
  }

 private:
  struct Dealt {
    std::uint64_t hash;
    std::uint32_t vertex;
  };
  static constexpr std::size_t part_size = 1 << 13;
  static constexpr int most_bits = 10;

  [[nodiscard]] std::size_t part_of(std::uint64_t hash) const {
    return bits_ == 0 ? 0 : static_cast<std::size_t>(hash >> (64 - bits_));
  }

  /// A stable counting sort by part: each thread deals out blocks, to places of their own.
  void deal() {
    const std::size_t parts = std::size_t{1} << bits_, blocks = (vertices_.size() + grain - 1) / grain;
    std::vector<std::size_t> place(blocks * parts, 0);     // first a count
    const auto for_each_vertex = [&](const auto& visit) {  // visit(vertex, hash, place of its block and part)
      tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
        for (std::size_t v = block * grain; v < std::min(vertices_.size(), (block + 1) * grain); ++v) {
          const std::uint64_t hash = hash_of(vertices_[v]);
          visit(static_cast<std::uint32_t>(v), hash, place[block * parts + part_of(hash)]);
        }
      });
    };
    for_each_vertex([](std::uint32_t, std::uint64_t, std::size_t& count) { ++count; });
    std::size_t sum = 0;
    for (std::size_t part = 0; part < parts; ++part) {
      ends_.push_back(sum);
      for (std::size_t block = 0; block < blocks; ++block) sum += std::exchange(place[block * parts + part], sum);
    }
    ends_.push_back(sum);
    dealt_ = FreshArray<Dealt>(sum);
    for_each_vertex([&](std::uint32_t v, std::uint64_t hash, std::size_t& next) { dealt_[next++] = {hash, v}; });
  }

  /// Vertices are in order, so the one that is in a table is the first.
  void find_in(std::span<const Dealt> part) {
    HashIndex table(part.size());
    for (std::uint32_t i = 0; i < part.size(); ++i) {
      const auto [hash, vertex] = part[i];
      const auto is_here = [&, hash = hash, vertex = vertex](std::uint32_t there) {
        return part[there].hash == hash && are_equal(vertices_[part[there].vertex], vertices_[vertex]);
      };
      first_[vertex] = part[table.find_or_add(hash, i, is_here)].vertex;
    }
  }

  const std::vector<Vertex>& vertices_;
  int bits_ = 0;
  std::vector<std::size_t> ends_;  ///< of the parts in `dealt_`, from 0
  FreshArray<Dealt> dealt_;
  std::vector<std::uint32_t> first_;
};

/// Makes one of vertices at the same place.
void weld(ScenePart& part) {
  std::vector<std::uint32_t> number = FirstAtPlaces(part.vertices).find(), first;
  for (std::uint32_t v = 0; v < number.size(); ++v) {
    const bool is_first = number[v] == v;
    number[v] = is_first ? static_cast<std::uint32_t>(first.size()) : number[number[v]];
    if (is_first) first.push_back(v);
  }
  if (first.size() == part.vertices.size()) return;
  for (Channel& c : part.channels)
    if (c.element == Element::vertex)
      std::visit([&](auto& values) { merge_values(c, values, part, number, first); }, c.values);
  std::vector<Vertex> vertices;
  for (const std::uint32_t v : first) vertices.push_back(part.vertices[v]);
  part.vertices = std::move(vertices);
  for (Triangle& t : part.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
}

/// Divides positions by what normalized integers stand for: in the transform if it is the same for all lists.
void divide(std::vector<ScenePart>& parts, const std::vector<double>& divisors, ExactMap& scale) {
  if (divisors.empty()) return;
  if (std::all_of(divisors.begin(), divisors.end(), [&](double d) { return d == divisors[0]; })) {
    for (std::size_t i = 0; i < 3; ++i) scale.rows[i][i] = Rational(1) / Rational(divisors[0]);
    return;
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (Vertex& p : parts[i].vertices)
      for (double& x : p) x /= divisors[i];
}

}  // namespace

GltfMesh read_gltf_mesh(const GltfValue& mesh, GltfBuffers& buffers, const Attributes& attributes, GltfTally& tally) {
  GltfMesh result;
  std::vector<ScenePart> parts;
  std::vector<double> divisors;
  const GltfValue lists = mesh.at("primitives");
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const GltfValue list = lists.at(i);
    const std::size_t mode = list.index_or("mode", triangle_list);
    if (mode > triangle_fan) list.refuse("has an unknown mode");
    if (mode < triangle_list || !list.at("attributes").has("POSITION")) {
      ++tally.lines;
      continue;
    }
    ScenePart part = ListReader(list, buffers, attributes, tally).read(divisors.emplace_back());
    if (list.has("extras") && list.at("extras").has("object")) {
      const std::string name = list.at("extras").text_or("object", "");
      const auto at = std::find(result.objects.begin(), result.objects.end(), name);
      const auto object = static_cast<std::int32_t>(at - result.objects.begin());
      if (at == result.objects.end()) result.objects.push_back(name);
      part.channels.push_back({std::string(channel_names::object), Element::face, Interpolation::nearest, 1,
                               std::vector<std::int32_t>(part.triangles.size(), object)});
    }
    parts.push_back(std::move(part));
  }
  divide(parts, divisors, result.scale);
  result.part = parts.size() == 1 ? std::move(parts[0]) : joined(parts);
  weld(result.part);
  result.part.drop_degenerate(tally.dropped, tally.triangles);
  tally.triangles += result.part.triangles.size();
  return result;
}

}  // namespace strata::io
