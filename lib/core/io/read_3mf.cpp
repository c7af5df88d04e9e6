#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/containers/huge_pages.h"
#include "core/io/readers.h"
#include "core/io/scene_mesh.h"
#include "core/io/srgb.h"
#include "core/io/threemf_model.h"
#include "core/io/xml_scanner.h"
#include "core/io/zip_archive.h"

namespace strata::io {
namespace {

std::string without_slash(std::string path) {
  while (path.starts_with('/')) path.erase(0, 1);
  return path;
}

/// Gives the triangles of an object the materials, colours and texture coordinates that they refer to.
class SurfaceResolver {
 public:
  SurfaceResolver(ThreemfModel& model, ZipArchive& archive, MeshFile& file)
      : model_(model), archive_(archive), file_(file) {}

  /// Takes over the materials of all groups that triangles refer to, in the order of groups.
  void take_materials() {
    std::set<std::uint32_t> used;
    for (const auto& [id, object] : model_.objects) {
      std::uint32_t last = 0;
      for (const ThreemfSurface& s : object.surfaces)
        if (s.group != last) used.insert(last = s.group);
    }
    for (auto& [id, group] : model_.groups)
      if (used.contains(id) && group.kind == ThreemfGroup::Kind::multi)
        used.insert(group.layers.begin(), group.layers.end());
    for (auto& [id, group] : model_.groups)
      if (used.contains(id) && (group.kind == ThreemfGroup::Kind::base || group.kind == ThreemfGroup::Kind::texture))
        (void)first_material(group);
  }

  void resolve(std::uint32_t id, ThreemfObject& object) {
    if (object.surfaces.empty()) return;
    object.surfaces.resize(object.part.triangles.size());
    id_ = id;
    material_.clear(), colors_.clear(), texcoords_.clear();
    count_ = object.surfaces.size();
    for (triangle_ = 0; triangle_ < count_; ++triangle_)
      if (const ThreemfSurface& s = object.surfaces[triangle_]; s.group != 0) apply(s, true);
    add_channels(object.part);
    object.surfaces = {};
  }
  [[nodiscard]] std::uint64_t unknown() const { return unknown_; }

 private:
  void apply(const ThreemfSurface& surface, bool may_be_multi) {
    const auto found = model_.groups.find(surface.group);
    if (found == model_.groups.end())
      fail_at(" refers to the group " + std::to_string(surface.group) + ", of which there is none");
    ThreemfGroup& group = found->second;
    switch (group.kind) {
      case ThreemfGroup::Kind::base:
        check(surface, 1, group.bases.size());
        set_material(first_material(group) + surface.corners[0]);
        break;
      case ThreemfGroup::Kind::color:
        check(surface, 3, group.colors.size());
        if (colors_.empty()) resize_fresh(colors_, 12 * count_, std::uint8_t{255});
        for (std::size_t k = 0; k < 3; ++k)
          std::copy_n(group.colors[surface.corners[k]].begin(), 4, &colors_[12 * triangle_ + 4 * k]);
        break;
      case ThreemfGroup::Kind::texture:
        check(surface, 3, group.texcoords.size());
        set_material(first_material(group));
        if (texcoords_.empty()) resize_fresh(texcoords_, 6 * count_);
        for (std::size_t k = 0; k < 3; ++k)
          std::copy_n(group.texcoords[surface.corners[k]].begin(), 2, &texcoords_[6 * triangle_ + 2 * k]);
        break;
      case ThreemfGroup::Kind::multi:
        if (!may_be_multi) fail_at(" has multiproperties within multiproperties");
        apply_layers(surface, group);
        break;
      case ThreemfGroup::Kind::unknown:
        ++unknown_;
        break;
    }
  }

  void apply_layers(const ThreemfSurface& surface, const ThreemfGroup& group) {
    const std::size_t layers = group.layers.size();
    if (layers == 0) return;
    check(surface, 3, group.multi.size() / layers);
    for (std::size_t layer = 0; layer < layers; ++layer) {
      ThreemfSurface s{group.layers[layer], {}};
      for (std::size_t k = 0; k < 3; ++k) s.corners[k] = group.multi[surface.corners[k] * layers + layer];
      apply(s, false);
    }
  }

  void check(const ThreemfSurface& surface, std::size_t corners, std::size_t count) const {
    for (std::size_t k = 0; k < corners; ++k)
      if (surface.corners[k] >= count)
        fail_at(" refers to surface " + std::to_string(surface.corners[k]) + " of the group " +
                std::to_string(surface.group) + ", which has " + std::to_string(count));
  }
  [[noreturn]] void fail_at(const std::string& what) const {
    fail("triangle " + std::to_string(triangle_) + " of object " + std::to_string(id_) + what);
  }

  void set_material(std::size_t material) {
    if (material_.empty()) resize_fresh(material_, count_, -1);
    material_[triangle_] = static_cast<std::int32_t>(material);
  }

  std::uint32_t first_material(ThreemfGroup& group) {
    if (group.first_material) return *group.first_material;
    auto& materials = file_.attributes.materials;
    group.first_material = static_cast<std::uint32_t>(materials.size());
    if (group.kind == ThreemfGroup::Kind::texture) {
      Material material;
      material.image = image_of(group.texture);
      materials.push_back(std::move(material));
    }
    for (const ThreemfGroup::Base& base : group.bases) {
      Material material;
      material.name = base.name;
      for (std::size_t k = 0; k < 3; ++k) material.color[k] = linear_of_srgb(base.color[k]);
      material.color[3] = base.color[3] / 255.0;
      materials.push_back(std::move(material));
    }
    return *group.first_material;
  }

  std::uint32_t image_of(std::uint32_t texture) {
    const auto found = model_.textures.find(texture);
    if (found == model_.textures.end())
      fail("there is no texture " + std::to_string(texture) + ", to which the file refers");
    ThreemfTexture& t = found->second;
    if (t.image) return *t.image;
    const UnpackedBytes bytes = archive_.unpack(t.path);
    const auto* data = reinterpret_cast<const std::byte*>(bytes.view().data());
    t.image = static_cast<std::uint32_t>(file_.attributes.images.size());
    file_.attributes.images.push_back({std::filesystem::path(t.path).filename().string(), t.media_type,
                                       std::vector<std::byte>(data, data + bytes.view().size())});
    return *t.image;
  }

  void add_channels(ScenePart& part) {
    const auto add = [&](std::string_view name, Element element, Interpolation how, std::uint32_t components,
                         auto& values) {
      if (!values.empty())
        part.channels.push_back(
            on_vertices_if_possible({std::string(name), element, how, components, std::move(values)}, part));
    };
    add(channel_names::material, Element::face, Interpolation::nearest, 1, material_);
    add(channel_names::color, Element::corner, Interpolation::linear, 4, colors_);
    add(channel_names::texcoord, Element::corner, Interpolation::linear, 2, texcoords_);
  }

  ThreemfModel& model_;
  ZipArchive& archive_;
  MeshFile& file_;
  std::uint32_t id_ = 0;
  std::size_t count_ = 0, triangle_ = 0;
  std::vector<std::int32_t> material_;
  std::vector<std::uint8_t> colors_;
  std::vector<double> texcoords_;
  std::uint64_t unknown_ = 0;
};

class ArchiveReader {
 public:
  explicit ArchiveReader(const Input& input) : name_(input.name), archive_(input.data) {}

  MeshFile read() {
    root_ = without_slash(root_path());
    ThreemfModel& root = model(root_);
    std::vector<ThreemfComponent> items = root.items;
    if (items.empty()) items = all_objects(root);
    for (const ThreemfComponent& item : items) load(item.path.empty() ? root_ : without_slash(item.path), 0);
    for (auto& [path, m] : models_) prepare(m);
    SceneMesh scene(things_, name_);
    for (const ThreemfComponent& item : items) place(scene, root_, item, ExactMap::identity(), "", 0);
    scene.finish(file_);
    file_.unit = root.unit;
    dropped_.note_dropped(file_);
    note_rest();
    return std::move(file_);
  }

 private:
  static constexpr std::size_t deepest = 100;

  /// Where the relationships say that the model is.
  std::string root_path() {
    constexpr std::string_view rels = "_rels/.rels", type = "/3dmodel";
    if (archive_.has(rels)) {
      const UnpackedBytes bytes = archive_.unpack(rels);
      XmlScanner xml(bytes.view());
      if (xml.next_child())
        while (xml.next_child()) {
          if (xml.name() == "Relationship" && xml.text_of("Type").ends_with(type)) return xml.text_of("Target");
          xml.skip();
        }
    }
    const std::string path = archive_.first_with_end(".model");
    if (path.empty()) fail("the archive is no 3MF file: it has no model");
    return path;
  }

  ThreemfModel& model(const std::string& path) {
    const auto [place, is_new] = models_.try_emplace(path);
    if (!is_new) return place->second;
    const UnpackedBytes bytes = archive_.unpack(path);
    try {
      place->second = parse_3mf_model(bytes.view());
    } catch (const Malformed& malformed) {
      const std::string line = malformed.unit == Malformed::Unit::line
                                   ? ", line " + std::to_string(Input{path, bytes.view()}.line_of(malformed.offset))
                                   : "";
      fail(path + line + ": " + malformed.reason);
    }
    things_ += place->second.things;
    return place->second;
  }

  /// Reads the parts that the objects of a part refer to.
  void load(const std::string& path, std::size_t depth) {
    if (depth > deepest) fail("parts refer to each other more than 100 deep");
    if (!loaded_.try_emplace(path, true).second) return;
    ThreemfModel& m = model(path);
    if (m.unit != models_.at(root_).unit) fail(path + " has another unit than the model");
    for (const auto& [id, object] : m.objects)
      for (const ThreemfComponent& c : object.components)
        if (!c.path.empty()) load(without_slash(c.path), depth + 1);
  }

  /// Without a build, all objects that are no components of others.
  std::vector<ThreemfComponent> all_objects(ThreemfModel& root) {
    std::vector<ThreemfComponent> items;
    for (auto& [id, object] : root.objects)
      for (const ThreemfComponent& c : object.components)
        if (const auto found = root.objects.find(c.object); c.path.empty() && found != root.objects.end())
          found->second.is_component = true;
    for (const auto& [id, object] : root.objects)
      if (!object.is_component) items.push_back({"", id, ExactMap::identity()});
    if (items.empty() && !root.objects.empty())
      items.push_back({"", root.objects.begin()->first, ExactMap::identity()});
    if (!items.empty()) file_.notes.emplace_back("the file builds nothing: all its objects are taken");
    return items;
  }

  void prepare(ThreemfModel& m) {
    SurfaceResolver surfaces(m, archive_, file_);
    surfaces.take_materials();
    for (auto& [id, object] : m.objects) {
      surfaces.resolve(id, object);
      object.part.drop_degenerate(dropped_, triangles_);
      triangles_ += object.part.triangles.size();
    }
    unknown_ += surfaces.unknown();
  }

  void place(SceneMesh& scene, const std::string& from, const ThreemfComponent& component, const ExactMap& outer,
             const std::string& outer_name, std::size_t depth) {
    const std::string path = component.path.empty() ? from : without_slash(component.path);
    ThreemfModel& m = models_.at(path);
    const auto found = m.objects.find(component.object);
    const std::string what = "object " + std::to_string(component.object);
    if (found == m.objects.end()) fail(path + ": there is no " + what + ", to which the file refers");
    ThreemfObject& object = found->second;
    if (object.is_entered) fail(path + ": " + what + " is a component of itself");
    if (depth > deepest) fail(path + ": components are nested more than 100 deep");
    scene.visit();
    const ExactMap map = product(outer, component.map);
    const std::string& name = object.name.empty() ? outer_name : object.name;
    if (!object.part.triangles.empty() || !object.part.vertices.empty()) {
      others_ += !object.is_model;
      scene.place(object.part, map, static_cast<std::int32_t>(file_.attributes.objects.size()));
      file_.attributes.objects.push_back(name);
    }
    object.is_entered = true;
    for (const ThreemfComponent& inner : object.components) place(scene, path, inner, map, name, depth + 1);
    object.is_entered = false;
  }

  void note_rest() {
    if (others_ > 0)
      file_.notes.push_back(std::to_string(others_) + " objects are support or other, and are taken as well");
    if (unknown_ > 0)
      file_.notes.push_back("surfaces of " + std::to_string(unknown_) +
                            " triangles ignored: of a kind that is not read");
  }

  std::string name_, root_;
  ZipArchive archive_;
  MeshFile file_;
  std::map<std::string, ThreemfModel> models_;
  std::map<std::string, bool> loaded_;
  Tally dropped_;
  std::uint64_t things_ = 0, triangles_ = 0, others_ = 0, unknown_ = 0;
};

}  // namespace

MeshFile read_3mf(const Input& input) {
  if (!ZipArchive::is_archive(input.data)) fail("no 3MF file: it does not begin as a zip archive");
  return ArchiveReader(input).read();
}

}  // namespace strata::io
