#pragma once
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/io/input.h"
#include "core/io/line_end.h"
#include "core/io/pieces.h"
#include "core/system/decimal.h"

namespace strata::io {

/// A cursor over the words and lines of a text, or of a piece of it. Numbers are exact and independent of the locale.
/// Lines end with LF, CR LF or CR. Every failure is Malformed with its offset.
class TextCursor {
 public:
  struct Syntax {
    bool hash_comments = false;  ///< '#' at the start of a word starts a comment
    bool continuation = false;   ///< a backslash before the line end joins two lines, but not in a comment
  };

  /// A byte order mark at the start of the text is skipped.
  TextCursor(std::string_view text, Syntax syntax, Piece piece);
  TextCursor(std::string_view text, Syntax syntax) : TextCursor(text, syntax, {0, text.size()}) {}

  [[nodiscard]] bool at_end() const { return at_ == end_; }
  [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  [[nodiscard]] std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }

  void skip_blanks() {
    while (at_ != end_) {
      if (*at_ == ' ' || *at_ == '\t' || *at_ == '\v' || *at_ == '\f')
        ++at_;
      else if (*at_ != '\\' || !skip_continuation())
        return;
    }
  }
  /// Skips blanks; true when only a comment follows on this line.
  [[nodiscard]] bool at_line_end() {
    skip_blanks();
    return at_ == end_ || *at_ == '\n' || *at_ == '\r' || (syntax_.hash_comments && *at_ == '#');
  }
  /// Advances to the start of the next line; continued lines are one line. Requires that no comment started on this
  /// line before.
  void skip_line() {
    while (true) {
      const char* const from = at_;
      at_ = find_line_end(at_, end_);
      if (at_ == end_) return;
      const bool joined = syntax_.continuation && at_ != begin_ && at_[-1] == '\\' && !has_comment(from);
      at_ = behind_line_end(at_, end_);
      if (!joined) return;
    }
  }
  /// Advances to the next word, on this line or a later one. False at the end of the text.
  bool next_word_anywhere() {
    while (at_line_end()) {
      if (at_ == end_) return false;
      skip_line();
    }
    return true;
  }
  /// The word here, up to white space; empty at the end of the line.
  std::string_view word() {
    if (at_line_end()) return {};
    const char* const first = at_;
    while (at_ != end_ && !is_white(*at_)) ++at_;
    return {first, static_cast<std::size_t>(at_ - first)};
  }
  /// All characters up to the end of the line, blanks and comments included.
  std::string_view rest_of_line() {
    const char* const first = at_;
    at_ = find_line_end(at_, end_);
    return {first, static_cast<std::size_t>(at_ - first)};
  }
  /// Skips the word if it equals this one, in any case.
  bool accept(std::string_view expected);
  /// Skips the character if it is here, without skipping blanks.
  bool accept_char(char c) {
    if (!is_at(c)) return false;
    ++at_;
    return true;
  }
  /// Skips the characters if the text continues with them, whatever follows.
  bool accept_text(std::string_view text);

  [[nodiscard]] bool is_at(char c) const { return at_ != end_ && *at_ == c; }
  [[nodiscard]] bool is_at_digit() const { return at_ != end_ && *at_ >= '0' && *at_ <= '9'; }
  /// True when a word ends here: white space, a continued line or the end follows.
  [[nodiscard]] bool at_delimiter() const { return is_delimiter(at_); }

  /// A finite double. Numbers below the range are zero, numbers beyond it are an error.
  double number(const char* what) {
    skip_blanks();
    double value = 0;
    const auto [last, error] = system::from_chars(behind_plus(), end_, value);
    if (error != std::errc{} || !is_delimiter(last) || !std::isfinite(value)) return unusual_number(what);
    at_ = last;
    return value;
  }
  /// The same, faster for integers.
  double whole_number(const char* what) {
    skip_blanks();
    std::int64_t value = 0;
    const char* const last = behind_digits(value);
    if (last == nullptr || !is_delimiter(last)) return number(what);
    at_ = last;
    return static_cast<double>(value);
  }
  /// An integer that may be followed by something other than white space.
  std::int64_t leading_integer(const char* what) {
    skip_blanks();
    std::int64_t value = 0;
    const char* const last = behind_digits(value);
    if (last == nullptr) return unusual_integer(what);
    at_ = last;
    return value;
  }
  /// An integer that ends with the word.
  std::int64_t integer(const char* what) {
    skip_blanks();
    const char* const first = at_;
    const std::int64_t value = leading_integer(what);
    if (at_delimiter()) return value;
    at_ = first;
    fail_expected(what);
  }
  /// A count of items that take at least `bytes` bytes of text each: at most as many as the rest of the text can
  /// contain.
  std::uint64_t count(const char* what, std::uint64_t bytes);

  /// Throws: "expected WHAT, found 'WORD'".
  [[noreturn]] void fail_expected(const std::string& what) const;
  [[noreturn]] void fail_here(const std::string& reason) const { fail_at_line(offset(), reason); }

 private:
  static bool is_white(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  [[nodiscard]] bool is_delimiter(const char* at) const {
    return at == end_ || is_white(*at) || (syntax_.continuation && *at == '\\');
  }
  [[nodiscard]] const char* behind_plus() const {
    return at_ + (is_at('+') && at_ + 1 != end_ && at_[1] != '-' ? 1 : 0);
  }
  /// The integer here, and the position after it. Null if there is no digit here, or many, or the text ends with them.
  const char* behind_digits(std::int64_t& value) const {
    constexpr std::size_t few = 15;  // a double represents them
    const char* const stop = remaining() > few ? at_ + few : end_;
    const char* at = at_;
    for (; at != stop && *at >= '0' && *at <= '9'; ++at) value = 10 * value + (*at - '0');
    return at == at_ || at == stop ? nullptr : at;
  }
  bool skip_continuation();                                ///< past a backslash and the line end after it
  [[nodiscard]] bool has_comment(const char* from) const;  ///< does one start in [from, at_)?
  double unusual_number(const char* what);                 ///< out of the range of doubles, or none
  std::int64_t unusual_integer(const char* what);          ///< signed, long, at the end of the text, or none

  const char* begin_;  ///< of the text
  const char* at_;
  const char* end_;  ///< of the piece
  Syntax syntax_;
};

}  // namespace strata::io
