#pragma once
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

#include "strata/errors.h"

namespace strata::io {

/// A destination of bytes. Every write is checked; failures are IoErrors.
class Sink {
 public:
  virtual ~Sink() = default;
  virtual void write(std::string_view bytes) = 0;
};

class StringSink : public Sink {
 public:
  void write(std::string_view bytes) override { text_.append(bytes); }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

class StreamSink : public Sink {
 public:
  StreamSink(std::ostream& stream, std::string name) : stream_(&stream), name_(std::move(name)) {}
  void write(std::string_view bytes) override;
  void finish();  ///< flushes

 private:
  std::ostream* stream_;
  std::string name_;
};

/// A file that becomes visible when it is complete: it is written beside the target, then renamed. It keeps the
/// permissions of a file that it replaces, and follows links. Targets that are no regular files are written in place.
/// Without finish() the unfinished file is removed.
class FileSink : public Sink {
 public:
  explicit FileSink(const std::filesystem::path& target);
  ~FileSink() override;
  FileSink(const FileSink&) = delete;
  FileSink& operator=(const FileSink&) = delete;

  void write(std::string_view bytes) override;
  /// Makes sure that all bytes are in the file. What may fail by a full disk has happened then.
  void complete();
  /// The same, and renames.
  void finish();

 private:
  struct CloseFile {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  void open_beside();
  [[noreturn]] void fail(const char* what, int error) const;

  std::filesystem::path asked_for_;  ///< as given, for messages
  std::filesystem::path target_;
  std::filesystem::path beside_;  ///< empty when written in place
  std::unique_ptr<std::FILE, CloseFile> file_;
};

}  // namespace strata::io
