#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <string_view>
#include <vector>

#include "core/io/file.h"
#include "core/io/pieces.h"

namespace strata::io {

/// Bytes that are in memory, or are read from a file piece by piece, so that they are never in memory together.
class PieceSource {
 public:
  explicit PieceSource(std::string_view data) : data_(data), size_(data.size()) {}
  explicit PieceSource(const File& file) : file_(&file), size_(file.size()) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  /// The bytes of a piece; from a file, they are valid until the next call of the same thread. Requires a piece within
  /// size(). Throws Malformed when the file has become shorter, IoError when it cannot be read.
  [[nodiscard]] std::string_view get(Piece piece);

 private:
  std::string_view data_;
  const File* file_ = nullptr;
  std::size_t size_;
  tbb::enumerable_thread_specific<std::vector<char>> buffers_;
};

}  // namespace strata::io
