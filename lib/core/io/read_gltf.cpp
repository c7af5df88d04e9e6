#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/io/binary.h"
#include "core/io/gltf_buffers.h"
#include "core/io/gltf_json.h"
#include "core/io/gltf_mesh.h"
#include "core/io/readers.h"
#include "core/io/scene_mesh.h"

namespace strata::io {
namespace {

constexpr std::array<std::string_view, 4> read_extensions{"KHR_mesh_quantization", "KHR_lights_punctual",
                                                          "EXT_mesh_manifold", "KHR_materials_"};

void check_version(const GltfValue& document) {
  if (!document.json().is_object() || !document.has("asset")) fail("no glTF file: its JSON has no member 'asset'");
  const std::string version = document.at("asset").text_or("version", "");
  if (!version.starts_with("2.")) fail("glTF of version " + io::quoted(version) + " is not read, only 2.0");
  for (std::size_t i = 0; i < document.count("extensionsRequired"); ++i) {
    const GltfValue extension = document.at("extensionsRequired").at(i);
    const std::string& name = extension.text();
    const bool is_known = std::any_of(read_extensions.begin(), read_extensions.end(),
                                      [&](std::string_view known) { return name.starts_with(known); });
    if (!is_known) fail("the file requires the extension " + io::quoted(name) + ", which is not read");
  }
}

/// The rows of the map that a node has.
ExactMap map_of_matrix(const GltfValue& matrix) {
  if (matrix.size() != 16) matrix.refuse("has not 16 numbers");
  ExactMap map;
  for (std::size_t i = 0; i < 16; ++i) {
    const double x = matrix.at(i).number();
    if (i % 4 == 3 && x != (i == 15 ? 1 : 0)) matrix.refuse("is no affine map");
    if (i % 4 < 3) map.rows[i % 4][i / 4] = Rational(x);
  }
  return map;
}

template <std::size_t N>
std::array<Rational, N> rationals(const GltfValue& node, const char* member, std::array<Rational, N> values) {
  if (!node.has(member)) return values;
  const GltfValue list = node.at(member);
  if (list.size() != N) list.refuse("has not " + std::to_string(N) + " numbers");
  for (std::size_t i = 0; i < N; ++i) values[i] = Rational(list.at(i).number());
  return values;
}

/// Scales, turns by a quaternion, moves.
ExactMap map_of_parts(const GltfValue& node) {
  const auto move = rationals<3>(node, "translation", {0, 0, 0});
  const auto scale = rationals<3>(node, "scale", {1, 1, 1});
  const auto [x, y, z, w] = rationals<4>(node, "rotation", {0, 0, 0, 1});
  const Rational one = 1, two = 2;
  const std::array<std::array<Rational, 3>, 3> turn{{
      {one - two * (y * y + z * z), two * (x * y - z * w), two * (x * z + y * w)},
      {two * (x * y + z * w), one - two * (x * x + z * z), two * (y * z - x * w)},
      {two * (x * z - y * w), two * (y * z + x * w), one - two * (x * x + y * y)},
  }};
  ExactMap map;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) map.rows[i][j] = turn[i][j] * scale[j];
    map.rows[i][3] = move[i];
  }
  return map;
}

class DocumentReader {
 public:
  DocumentReader(const Input& input, const GltfJson& json, std::string_view chunk, const std::filesystem::path* folder)
      : name_(input.name), document_(json, ""), buffers_(document_, chunk, folder) {}

  MeshFile read() {
    check_version(document_);
    read_images();
    read_materials();
    const std::size_t nodes = document_.count("nodes");
    entered_.resize(nodes);
    for (const std::size_t root : roots()) load(root, 0);
    std::uint64_t things = nodes;
    for (const auto& [index, mesh] : meshes_) things += mesh.part.vertices.size() + mesh.part.triangles.size();
    SceneMesh scene(things, name_);
    for (const std::size_t root : roots()) place(scene, root, ExactMap::identity(), 0);
    scene.finish(file_);
    note_rest();
    return std::move(file_);
  }

 private:
  static constexpr std::size_t deepest = 200;

  [[nodiscard]] GltfValue node(std::size_t index) const { return document_.at("nodes").at(index); }

  /// Nodes of the scene, or of all roots if there is none.
  std::vector<std::size_t> roots() const {
    std::vector<std::size_t> roots;
    const std::size_t nodes = document_.count("nodes");
    if (document_.count("scenes") > 0) {
      const std::size_t index = document_.index_or("scene", 0);
      const GltfValue scene = document_.at("scenes").at(index);
      for (std::size_t i = 0; i < scene.count("nodes"); ++i)
        roots.push_back(scene.at("nodes").at(i).index_below(nodes));
      return roots;
    }
    std::vector<bool> is_child(nodes);
    for (std::size_t n = 0; n < nodes; ++n)
      for (std::size_t i = 0; i < node(n).count("children"); ++i)
        is_child[node(n).at("children").at(i).index_below(nodes)] = true;
    for (std::size_t n = 0; n < nodes; ++n)
      if (!is_child[n]) roots.push_back(n);
    return roots;
  }

  /// Reads the meshes of a node and of those beneath it.
  void load(std::size_t index, std::size_t depth) {
    const GltfValue n = node(index);
    if (depth > deepest) n.refuse("nodes are nested more than 200 deep");
    if (n.has("mesh")) {
      const std::size_t mesh = n.at("mesh").index();
      const auto [place, is_new] = meshes_.try_emplace(mesh);
      if (is_new) place->second = read_gltf_mesh(document_.at("meshes").at(mesh), buffers_, file_.attributes, tally_);
    }
    if (loaded_.size() < entered_.size()) loaded_.resize(entered_.size());
    if (loaded_[index]) return;
    loaded_[index] = true;
    for (std::size_t i = 0; i < n.count("children"); ++i)
      load(n.at("children").at(i).index_below(entered_.size()), depth + 1);
  }

  void place(SceneMesh& scene, std::size_t index, const ExactMap& outer, std::size_t depth) {
    const GltfValue n = node(index);
    if (entered_[index]) n.refuse("is a child of itself");
    if (depth > deepest) n.refuse("nodes are nested more than 200 deep");
    scene.visit();
    const ExactMap map = product(outer, n.has("matrix") ? map_of_matrix(n.at("matrix")) : map_of_parts(n));
    if (n.has("mesh")) place_mesh(scene, n, map);
    entered_[index] = true;
    for (std::size_t i = 0; i < n.count("children"); ++i) place(scene, n.at("children").at(i).index(), map, depth + 1);
    entered_[index] = false;
  }

  void place_mesh(SceneMesh& scene, const GltfValue& n, const ExactMap& map) {
    const std::size_t index = n.at("mesh").index();
    GltfMesh& mesh = meshes_.at(index);
    skins_ += n.has("skin");
    if (mesh.part.triangles.empty()) return;
    auto& objects = file_.attributes.objects;
    const auto first = static_cast<std::int32_t>(objects.size());
    if (mesh.objects.empty())
      objects.push_back(n.text_or("name", document_.at("meshes").at(index).text_or("name", "")));
    objects.insert(objects.end(), mesh.objects.begin(), mesh.objects.end());
    scene.place(mesh.part, product(map, mesh.scale), first);
  }

  void read_images() {
    for (std::size_t i = 0; i < document_.count("images"); ++i) {
      const GltfValue value = document_.at("images").at(i);
      Image image{value.text_or("name", ""), value.text_or("mimeType", ""), {}};
      std::optional<std::string> bytes;
      if (value.has("bufferView")) {
        bytes = buffers_.view(value.at("bufferView").index());
      } else {
        const std::string uri = value.text_or("uri", "");
        bytes = buffers_.resource(uri);
        if (!uri.starts_with("data:")) image.name = std::filesystem::path(uri).filename().string();
        if (uri.starts_with("data:") && image.media_type.empty())
          image.media_type = uri.substr(5, uri.find_first_of(";,") - 5);
      }
      if (!bytes)
        file_.notes.push_back("image " + std::to_string(i) +
                              " left out: there is no such file beneath the folder of the model");
      else
        image.bytes.assign(reinterpret_cast<const std::byte*>(bytes->data()),
                           reinterpret_cast<const std::byte*>(bytes->data() + bytes->size()));
      file_.attributes.images.push_back(std::move(image));
    }
  }

  void read_materials() {
    for (std::size_t i = 0; i < document_.count("materials"); ++i) {
      const GltfValue value = document_.at("materials").at(i);
      Material material;
      material.name = value.text_or("name", "");
      material.metallic = 1;
      for (const char* member :
           {"normalTexture", "occlusionTexture", "emissiveTexture", "emissiveFactor", "extensions"})
        looks_ += value.has(member);
      if (value.has("pbrMetallicRoughness")) read_look(value.at("pbrMetallicRoughness"), material);
      file_.attributes.materials.push_back(std::move(material));
    }
  }

  void read_look(const GltfValue& look, Material& material) {
    if (look.has("baseColorFactor")) {
      const GltfValue color = look.at("baseColorFactor");
      if (color.size() != 4) color.refuse("has not 4 numbers");
      for (std::size_t k = 0; k < 4; ++k) material.color[k] = color.at(k).number();
    }
    material.metallic = look.number_or("metallicFactor", 1);
    material.roughness = look.number_or("roughnessFactor", 1);
    looks_ += look.has("metallicRoughnessTexture");
    if (!look.has("baseColorTexture")) return;
    const GltfValue texture = look.at("baseColorTexture");
    looks_ += texture.has("extensions") || texture.index_or("texCoord", 0) != 0;
    const GltfValue source = document_.at("textures").at(texture.at("index").index());
    if (source.has("source"))
      material.image = static_cast<std::uint32_t>(source.at("source").index_below(file_.attributes.images.size()));
  }

  void note_rest() {
    auto& notes = file_.notes;
    tally_.dropped.note_dropped(file_);
    if (tally_.lines > 0) notes.push_back(std::to_string(tally_.lines) + " lists of points and lines ignored");
    if (tally_.other_attributes) notes.emplace_back("tangents, joints and weights of vertices ignored");
    if (tally_.targets) notes.emplace_back("morph targets ignored");
    if (skins_ > 0) notes.emplace_back("skins ignored: meshes are as they stand in the file");
    if (looks_ > 0)
      notes.emplace_back(
          "looks of materials ignored but for colour, one image of it, how metallic and how rough they are");
  }

  std::string name_;
  GltfValue document_;
  GltfBuffers buffers_;
  MeshFile file_;
  GltfTally tally_;
  std::map<std::size_t, GltfMesh> meshes_;
  std::vector<bool> entered_, loaded_;
  std::uint64_t skins_ = 0, looks_ = 0;
};

struct Chunks {
  std::string_view json, binary;
};

Chunks chunks_of(std::string_view file) {
  constexpr std::size_t header = 12, chunk_header = 8;
  constexpr std::uint32_t mark = 0x46546c67, json = 0x4e4f534a, binary = 0x004e4942;
  const auto word = [&](std::size_t at) { return load<std::uint32_t>(file.data() + at, std::endian::little); };
  if (file.size() < header || word(0) != mark) fail("no GLB file: it does not begin with 'glTF'");
  if (word(4) != 2) fail("GLB of version " + std::to_string(word(4)) + " is not read, only 2");
  if (word(8) > file.size())
    fail("the file is truncated: it has " + std::to_string(file.size()) + " bytes of " + std::to_string(word(8)));
  const std::size_t end = word(8);
  Chunks chunks;
  for (std::size_t at = header; at + chunk_header <= end;) {
    const std::size_t size = word(at), kind = word(at + 4);
    if (size > end - at - chunk_header) fail_at_byte(at, "a chunk exceeds the file");
    const std::string_view bytes = file.substr(at + chunk_header, size);
    if (kind == json && chunks.json.empty()) chunks.json = bytes;
    if (kind == binary && chunks.binary.empty()) chunks.binary = bytes;
    at += chunk_header + size;
  }
  if (chunks.json.empty()) fail("a GLB file without JSON");
  return chunks;
}

}  // namespace

MeshFile read_glb(const Input& input, const std::filesystem::path* folder) {
  const Chunks chunks = chunks_of(input.data);
  const GltfJson json = parse_gltf_json(chunks.json);
  return DocumentReader(input, json, chunks.binary, folder).read();
}

MeshFile read_gltf(const Input& input, const std::filesystem::path* folder) {
  if (input.data.starts_with("glTF")) return read_glb(input, folder);
  const GltfJson json = parse_gltf_json(input.data);
  return DocumentReader(input, json, {}, folder).read();
}

}  // namespace strata::io
