#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/io/face_list.h"
#include "core/io/readers.h"
#include "core/io/scene_mesh.h"
#include "core/io/xml_scanner.h"
#include "core/io/zip_archive.h"

namespace strata::io {
namespace {

using Color = std::array<float, 4>;

struct AmfObject {
  std::string name;
  ScenePart part;
  bool has_mesh = false;
};

struct AmfInstance {
  std::string object;
  ExactMap map = ExactMap::identity();
};

class AmfReader {
 public:
  AmfReader(std::string_view text, std::string name) : xml_(text), name_(std::move(name)) {}

  MeshFile read() {
    if (!xml_.next_child() || xml_.name() != "amf") xml_.fail_here("expected <amf>, of which AMF consists");
    if (const auto* unit = xml_.find("unit")) {
      const auto known = *unit == "feet" ? std::optional(Unit::foot) : unit_named(*unit);
      if (!known) xml_.fail_here("unknown unit " + quoted(*unit));
      file_.unit = *known;
    } else {
      file_.unit = Unit::millimeter;
    }
    while (xml_.next_child())
      if (xml_.name() == "object")
        read_object();
      else if (xml_.name() == "material")
        read_material();
      else if (xml_.name() == "constellation")
        read_constellation();
      else
        xml_.skip();
    finish();
    return std::move(file_);
  }

 private:
  double number(const char* what) { return xml_.number(xml_.content(), what); }

  /// Parts of a colour that are formulas are not read.
  Color read_color() {
    Color color{0, 0, 0, 1};
    while (xml_.next_child()) {
      const std::size_t k = std::string_view("rgba").find(xml_.name());
      if (k < 4 && xml_.name().size() == 1)
        color[k] = static_cast<float>(number("a number from 0 to 1: formulas of colours are not read"));
      else
        xml_.skip();
    }
    return color;
  }

  void read_material() {
    Material material;
    const std::string id = xml_.text_of("id");
    while (xml_.next_child())
      if (xml_.name() == "color") {
        const Color c = read_color();
        material.color = {c[0], c[1], c[2], c[3]};
      } else if (xml_.name() == "metadata" && xml_.text_of("type") == "name") {
        material.name = unescaped(xml_.content());
      } else {
        xml_.skip();
      }
    materials_.emplace(id, static_cast<std::int32_t>(file_.attributes.materials.size()));
    file_.attributes.materials.push_back(std::move(material));
  }

  void read_object() {
    const std::string id = xml_.text_of("id");
    const auto [place, is_new] = objects_.try_emplace(id);
    if (!is_new) xml_.fail_here("two objects have the id " + io::quoted(id));
    order_.push_back(id);
    AmfObject& object = place->second;
    while (xml_.next_child())
      if (xml_.name() == "metadata" && xml_.text_of("type") == "name")
        object.name = unescaped(xml_.content());
      else if (xml_.name() == "mesh")
        read_mesh_of(object);
      else
        xml_.skip();
    things_ += object.part.vertices.size() + object.part.triangles.size() + 1;
  }

  void read_mesh_of(AmfObject& object) {
    if (object.has_mesh) xml_.fail_here("an object has two meshes");
    object.has_mesh = true;
    read_mesh(object.part);
  }

  void read_mesh(ScenePart& part) {
    std::vector<float> colors;
    volumes_.clear();
    while (xml_.next_child())
      if (xml_.name() == "vertices")
        read_vertices(part, colors);
      else if (xml_.name() == "volume")
        read_volume(part);
      else
        xml_.skip();
    if (!colors.empty()) {
      complete(colors, 4 * part.vertices.size());
      part.channels.push_back(
          {std::string(channel_names::color), Element::vertex, Interpolation::linear, 4, std::move(colors)});
    }
    if (std::any_of(volumes_.begin(), volumes_.end(), [](const std::string& m) { return !m.empty(); }))
      add_materials(part);
  }

  /// White where there is no colour.
  static void complete(std::vector<float>& colors, std::size_t size) {
    colors.resize(std::max(size, colors.size()), 1);
  }

  void read_vertices(ScenePart& part, std::vector<float>& colors) {
    while (xml_.next_child()) {
      if (xml_.name() != "vertex") {
        xml_.skip();
        continue;
      }
      Vertex p{};
      unsigned found = 0;
      std::optional<Color> color;
      while (xml_.next_child())
        if (xml_.name() == "coordinates")
          read_coordinates(p, found);
        else if (xml_.name() == "color")
          color = read_color();
        else
          xml_.skip();
      if (found != 7) xml_.fail_here("a vertex has not all of x, y and z");
      if (color) {
        complete(colors, 4 * part.vertices.size());
        colors.insert(colors.end(), color->begin(), color->end());
      }
      part.vertices.push_back(p);
    }
    if (part.vertices.size() > most_items) xml_.fail_here("more than 2^32 - 2 vertices");
  }

  void read_coordinates(Vertex& p, unsigned& found) {
    while (xml_.next_child()) {
      const std::size_t k = std::string_view("xyz").find(xml_.name());
      if (k > 2 || xml_.name().size() != 1) {
        xml_.skip();
        continue;
      }
      p[k] = number("a coordinate");
      found |= 1U << k;
    }
  }

  void read_volume(ScenePart& part) {
    const std::string material = xml_.text_of("materialid");
    while (xml_.next_child()) {
      if (xml_.name() != "triangle") {
        xml_.skip();
        continue;
      }
      Triangle t{};
      unsigned found = 0;
      while (xml_.next_child()) {
        const std::string_view name = xml_.name();
        if (name.size() != 2 || name[0] != 'v' || name[1] < '1' || name[1] > '3') {
          xml_.skip();
          continue;
        }
        const auto k = static_cast<std::size_t>(name[1] - '1');
        t[k] = xml_.index(xml_.content(), "the index of a vertex");
        if (t[k] >= part.vertices.size())
          xml_.fail_here("vertex index " + std::to_string(t[k]) + " is out of range: the mesh has " +
                         std::to_string(part.vertices.size()) + " vertices");
        found |= 1U << k;
      }
      if (found != 7) xml_.fail_here("a triangle has not all of v1, v2 and v3");
      part.triangles.push_back(t);
      volumes_.push_back(material);
    }
  }

  void add_materials(ScenePart& part) { pending_.push_back({&part, std::move(volumes_)}); }

  /// Materials may follow the objects that have them.
  void resolve_materials() {
    for (const auto& [part, ids] : pending_) {
      std::vector<std::int32_t> values;
      for (const std::string& id : ids) {
        const auto found = materials_.find(id);
        values.push_back(found == materials_.end() ? -1 : found->second);
      }
      part->channels.push_back(
          {std::string(channel_names::material), Element::face, Interpolation::nearest, 1, std::move(values)});
    }
  }

  void read_constellation() {
    std::vector<AmfInstance>& instances = constellations_[xml_.text_of("id")];
    while (xml_.next_child()) {
      if (xml_.name() != "instance") {
        xml_.skip();
        continue;
      }
      AmfInstance instance;
      instance.object = xml_.text_of("objectid");
      referred_[instance.object] = true;
      read_placement(instance);
      instances.push_back(std::move(instance));
      ++things_;
    }
  }

  void read_placement(AmfInstance& instance) {
    constexpr std::array<std::string_view, 6> names{"deltax", "deltay", "deltaz", "rx", "ry", "rz"};
    while (xml_.next_child()) {
      const auto k = static_cast<std::size_t>(std::find(names.begin(), names.end(), xml_.name()) - names.begin());
      if (k == names.size()) {
        xml_.skip();
        continue;
      }
      const double x = number("a number");
      if (k < 3) instance.map.rows[k][3] = Rational(x);
      if (k >= 3 && x != 0) xml_.fail_here("instances that are turned are not read");
    }
  }

  void place(SceneMesh& scene, const AmfInstance& instance, const ExactMap& outer, std::size_t depth) {
    constexpr std::size_t deepest = 100;
    if (depth > deepest) fail("constellations contain themselves, or are nested more than 100 deep");
    scene.visit();
    const ExactMap map = product(outer, instance.map);
    if (const auto object = objects_.find(instance.object); object != objects_.end()) {
      scene.place(object->second.part, map, static_cast<std::int32_t>(file_.attributes.objects.size()));
      file_.attributes.objects.push_back(object->second.name);
    } else if (const auto inner = constellations_.find(instance.object); inner != constellations_.end()) {
      for (const AmfInstance& i : inner->second) place(scene, i, map, depth + 1);
    } else {
      fail("there is no object " + io::quoted(instance.object) + ", to which the file refers");
    }
  }

  void finish() {
    resolve_materials();
    Tally dropped;
    std::uint64_t triangles = 0;
    for (const std::string& id : order_) {
      ScenePart& part = objects_.at(id).part;
      part.drop_degenerate(dropped, triangles);
      triangles += part.triangles.size();
    }
    SceneMesh scene(things_, name_);
    for (const std::string& id : order_)
      if (!referred_.contains(id)) place(scene, {id, ExactMap::identity()}, ExactMap::identity(), 0);
    for (const auto& [id, instances] : constellations_)
      if (!referred_.contains(id)) place(scene, {id, ExactMap::identity()}, ExactMap::identity(), 0);
    scene.finish(file_);
    dropped.note_dropped(file_);
  }

  XmlScanner xml_;
  std::string name_;
  MeshFile file_;
  std::map<std::string, AmfObject> objects_;
  std::vector<std::string> order_;
  std::map<std::string, std::int32_t> materials_;
  std::map<std::string, std::vector<AmfInstance>> constellations_;
  std::map<std::string, bool> referred_;
  std::vector<std::string> volumes_;  ///< material of each triangle of the mesh
  std::vector<std::pair<ScenePart*, std::vector<std::string>>> pending_;
  std::uint64_t things_ = 0;
};

}  // namespace

MeshFile read_amf(const Input& input) {
  if (!ZipArchive::is_archive(input.data)) return AmfReader(input.data, input.name).read();
  ZipArchive archive(input.data);
  const std::string member = archive.first_with_end(".amf");
  if (member.empty()) fail("the archive has no AMF file");
  const UnpackedBytes bytes = archive.unpack(member);
  try {
    return AmfReader(bytes.view(), input.name).read();
  } catch (const Malformed& malformed) {
    fail(member + ", line " + std::to_string(Input{member, bytes.view()}.line_of(malformed.offset)) + ": " +
         malformed.reason);
  }
}

}  // namespace strata::io
