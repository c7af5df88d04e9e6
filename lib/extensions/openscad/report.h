#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace strata::openscad {

/// A position in a text: line and column, both from 1; columns in bytes.
struct Place {
  std::size_t line = 1;
  std::size_t column = 1;
};

/// Errors in a file, which end the reading, and notes.
class Report {
 public:
  explicit Report(std::string file) : file_(std::move(file)) {}

  [[nodiscard]] const std::string& file() const { return file_; }
  [[noreturn]] void fail(const Place& place, const std::string& reason) const;  ///< throws CsgError

  /// Equal notes become one, with the line of the first and their number. Of very many different ones the first ones
  /// are kept.
  void note(const Place& place, const std::string& what);

  [[nodiscard]] bool is_empty() const { return notes_.empty(); }
  /// Adds the notes of another report, in their order.
  void absorb(const Report& other);

  /// In order of first occurrence: "color is passed over (12 times, first in line 3)".
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  struct Note {
    std::string what;
    std::size_t line = 0;
    std::size_t count = 0;
  };

  void note(const std::string& what, std::size_t line, std::size_t count);

  std::string file_;
  std::vector<Note> notes_;
  std::map<std::string, std::size_t> number_of_;
  std::size_t left_out_ = 0;
};

}  // namespace strata::openscad
