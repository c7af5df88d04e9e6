#include "row_file.h"

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

RowFile::RowFile(const std::string& path, Header header, std::optional<std::uint64_t> count)
    : file_(path), header_(std::move(header)) {
  if (count) {
    file_.write(header_(*count));
  } else {
    waiting_.reset(std::tmpfile());
    if (!waiting_) fail_waiting();
  }
}

void RowFile::write(std::string_view rows) {
  if (!waiting_) return file_.write(rows);
  if (std::fwrite(rows.data(), 1, rows.size(), waiting_.get()) != rows.size()) fail_waiting();
}

void RowFile::finish(std::uint64_t count) {
  if (waiting_) {
    file_.write(header_(count));
    copy_waiting_rows();
  }
  file_.finish();
}

void RowFile::copy_waiting_rows() {
  std::rewind(waiting_.get());
  std::array<char, 1 << 16> piece;
  while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), waiting_.get()))
    file_.write({piece.data(), got});
  if (std::ferror(waiting_.get()) != 0) fail_waiting();
}

void RowFile::fail_waiting() {
  throw strata::IoError("a temporary file", {}, "cannot write: " + std::generic_category().message(errno));
}
