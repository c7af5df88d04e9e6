#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/io/face_list.h"
#include "core/io/obj_extras.h"
#include "core/io/pieces.h"

namespace strata::io {

/// Geometry statements that are not read.
struct ObjIgnored {
  std::uint64_t lines = 0, points = 0, free_form = 0, unknown = 0;
  std::size_t first_unknown = 0;  ///< offset in the text

  void add_unknown(std::size_t offset) {
    if (unknown++ == 0) first_unknown = offset;
  }
  /// Adds the statements of a later piece.
  void add(const ObjIgnored& later) {
    if (unknown == 0) first_unknown = later.first_unknown;
    lines += later.lines;
    points += later.points;
    free_form += later.free_form;
    unknown += later.unknown;
  }
  void note(MeshFile& file) const;
};

/// Which vertices the faces of a piece use.
struct ObjUses {
  std::uint64_t highest = 0;  ///< among those counted from the start of the file
  std::int64_t lowest = 0;    ///< among those counted back, from the start of the piece
  bool absolute = false, relative = false;
};

/// The content of a piece. The indices of its faces count from the start of the file, or, if they are relative, from
/// the start of the piece.
struct ObjPiece {
  std::vector<Vertex> vertices;
  FaceList faces;
  ObjUses uses;
  ObjExtras extras;
  ObjIgnored ignored;
};

/// Reads a piece that consists of whole lines. Only in a piece that is the whole file is every index checked at once:
/// there the number of vertices before a face, and in all, is known. A face may use vertices that follow later. Throws
/// Malformed, also for pieces that use both absolute and relative indices, unless they are the whole file.
[[nodiscard]] ObjPiece read_obj_piece(const Input& input, Piece place);

}  // namespace strata::io
