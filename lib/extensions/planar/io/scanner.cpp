#include "extensions/planar/io/scanner.h"

#include <algorithm>
#include <cctype>

namespace strata::planar {
namespace {

constexpr std::string_view number_characters = "+-0123456789.eE";

Rational rational_of(const io::ExactCoordinate& c) { return c.exact ? *c.exact : to_rational(c.nearest); }

bool is_equal(const CoordinatePair& p, const CoordinatePair& q) {
  return rational_of(p[0]) == rational_of(q[0]) && rational_of(p[1]) == rational_of(q[1]);
}

Rational twice_area_of(const std::vector<CoordinatePair>& ring) {
  LoopsBuilder builder;
  for (const auto& [x, y] : ring) {
    if (x.exact || y.exact) {
      builder.add_vertex(RationalPlacement{rational_of(x), rational_of(y)});
    } else {
      builder.add_vertex(PlanePoint{x.nearest, y.nearest});
    }
  }
  builder.end_loop();
  return twice_area(builder.finish());
}

}  // namespace

void Scanner::skip_space() {
  while (!at_end() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
}

bool Scanner::accept(char c) {
  skip_space();
  if (peek() != c || at_end()) return false;
  ++at_;
  return true;
}

void Scanner::expect(char c) {
  if (!accept(c)) fail_expected(std::string("'") + c + "'");
}

std::string Scanner::word() {
  skip_space();
  std::string letters;
  while (std::isalpha(static_cast<unsigned char>(peek())) != 0)
    letters.push_back(static_cast<char>(std::toupper(static_cast<unsigned char>(take()))));
  return letters;
}

bool Scanner::is_at_number() {
  skip_space();
  return !at_end() &&
         (std::isdigit(static_cast<unsigned char>(peek())) != 0 || peek() == '-' || peek() == '+' || peek() == '.');
}

io::ExactCoordinate Scanner::number(bool quotients) {
  skip_space();
  std::size_t end = at_;
  bool has_point = false, has_exponent = false;
  for (; end < text_.size(); ++end) {  // "1-2" and "1.5.5" are two numbers each, in paths
    const char c = text_[end];
    if (c == '/' && quotients) continue;
    if (number_characters.find(c) == std::string_view::npos) break;
    const bool is_exponent = c == 'e' || c == 'E';
    const bool behind_exponent = end > at_ && (text_[end - 1] == 'e' || text_[end - 1] == 'E');
    if ((c == '+' || c == '-') && end > at_ && !behind_exponent && !(quotients && text_[end - 1] == '/')) break;
    if (c == '.' && (has_point || has_exponent)) break;
    if (is_exponent && has_exponent) break;
    has_point = has_point || c == '.';
    has_exponent = has_exponent || is_exponent;
  }
  if (end == at_) fail_expected("a number");
  const std::string_view digits = text_.substr(at_, end - at_);
  try {
    io::TextCursor cursor(digits, {});
    io::ExactCoordinate value = io::read_coordinate(cursor);
    if (!quotients) value.exact.reset();  // long integers are rounded where rationals are not supported
    at_ = end;
    return value;
  } catch (const io::Malformed& e) {
    fail(e.reason);
  }
}

void Scanner::fail_expected(const std::string& what) const {
  if (at_end()) fail("expected " + what + ", found the end of the file");
  const auto end = text_.find_first_of(" \t\r\n,()[]{}<>\"", at_ + 1);
  fail("expected " + what + ", found " + io::quoted(text_.substr(at_, end - at_)));
}

void RingCollector::drop_repeated_end() {
  while (ring_.size() > 1 && is_equal(ring_.front(), ring_.back())) ring_.pop_back();
}

void RingCollector::flush() {
  for (auto& [x, y] : ring_) {
    if (x.exact || y.exact) {
      builder_.add_vertex(RationalPlacement{rational_of(x), rational_of(y)});
    } else {
      builder_.add_vertex(PlanePoint{x.nearest, y.nearest});
    }
  }
  if (!ring_.empty()) builder_.end_loop();
  ring_.clear();
}

void RingCollector::end_path() {
  drop_repeated_end();
  flush();
}

void RingCollector::end_ring(bool is_shell) {
  drop_repeated_end();
  const Rational area = twice_area_of(ring_);
  if (is_shell ? area < 0 : area > 0) std::reverse(ring_.begin(), ring_.end());
  flush();
}

}  // namespace strata::planar
