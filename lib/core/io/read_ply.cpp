#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/io/line_records.h"
#include "core/io/piece_source.h"
#include "core/io/ply_records.h"
#include "core/io/ply_textures.h"
#include "core/io/readers.h"

namespace strata::io {
namespace {

template <class Numbers>
void check_room(const PlyElement& element, Numbers& numbers) {
  const std::uint64_t room = numbers.records(element);
  if (element.count > room)
    numbers.fail_at(numbers.offset(), "the header promises " + std::to_string(element.count) + " elements '" +
                                          element.name + "', but the rest of the file has room for " +
                                          std::to_string(room) + " at most: truncated, or the count is wrong");
}

std::vector<std::string> notes_of(bool has_more) {
  return has_more ? std::vector<std::string>{"data behind the last element was ignored"} : std::vector<std::string>();
}

/// Reads all data in order, without assumptions.
template <class Numbers>
MeshFile read_whole(const Input& input, const PlyPlan& plan, Numbers numbers) {
  PlyStore store(plan);
  PlyRecords records(plan, store, numbers);
  for (const PlyElementPlan& p : plan.elements) {
    check_room(*p.element, records.numbers());
    store.make_room(p);
    records.read(p, 0, p.element->count);
  }
  const auto notes = notes_of(records.numbers().has_more());
  std::vector<PlyPiece> all;
  all.push_back(records.take());
  return join_ply(plan, store, all, notes, input.data.size(), input.name);
}

/// Reads a binary file in pieces. Assumes that the lists of an element have the length of those of its first record, so
/// that all records have the same size. This is certain when every piece ends where the next one starts.
class BinaryPieces {
 public:
  BinaryPieces(PieceSource& source, const PlyPlan& plan, const PlyHeader& header)
      : source_(source), plan_(plan), order_(*header.order), offset_(header.data), store_(plan) {}

  MeshFile read(std::size_t size, const std::string& name) {
    for (const PlyElementPlan& p : plan_.elements) read_element(p, size);
    return join_ply(plan_, store_, pieces_, notes_of(offset_ < source_.size()), source_.size(), name);
  }

 private:
  [[nodiscard]] PlyRecords<BinaryNumbers> records_of(Piece piece) {
    return {plan_, store_, BinaryNumbers(source_.get(piece), 0, order_)};
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
    store_.make_room(p);
    const std::size_t per_piece = std::max<std::size_t>(size / stride, 1);
    const std::size_t pieces = (count + per_piece - 1) / per_piece, before = pieces_.size();
    pieces_.resize(before + pieces, PlyPiece(plan_));
    tbb::parallel_for(std::size_t{0}, pieces, [&](std::size_t i) {
      const std::size_t first = i * per_piece, own = std::min<std::size_t>(per_piece, count - first);
      const std::size_t place = offset_ + first * stride;
      auto records = records_of({place, place + own * stride});
      records.read(p, first, own);
      if (records.numbers().has_more()) fail("records of other sizes");
      pieces_[before + i] = records.take();
    });
    offset_ += count * stride;
  }

  PieceSource& source_;
  const PlyPlan& plan_;
  std::endian order_;
  std::size_t offset_;  ///< of the next element
  PlyStore store_;
  std::vector<PlyPiece> pieces_;
};

/// Reads a text in pieces. Assumes that every record is a line.
class TextPieces {
 public:
  TextPieces(const Input& input, const PlyPlan& plan, const PlyHeader& header)
      : input_(input), plan_(plan), offset_(header.data), store_(plan) {}

  MeshFile read(std::size_t size) {
    const TextNumbers data(input_, {offset_, input_.data.size()}, true);
    std::uint64_t count = 0;
    for (const PlyElementPlan& p : plan_.elements) {
      // Checked before they are added up: counts may be anything.
      if (p.element->count > data.records(*p.element)) fail("more records than the file has room for");
      count += p.element->count;
    }
    const auto places = divide_records(input_, offset_, count, {}, size);
    if (places.size() == 1) fail("one piece, which may have fewer lines than records");
    for (const PlyElementPlan& p : plan_.elements) store_.make_room(p);
    std::vector<PlyPiece> pieces(places.size(), PlyPiece(plan_));
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) { pieces[i] = read_piece(places[i]); });
    return join_ply(plan_, store_, pieces, {}, input_.data.size(), input_.name);
  }

 private:
  PlyPiece read_piece(const RecordPiece& piece) {
    PlyRecords records(plan_, store_, TextNumbers(input_, piece.piece, true));
    std::uint64_t first = 0;  // of the element's records in the file
    for (const PlyElementPlan& p : plan_.elements) {
      const std::uint64_t last = first + p.element->count;
      const std::uint64_t from = std::max(first, piece.first), to = std::min(last, piece.last);
      if (from < to) records.read(p, from - first, to - from);
      first = last;
    }
    // Only the last piece extends beyond its records.
    if (records.numbers().has_more()) fail("data behind the last element");
    return records.take();
  }

  const Input& input_;
  const PlyPlan& plan_;
  std::size_t offset_;
  PlyStore store_;
};

}  // namespace

MeshFile read_ply(const Input& input, const std::filesystem::path* folder) {
  const PlyHeader header = read_ply_header(input);
  const PlyPlan plan = plan_ply(header);
  MeshFile file = read_in_pieces(input, [&](std::size_t size) {
    const bool in_pieces = size < input.data.size();
    PieceSource source(input.data);
    if (header.order)
      return in_pieces ? BinaryPieces(source, plan, header).read(size, input.name)
                       : read_whole(input, plan, BinaryNumbers(input.data, header.data, *header.order));
    return in_pieces ? TextPieces(input, plan, header).read(size)
                     : read_whole(input, plan, TextNumbers(input, {header.data, input.data.size()}, false));
  });
  add_textures(file, header.textures, folder);
  return file;
}

std::optional<MeshFile> read_binary_ply(const File& file, std::size_t piece, const std::filesystem::path& folder) {
  PieceSource source(file);
  try {
    const std::string start(source.get({0, std::min(file.size(), piece)}));
    const PlyHeader header = read_ply_header({file.name(), start});
    if (!header.order || header.data == start.size()) return {};
    const PlyPlan plan = plan_ply(header);
    MeshFile mesh = BinaryPieces(source, plan, header).read(piece, file.name());
    add_textures(mesh, header.textures, &folder);
    return mesh;
  } catch (const Malformed&) {
    return {};
  }
}

}  // namespace strata::io
