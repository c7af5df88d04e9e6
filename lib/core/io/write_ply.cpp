#include <algorithm>
#include <array>
#include <bit>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "core/io/binary.h"
#include "core/io/blocks.h"
#include "core/io/losses.h"
#include "core/io/ply_names.h"
#include "core/io/ply_textures.h"
#include "core/io/text_lines.h"
#include "core/io/writers.h"

namespace strata::io {
namespace {

const char* type_name(const ChannelValues& values) {
  constexpr std::array<const char*, 4> names{"float", "double", "uchar", "int"};
  return names[values.index()];
}

/// A name that cannot stand in a line of the header is not kept.
bool has_line(const std::string& name) {
  return std::none_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; });
}

/// The known properties that a channel with a name in its element is written as; null: others.
const PlyKnownNames* known_names(const Channel& c, std::string_view name) {
  const auto* const known = std::find_if(ply_known_names.begin(), ply_known_names.end(),
                                         [&](const PlyKnownNames& k) { return k.channel == name; });
  if (known == ply_known_names.end() || c.interpolation != known->interpolation || c.element == Element::corner)
    return nullptr;
  const bool is_color = name == channel_names::color;
  const bool is_count = c.components == known->least || (is_color && c.components == known->least + 1);
  const bool is_float =
      std::holds_alternative<std::vector<float>>(c.values) || std::holds_alternative<std::vector<double>>(c.values);
  const bool is_byte = std::holds_alternative<std::vector<std::uint8_t>>(c.values);
  return is_count && (is_float || (is_color && is_byte)) ? known : nullptr;
}

bool is_texcoord_list(const Channel& c, std::string_view name) {
  return name == channel_names::texcoord && c.element == Element::corner && c.components == 2 &&
         c.interpolation == Interpolation::linear && c.values.index() < 2;
}

/// Names of properties are words, each different.
class PropertyNames {
 public:
  explicit PropertyNames(std::set<std::string> used) : used_(std::move(used)) {}

  std::string take(std::string name) {
    for (char& c : name)
      if (c == ' ') c = '_';
    while (!used_.insert(name).second) name += '_';
    return name;
  }

 private:
  std::set<std::string> used_;
};

std::string announcement(const Channel& c) {
  const auto* const how = std::find_if(ply_interpolations.begin(), ply_interpolations.end(),
                                       [&](const auto& known) { return known.second == c.interpolation; });
  return "comment channel " + std::to_string(c.components) + " " + std::string(how->first) + " " + c.name + "\n";
}

/// A channel, and its name in its element.
struct NamedChannel {
  const Channel* channel;
  std::string_view name;  ///< without what tells it from a channel of the other element

  [[nodiscard]] const PlyKnownNames* known() const { return known_names(*channel, name); }
  [[nodiscard]] bool is_texcoords() const { return is_texcoord_list(*channel, name); }
};

/// The channels that are written behind the vertices or the lists of vertices.
class Columns {
 public:
  Columns(const Attributes& attributes, const PlyTextures& textures, bool are_of_vertices) {
    for (const Channel& c : attributes.channels) {
      const bool is_replaced = !textures.empty() && c.name == channel_names::material;
      const Channel& written = is_replaced ? textures.numbers() : c;
      if ((written.element == Element::vertex) == are_of_vertices && has_line(c.name))
        columns_.push_back({&written, written.name});
    }
    const std::string_view prefix = ply_prefix(are_of_vertices ? Element::vertex : Element::face);
    for (NamedChannel& column : columns_)
      if (column.name.starts_with(prefix) && column.name.size() > prefix.size())
        if (const std::string_view name = column.name.substr(prefix.size()); !has(name)) column.name = name;
  }

  /// The lines of the header. `used` are names of properties before.
  [[nodiscard]] std::string header(std::set<std::string> used) const {
    for (const NamedChannel& c : columns_) {
      if (c.is_texcoords()) used.emplace(ply_texcoord_list);
      const PlyKnownNames* const known = c.known();
      if (known == nullptr) continue;
      for (const std::string_view name : known->names(c.channel->components)) used.emplace(name);
    }
    PropertyNames names(std::move(used));
    std::string text;
    for (const NamedChannel& c : columns_) text += properties(c, names);
    return text;
  }

  /// The most bytes of a record in a text, and the number in a binary file.
  [[nodiscard]] std::size_t most_characters() const {
    std::size_t sum = 0;
    for (const auto& [c, name] : columns_) sum += 3 + per_record(*c) * (longest_number + 1);
    return sum;
  }
  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& [c, name] : columns_)
      sum += (is_list(*c) ? 1 : 0) + per_record(*c) * std::visit([](const auto& v) { return sizeof v[0]; }, c->values);
    return sum;
  }

  char* append_text(char* at, std::size_t record) const {
    for (const auto& [c, name] : columns_) {
      if (is_list(*c)) at = append(append(at, " "), std::to_string(per_record(*c)));
      for_each_value(*c, record, [&](auto x) {
        *at++ = ' ';
        at = std::to_chars(at, at + longest_number, x).ptr;
      });
    }
    return at;
  }
  char* append_bytes(char* at, std::size_t record, std::endian order) const {
    for (const auto& [c, name] : columns_) {
      if (is_list(*c)) *at++ = static_cast<char>(per_record(*c));
      for_each_value(*c, record, [&](auto x) { at = store(at, x, order); });
    }
    return at;
  }

 private:
  static bool is_list(const Channel& c) { return c.element == Element::corner; }
  static std::size_t per_record(const Channel& c) { return (is_list(c) ? 3U : 1U) * std::size_t{c.components}; }

  template <class Use>
  static void for_each_value(const Channel& c, std::size_t record, const Use& use) {
    const std::size_t n = per_record(c);
    std::visit(
        [&](const auto& values) {
          for (std::size_t i = record * n; i < (record + 1) * n; ++i) use(values[i]);
        },
        c.values);
  }

  /// True where a channel of the element has a name.
  [[nodiscard]] bool has(std::string_view name) const {
    return std::any_of(columns_.begin(), columns_.end(), [&](const NamedChannel& c) { return c.name == name; });
  }

  static std::string properties(const NamedChannel& column, PropertyNames& names) {
    const Channel& c = *column.channel;
    const std::string type = type_name(c.values), name(column.name);
    const PlyKnownNames* const known = column.known();
    const bool is_usual = known != nullptr || column.is_texcoords();
    std::string text = is_usual && name == c.name ? "" : announcement(c);
    if (column.is_texcoords())
      return text + "property list uchar " + type + " " + std::string(ply_texcoord_list) + "\n";
    if (is_list(c)) return text + "property list uchar " + type + " " + names.take(name) + "\n";
    for (std::size_t k = 0; k < c.components; ++k) {
      const std::string own = c.components == 1 ? name : name + "_" + std::to_string(k);
      text +=
          "property " + type + " " + (known != nullptr ? std::string(known->properties[k]) : names.take(own)) + "\n";
    }
    return text;
  }

  std::vector<NamedChannel> columns_;
};

class PlyWriter {
 public:
  explicit PlyWriter(const Target& target)
      : mesh_(target.mesh),
        sink_(target.sink),
        textures_(target.attributes, target.beside),
        of_vertices_(target.attributes, textures_, true),
        of_faces_(target.attributes, textures_, false) {}

  [[nodiscard]] const PlyTextures& textures() const { return textures_; }

  void write_text() {
    write_header("ascii");
    write_blocks(sink_, mesh_.vertices.size(), longest_line("") + of_vertices_.most_characters(),
                 [&](std::size_t i, char* at) { return append_rest(at, "", mesh_.vertices[i], of_vertices_, i); });
    write_blocks(sink_, mesh_.triangles.size(), longest_line("3 ") + of_faces_.most_characters(),
                 [&](std::size_t i, char* at) { return append_rest(at, "3 ", mesh_.triangles[i], of_faces_, i); });
  }

  void write_binary(std::endian order) {
    write_header(order == std::endian::big ? "binary_big_endian" : "binary_little_endian");
    write_blocks(sink_, mesh_.vertices.size(), sizeof(Vertex) + of_vertices_.bytes(), [&](std::size_t i, char* at) {
      for (const double x : mesh_.vertices[i]) at = store(at, x, order);
      return of_vertices_.append_bytes(at, i, order);
    });
    write_blocks(sink_, mesh_.triangles.size(), 1 + sizeof(Triangle) + of_faces_.bytes(), [&](std::size_t i, char* at) {
      *at++ = '\3';
      for (const std::uint32_t v : mesh_.triangles[i]) at = store(at, v, order);
      return of_faces_.append_bytes(at, i, order);
    });
  }

 private:
  void write_header(const std::string& format) {
    // Many readers support signed indices only.
    const bool is_signed = mesh_.vertices.size() <= std::size_t{1} << 31;
    sink_.write("ply\nformat " + format + " 1.0\n" + textures_.write() + "element vertex " +
                std::to_string(mesh_.vertices.size()) + "\nproperty double x\nproperty double y\nproperty double z\n" +
                of_vertices_.header({"x", "y", "z"}) + "element face " + std::to_string(mesh_.triangles.size()) +
                "\nproperty list uchar " + (is_signed ? "int" : "uint") + " vertex_indices\n" +
                of_faces_.header({"vertex_indices"}) + "end_header\n");
  }

  template <class Numbers>
  static char* append_rest(char* at, std::string_view start, const Numbers& numbers, const Columns& rest,
                           std::size_t record) {
    at = rest.append_text(append_line(at, start, numbers) - 1, record);
    *at++ = '\n';
    return at;
  }

  MeshView mesh_;
  Sink& sink_;
  PlyTextures textures_;
  Columns of_vertices_, of_faces_;
};

}  // namespace

Notes write_ply(const Target& target, Format format) {
  PlyWriter writer(target);
  if (format == Format::ply_ascii)
    writer.write_text();
  else
    writer.write_binary(format == Format::ply_big_endian ? std::endian::big : std::endian::little);
  Notes notes;
  const bool has_textures = !writer.textures().empty();
  note_losses(notes, target.attributes, target.unit, "PLY", {.materials = has_textures, .images = has_textures},
              [](const Channel& c) { return has_line(c.name); });
  if (has_textures) writer.textures().note(notes);
  return notes;
}

}  // namespace strata::io
