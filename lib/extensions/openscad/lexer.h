#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "extensions/openscad/report.h"

namespace strata::openscad {

struct Token {
  enum class Kind : std::uint8_t {
    end,
    name,    ///< letters, digits, '_' and '$'
    number,  ///< without a sign, which is a token of its own
    string,
    mark  ///< one character: a bracket, a separator, a modifier or a sign
  };
  Kind kind = Kind::end;
  std::string_view text;  ///< as in the file; strings with their quotes
  double number = 0;
  Place place;

  [[nodiscard]] bool is(char mark) const { return kind == Kind::mark && text[0] == mark; }
};

/// Divides a text into tokens, with one token of lookahead. White space, comments and byte order marks are skipped. The
/// text must outlive the tokens. Throws CsgError for characters that begin no token, unterminated strings and comments,
/// and numbers beyond the range of doubles.
class Lexer {
 public:
  Lexer(std::string_view text, const Report& report) : text_(text), report_(report) { advance(); }

  [[nodiscard]] const Token& next() const { return next_; }
  Token take() {
    const Token token = next_;
    advance();
    return token;
  }
  /// Takes the next token if it is that character.
  bool take(char mark) {
    if (!next_.is(mark)) return false;
    advance();
    return true;
  }
  void expect(char mark) {
    if (!take(mark)) fail_expected(std::string("'") + mark + "'");
  }
  /// Throws: "expected WHAT, found 'TOKEN'".
  [[noreturn]] void fail_expected(const std::string& what) const;

 private:
  void advance();
  void skip_space();
  void skip_comment();
  void skip(std::size_t count);
  [[nodiscard]] bool starts(std::string_view with) const { return text_.substr(at_).starts_with(with); }
  [[nodiscard]] std::size_t number_length() const;
  [[nodiscard]] std::size_t string_length() const;
  [[nodiscard]] std::size_t name_length() const;
  [[nodiscard]] double number_of(std::string_view digits) const;

  std::string_view text_;
  const Report& report_;
  std::size_t at_ = 0;
  Place place_;
  Token next_;
};

}  // namespace strata::openscad
