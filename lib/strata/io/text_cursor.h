#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "strata/io/input.h"

namespace strata::io {

/// Walks through the words and lines of a text. Numbers are read with std::from_chars: exact, in no locale.
/// Lines end with LF, CR LF or CR. Every failure is an IoError with the line.
class TextCursor {
 public:
  struct Syntax {
    bool hash_comments = false;  ///< '#' at the start of a word hides the rest of the line
    bool continuation = false;   ///< a backslash before the line end joins two lines
  };

  /// Starts at the offset, after a byte order mark.
  TextCursor(const Input& input, Syntax syntax, std::size_t offset = 0);

  [[nodiscard]] bool at_end() const { return at_ == end_; }
  [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(at_ - input_->data.data()); }
  [[nodiscard]] std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }

  void skip_blanks() {
    while (at_ != end_) {
      if (*at_ == ' ' || *at_ == '\t' || *at_ == '\v' || *at_ == '\f')
        ++at_;
      else if (*at_ != '\\' || !skip_continuation())
        return;
    }
  }
  /// Skips blanks; true when nothing follows on this line but a comment.
  [[nodiscard]] bool at_line_end() {
    skip_blanks();
    return at_ == end_ || *at_ == '\n' || *at_ == '\r' || (syntax_.hash_comments && *at_ == '#');
  }
  /// To the start of the next line; continued lines are one line.
  void skip_line();
  /// To the next word, on this line or a later one. False at the end of the text.
  bool next_word_anywhere() {
    while (at_line_end()) {
      if (at_ == end_) return false;
      skip_line();
    }
    return true;
  }
  /// The word here, up to white space; empty at the line's end.
  std::string_view word();
  /// Skips the word if it is the one given, in any case.
  bool accept(std::string_view word);
  /// Skips the character if it is here, without skipping blanks.
  bool accept_char(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  [[nodiscard]] bool is_at(char c) const { return at_ != end_ && *at_ == c; }
  [[nodiscard]] bool is_at_digit() const { return at_ != end_ && *at_ >= '0' && *at_ <= '9'; }
  /// Skips the characters if the text goes on with them, whatever follows.
  bool accept_text(std::string_view text);

  /// A finite double. Numbers below the range are zero, numbers beyond it are an error.
  double number(const char* what);
  /// An integer that ends with the word.
  std::int64_t integer(const char* what);
  /// An integer that something other than white space may follow.
  std::int64_t leading_integer(const char* what);
  /// A count of things that take at least `bytes` bytes of text each: no more than the rest of the text can hold.
  std::uint64_t count(const char* what, std::uint64_t bytes);
  /// True when a word ends here: white space, a continued line or the end follows.
  [[nodiscard]] bool at_delimiter() const;

  /// Throws: "expected WHAT, found 'WORD'".
  [[noreturn]] void fail_expected(const std::string& what) const;
  [[noreturn]] void fail(const std::string& reason) const { input_->fail_at_line(offset(), reason); }
  /// The same at an earlier place.
  [[noreturn]] void fail_at(std::size_t offset, const std::string& reason) const {
    input_->fail_at_line(offset, reason);
  }

 private:
  bool skip_continuation();  ///< past a backslash and the line end behind it
  double out_of_range(const char* first, const char* last, const char* what);

  const Input* input_;
  Syntax syntax_;
  const char* at_;
  const char* end_;
};

}  // namespace strata::io
