#pragma once
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "strata/io.h"

namespace strata::io {

/// A statement that holds for the faces after it.
struct ObjChange {
  enum class Kind { material, group, object };
  Kind kind;
  std::uint64_t face;  ///< of the piece
  std::string name;
};

/// The indices of a corner, those that count from the start of the file, from 0, or back, from the start of the piece.
struct ObjCorner {
  static constexpr std::int64_t none = std::numeric_limits<std::int64_t>::min();
  std::uint32_t vertex = 0;
  std::int64_t texcoord = none, normal = none;
  bool relative_texcoord = false, relative_normal = false;
};

/// What a piece of an OBJ file holds beside vertices and faces. Lists are empty where the file has nothing of the kind.
struct ObjExtras {
  std::vector<double> texcoords;    ///< 2 each
  std::vector<double> normals;      ///< 3 each
  std::vector<double> colors;       ///< 3 for each vertex of the piece
  std::uint64_t first_face = 0;     ///< the first face whose corners are kept, if any are
  std::vector<ObjCorner> corners;   ///< of that face and all after it
  std::vector<std::uint64_t> ends;  ///< per face, where its corners end
  std::vector<ObjChange> changes;
  std::vector<std::string> libraries;  ///< of materials
};

/// A piece's extras, and where its lists start in the file.
struct ObjExtrasAt {
  ObjExtras* extras;
  std::uint64_t faces, vertices;  ///< before the piece
  bool relative_vertices;         ///< corners count vertices from the piece's first one
};

/// Gives the mesh of the file the channels and materials that the pieces hold. Libraries of materials and images are
/// read from `folder` and beneath it; null: they are not. `face_count` of the file. Indices out of range are
/// noted.
void add_obj_extras(MeshFile& file, const std::vector<ObjExtrasAt>& pieces, std::uint64_t face_count,
                    const std::filesystem::path* folder);

}  // namespace strata::io
