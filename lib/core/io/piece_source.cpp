#include "core/io/piece_source.h"

namespace strata::io {

std::string_view PieceSource::get(Piece piece) {
  if (file_ == nullptr) return data_.substr(piece.first, piece.size());
  std::vector<char>& buffer = buffers_.local();
  if (buffer.size() < piece.size()) buffer.resize(piece.size());
  if (file_->read_at(piece.first, buffer.data(), piece.size()) < piece.size()) fail("the file became shorter");
  return {buffer.data(), piece.size()};
}

}  // namespace strata::io
