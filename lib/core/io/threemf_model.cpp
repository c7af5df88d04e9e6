#include "core/io/threemf_model.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <limits>
#include <utility>

#include "core/containers/huge_pages.h"
#include "core/io/face_list.h"
#include "core/io/holds_for_all.h"
#include "core/io/xml_scanner.h"

namespace strata::io {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Of the words of a list; calls use(word).
template <class Use>
void for_each_word(std::string_view list, const Use& use) {
  constexpr std::string_view blanks = " \t\r\n";
  for (std::size_t first = list.find_first_not_of(blanks); first != std::string_view::npos;) {
    const std::size_t end = std::min(list.find_first_of(blanks, first), list.size());
    use(list.substr(first, end - first));
    first = list.find_first_not_of(blanks, end);
  }
}

const std::string_view& required(const XmlScanner& xml, std::string_view attribute) {
  const auto* value = xml.find(attribute);
  if (value == nullptr)
    xml.fail_here("<" + std::string(xml.name().substr(0, 32)) + "> has no attribute " + std::string(attribute));
  return *value;
}

std::uint32_t required_index(const XmlScanner& xml, std::string_view attribute) {
  return xml.index(required(xml, attribute), "a whole number");
}

double required_number(const XmlScanner& xml, std::string_view attribute) {
  return xml.number(required(xml, attribute), "a number");
}

/// The children of that name of the element at which the scanner is, in order; read(scanner) gives each. Other children
/// are skipped. Long lists are read in pieces, on all threads; where that fails, again by the scanner, which finds the
/// first error.
template <class Read>
auto read_list(XmlScanner& xml, std::string_view name, const Read& read) {
  using Item = decltype(read(xml));
  const auto append = [&](XmlScanner& scanner, std::vector<Item>& items) {
    while (scanner.next_child()) {
      if (scanner.name() == name) items.push_back(read(scanner));
      scanner.skip();
    }
  };
  std::vector<Item> all;
  if (const std::vector<std::string_view> pieces = xml.pieces(); pieces.size() > 1) {
    std::vector<std::vector<Item>> of_piece(pieces.size());
    std::atomic<bool> is_read = true;
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
      try {
        XmlScanner piece(pieces[i]);
        if (is_read) append(piece, of_piece[i]);
      } catch (const Malformed&) {
        is_read = false;
      }
    });
    if (is_read) {
      xml.pass(pieces);
      std::size_t count = 0;
      for (const auto& items : of_piece) count += items.size();
      all.reserve(count);
      prefer_huge_pages(all.data(), count * sizeof(Item));
      for (auto& items : of_piece) {
        all.insert(all.end(), items.begin(), items.end());
        items = {};
      }
    }
  }
  append(xml, all);
  return all;
}

class ModelParser {
 public:
  explicit ModelParser(std::string_view text) : xml_(text) {}

  ThreemfModel parse() {
    if (!xml_.next_child() || xml_.name() != "model")
      xml_.fail_here("expected <model>, which a part of 3MF consists of");
    read_model_attributes();
    while (xml_.next_child())
      if (xml_.name() == "resources")
        read_resources();
      else if (xml_.name() == "build")
        read_build();
      else
        xml_.skip();
    return std::move(model_);
  }

 private:
  void read_model_attributes() {
    if (const auto* unit = xml_.find("unit")) {
      const auto known = unit_named(*unit);
      if (!known) xml_.fail_here("unknown unit " + quoted(*unit));
      model_.unit = *known;
    }
    const std::string_view* const required = xml_.find("requiredextensions");
    if (required == nullptr) return;
    constexpr std::array<std::string_view, 4> known{"/material/", "/production/", "/trianglesets/", "/core/"};
    for_each_word(*required, [&](std::string_view prefix) {
      const std::string_view* const name = xml_.find(prefix);
      const std::string_view extension = name == nullptr ? prefix : *name;
      const bool is_known = std::any_of(
          known.begin(), known.end(), [&](std::string_view k) { return extension.find(k) != std::string_view::npos; });
      if (!is_known)
        xml_.fail_here("the file requires the extension '" + std::string(extension.substr(0, 100)) +
                       "', which is not read");
    });
  }

  std::uint32_t index_or(std::string_view attribute, std::uint32_t otherwise) {
    const auto* value = xml_.find(attribute);
    return value == nullptr ? otherwise : xml_.index(*value, "a whole number");
  }

  void read_resources() {
    while (xml_.next_child()) {
      const std::string_view name = xml_.name();
      if (name == "object")
        read_object();
      else if (name == "basematerials")
        read_bases();
      else if (name == "colorgroup")
        read_colors();
      else if (name == "texture2d")
        read_texture();
      else if (name == "texture2dgroup")
        read_texcoords();
      else if (name == "multiproperties")
        read_multi();
      else
        read_unknown();
    }
  }

  ThreemfGroup& new_group(ThreemfGroup::Kind kind) {
    const auto [place, is_new] = model_.groups.try_emplace(required_index(xml_, "id"));
    if (!is_new) xml_.fail_here("two groups of surfaces have the id " + std::to_string(place->first));
    place->second.kind = kind;
    return place->second;
  }

  void read_bases() {
    ThreemfGroup& group = new_group(ThreemfGroup::Kind::base);
    while (xml_.next_child()) {
      if (xml_.name() == "base") group.bases.push_back({xml_.text_of("name"), color("displaycolor")});
      xml_.skip();
    }
  }

  void read_colors() {
    ThreemfGroup& group = new_group(ThreemfGroup::Kind::color);
    while (xml_.next_child()) {
      if (xml_.name() == "color") group.colors.push_back(color("color"));
      xml_.skip();
    }
  }

  void read_texture() {
    const std::uint32_t id = required_index(xml_, "id");
    if (!model_.textures.try_emplace(id, ThreemfTexture{xml_.text_of("path"), xml_.text_of("contenttype"), {}}).second)
      xml_.fail_here("two textures have the id " + std::to_string(id));
    xml_.skip();
  }

  void read_texcoords() {
    ThreemfGroup& group = new_group(ThreemfGroup::Kind::texture);
    group.texture = required_index(xml_, "texid");
    group.texcoords = read_list(xml_, "tex2coord", [](const XmlScanner& xml) {
      return std::array<double, 2>{required_number(xml, "u"), required_number(xml, "v")};
    });
  }

  void read_multi() {
    ThreemfGroup& group = new_group(ThreemfGroup::Kind::multi);
    for_each_word(xml_.text_of("pids"),
                  [&](std::string_view word) { group.layers.push_back(xml_.index(word, "the id of a group")); });
    while (xml_.next_child()) {
      if (xml_.name() == "multi") {
        std::vector<std::uint32_t> entry;
        for_each_word(xml_.text_of("pindices"),
                      [&](std::string_view word) { entry.push_back(xml_.index(word, "an index")); });
        entry.resize(group.layers.size());
        group.multi.insert(group.multi.end(), entry.begin(), entry.end());
      }
      xml_.skip();
    }
  }

  /// Resources of other kinds may be groups as well.
  void read_unknown() {
    if (const auto* id = xml_.find("id")) {
      std::uint32_t number = 0;
      const auto [end, error] = std::from_chars(id->data(), id->data() + id->size(), number);
      if (error == std::errc{} && end == id->data() + id->size()) model_.groups.try_emplace(number);
    }
    xml_.skip();
  }

  /// "#rrggbb" or "#rrggbbaa".
  std::array<std::uint8_t, 4> color(std::string_view attribute) {
    std::array<std::uint8_t, 4> color{255, 255, 255, 255};
    const auto* value = xml_.find(attribute);
    if (value == nullptr) return color;
    const std::string_view text = *value;
    bool is_good = (text.size() == 7 || text.size() == 9) && text[0] == '#';
    for (std::size_t i = 0; is_good && 2 * i + 2 < text.size(); ++i) {
      const char* const end = text.data() + 2 * i + 3;
      is_good = std::from_chars(end - 2, end, color[i], 16).ptr == end;
    }
    if (!is_good) xml_.fail_here("expected a colour such as #ff8000, found " + quoted(text));
    return color;
  }

  ExactMap transform() {
    ExactMap map = ExactMap::identity();
    const auto* value = xml_.find("transform");
    if (value == nullptr) return map;
    std::size_t n = 0;
    for_each_word(*value, [&](std::string_view word) {
      const double x = xml_.number(word, "a number of a transform");
      if (n < 12) map.rows[n % 3][n / 3] = Rational(x);
      ++n;
    });
    if (n != 12) xml_.fail_here("a transform has " + std::to_string(n) + " numbers, not 12");
    return map;
  }

  void read_object() {
    const std::uint32_t id = required_index(xml_, "id");
    const auto [place, is_new] = model_.objects.try_emplace(id);
    if (!is_new) xml_.fail_here("two objects have the id " + std::to_string(id));
    ThreemfObject& object = place->second;
    object.name = xml_.text_of("name");
    const std::string type = xml_.text_of("type");
    object.is_model = type != "support" && type != "solidsupport" && type != "other";
    const std::uint32_t group = index_or("pid", 0), number = index_or("pindex", 0);
    usual_ = {group, {number, number, number}};
    ++model_.things;
    while (xml_.next_child()) {
      if (xml_.name() == "mesh")
        read_mesh(object);
      else if (xml_.name() == "components")
        read_components(object);
      else
        xml_.skip();
    }
  }

  void read_components(ThreemfObject& object) {
    while (xml_.next_child()) {
      if (xml_.name() == "component") {
        object.components.push_back({xml_.text_of("path"), required_index(xml_, "objectid"), transform()});
        ++model_.things;
      }
      xml_.skip();
    }
  }

  void read_mesh(ThreemfObject& object) {
    while (xml_.next_child()) {
      if (xml_.name() == "vertices")
        read_vertices(object.part);
      else if (xml_.name() == "triangles")
        read_triangles(object);
      else if (xml_.name() == "beamlattice")
        xml_.fail_here("the mesh has a lattice of beams, which is not read");
      else
        xml_.skip();
    }
    model_.things += object.part.vertices.size() + object.part.triangles.size();
  }

  void read_vertices(ScenePart& part) {
    std::vector<Vertex> vertices = read_list(xml_, "vertex", [](const XmlScanner& xml) {
      unsigned found = 0;
      Vertex p{};
      for (const XmlScanner::Attribute& a : xml.attributes()) {
        const char axis = a.name.size() == 1 ? a.name[0] : ' ';
        if (axis < 'x' || axis > 'z') continue;
        p[static_cast<std::size_t>(axis - 'x')] = xml.number(a.value, "a coordinate");
        found |= 1U << static_cast<unsigned>(axis - 'x');
      }
      if (found != 7) xml.fail_here("a vertex has not all of x, y and z");
      return p;
    });
    if (part.vertices.empty())
      part.vertices = std::move(vertices);
    else
      part.vertices.insert(part.vertices.end(), vertices.begin(), vertices.end());
    if (part.vertices.size() > most_items) xml_.fail_here("more than 2^32 - 2 vertices");
  }

  struct GivenTriangle {
    Triangle corners;
    ThreemfSurface surface;  ///< what is not given is `none`
  };

  static GivenTriangle triangle(const XmlScanner& xml, std::size_t vertices) {
    GivenTriangle t{{none, none, none}, {none, {none, none, none}}};
    for (const XmlScanner::Attribute& a : xml.attributes()) {
      if (a.name == "pid") t.surface.group = xml.index(a.value, "the id of a group");
      if (a.name.size() != 2 || a.name[1] < '1' || a.name[1] > '3') continue;
      const auto corner = static_cast<std::size_t>(a.name[1] - '1');
      if (a.name[0] == 'v') t.corners[corner] = xml.index(a.value, "the index of a vertex");
      if (a.name[0] == 'p') t.surface.corners[corner] = xml.index(a.value, "the index of a surface");
    }
    for (const std::uint32_t v : t.corners)
      if (v >= vertices)
        xml.fail_here(v == none ? std::string("a triangle has not all of v1, v2 and v3")
                                : "vertex index " + std::to_string(v) + " is out of range: the mesh has " +
                                      std::to_string(vertices) + " vertices");
    return t;
  }

  void read_triangles(ThreemfObject& object) {
    const std::size_t vertices = object.part.vertices.size();
    const std::vector<GivenTriangle> given =
        read_list(xml_, "triangle", [&](const XmlScanner& xml) { return triangle(xml, vertices); });
    const std::size_t first = object.part.triangles.size(), count = first + given.size();
    const auto append = [&](auto& values, const auto& value_of) {
      values.reserve(count);
      prefer_huge_pages(values.data(), count * sizeof(values[0]));
      values.resize(count);
      tbb::parallel_for(std::size_t{0}, given.size(), [&](std::size_t i) { values[first + i] = value_of(given[i]); });
    };
    append(object.part.triangles, [](const GivenTriangle& t) { return t.corners; });
    const bool has_none = object.surfaces.empty() && holds_for_all(given.size(), [&](std::size_t i) {
                            return completed(given[i].surface).group == 0;
                          });
    if (!has_none) append(object.surfaces, [&](const GivenTriangle& t) { return completed(t.surface); });
  }

  /// What a triangle does not say of its surface is that of the object. Without p1 it has the object's surface; p2 and
  /// p3 are p1 unless they are given.
  [[nodiscard]] ThreemfSurface completed(ThreemfSurface surface) const {
    if (surface.corners[0] == none) return usual_;
    if (surface.group == none) surface.group = usual_.group;
    for (const std::size_t k : {1, 2})
      if (surface.corners[k] == none) surface.corners[k] = surface.corners[0];
    return surface;
  }

  void read_build() {
    while (xml_.next_child()) {
      if (xml_.name() == "item") {
        model_.items.push_back({xml_.text_of("path"), required_index(xml_, "objectid"), transform()});
        ++model_.things;
      }
      xml_.skip();
    }
  }

  XmlScanner xml_;
  ThreemfModel model_;
  ThreemfSurface usual_;  ///< of the object's triangles
};

}  // namespace

ThreemfModel parse_3mf_model(std::string_view text) { return ModelParser(text).parse(); }

}  // namespace strata::io
