#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/io/corner_values.h"
#include "core/io/finite_values.h"
#include "core/io/images.h"
#include "core/io/losses.h"
#include "core/io/mtl.h"
#include "core/io/object_faces.h"
#include "core/io/text_lines.h"
#include "core/io/writers.h"

namespace strata::io {
namespace {

std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '#' || c == '\\') c = '_';
  return text;
}

void append_number(std::string& text, double x) {
  std::array<char, longest_number + 8> digits;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr);
}

/// The lines of the values of a channel, each once, and which of them corners have.
template <std::size_t N>
class ValueLines {
 public:
  ValueLines(MeshView mesh, const Channel* channel) : mesh_(mesh), channel_(channel) {
    if (channel == nullptr || channel->element == Element::vertex) return;
    numbers_.reserve(3 * mesh.triangles.size());
    std::vector<std::uint32_t> last(mesh.vertices.size());
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        numbers_.push_back(different_.number_of(at(3 * f + k), last[mesh.triangles[f][k]]));
  }
  [[nodiscard]] bool empty() const { return channel_ == nullptr; }
  void write(Sink& sink, std::string_view start) const {
    if (empty()) return;
    const bool is_plain = channel_->element == Element::vertex;
    write_texts(sink, is_plain ? mesh_.vertices.size() : different_.values().size(),
                [&](std::size_t i, std::string& text) {
                  text += start;
                  for (const double x : is_plain ? at(i) : different_.values()[i]) append_number(text += ' ', x);
                  text += '\n';
                });
  }
  /// From 1.
  [[nodiscard]] std::uint64_t number(std::size_t face, std::size_t corner) const {
    return std::uint64_t{1} + (numbers_.empty() ? mesh_.triangles[face][corner] : numbers_[3 * face + corner]);
  }

 private:
  [[nodiscard]] std::array<double, N> at(std::size_t element) const {
    std::array<double, N> values;
    for (std::size_t k = 0; k < N; ++k) values[k] = value_of(*channel_, element, k);
    return values;
  }

  MeshView mesh_;
  const Channel* channel_;
  Numbered<std::array<double, N>> different_;
  std::vector<std::uint32_t> numbers_;
};

/// Names of one kind, and the faces at which another one begins.
struct Changes {
  std::string_view keyword;
  std::span<const std::int32_t> index;
  std::vector<std::string> names;

  void append(std::string& text, std::size_t face) const {
    if (index.empty() || (face > 0 ? index[face] == index[face - 1] : index[face] < 0)) return;
    text.append(keyword);
    if (index[face] >= 0) text.append(" ").append(names[static_cast<std::size_t>(index[face])]);
    text += '\n';
  }
};

class ObjWriter {
 public:
  explicit ObjWriter(const Target& target)
      : target_(target),
        attributes_(target.attributes),
        texcoords_(target.mesh, numbers(channel_names::texcoord, 2)),
        normals_(target.mesh, numbers(channel_names::normal, 3)),
        color_(colors()) {
    add_changes("o", channel_names::object, attributes_.objects);
    add_changes("g", channel_names::group, attributes_.groups);
    std::vector<std::string> materials;
    for (std::size_t m = 0; m < attributes_.materials.size(); ++m)
      materials.push_back(one_line(mtl_name(attributes_, m)));
    add_changes("usemtl", channel_names::material, std::move(materials));
  }

  Notes write() {
    Sink& sink = target_.sink;
    const bool has_library = target_.beside != nullptr && !attributes_.materials.empty();
    if (has_library) write_library();
    write_vertices();
    texcoords_.write(sink, "vt");
    normals_.write(sink, "vn");
    write_texts(sink, target_.mesh.triangles.size(), [&](std::size_t f, std::string& text) { append_face(text, f); });
    Notes notes;
    note_losses(notes, attributes_, target_.unit, "OBJ",
                {.materials = has_library,
                 .images = has_library,
                 .objects = has(channel_names::object),
                 .groups = has(channel_names::group)},
                [&](const Channel& c) { return keeps(c); });
    note_not_finite(notes, not_finite_, "OBJ");
    if (color_ != nullptr && color_->components == 4)
      notes.emplace_back("opacity of colours left out: OBJ cannot keep it");
    return notes;
  }

 private:
  /// A channel of the name that lines of so many numbers can hold, or null.
  const Channel* numbers(std::string_view name, std::uint32_t components) {
    const Channel* const c = attributes_.find(name);
    const bool fits = c != nullptr && c->element != Element::face && c->components == components &&
                      !std::holds_alternative<std::vector<std::uint8_t>>(c->values) &&
                      !std::holds_alternative<std::vector<std::int32_t>>(c->values);
    return fits ? finite(c) : nullptr;
  }
  /// Colours that can follow the coordinates of vertices, or null.
  const Channel* colors() {
    const Channel* const c = attributes_.find(channel_names::color);
    const bool fits = c != nullptr && c->element == Element::vertex && c->components >= 3 &&
                      !std::holds_alternative<std::vector<std::int32_t>>(c->values);
    return fits ? finite(c) : nullptr;
  }
  const Channel* finite(const Channel* c) {
    if (has_finite_values(*c)) return c;
    not_finite_.push_back(c);
    return nullptr;
  }

  void add_changes(std::string_view keyword, std::string_view channel, std::vector<std::string> names) {
    for (std::string& name : names) name = one_line(std::move(name));
    const auto index = indices_of(attributes_, channel);
    if (!index.empty()) changes_.push_back({keyword, index, std::move(names)});
  }
  [[nodiscard]] bool has(std::string_view channel) const { return !indices_of(attributes_, channel).empty(); }
  [[nodiscard]] bool keeps(const Channel& c) const {
    return &c == color_ || (c.name == channel_names::texcoord && !texcoords_.empty()) ||
           (c.name == channel_names::normal && !normals_.empty()) || has(c.name) ||
           std::find(not_finite_.begin(), not_finite_.end(), &c) != not_finite_.end();
  }

  /// The library and its images stand beside the file, named after it.
  void write_library() {
    FilesBeside& beside = *target_.beside;
    const std::string stem = beside.stem();
    beside.add(stem + ".mtl").write(mtl_text(attributes_, write_beside(attributes_.images, beside)));
    target_.sink.write("mtllib " + stem + ".mtl\n");
  }

  void write_vertices() {
    const MeshView mesh = target_.mesh;
    if (color_ == nullptr)
      return write_blocks(target_.sink, mesh.vertices.size(), longest_line("v "),
                          [&](std::size_t i, char* at) { return append_line(at, "v ", mesh.vertices[i]); });
    const double unit = std::holds_alternative<std::vector<std::uint8_t>>(color_->values) ? 255 : 1;
    write_texts(target_.sink, mesh.vertices.size(), [&](std::size_t i, std::string& text) {
      text += "v";
      for (const double x : mesh.vertices[i]) append_number(text += ' ', x);
      for (std::size_t k = 0; k < 3; ++k) append_number(text += ' ', value_of(*color_, i, k) / unit);
      text += '\n';
    });
  }

  void append_face(std::string& text, std::size_t f) const {
    for (const Changes& c : changes_) c.append(text, f);
    text += "f";
    for (std::size_t k = 0; k < 3; ++k) {
      text.append(" ").append(std::to_string(target_.mesh.triangles[f][k] + std::uint64_t{1}));
      if (!texcoords_.empty()) text.append("/").append(std::to_string(texcoords_.number(f, k)));
      if (!normals_.empty()) text.append(texcoords_.empty() ? "//" : "/").append(std::to_string(normals_.number(f, k)));
    }
    text += '\n';
  }

  const Target& target_;
  const Attributes& attributes_;
  std::vector<const Channel*> not_finite_;
  ValueLines<2> texcoords_;
  ValueLines<3> normals_;
  const Channel* color_;
  std::vector<Changes> changes_;
};

}  // namespace

Notes write_obj(const Target& target) {
  const MeshView mesh = target.mesh;
  target.sink.write("# " + std::to_string(mesh.vertices.size()) + " vertices, " +
                    std::to_string(mesh.triangles.size()) + " triangles\n");
  if (!target.attributes.empty()) return ObjWriter(target).write();
  write_lines(mesh, target.sink, "v ", "f ", 1);
  Notes notes;
  note_losses(notes, target.attributes, target.unit, "OBJ");
  return notes;
}

}  // namespace strata::io
