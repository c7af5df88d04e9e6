#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <bit>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/io/binary.h"
#include "core/io/blocks.h"
#include "core/io/corner_values.h"
#include "core/io/finite_values.h"
#include "core/io/folder_of_model.h"
#include "core/io/holds_for_all.h"
#include "core/io/images.h"
#include "core/io/losses.h"
#include "core/io/object_faces.h"
#include "core/io/seam_vertices.h"
#include "core/io/writers.h"

namespace strata::io {
namespace {

using Json = nlohmann::json;

constexpr std::uint32_t type_of_bytes = 5121, type_of_indices = 5125, type_of_floats = 5126;
constexpr std::uint32_t vertex_buffer = 34962, index_buffer = 34963;
constexpr std::endian byte_order = std::endian::little;

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

bool is_bytes(const Channel& c) { return std::holds_alternative<std::vector<std::uint8_t>>(c.values); }

/// The attribute of vertices that a channel becomes; none if it becomes none.
std::string attribute_of(const Channel& c) {
  const bool is_integer = std::holds_alternative<std::vector<std::int32_t>>(c.values);
  if (c.element == Element::face || is_integer) return {};
  const auto numbered = [&](std::string_view start, std::string_view prefix) {
    const std::string number = c.name.substr(start.size());
    const bool is_number = std::all_of(number.begin(), number.end(), [](char x) { return x >= '0' && x <= '9'; });
    return is_number ? std::string(prefix) + (number.empty() ? "0" : number) : "_" + c.name;
  };
  if (c.name == channel_names::normal && c.components == 3 && !is_bytes(c)) return "NORMAL";
  if (c.name.starts_with(channel_names::texcoord) && c.components == 2 && !is_bytes(c))
    return numbered(channel_names::texcoord, "TEXCOORD_");
  if (c.name.starts_with(channel_names::color) && c.components >= 3) return numbered(channel_names::color, "COLOR_");
  return "_" + c.name;
}

/// A box of floats.
struct Bounds {
  static constexpr float infinite = std::numeric_limits<float>::infinity();
  std::array<float, 3> low{infinite, infinite, infinite}, high{-infinite, -infinite, -infinite};

  void add(const std::array<float, 3>& bottom, const std::array<float, 3>& top) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], bottom[k]);
      high[k] = std::max(high[k], top[k]);
    }
  }
};

/// The box of some vertices, rounded to floats. In parallel.
Bounds bounds_of(std::span<const Vertex> vertices, const std::vector<std::uint32_t>& some) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, some.size(), 1 << 14), Bounds{},
      [&](const auto& range, Bounds box) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          const Vertex& v = vertices[some[i]];
          const std::array<float, 3> point{static_cast<float>(v[0]), static_cast<float>(v[1]),
                                           static_cast<float>(v[2])};
          box.add(point, point);
        }
        return box;
      },
      [](Bounds a, const Bounds& b) {
        a.add(b.low, b.high);
        return a;
      });
}

/// Writes the parts of the buffer, one behind the other; their places are in the JSON.
class Buffer {
 public:
  /// Adds a part of `count` items of `size` bytes each; `store(i, at)` stores one. Returns the number of its view.
  template <class Store>
  std::size_t add(std::size_t count, std::size_t size, std::uint32_t target, const Store& store) {
    Json view = {{"buffer", 0}, {"byteOffset", size_}, {"byteLength", count * size}};
    if (target != 0) view["target"] = target;
    if (target == vertex_buffer) view["byteStride"] = size;
    views_.push_back(std::move(view));
    const std::size_t rest = padded(count * size) - count * size;
    parts_.push_back([count, size, rest, store](Sink& sink) {
      write_blocks(sink, count, size, [&](std::size_t i, char* at) {
        store(i, at);
        return at + size;
      });
      sink.write(std::string(rest, '\0'));
    });
    size_ += padded(count * size);
    return views_.size() - 1;
  }
  std::size_t add_bytes(const std::vector<std::byte>& bytes) {
    views_.push_back({{"buffer", 0}, {"byteOffset", size_}, {"byteLength", bytes.size()}});
    parts_.push_back([&bytes](Sink& sink) {
      sink.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
      sink.write(std::string(padded(bytes.size()) - bytes.size(), '\0'));
    });
    size_ += padded(bytes.size());
    return views_.size() - 1;
  }
  void write(Sink& sink) const {
    for (const auto& part : parts_) part(sink);
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Json& views() const { return views_; }

 private:
  Json views_ = Json::array();
  std::vector<std::function<void(Sink&)>> parts_;
  std::size_t size_ = 0;
};

class DocumentWriter {
 public:
  DocumentWriter(const Target& target, Notes& notes) : target_(target), attributes_(target.attributes), notes_(notes) {
    notes_ = note_floats(target.mesh.vertices, target.name, "glTF");
    for (const Channel& c : attributes_.channels) {
      std::string attribute = attribute_of(c);
      if (attribute.empty()) continue;
      if (has_finite_floats(c))
        kept_.emplace_back(&c, std::move(attribute));
      else
        not_finite_.push_back(&c);
    }
    for (const auto& [c, attribute] : kept_)
      if (c->element == Element::corner) seams_.push_back(c);
    objects_ = closed_objects(target.mesh, attributes_);
    is_apart_ = !objects_.empty();
    if (!is_apart_) objects_.push_back(one_object(target.mesh, attributes_));
    note();
    json_ = {{"asset", {{"version", "2.0"}, {"generator", "strata"}}}};
    write_materials();
    write_objects();
    finish();
  }

  [[nodiscard]] const Buffer& buffer() const { return buffer_; }
  [[nodiscard]] Json& json() { return json_; }

 private:
  void note() {
    const bool is_meter = target_.unit == Unit::meter;
    note_losses(notes_, attributes_, target_.unit, "glTF",
                {.materials = true, .images = true, .objects = true, .unit = is_meter}, [&](const Channel& c) {
                  const bool is_known = c.name == channel_names::material || c.name == channel_names::object;
                  return !attribute_of(c).empty() || (is_known && !indices_of(attributes_, c.name).empty());
                });
    note_not_finite(notes_, not_finite_, "glTF");
    std::string rounded;
    for (const auto& [c, attribute] : kept_)
      if (const auto* values = std::get_if<std::vector<double>>(&c->values)) {
        const bool flips = attribute.starts_with("TEXCOORD");
        const auto is_float = [](double x) { return static_cast<double>(static_cast<float>(x)) == x; };
        const auto is_kept = [&](std::size_t i) {
          return is_float(flips && i % 2 == 1 ? 1 - (*values)[i] : (*values)[i]);
        };
        if (!holds_for_all(values->size(), is_kept)) rounded += (rounded.empty() ? "" : ", ") + c->name;
      }
    if (!rounded.empty()) notes_.push_back("values of " + rounded + " were rounded: glTF holds floats only");
  }

  void write_materials() {
    for (const Material& m : attributes_.materials) {
      Json look = {{"baseColorFactor", m.color}, {"metallicFactor", m.metallic}, {"roughnessFactor", m.roughness}};
      if (m.image) look["baseColorTexture"] = {{"index", *m.image}};
      Json material = {{"pbrMetallicRoughness", std::move(look)}};
      if (!m.name.empty()) material["name"] = m.name;
      if (m.color[3] < 1) material["alphaMode"] = "BLEND";
      json_["materials"].push_back(std::move(material));
    }
    const auto names = file_names_of(attributes_.images);
    for (std::size_t i = 0; i < attributes_.images.size(); ++i) {
      const Image& image = attributes_.images[i];
      json_["images"].push_back({{"bufferView", buffer_.add_bytes(image.bytes)},
                                 {"mimeType", media_type_of(image)},
                                 {"name", image.name.empty() ? names[i] : image.name}});
      json_["textures"].push_back({{"source", i}});
    }
  }

  void write_objects() {
    vertices_.reserve(objects_.size());
    for (ObjectFaces& object : objects_) {
      if (object.triangles.empty()) continue;
      vertices_.push_back(divide_at_seams(object, seams_));
      Json node = {{"mesh", json_["meshes"].size()}};
      if (!object.name.empty()) node["name"] = object.name;
      json_["meshes"].push_back({{"primitives", write_lists(object, vertices_.back())}});
      json_["scenes"][0]["nodes"].push_back(json_["nodes"].size());
      json_["nodes"].push_back(std::move(node));
    }
    json_["scene"] = 0;
    if (!json_.contains("scenes")) json_["scenes"].push_back(Json::object());
  }

  /// Faces of one material, and of one object where objects are not apart, are a list.
  Json write_lists(const ObjectFaces& object, const SeamVertices& vertices) {
    const Json attributes = write_vertices(vertices);
    const auto material = indices_of(attributes_, channel_names::material);
    const auto object_of = is_apart_ || !object.name.empty() ? std::span<const std::int32_t>()
                                                             : indices_of(attributes_, channel_names::object);
    using Key = std::pair<std::int32_t, std::int32_t>;
    const auto key_of = [&](std::size_t i) {
      const std::uint32_t f = object.faces[i];
      return Key(object_of.empty() ? -1 : object_of[f], material.empty() ? -1 : material[f]);
    };
    Json all = Json::array();
    const auto add_list = [&](const Key& key, std::size_t indices) {
      Json list = {{"attributes", attributes}, {"indices", indices}};
      if (key.second >= 0) list["material"] = key.second;
      if (key.first >= 0) list["extras"] = {{"object", attributes_.objects[static_cast<std::size_t>(key.first)]}};
      all.push_back(std::move(list));
    };
    const std::size_t count = object.faces.size();
    if (holds_for_all(count, [&, first = key_of(0)](std::size_t i) { return key_of(i) == first; })) {
      add_list(key_of(0), write_indices(vertices, count, std::identity()));
      return all;
    }
    std::map<Key, std::vector<std::uint32_t>> lists;
    auto last = lists.end();  // successive faces mostly have the same
    for (std::size_t i = 0; i < count; ++i) {
      const Key key = key_of(i);
      if (last == lists.end() || last->first != key) last = lists.try_emplace(key).first;
      last->second.push_back(static_cast<std::uint32_t>(i));
    }
    for (auto& [key, faces] : lists) {
      const std::vector<std::uint32_t>& list = lists_.emplace_back(std::move(faces));
      add_list(key, write_indices(vertices, list.size(), [&list](std::size_t i) { return list[i]; }));
    }
    return all;
  }

  Json write_vertices(const SeamVertices& vertices) {
    const std::size_t count = vertices.vertices.size();
    const std::size_t view = buffer_.add(count, 12, vertex_buffer, [this, &vertices](std::size_t i, char* at) {
      for (const double x : target_.mesh.vertices[vertices.vertices[i]])
        at = store(at, static_cast<float>(x), byte_order);
    });
    const Bounds bounds = bounds_of(target_.mesh.vertices, vertices.vertices);
    Json attributes = {{"POSITION", add_accessor(view, type_of_floats, count, 3)}};
    json_["accessors"].back()["min"] = bounds.low;
    json_["accessors"].back()["max"] = bounds.high;
    for (const auto& [c, attribute] : kept_) attributes[attribute] = write_channel(*c, attribute, vertices);
    return attributes;
  }

  std::size_t write_channel(const Channel& c, const std::string& attribute, const SeamVertices& vertices) {
    const std::size_t n = c.components, count = vertices.vertices.size();
    const auto element = [&c, &vertices](std::size_t i) -> std::size_t {
      return c.element == Element::vertex ? vertices.vertices[i] : vertices.corners[i];
    };
    if (const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&c.values)) {
      const std::size_t view = buffer_.add(count, 4, vertex_buffer, [element, bytes, n](std::size_t i, char* at) {
        std::fill_n(at, 4, '\0');
        if (element(i) == SeamVertices::none) return;
        for (std::size_t k = 0; k < n; ++k) at[k] = static_cast<char>((*bytes)[element(i) * n + k]);
      });
      const std::size_t accessor = add_accessor(view, type_of_bytes, count, n);
      json_["accessors"].back()["normalized"] = true;
      return accessor;
    }
    const bool flips = attribute.starts_with("TEXCOORD");
    const std::size_t view = buffer_.add(count, 4 * n, vertex_buffer, [element, &c, flips, n](std::size_t i, char* at) {
      for (std::size_t k = 0; k < n; ++k) {
        const double x = element(i) == SeamVertices::none ? 0 : value_of(c, element(i), k);
        at = store(at, static_cast<float>(flips && k == 1 ? 1 - x : x), byte_order);
      }
    });
    return add_accessor(view, type_of_floats, count, n);
  }

  /// The triangles `number(i)` for each i below n.
  template <class Number>
  std::size_t write_indices(const SeamVertices& vertices, std::size_t n, const Number& number) {
    const std::size_t view = buffer_.add(n, 12, index_buffer, [&vertices, number](std::size_t i, char* at) {
      for (const std::uint32_t v : vertices.triangles[number(i)]) at = store(at, v, byte_order);
    });
    return add_accessor(view, type_of_indices, 3 * n, 1);
  }

  std::size_t add_accessor(std::size_t view, std::uint32_t type, std::size_t count, std::size_t components) {
    constexpr std::array<const char*, 4> names{"SCALAR", "VEC2", "VEC3", "VEC4"};
    json_["accessors"].push_back(
        {{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", names[components - 1]}});
    return json_["accessors"].size() - 1;
  }

  void finish() {
    if (buffer_.size() == 0) return;
    json_["bufferViews"] = buffer_.views();
    json_["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
  }

  const Target& target_;
  const Attributes& attributes_;
  Notes& notes_;
  std::vector<std::pair<const Channel*, std::string>> kept_;
  std::vector<const Channel*> not_finite_;
  std::vector<const Channel*> seams_;
  std::vector<ObjectFaces> objects_;
  bool is_apart_ = false;
  std::vector<SeamVertices> vertices_;            ///< per object
  std::deque<std::vector<std::uint32_t>> lists_;  ///< faces of each list
  Buffer buffer_;
  Json json_;
};

/// Names that are not UTF-8 get marks in place of what is not.
std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

Notes write_glb(const Target& target) {
  constexpr std::uint32_t mark = 0x46546c67, json_mark = 0x4e4f534a, binary_mark = 0x004e4942;
  constexpr std::size_t header_size = 12, chunk_header = 8;
  Notes notes;
  DocumentWriter document(target, notes);
  std::string json = dumped(document.json());
  json.resize(padded(json.size()), ' ');
  const std::size_t binary = document.buffer().size();
  const std::size_t size = header_size + chunk_header + json.size() + (binary > 0 ? chunk_header + binary : 0);
  if (size > std::numeric_limits<std::uint32_t>::max()) throw IoError(target.name, {}, "GLB holds less than 4 GB");
  const auto write_words = [&](std::initializer_list<std::size_t> words) {
    std::string bytes(4 * words.size(), '\0');
    char* at = bytes.data();
    for (const std::size_t w : words) at = store(at, static_cast<std::uint32_t>(w), byte_order);
    target.sink.write(bytes);
  };
  write_words({mark, 2, size, json.size(), json_mark});
  target.sink.write(json);
  if (binary > 0) write_words({binary, binary_mark});
  document.buffer().write(target.sink);
  return notes;
}

Notes write_gltf(const Target& target) {
  Notes notes;
  DocumentWriter document(target, notes);
  if (document.buffer().size() > 0) {
    StringSink bytes;
    document.buffer().write(bytes);
    document.json()["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(bytes.take());
  }
  target.sink.write(dumped(document.json()) + "\n");
  return notes;
}

}  // namespace strata::io
