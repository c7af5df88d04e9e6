#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/io/face_list.h"
#include "core/io/ply_plan.h"
#include "strata/io.h"

namespace strata::io {

/// What is read to a place that the number of its record tells: many tasks may do it at once.
struct PlyStore {
  explicit PlyStore(const PlyPlan& plan);
  /// For the records of an element, once it is certain that the file has room for so many.
  void make_room(const PlyElementPlan& element);

  std::vector<Vertex> vertices;
  std::vector<ChannelValues> values;  ///< per channel of the plan; none of those on corners
};

/// Lists of values beside the corners of faces, for one channel.
struct PlyCornerValues {
  ChannelValues values;
  std::vector<std::uint64_t> ends;  ///< per face
};

/// What a task reads in the order of the file.
struct PlyPiece {
  explicit PlyPiece(const PlyPlan& plan);

  FaceList faces;
  std::vector<std::uint32_t> corners;   ///< of all faces, if there are channels on corners
  std::vector<std::uint64_t> ends;      ///< of these, per face
  std::vector<PlyCornerValues> values;  ///< per channel of the plan, if some are on corners
  std::uint64_t no_numbers = 0;         ///< values that are none of their type
};

/// The mesh, the channels and the notes of a file of so many bytes. Requires that the pieces have all records.
[[nodiscard]] MeshFile join_ply(const PlyPlan& plan, PlyStore& store, std::vector<PlyPiece>& pieces,
                                std::vector<std::string> notes, std::uint64_t bytes, const std::string& name);

}  // namespace strata::io
