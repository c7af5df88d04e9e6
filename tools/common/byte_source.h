#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "strata/monitor.h"

/// The bytes of a file or of standard input ("-"), read from the first to the last. Waiting for a slow pipe ends when
/// `cancel` is set. Throws strata::IoError, strata::Cancelled.
class ByteSource {
 public:
  explicit ByteSource(const std::string& path, const strata::CancelToken* cancel = nullptr);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// The path, or "standard input", for messages.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Copies the next bytes, at most `size`; 0 at the end only.
  std::size_t read(char* to, std::size_t size);
  /// Puts bytes back, to be read next.
  void put_back(const std::string& bytes);
  /// How much of the file was read, 0 to 1; 0 where nobody can tell (pipes).
  [[nodiscard]] double fraction() const;

 private:
  void wait() const;
  [[noreturn]] void fail(int error) const;

  std::string name_;
  const strata::CancelToken* cancel_;
  std::string back_;  ///< bytes that were put back
  int descriptor_ = 0;
  std::uint64_t size_ = 0;
  std::uint64_t done_ = 0;
};
