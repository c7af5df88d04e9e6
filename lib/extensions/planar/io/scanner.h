#pragma once
#include <string>
#include <string_view>

#include "core/io/input.h"
#include "core/io/xoff_number.h"
#include "strata/planar.h"

namespace strata::planar {

/// A cursor over the characters and words of a text. Every failure is io::Malformed with its offset.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  void skip_space();
  [[nodiscard]] bool at_end() const { return at_ == text_.size(); }
  [[nodiscard]] char peek() const { return at_end() ? '\0' : text_[at_]; }
  char take() { return text_[at_++]; }
  [[nodiscard]] std::size_t offset() const { return at_; }
  /// Skips white space, and the character if it follows.
  bool accept(char c);
  void expect(char c);
  /// Letters, in upper case; empty if there are none.
  [[nodiscard]] std::string word();
  /// True where a number may start.
  [[nodiscard]] bool is_at_number();
  /// A number, as a coordinate of a point. `quotients`: 1/3 is a number.
  [[nodiscard]] io::ExactCoordinate number(bool quotients);
  [[noreturn]] void fail(const std::string& reason) const { io::fail_at_line(at_, reason); }
  [[noreturn]] void fail_expected(const std::string& what) const;

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

using CoordinatePair = std::array<io::ExactCoordinate, 2>;

/// Collects the rings of a file.
class RingCollector {
 public:
  void add(CoordinatePair p) { ring_.push_back(std::move(p)); }
  /// Ends a ring unchanged, except for a repeated last vertex.
  void end_path();
  /// Ends a ring of a polygon, which is reversed if necessary.
  void end_ring(bool is_shell);
  [[nodiscard]] Loops finish() { return builder_.finish(); }

 private:
  void drop_repeated_end();
  void flush();
  LoopsBuilder builder_;
  std::vector<CoordinatePair> ring_;
};

/// Readers of the formats.
Loops read_wkt(std::string_view text, std::vector<std::string>& notes);
Loops read_geojson(std::string_view text, std::vector<std::string>& notes);
Loops read_svg(std::string_view text, std::vector<std::string>& notes);

}  // namespace strata::planar
