#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/containers/huge_pages.h"
#include "core/io/obj_piece.h"
#include "core/io/readers.h"

namespace strata::io {
namespace {

/// The number of vertices before every piece, and in all.
std::vector<std::uint64_t> vertices_before(std::span<const ObjPiece> pieces) {
  std::vector<std::uint64_t> before{0};
  for (const ObjPiece& piece : pieces) before.push_back(before.back() + piece.vertices.size());
  if (before.back() > most_items) fail("more than 2^32 - 2 vertices");
  return before;
}

/// Throws when faces use vertices that do not exist.
void check(const ObjUses& uses, std::uint64_t before, std::uint64_t vertex_count) {
  if (uses.absolute && uses.highest >= vertex_count) fail("an index out of range");
  if (static_cast<std::int64_t>(before) + uses.lowest < 0) fail("a relative index out of range");
}

/// A face counts its vertices from the start of the file, or of the piece that is whole.
std::vector<ObjExtrasAt> extras_of(std::vector<ObjPiece>& pieces, std::span<const std::uint64_t> vertices,
                                   std::span<const std::uint64_t> faces) {
  std::vector<ObjExtrasAt> extras;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    extras.push_back({&pieces[i].extras, faces[i], vertices[i], pieces[i].uses.relative});
  return extras;
}

MeshFile join_pieces(const Input& input, std::vector<ObjPiece> pieces, const std::filesystem::path* folder) {
  const auto before = vertices_before(pieces);
  MeshFile file;
  resize_fresh(file.mesh.vertices, before.back());
  std::vector<FaceList> faces(pieces.size());
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
    ObjPiece& piece = pieces[i];
    check(piece.uses, before[i], before.back());
    if (piece.uses.relative) piece.faces.shift(static_cast<std::uint32_t>(before[i]));
    std::copy(piece.vertices.begin(), piece.vertices.end(), file.mesh.vertices.begin() + before[i]);
    faces[i] = std::move(piece.faces);
  });
  std::vector<std::uint64_t> faces_before{0};
  for (const FaceList& list : faces) faces_before.push_back(faces_before.back() + list.count());
  gather_faces(faces, file, input.name);
  add_obj_extras(file, extras_of(pieces, before, faces_before), faces_before.back(), folder);
  return file;
}

MeshFile read_pieces(const Input& input, std::span<const Piece> places, const std::filesystem::path* folder) {
  std::vector<ObjPiece> pieces(places.size());
  tbb::parallel_for(std::size_t{0}, places.size(),
                    [&](std::size_t i) { pieces[i] = read_obj_piece(input, places[i]); });
  ObjIgnored ignored;
  bool is_empty = true;
  for (const ObjPiece& piece : pieces) {
    ignored.add(piece.ignored);
    is_empty = is_empty && piece.vertices.empty() && piece.faces.count() == 0;
  }
  if (ignored.unknown > 0 && is_empty)
    fail_at_line(ignored.first_unknown, "expected OBJ statements such as 'v 0 0 0' and 'f 1 2 3'");
  MeshFile file = join_pieces(input, std::move(pieces), folder);
  ignored.note(file);
  return file;
}

}  // namespace

MeshFile read_obj(const Input& input, const std::filesystem::path* folder) {
  return read_in_pieces(
      input, [&](std::size_t size) { return read_pieces(input, split_at_lines(input.data, 0, size), folder); });
}

}  // namespace strata::io
