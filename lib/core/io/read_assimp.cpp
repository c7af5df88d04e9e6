#include "core/io/readers.h"

#if STRATA_WITH_ASSIMP

#include <assimp/DefaultIOSystem.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <assimp/version.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/io/apart.h"
#include "core/io/face_list.h"

namespace strata::io {
namespace {

/// Rows of an affine map, in doubles so that chains of nodes do not round to floats at every step.
using Affine = std::array<std::array<double, 4>, 3>;

Affine affine_of(const aiMatrix4x4& m) {
  return {{{m.a1, m.a2, m.a3, m.a4}, {m.b1, m.b2, m.b3, m.b4}, {m.c1, m.c2, m.c3, m.c4}}};
}

Affine product(const Affine& a, const Affine& b) {
  Affine r{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      r[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] + (j == 3 ? a[i][3] : 0);
  return r;
}

Vertex image(const Affine& m, const aiVector3D& p) {
  Vertex r{};
  for (std::size_t i = 0; i < 3; ++i) r[i] = m[i][0] * p.x + m[i][1] * p.y + m[i][2] * p.z + m[i][3];
  return r;
}

bool mirrors(const Affine& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) <
         0;
}

/// Gathers the meshes of all nodes into one, in the coordinates of the scene.
class SceneReader {
 public:
  SceneReader(const aiScene& scene, std::string name) : scene_(scene), name_(std::move(name)) {}

  MeshFile read() {
    // An explicit stack: files may nest nodes deeper than the stack of a thread.
    std::vector<std::pair<const aiNode*, Affine>> stack;
    if (scene_.mRootNode != nullptr) stack.emplace_back(scene_.mRootNode, affine_of(aiMatrix4x4()));
    while (!stack.empty()) {
      const auto [node, parent] = stack.back();
      stack.pop_back();
      const Affine map = product(parent, affine_of(node->mTransformation));
      for (unsigned i = 0; i < node->mNumMeshes; ++i) add(*scene_.mMeshes[node->mMeshes[i]], map);
      for (unsigned i = node->mNumChildren; i-- > 0;) stack.emplace_back(node->mChildren[i], map);
    }
    if (faces_.count() == 0 && lines_ == 0) throw IoError(name_, {}, "cannot be read: assimp finds no faces in it");
    file_.notes.emplace_back("read through assimp: coordinates come as floats, moved by the transforms of the scene");
    if (lines_ > 0) file_.notes.push_back(std::to_string(lines_) + " points and lines ignored");
    gather_faces({&faces_, 1}, file_, name_);
    return std::move(file_);
  }

 private:
  void add(const aiMesh& mesh, const Affine& map) {
    const std::uint64_t first = file_.mesh.vertices.size();
    if (first + mesh.mNumVertices > most_items) throw IoError(name_, {}, "more than 2^32 - 2 vertices");
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const Vertex p = image(map, mesh.mVertices[i]);
      if (!std::isfinite(p[0] + p[1] + p[2])) throw IoError(name_, {}, "a coordinate is not finite");
      file_.mesh.vertices.push_back(p);
    }
    const bool mirrored = mirrors(map);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) add(mesh.mFaces[i], mesh.mNumVertices, first, mirrored);
  }

  void add(const aiFace& face, unsigned vertex_count, std::uint64_t first, bool mirrored) {
    if (face.mNumIndices < 3) {
      ++lines_;
      return;
    }
    corners_.clear();
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      const unsigned v = face.mIndices[mirrored ? face.mNumIndices - 1 - k : k];
      if (v >= vertex_count) throw IoError(name_, {}, "a vertex index is out of range");
      corners_.push_back(static_cast<std::uint32_t>(first + v));
    }
    faces_.add(corners_);
  }

  const aiScene& scene_;
  std::string name_;
  MeshFile file_;
  FaceList faces_;
  std::vector<std::uint32_t> corners_;
  std::uint64_t lines_ = 0;
};

bool is_3mf(const std::string& name) {
  std::string extension = std::filesystem::path(name).extension().string();
  for (char& c : extension) c = c == 'M' ? 'm' : c == 'F' ? 'f' : c;
  return extension == ".3mf";
}

/// Up to version 5.2, assimp's 3MF reader leaves textures in the scene that it has already freed. This prevents the
/// scene from freeing them again.
void forget_freed_textures(aiScene& scene) {
  if (std::pair(aiGetVersionMajor(), aiGetVersionMinor()) > std::pair(5U, 2U)) return;
  delete[] scene.mTextures;
  scene.mTextures = nullptr;
  scene.mNumTextures = 0;
}

/// Opens the file of a model and files beneath its folder, and no others: not what a path within the model names beyond
/// that, by `..`, by an absolute path or by a link. Assimp owns it.
class FolderOfModel : public Assimp::DefaultIOSystem {
 public:
  explicit FolderOfModel(const std::filesystem::path& model) {
    std::error_code ignored;
    model_ = std::filesystem::weakly_canonical(std::filesystem::absolute(model), ignored);
    folder_ = std::filesystem::weakly_canonical(std::filesystem::absolute(model).parent_path(), ignored);
  }
  bool Exists(const char* file) const override { return is_beneath(file) && DefaultIOSystem::Exists(file); }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    return is_beneath(file) && std::string_view(mode).find_first_of("wa+") == std::string_view::npos
               ? DefaultIOSystem::Open(file, mode)
               : nullptr;
  }

 private:
  [[nodiscard]] bool is_beneath(const char* file) const {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::weakly_canonical(std::filesystem::absolute(file), error);
    if (error) return false;
    if (path == model_) return true;
    // A pipe may never have an end.
    return std::filesystem::is_regular_file(path, error) &&
           std::mismatch(folder_.begin(), folder_.end(), path.begin(), path.end()).first == folder_.end();
  }

  std::filesystem::path model_, folder_;
};

/// Of a model in memory there are no other files.
class NoFiles : public Assimp::DefaultIOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
};

/// Runs one of assimp's readers and takes over the scene. No post-processing is requested, because it rounds and welds.
template <class Import>
MeshFile read_scene(const std::string& name, const Import& import) {
  try {
    Assimp::Importer importer;
    if (import(importer) == nullptr)
      throw IoError(name, {}, std::string("cannot be read: ") + importer.GetErrorString());
    const std::unique_ptr<aiScene> scene(importer.GetOrphanedScene());
    if (is_3mf(name)) forget_freed_textures(*scene);
    return SceneReader(*scene, name).read();
  } catch (const IoError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw IoError(name, {}, std::string("cannot be read: ") + error.what());
  }
}

}  // namespace

bool can_read_other(const std::string& extension) { return Assimp::Importer().IsExtensionSupported(extension); }

MeshFile read_other(const Input& input) {
  const std::string hint = std::filesystem::path(input.name).extension().string();
  return read_apart(input.name, limits_for(input.data.size()), [&] {
    return read_scene(input.name, [&](Assimp::Importer& importer) {
      importer.SetIOHandler(new NoFiles);
      return importer.ReadFileFromMemory(input.data.data(), input.data.size(), 0, hint.empty() ? "" : hint.c_str() + 1);
    });
  });
}

MeshFile read_other(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::uintmax_t bytes = std::filesystem::file_size(path, ignored);
  return read_apart(path.string(), limits_for(ignored ? 0 : bytes), [&] {
    return read_scene(path.string(), [&](Assimp::Importer& importer) {
      importer.SetIOHandler(new FolderOfModel(path));
      return importer.ReadFile(path.string(), 0);
    });
  });
}

}  // namespace strata::io

#else

namespace strata::io {

bool can_read_other(const std::string&) { return false; }

MeshFile read_other(const Input&) { fail("this build reads stl, obj, off and ply only (no assimp)"); }

MeshFile read_other(const std::filesystem::path& path) {
  throw IoError(path.string(), {}, "this build reads stl, obj, off and ply only (no assimp)");
}

}  // namespace strata::io

#endif
