#include "core/io/obj_extras.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/io/corner_finder.h"
#include "core/io/face_values.h"
#include "core/io/file.h"
#include "core/io/folder_of_model.h"
#include "core/io/mtl.h"
#include "core/io/scene_mesh.h"

namespace strata::io {
namespace {

/// Bytes where all values are 255ths as floats have them, else floats.
ChannelValues color_values(const std::vector<double>& colors) {
  const auto byte = [](double x) { return std::round(255 * x); };
  const bool are_bytes = std::all_of(colors.begin(), colors.end(), [&](double x) {
    return x >= 0 && x <= 1 && static_cast<float>(byte(x) / 255) == static_cast<float>(x);
  });
  if (are_bytes) {
    std::vector<std::uint8_t> values;
    for (const double x : colors) values.push_back(static_cast<std::uint8_t>(byte(x)));
    return values;
  }
  return std::vector<float>(colors.begin(), colors.end());
}

class ExtrasAdder {
 public:
  ExtrasAdder(MeshFile& file, const std::vector<ObjExtrasAt>& pieces, std::uint64_t face_count)
      : file_(file), pieces_(pieces), face_count_(face_count) {}

  void add(const std::filesystem::path* folder) {
    read_libraries(folder);
    add_changes(ObjChange::Kind::material, channel_names::material);
    add_changes(ObjChange::Kind::object, channel_names::object);
    add_changes(ObjChange::Kind::group, channel_names::group);
    add_colors();
    add_corners(&ObjExtras::texcoords, &ObjCorner::texcoord, &ObjCorner::relative_texcoord, 2, channel_names::texcoord);
    add_corners(&ObjExtras::normals, &ObjCorner::normal, &ObjCorner::relative_normal, 3, channel_names::normal);
  }

 private:
  void read_libraries(const std::filesystem::path* folder) {
    std::vector<std::string> names;
    for (const ObjExtrasAt& piece : pieces_)
      for (const std::string& name : piece.extras->libraries)
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    for (const std::string& name : names) {
      const auto path = file_beneath(folder, name);
      if (!path && folder == nullptr) continue;  // of a model in memory there are no other files
      if (!path) {
        file_.notes.push_back("the library of materials '" + name.substr(0, 100) +
                              "' left out: there is no such file beneath the folder of the model");
        continue;
      }
      const File library(*path);
      const FileBytes bytes(library);
      for (std::string& note : read_mtl(bytes.view(), *folder, name, file_.attributes))
        file_.notes.push_back(std::move(note));
    }
    for (std::size_t i = 0; i < file_.attributes.materials.size(); ++i)
      materials_.emplace(file_.attributes.materials[i].name, static_cast<std::int32_t>(i));
  }

  /// The index of a name, which is new or known.
  std::int32_t index_of(ObjChange::Kind kind, const std::string& name) {
    if (kind == ObjChange::Kind::material) {
      const auto [place, is_new] =
          materials_.try_emplace(name, static_cast<std::int32_t>(file_.attributes.materials.size()));
      if (is_new) {
        file_.attributes.materials.push_back({});
        file_.attributes.materials.back().name = name;
      }
      return place->second;
    }
    auto& names = kind == ObjChange::Kind::group ? file_.attributes.groups : file_.attributes.objects;
    auto& known = kind == ObjChange::Kind::group ? groups_ : objects_;
    const auto [place, is_new] = known.try_emplace(name, static_cast<std::int32_t>(names.size()));
    if (is_new) names.push_back(name);
    return place->second;
  }

  void add_changes(ObjChange::Kind kind, std::string_view channel) {
    std::vector<std::int32_t> of_face;
    std::int32_t now = -1;
    for (const ObjExtrasAt& piece : pieces_)
      for (const ObjChange& change : piece.extras->changes) {
        if (change.kind != kind) continue;
        of_face.resize(std::min(piece.faces + change.face, face_count_), now);
        now = change.name.empty() ? -1 : index_of(kind, change.name);
      }
    if (of_face.empty() && now == -1) return;
    of_face.resize(face_count_, now);
    file_.attributes.channels.push_back(
        {std::string(channel), Element::face, Interpolation::nearest, 1, std::move(of_face)});
    repeat_on_triangles(file_.attributes.channels.back(), file_);
  }

  void add_colors() {
    std::vector<double> colors;
    for (const ObjExtrasAt& piece : pieces_) {
      if (piece.extras->colors.empty()) continue;
      colors.resize(3 * piece.vertices, 1);
      colors.insert(colors.end(), piece.extras->colors.begin(), piece.extras->colors.end());
    }
    if (colors.empty()) return;
    colors.resize(3 * file_.mesh.vertices.size(), 1);
    file_.attributes.channels.push_back(
        {std::string(channel_names::color), Element::vertex, Interpolation::linear, 3, color_values(colors)});
  }

  /// Triangles have corners of their faces: those with the same vertices.
  void add_corners(std::vector<double> ObjExtras::*list, std::int64_t ObjCorner::*index, bool ObjCorner::*is_relative,
                   std::uint32_t components, std::string_view name) {
    std::vector<double> all;
    std::vector<std::uint64_t> before;
    bool is_used = false;
    for (const ObjExtrasAt& piece : pieces_) {
      before.push_back(all.size() / components);
      all.insert(all.end(), (piece.extras->*list).begin(), (piece.extras->*list).end());
      for (const ObjCorner& c : piece.extras->corners) is_used = is_used || c.*index != ObjCorner::none;
    }
    if (!is_used) return;
    const auto count = static_cast<std::int64_t>(all.size() / components);
    std::vector<double> values(3 * file_.mesh.triangles.size() * components);
    std::size_t p = 0;
    std::uint64_t astray = 0, found_face = face_count_;
    CornerFinder finder;
    for (std::size_t t = 0; t < file_.mesh.triangles.size(); ++t) {
      const std::uint64_t face = face_of(file_, t);
      while (p + 1 < pieces_.size() && face >= pieces_[p + 1].faces) ++p;
      const ObjExtras& e = *pieces_[p].extras;
      const std::uint64_t own = face - pieces_[p].faces;
      if (e.corners.empty() || own < e.first_face) continue;
      const std::uint64_t f = own - e.first_face, first = f == 0 ? 0 : e.ends[f - 1], last = e.ends[f];
      if (face != found_face) finder.start(last - first, [&](std::size_t i) { return e.corners[first + i].vertex; });
      found_face = face;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex =
            file_.mesh.triangles[t][k] -
            (pieces_[p].relative_vertices ? static_cast<std::uint32_t>(pieces_[p].vertices) : 0);
        const ObjCorner& corner = e.corners[first + finder.corner_at(vertex)];
        std::int64_t i = corner.*index;
        if (i == ObjCorner::none) continue;
        if (corner.*is_relative) i += static_cast<std::int64_t>(before[p]);
        if (i < 0 || i >= count) {
          ++astray;
          continue;
        }
        std::copy_n(&all[static_cast<std::size_t>(i) * components], components, &values[(3 * t + k) * components]);
      }
    }
    if (astray > 0)
      file_.notes.push_back(std::to_string(astray) + " corners have no " + std::string(name) +
                            ": there is none of that index");
    if (all.empty()) return;
    const auto how = name == channel_names::normal ? Interpolation::spherical : Interpolation::linear;
    ScenePart part;  // lent, for a look at its corners
    std::swap(part.vertices, file_.mesh.vertices);
    std::swap(part.triangles, file_.mesh.triangles);
    Channel channel =
        on_vertices_if_possible({std::string(name), Element::corner, how, components, std::move(values)}, part);
    std::swap(part.vertices, file_.mesh.vertices);
    std::swap(part.triangles, file_.mesh.triangles);
    file_.attributes.channels.push_back(std::move(channel));
  }

  MeshFile& file_;
  const std::vector<ObjExtrasAt>& pieces_;
  std::uint64_t face_count_;
  std::map<std::string, std::int32_t> materials_, groups_, objects_;
};

}  // namespace

void add_obj_extras(MeshFile& file, const std::vector<ObjExtrasAt>& pieces, std::uint64_t face_count,
                    const std::filesystem::path* folder) {
  const bool has_any = std::any_of(pieces.begin(), pieces.end(), [](const ObjExtrasAt& p) {
    const ObjExtras& e = *p.extras;
    return !e.colors.empty() || !e.corners.empty() || !e.changes.empty() || !e.libraries.empty();
  });
  if (has_any) ExtrasAdder(file, pieces, face_count).add(folder);
}

}  // namespace strata::io
