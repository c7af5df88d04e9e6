#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/io/blocks.h"
#include "core/io/finite_values.h"
#include "core/io/losses.h"
#include "core/io/text_lines.h"
#include "core/io/writers.h"

namespace strata::io {
namespace {

template <class T>
bool has(const Channel& c) {
  return std::holds_alternative<std::vector<T>>(c.values);
}

/// The values that are written of an element; null: none.
struct OffChannels {
  const Channel* normal = nullptr;
  const Channel* color = nullptr;
  const Channel* texcoord = nullptr;
  const Channel* face_color = nullptr;

  explicit OffChannels(const Attributes& attributes) {
    for (const Channel& c : attributes.channels) {
      const bool is_float = has<float>(c) || has<double>(c), is_of_vertices = c.element == Element::vertex;
      if (c.name == channel_names::normal && c.components == 3 && is_float && is_of_vertices) normal = &c;
      if (c.name == channel_names::texcoord && c.components == 2 && is_float && is_of_vertices) texcoord = &c;
      // Colours are read as floats.
      const bool is_color = has<float>(c) || has<std::uint8_t>(c) || (has<double>(c) && has_finite_floats(c));
      if (c.name == channel_names::color && c.components >= 3 && is_color) {
        if (is_of_vertices) color = &c;
        if (c.element == Element::face) face_color = &c;
      }
    }
  }
  [[nodiscard]] std::string keyword() const {
    return std::string(texcoord != nullptr ? "ST" : "") + (color != nullptr ? "C" : "") +
           (normal != nullptr ? "N" : "") + "OFF";
  }
  [[nodiscard]] bool keeps(const Channel& c) const {
    return &c == normal || &c == color || &c == texcoord || &c == face_color;
  }
};

constexpr std::size_t longest_value = longest_number + 3;  // a blank before it, a point and a zero behind it

/// Floats that are whole numbers have a point: a colour of integers has bytes.
template <class T>
char* append_value(char* at, T value, bool with_point) {
  *at++ = ' ';
  char* const end = std::to_chars(at, at + longest_number, value).ptr;
  const bool is_whole = std::all_of(at, end, [](char c) { return c == '-' || (c >= '0' && c <= '9'); });
  return with_point && is_whole ? append(end, ".0") : end;
}

char* append_values(char* at, const Channel* c, std::size_t element, bool with_point) {
  if (c == nullptr) return at;
  std::visit(
      [&](const auto& values) {
        for (std::size_t k = 0; k < c->components; ++k)
          at = append_value(at, values[element * c->components + k], with_point);
      },
      c->values);
  return at;
}

char* append_color(char* at, const Channel* c, std::size_t element) {
  return append_values(at, c, element, c != nullptr && !has<std::uint8_t>(*c));
}

}  // namespace

Notes write_off(const Target& target) {
  const MeshView mesh = target.mesh;
  const OffChannels channels(target.attributes);
  target.sink.write(channels.keyword() + "\n" + std::to_string(mesh.vertices.size()) + " " +
                    std::to_string(mesh.triangles.size()) + " 0\n");
  // A normal, a colour, a place in a texture.
  write_blocks(target.sink, mesh.vertices.size(), longest_line("") + 9 * longest_value, [&](std::size_t i, char* at) {
    at = append_line(at, "", mesh.vertices[i]) - 1;
    at = append_values(at, channels.normal, i, false);
    at = append_color(at, channels.color, i);
    at = append_values(at, channels.texcoord, i, false);
    return append(at, "\n");
  });
  write_blocks(target.sink, mesh.triangles.size(), longest_line("3 ") + 4 * longest_value,
               [&](std::size_t i, char* at) {
                 at = append_line(at, "3 ", mesh.triangles[i]) - 1;
                 return append(append_color(at, channels.face_color, i), "\n");
               });
  Notes notes;
  note_losses(notes, target.attributes, target.unit, "OFF", {}, [&](const Channel& c) { return channels.keeps(c); });
  return notes;
}

}  // namespace strata::io
