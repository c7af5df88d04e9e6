#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/containers/huge_pages.h"
#include "core/io/line_records.h"
#include "core/io/piece_source.h"
#include "core/io/ply_records.h"
#include "core/io/readers.h"

namespace strata::io {
namespace {

constexpr const char* ignored_rest = "data behind the last element was ignored";

template <class Numbers>
void check_room(const PlyElement& element, Numbers& numbers) {
  const std::uint64_t room = numbers.records(element);
  if (element.count > room)
    numbers.fail_at(numbers.offset(), "the header promises " + std::to_string(element.count) + " elements '" +
                                          element.name + "', but the rest of the file has room for " +
                                          std::to_string(room) + " at most: truncated, or the count is wrong");
}

/// Reads all data in order, without assumptions.
template <class Numbers>
MeshFile read_whole(const Input& input, const PlyPlan& plan, Numbers numbers) {
  MeshFile file;
  PlyRecords records(plan, numbers);
  for (const PlyElementPlan& p : plan.elements) {
    check_room(*p.element, records.numbers());
    if (p.role == PlyRole::points) resize_fresh(file.mesh.vertices, p.element->count);
    records.read(p, 0, p.element->count, file.mesh.vertices);
  }
  if (records.numbers().has_more()) file.notes.emplace_back(ignored_rest);
  const FaceList faces = records.take_faces();
  gather_faces({&faces, 1}, file, input.name);
  return file;
}

/// Reads a binary file in pieces. Assumes that the lists of an element have the length of those of its first record, so
/// that all records have the same size. This is certain when every piece ends where the next one starts.
class BinaryPieces {
 public:
  BinaryPieces(PieceSource& source, const PlyPlan& plan, const PlyHeader& header)
      : source_(source), plan_(plan), order_(*header.order), offset_(header.data) {}

  MeshFile read(std::size_t size, const std::string& name) {
    for (const PlyElementPlan& p : plan_.elements) read_element(p, size);
    if (offset_ < source_.size()) file_.notes.emplace_back(ignored_rest);
    gather_faces(faces_, file_, name);
    return std::move(file_);
  }

 private:
  [[nodiscard]] PlyRecords<BinaryNumbers> records_of(Piece piece) {
    return {plan_, BinaryNumbers(source_.get(piece), 0, order_)};
  }

  std::size_t next_size(const PlyElement& element) {
    constexpr std::size_t longest = 1 << 16;
    auto record = records_of({offset_, std::min(offset_ + longest, source_.size())});
    record.skip(element, 1);
    return record.numbers().offset();
  }

  void read_element(const PlyElementPlan& p, std::size_t size) {
    const std::size_t stride = next_size(*p.element);
    const std::uint64_t count = p.element->count;
    if (count > (source_.size() - offset_) / stride) fail("fewer records, or of other sizes");
    if (p.role == PlyRole::points) resize_fresh(file_.mesh.vertices, count);
    const std::size_t per_piece = std::max<std::size_t>(size / stride, 1);
    const std::size_t pieces = (count + per_piece - 1) / per_piece, lists = faces_.size();
    faces_.resize(lists + pieces);
    tbb::parallel_for(std::size_t{0}, pieces, [&](std::size_t i) {
      const std::size_t first = i * per_piece, own = std::min<std::size_t>(per_piece, count - first);
      const std::size_t place = offset_ + first * stride;
      auto records = records_of({place, place + own * stride});
      records.read(p, first, own, file_.mesh.vertices);
      if (records.numbers().has_more()) fail("records of other sizes");
      faces_[lists + i] = records.take_faces();
    });
    offset_ += count * stride;
  }

  PieceSource& source_;
  const PlyPlan& plan_;
  std::endian order_;
  std::size_t offset_;  ///< of the next element
  MeshFile file_;
  std::vector<FaceList> faces_;
};

/// Reads a text in pieces. Assumes that every record is a line.
class TextPieces {
 public:
  TextPieces(const Input& input, const PlyPlan& plan, const PlyHeader& header)
      : input_(input), plan_(plan), offset_(header.data) {}

  MeshFile read(std::size_t size) {
    std::uint64_t count = 0;
    for (const PlyElementPlan& p : plan_.elements) {
      // Checked before they are added up: counts may be anything.
      if (p.element->count > input_.data.size()) fail("more records than bytes");
      count += p.element->count;
    }
    const auto pieces = divide_records(input_, offset_, count, {}, size);
    if (pieces.size() == 1) fail("one piece, which may have fewer lines than records");
    for (const PlyElementPlan& p : plan_.elements)
      if (p.role == PlyRole::points) resize_fresh(file_.mesh.vertices, p.element->count);
    std::vector<FaceList> faces(pieces.size());
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) { faces[i] = read_piece(pieces[i]); });
    gather_faces(faces, file_, input_.name);
    return std::move(file_);
  }

 private:
  FaceList read_piece(const RecordPiece& piece) {
    PlyRecords records(plan_, TextNumbers(input_, piece.piece, true));
    std::uint64_t first = 0;  // of the element's records in the file
    for (const PlyElementPlan& p : plan_.elements) {
      const std::uint64_t last = first + p.element->count;
      const std::uint64_t from = std::max(first, piece.first), to = std::min(last, piece.last);
      if (from < to) records.read(p, from - first, to - from, file_.mesh.vertices);
      first = last;
    }
    // Only the last piece extends beyond its records.
    if (records.numbers().has_more()) fail("data behind the last element");
    return records.take_faces();
  }

  const Input& input_;
  const PlyPlan& plan_;
  std::size_t offset_;
  MeshFile file_;
};

}  // namespace

MeshFile read_ply(const Input& input) {
  const PlyHeader header = read_ply_header(input);
  const PlyPlan plan = plan_ply(header);
  return read_in_pieces(input, [&](std::size_t size) {
    const bool in_pieces = size < input.data.size();
    PieceSource source(input.data);
    if (header.order)
      return in_pieces ? BinaryPieces(source, plan, header).read(size, input.name)
                       : read_whole(input, plan, BinaryNumbers(input.data, header.data, *header.order));
    return in_pieces ? TextPieces(input, plan, header).read(size)
                     : read_whole(input, plan, TextNumbers(input, {header.data, input.data.size()}, false));
  });
}

std::optional<MeshFile> read_binary_ply(const File& file, std::size_t piece) {
  PieceSource source(file);
  try {
    const std::string start(source.get({0, std::min(file.size(), piece)}));
    const PlyHeader header = read_ply_header({file.name(), start});
    if (!header.order || header.data == start.size()) return {};
    const PlyPlan plan = plan_ply(header);
    return BinaryPieces(source, plan, header).read(piece, file.name());
  } catch (const Malformed&) {
    return {};
  }
}

}  // namespace strata::io
