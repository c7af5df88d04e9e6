#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "core/io/corner_values.h"
#include "core/io/finite_values.h"
#include "core/io/images.h"
#include "core/io/losses.h"
#include "core/io/object_faces.h"
#include "core/io/srgb.h"
#include "core/io/text_lines.h"
#include "core/io/writers.h"
#include "core/io/xml_scanner.h"
#include "core/io/zip_writer.h"

namespace strata::io {
namespace {

template <class Number>
char* append_attribute(char* at, std::string_view name, Number x) {
  at = append(at, name);
  at = std::to_chars(at, at + longest_number, x).ptr;
  *at++ = '"';
  return at;
}

std::string color_text(const std::array<std::uint8_t, 4>& color) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text = "#";
  for (std::size_t k = 0; k < (color[3] == 255 ? 3 : 4); ++k) {
    text += digits[color[k] >> 4U];
    text += digits[color[k] & 15U];
  }
  return text;
}

bool is_colors(const Channel* c) {
  return c != nullptr && c->components >= 3 && !std::holds_alternative<std::vector<std::int32_t>>(c->values);
}

/// Number of a group and numbers in it, for a triangle; group 0: none.
struct Surface {
  std::uint32_t group = 0;
  std::array<std::uint32_t, 3> corners{};
};

/// The groups of surfaces that triangles refer to. Group 1 has the materials without images, group 2 the colours, and
/// every material with an image one of its own; a triangle with a material and colours refers to a group of pairs of
/// both.
class Surfaces {
 public:
  Surfaces(const Target& target, Notes& notes) : target_(target), attributes_(target.attributes) {
    material_ = indices_of(attributes_, channel_names::material);
    if (const Channel* const color = attributes_.find(channel_names::color); is_colors(color)) keep(*color, color_);
    const Channel* const texcoord = attributes_.find(channel_names::texcoord);
    const bool is_textured = std::any_of(attributes_.materials.begin(), attributes_.materials.end(),
                                         [](const Material& m) { return m.image.has_value(); });
    if (texcoord != nullptr && texcoord->components == 2 && is_textured && !material_.empty())
      keep(*texcoord, texcoord_);
    std::uint32_t bases = 0;
    for (std::size_t m = 0; m < attributes_.materials.size(); ++m) bases_.push_back(has_texture(m) ? bases : bases++);
    base_count_ = bases;
    texcoords_.resize(attributes_.materials.size());
    pairs_.resize(attributes_.materials.size());
    number_surfaces();
    note(notes);
  }

  [[nodiscard]] bool empty() const { return surfaces_.empty(); }
  [[nodiscard]] const Surface& of(std::size_t face) const { return surfaces_[face]; }

  /// All groups, as resources.
  void write(Sink& sink, const std::vector<std::string>& image_names) const {
    write_textures(sink, image_names);
    write_bases(sink);
    if (!colors_.values().empty()) {
      sink.write("<m:colorgroup id=\"2\">\n");
      write_texts(sink, colors_.values().size(), [&](std::size_t i, std::string& text) {
        text += "<m:color color=\"" + color_text(colors_.values()[i]) + "\"/>\n";
      });
      sink.write("</m:colorgroup>\n");
    }
    for (std::size_t m = 0; m < texcoords_.size(); ++m) write_texcoords(sink, m);
    for (std::size_t m = 0; m < pairs_.size(); ++m) write_pairs(sink, m);
  }

  [[nodiscard]] bool keeps(const Channel& c) const {
    return &c == color_ || &c == texcoord_ || std::ranges::find(not_finite_, &c) != not_finite_.end() ||
           (c.name == channel_names::material && !material_.empty());
  }
  [[nodiscard]] bool writes_images() const { return texcoord_ != nullptr; }
  [[nodiscard]] std::uint32_t first_free() const { return pair_group(attributes_.materials.size()); }

 private:
  [[nodiscard]] static constexpr std::uint32_t base_group() { return 1; }
  [[nodiscard]] static constexpr std::uint32_t color_group() { return 2; }
  [[nodiscard]] static std::uint32_t texture(std::size_t image) { return static_cast<std::uint32_t>(3 + image); }
  [[nodiscard]] std::uint32_t texture_group(std::size_t material) const {
    return texture(attributes_.images.size() + material);
  }
  [[nodiscard]] std::uint32_t pair_group(std::size_t material) const {
    return texture_group(attributes_.materials.size() + material);
  }
  [[nodiscard]] bool has_texture(std::size_t material) const {
    return texcoord_ != nullptr && attributes_.materials[material].image.has_value();
  }

  /// Keeps a channel if the format can.
  void keep(const Channel& channel, const Channel*& as) {
    if (has_finite_values(channel))
      as = &channel;
    else
      not_finite_.push_back(&channel);
  }

  void number_surfaces() {
    if (material_.empty() && color_ == nullptr) return;
    surfaces_.resize(target_.mesh.triangles.size());
    last_color_.resize(color_ != nullptr ? target_.mesh.vertices.size() : 0);
    last_texcoord_.resize(texcoord_ != nullptr ? target_.mesh.vertices.size() : 0);
    for (std::size_t f = 0; f < surfaces_.size(); ++f) {
      const Surface material = material_of(f), color = color_of(f);
      if (material.group == 0 || color.group == 0)
        surfaces_[f] = material.group == 0 ? color : material;
      else
        surfaces_[f] = pair_of(static_cast<std::size_t>(material_[f]), material, color);
    }
  }

  Surface material_of(std::size_t f) {
    if (material_.empty() || material_[f] < 0) return {};
    const auto m = static_cast<std::uint32_t>(material_[f]);
    if (!has_texture(m)) return {base_group(), {bases_[m], bases_[m], bases_[m]}};
    Surface surface{texture_group(m), {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& t = target_.mesh.triangles[f];
      const std::size_t e = element_of_corner(*texcoord_, t, f, k);
      const std::array<double, 2> value{value_of(*texcoord_, e, 0), value_of(*texcoord_, e, 1)};
      surface.corners[k] = texcoords_[m].number_of(value, last_texcoord_[t[k]]);
    }
    return surface;
  }

  Surface color_of(std::size_t f) {
    if (color_ == nullptr) return {};
    Surface surface{color_group(), {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& t = target_.mesh.triangles[f];
      const std::size_t e = element_of_corner(*color_, t, f, k);
      std::array<std::uint8_t, 4> color{255, 255, 255, 255};
      for (std::size_t i = 0; i < color_->components; ++i) color[i] = color_byte(value_of(*color_, e, i));
      surface.corners[k] = colors_.number_of(color, last_color_[t[k]]);
    }
    return surface;
  }

  std::uint8_t color_byte(double x) {
    if (std::holds_alternative<std::vector<std::uint8_t>>(color_->values)) return static_cast<std::uint8_t>(x);
    const std::uint8_t byte = byte_of(x);
    colors_are_rounded_ = colors_are_rounded_ || static_cast<float>(byte / 255.0) != static_cast<float>(x);
    return byte;
  }

  Surface pair_of(std::size_t m, const Surface& material, const Surface& color) {
    Surface surface{pair_group(m), {}};
    for (std::size_t k = 0; k < 3; ++k)
      surface.corners[k] = pairs_[m].number_of({material.corners[k], color.corners[k]});
    return surface;
  }

  void note(Notes& notes) const {
    note_not_finite(notes, not_finite_, "3MF");
    if (colors_are_rounded_) notes.emplace_back("colours were rounded to bytes: 3MF holds no others");
    std::size_t looks = 0, names = 0, rounded = 0;
    for (std::size_t i = 0; i < attributes_.materials.size(); ++i) {
      const Material& m = attributes_.materials[i];
      const bool textured = has_texture(i);
      looks += m.metallic != 0 || m.roughness != 1 || (textured && m.color != std::array<double, 4>{1, 1, 1, 1});
      names += textured && !m.name.empty();
      if (!textured)
        for (std::size_t k = 0; k < 3; ++k) rounded += linear_of_srgb(srgb_of_linear(m.color[k])) != m.color[k];
    }
    if (looks > 0)
      notes.emplace_back(
          "how metallic and rough materials are, and colours below textures, left out: 3MF cannot keep them");
    if (names > 0) notes.emplace_back("names of materials with textures left out: 3MF cannot keep them");
    if (rounded > 0) notes.emplace_back("colours of materials were rounded to bytes: 3MF holds no others");
  }

  void write_textures(Sink& sink, const std::vector<std::string>& image_names) const {
    if (!writes_images()) return;
    for (std::size_t i = 0; i < image_names.size(); ++i)
      sink.write("<m:texture2d id=\"" + std::to_string(texture(i)) + "\" path=\"/3D/Textures/" +
                 escaped(image_names[i]) + "\" contenttype=\"" + escaped(media_type_of(attributes_.images[i])) +
                 "\"/>\n");
  }

  void write_bases(Sink& sink) const {
    if (base_count_ == 0) return;
    sink.write("<basematerials id=\"1\">\n");
    for (std::size_t i = 0; i < attributes_.materials.size(); ++i) {
      if (has_texture(i)) continue;
      const Material& m = attributes_.materials[i];
      std::array<std::uint8_t, 4> color{0, 0, 0, byte_of(m.color[3])};
      for (std::size_t k = 0; k < 3; ++k) color[k] = srgb_of_linear(m.color[k]);
      sink.write("<base name=\"" + escaped(m.name) + "\" displaycolor=\"" + color_text(color) + "\"/>\n");
    }
    sink.write("</basematerials>\n");
  }

  void write_texcoords(Sink& sink, std::size_t m) const {
    const auto& values = texcoords_[m].values();
    if (values.empty()) return;
    sink.write("<m:texture2dgroup id=\"" + std::to_string(texture_group(m)) + "\" texid=\"" +
               std::to_string(texture(*attributes_.materials[m].image)) + "\">\n");
    write_texts(sink, values.size(), [&](std::size_t i, std::string& text) {
      text += "<m:tex2coord u=\"" + number_text(values[i][0]) + "\" v=\"" + number_text(values[i][1]) + "\"/>\n";
    });
    sink.write("</m:texture2dgroup>\n");
  }

  void write_pairs(Sink& sink, std::size_t m) const {
    const auto& values = pairs_[m].values();
    if (values.empty()) return;
    const std::uint32_t first = has_texture(m) ? texture_group(m) : base_group();
    sink.write("<m:multiproperties id=\"" + std::to_string(pair_group(m)) + "\" pids=\"" + std::to_string(first) + " " +
               std::to_string(color_group()) + "\">\n");
    write_texts(sink, values.size(), [&](std::size_t i, std::string& text) {
      text += "<m:multi pindices=\"" + std::to_string(values[i][0]) + " " + std::to_string(values[i][1]) + "\"/>\n";
    });
    sink.write("</m:multiproperties>\n");
  }

  const Target& target_;
  const Attributes& attributes_;
  std::span<const std::int32_t> material_;
  const Channel* color_ = nullptr;
  const Channel* texcoord_ = nullptr;
  std::vector<const Channel*> not_finite_;  ///< channels that cannot be written
  std::vector<std::uint32_t> bases_;        ///< per material, its number among those without images
  std::uint32_t base_count_ = 0;
  std::vector<Surface> surfaces_;
  Numbered<std::array<std::uint8_t, 4>> colors_;
  std::vector<Numbered<std::array<double, 2>>> texcoords_;     ///< per material
  std::vector<Numbered<std::array<std::uint32_t, 2>>> pairs_;  ///< of material and colour, per material
  std::vector<std::uint32_t> last_color_, last_texcoord_;      ///< the numbers last found at each vertex
  bool colors_are_rounded_ = false;
};

void write_object(Sink& sink, const Target& target, const ObjectFaces& object, const Surfaces& surfaces,
                  std::uint32_t id) {
  sink.write("<object id=\"" + std::to_string(id) + "\" type=\"model\"" +
             (object.name.empty() ? "" : " name=\"" + escaped(object.name) + "\"") + "><mesh>\n<vertices>\n");
  write_blocks(sink, object.vertices.size(), 24 + 3 * (longest_number + 6), [&](std::size_t i, char* at) {
    const Vertex& p = target.mesh.vertices[object.vertices[i]];
    at = append_attribute(at, "<vertex x=\"", p[0]);
    at = append_attribute(at, " y=\"", p[1]);
    at = append_attribute(at, " z=\"", p[2]);
    return append(at, "/>\n");
  });
  sink.write("</vertices>\n<triangles>\n");
  write_blocks(sink, object.triangles.size(), 24 + 7 * (10 + 6), [&](std::size_t i, char* at) {
    const Triangle& t = object.triangles[i];
    at = append_attribute(at, "<triangle v1=\"", t[0]);
    at = append_attribute(at, " v2=\"", t[1]);
    at = append_attribute(at, " v3=\"", t[2]);
    if (!surfaces.empty())
      if (const Surface& s = surfaces.of(object.faces[i]); s.group != 0) {
        at = append_attribute(at, " pid=\"", s.group);
        at = append_attribute(at, " p1=\"", s.corners[0]);
        if (s.corners[1] != s.corners[0] || s.corners[2] != s.corners[0]) {
          at = append_attribute(at, " p2=\"", s.corners[1]);
          at = append_attribute(at, " p3=\"", s.corners[2]);
        }
      }
    return append(at, "/>\n");
  });
  sink.write("</triangles>\n</mesh></object>\n");
}

void write_model(ZipWriter& zip, const Target& target, const std::vector<ObjectFaces>& objects,
                 const Surfaces& surfaces, const std::vector<std::string>& image_names) {
  ZipWriter::Member model(zip, "3D/3dmodel.model");
  const std::string_view unit = target.unit == Unit::none ? name(Unit::millimeter) : name(target.unit);
  model.write("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"" + std::string(unit) +
              "\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
              "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n<resources>\n");
  surfaces.write(model, image_names);
  std::string items;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const auto id = static_cast<std::uint32_t>(surfaces.first_free() + i);
    write_object(model, target, objects[i], surfaces, id);
    items += "<item objectid=\"" + std::to_string(id) + "\"/>\n";
  }
  model.write("</resources>\n<build>\n" + items + "</build>\n</model>\n");
  model.finish();
}

constexpr std::string_view relationships =
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n";

void write_package(ZipWriter& zip) {
  zip.add("[Content_Types].xml",
          "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
          "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
          "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
          "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
          "<Default Extension=\"png\" ContentType=\"image/png\"/>\n"
          "<Default Extension=\"jpg\" ContentType=\"image/jpeg\"/>\n"
          "<Default Extension=\"jpeg\" ContentType=\"image/jpeg\"/>\n</Types>\n");
  zip.add("_rels/.rels", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + std::string(relationships) +
                             "<Relationship Id=\"rel0\" Target=\"/3D/3dmodel.model\" "
                             "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
                             "</Relationships>\n");
}

void write_images(ZipWriter& zip, const Attributes& attributes, const std::vector<std::string>& names) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + std::string(relationships);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& bytes = attributes.images[i].bytes;
    zip.store("3D/Textures/" + names[i], {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    text += "<Relationship Id=\"rel" + std::to_string(i) + "\" Target=\"/3D/Textures/" + escaped(names[i]) +
            "\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dtexture\"/>\n";
  }
  zip.add("3D/_rels/3dmodel.model.rels", text + "</Relationships>\n");
}

}  // namespace

Notes write_3mf(const Target& target) {
  Notes notes;
  const Attributes& attributes = target.attributes;
  const Surfaces surfaces(target, notes);
  std::vector<ObjectFaces> objects = closed_objects(target.mesh, attributes);
  const bool are_apart = !objects.empty();
  if (!are_apart) objects.push_back(one_object(target.mesh, attributes));
  const bool keeps_objects = are_apart || !objects.front().name.empty();
  note_losses(notes, attributes, target.unit, "3MF",
              {.materials = true, .images = surfaces.writes_images(), .objects = keeps_objects, .unit = true},
              [&](const Channel& c) {
                return surfaces.keeps(c) ||
                       (c.name == channel_names::object && !indices_of(attributes, c.name).empty());
              });
  const std::vector<std::string> image_names = file_names_of(attributes.images);
  ZipWriter zip(target.sink);
  write_package(zip);
  write_model(zip, target, objects, surfaces, image_names);
  if (surfaces.writes_images() && !image_names.empty()) write_images(zip, attributes, image_names);
  zip.finish();
  return notes;
}

}  // namespace strata::io
