#include "core/io/sink.h"

#include <cerrno>
#include <ostream>
#include <system_error>

#include "core/system/file.h"

namespace strata::io {
namespace fs = std::filesystem;

void StreamSink::write(std::string_view bytes) {
  if (!stream_->write(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    throw IoError(name_, {}, "cannot write: the stream reports an error");
}

void StreamSink::finish() {
  if (!stream_->flush()) throw IoError(name_, {}, "cannot write: the stream reports an error");
}

FileSink::FileSink(const fs::path& target) : asked_for_(target), target_(target) {
  std::error_code ignored;
  if (const auto real = fs::canonical(target, ignored); !real.empty()) target_ = real;
  const auto status = fs::status(target_, ignored);
  if (fs::is_directory(status)) throw IoError(target.string(), {}, "is a directory, expected the name of a file");
  if (fs::exists(status)) {
    // Renaming could replace a file that is not writable, so this opens it; this changes nothing in a regular file.
    file_.reset(system::open_stream(target_,
                                    fs::is_regular_file(status) ? system::FileMode::update : system::FileMode::create));
    if (!file_) fail("cannot write", errno);
  }
  if (!fs::exists(status) || fs::is_regular_file(status)) open_beside();
  if (fs::is_regular_file(status)) fs::permissions(beside_, status.permissions(), ignored);
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
}

void FileSink::open_beside() {
  constexpr int most_attempts = 1000;
  for (int i = 0; i < most_attempts; ++i) {
    beside_ = target_;
    beside_ += std::string(".").append(std::to_string(i)).append(".part");
    file_.reset(system::open_stream(beside_, system::FileMode::beside));
    if (file_ || errno != EEXIST) break;
  }
  const int error = errno;
  if (file_) return;
  beside_.clear();
  fail("cannot create a file in that directory", error);
}

FileSink::~FileSink() {
  if (beside_.empty()) return;
  file_.reset();
  std::error_code ignored;
  fs::remove(beside_, ignored);
}

void FileSink::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) fail("cannot write", errno);
}

void FileSink::complete() {
  if (!file_) return;
  if (std::fflush(file_.get()) != 0) fail("cannot write", errno);
  if (std::fclose(file_.release()) != 0) fail("cannot write", errno);
}

void FileSink::finish() {
  complete();
  if (beside_.empty()) return;
  std::error_code error;
  fs::rename(beside_, target_, error);
  if (error) fail("cannot rename the finished file", error.value());
  beside_.clear();
}

void FileSink::fail(const char* what, int error) const {
  throw IoError(asked_for_.string(), {}, std::string(what) + ": " + std::generic_category().message(error));
}

}  // namespace strata::io
