#pragma once
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace strata {

/// A file that cannot be read or written, or does not hold what its format demands. what() is one sentence; what its
/// reason quotes has no control characters: "part.obj:12: expected a number for y, found 'abc'".
class IoError : public std::runtime_error {
 public:
  /// Where in the file: a line (text, from 1) or a byte (binary, from 0).
  struct Place {
    std::optional<std::uint64_t> line;
    std::optional<std::uint64_t> byte;
  };

  IoError(std::string path, Place place, std::string reason);

  [[nodiscard]] const std::string& path() const noexcept { return path_; }  ///< or the name given for a stream
  [[nodiscard]] std::optional<std::uint64_t> line() const noexcept { return place_.line; }
  [[nodiscard]] std::optional<std::uint64_t> byte() const noexcept { return place_.byte; }
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }  ///< what was expected, what was found

 private:
  std::string path_;
  Place place_;
  std::string reason_;
};

}  // namespace strata
