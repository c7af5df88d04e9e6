#include "extensions/openscad/lexer.h"

#include <charconv>

#include "core/system/decimal.h"

namespace strata::openscad {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$'; }
bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_mark(char c) { return std::string_view("(){}[],;=#!%*+-").find(c) != std::string_view::npos; }

}  // namespace

/// Lines end with LF, CR LF or CR.
void Lexer::skip(std::size_t count) {
  for (const std::size_t end = at_ + count; at_ < end; ++at_) {
    const bool ends_line = text_[at_] == '\n' || (text_[at_] == '\r' && text_.substr(at_ + 1, 1) != "\n");
    place_ = ends_line ? Place{place_.line + 1, 1} : Place{place_.line, place_.column + 1};
  }
}

void Lexer::skip_space() {
  while (at_ < text_.size()) {
    if (is_space(text_[at_])) {
      skip(1);
    } else if (starts("//") || starts("/*")) {
      skip_comment();
    } else if (starts("\xEF\xBB\xBF")) {
      skip(3);
    } else {
      return;
    }
  }
}

void Lexer::skip_comment() {
  if (starts("//")) return skip(std::min(text_.find_first_of("\r\n", at_), text_.size()) - at_);
  const std::size_t end = text_.find("*/", at_ + 2);
  if (end == std::string_view::npos) report_.fail(place_, "a comment is never closed");
  skip(end + 2 - at_);
}

std::size_t Lexer::name_length() const {
  std::size_t end = at_ + 1;
  while (end < text_.size() && (is_name_start(text_[end]) || is_digit(text_[end]))) ++end;
  return end - at_;
}

/// Digits, a point and digits, an exponent. Further letters and digits belong to the same token and make it invalid.
std::size_t Lexer::number_length() const {
  std::size_t end = at_;
  while (end < text_.size()) {
    const char c = text_[end];
    const bool is_sign = (c == '-' || c == '+') && (text_[end - 1] == 'e' || text_[end - 1] == 'E');
    if (!is_digit(c) && c != '.' && !is_name_start(c) && !is_sign) break;
    ++end;
  }
  return end - at_;
}

std::size_t Lexer::string_length() const {
  for (std::size_t end = at_ + 1; end < text_.size(); ++end) {
    if (text_[end] == '"') return end + 1 - at_;
    if (text_[end] == '\\') ++end;
  }
  report_.fail(place_, "a string is never closed");
}

double Lexer::number_of(std::string_view digits) const {
  double value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [last, error] = system::from_chars(digits.data(), end, value);
  if (error == std::errc::result_out_of_range && last == end)
    report_.fail(place_, "the number " + std::string(digits.substr(0, 32)) + " is beyond the range of doubles");
  if (error != std::errc{} || last != end)
    report_.fail(place_, "'" + std::string(digits.substr(0, 32)) + "' is no number");
  return value;
}

void Lexer::advance() {
  skip_space();
  next_ = {Token::Kind::end, text_.substr(at_, 0), 0, place_};
  if (at_ == text_.size()) return;
  const char c = text_[at_];
  std::size_t length = 1;
  if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
    next_.kind = Token::Kind::number;
    length = number_length();
    next_.number = number_of(text_.substr(at_, length));
  } else if (is_name_start(c)) {
    next_.kind = Token::Kind::name;
    length = name_length();
  } else if (c == '"') {
    next_.kind = Token::Kind::string;
    length = string_length();
  } else if (is_mark(c)) {
    next_.kind = Token::Kind::mark;
  } else {
    const bool is_plain = c > ' ' && c < 0x7f;
    report_.fail(place_,
                 is_plain ? std::string("a '") + c + "' has no meaning here" : "a character has no meaning here");
  }
  next_.text = text_.substr(at_, length);
  skip(length);
}

void Lexer::fail_expected(const std::string& what) const {
  const std::string found =
      next_.kind == Token::Kind::end ? "the end of the file" : "'" + std::string(next_.text.substr(0, 32)) + "'";
  report_.fail(next_.place, "expected " + what + ", found " + found);
}

}  // namespace strata::openscad
