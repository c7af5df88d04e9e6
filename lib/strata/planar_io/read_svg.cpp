#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strata/planar_io/scanner.h"

namespace strata::plane {
namespace {

Rational exact(const io::ExactCoordinate& c) { return to_rational(c.nearest); }

/// Path data (SVG 1.1, 8.3), straight lines only. Subpaths are closed as filling closes them.
class PathReader {
 public:
  PathReader(std::string_view text, std::size_t begin, std::size_t end, RingCollector& rings)
      : begin_(begin), scanner_(text.substr(begin, end - begin)), rings_(rings) {}

  void read() {
    try {
      for (scanner_.skip_space(); !scanner_.at_end(); scanner_.skip_space()) command(scanner_.take());
      rings_.end_path();
    } catch (io::Malformed& e) {
      e.offset += begin_;  // in the file
      throw;
    }
  }

 private:
  void command(char c) {
    switch (c) {
      case 'M':
      case 'm':
        return move(c == 'm');
      case 'L':
      case 'l':
        return lines(c == 'l');
      case 'H':
      case 'h':
        return along(0, c == 'h');
      case 'V':
      case 'v':
        return along(1, c == 'v');
      case 'Z':
      case 'z':
        return close();
      default:
        refuse(c);
    }
  }
  [[noreturn]] void refuse(char c) const {
    switch (c) {
      case 'C':
      case 'c':
      case 'S':
      case 's':
        scanner_.fail("cubic Bezier curves are not straight: flatten the path first");
      case 'Q':
      case 'q':
      case 'T':
      case 't':
        scanner_.fail("quadratic Bezier curves are not straight: flatten the path first");
      case 'A':
      case 'a':
        scanner_.fail("elliptical arcs are not straight: flatten the path first");
      default:
        scanner_.fail("expected a path command, found " + io::quoted({&c, 1}));
    }
  }
  void move(bool is_relative) {
    rings_.end_path();
    point(is_relative);
    start_ = at_;
    started_ = true;
    emit();
    while (next_argument()) line(is_relative);
  }
  void lines(bool is_relative) {
    begin_line();
    do line(is_relative);
    while (next_argument());
  }
  void line(bool is_relative) {
    point(is_relative);
    emit();
  }
  void along(std::size_t axis, bool is_relative) {
    begin_line();
    do {
      coordinate(axis, is_relative);
      emit();
    } while (next_argument());
  }
  void close() {
    if (!started_) scanner_.fail("expected M before Z");
    rings_.end_path();
    at_ = start_;
    is_closed_ = true;
  }
  /// What is drawn after Z without a move goes on from the start of the last subpath.
  void begin_line() {
    if (!started_) scanner_.fail("expected M before lines");
    if (is_closed_) emit();
  }
  void point(bool is_relative) {
    coordinate(0, is_relative);
    scanner_.accept(',');
    coordinate(1, is_relative);
  }
  void coordinate(std::size_t axis, bool is_relative) {
    const Rational x = exact(scanner_.number(false));
    at_[axis] = is_relative ? Rational(at_[axis] + x) : x;
    if (!std::isfinite(to_nearest_double(at_[axis])))
      scanner_.fail("a sum of relative coordinates is beyond all doubles");
  }
  bool next_argument() { return scanner_.accept(',') || scanner_.is_at_number(); }
  void emit() {
    CoordinatePair p;
    for (std::size_t i = 0; i < 2; ++i) {
      const double nearest = to_nearest_double(at_[i]);
      p[i].nearest = nearest;
      if (!(to_rational(nearest) == at_[i])) p[i].exact = at_[i];
    }
    rings_.add(std::move(p));
    is_closed_ = false;
  }

  std::size_t begin_;
  Scanner scanner_;
  RingCollector& rings_;
  RationalPlacement at_, start_;
  bool started_ = false, is_closed_ = false;
};

constexpr std::string_view white = " \t\r\n";

/// A tag: from '<' to its '>', which is not quoted.
struct Tag {
  std::size_t begin = 0;
  std::string_view text;  ///< of the file, up to the end of the tag

  [[nodiscard]] std::size_t end_of_name() const { return find_of(" \t\r\n/", begin + 1); }
  /// Without the prefix of a name space.
  [[nodiscard]] std::string_view name() const {
    const std::string_view whole = text.substr(begin + 1, end_of_name() - begin - 1);
    return whole.substr(whole.find(':') + 1);  // all of it, if there is none
  }
  /// The value of an attribute, as a range of the text.
  [[nodiscard]] std::optional<std::array<std::size_t, 2>> value(std::string_view attribute) const {
    for (std::size_t at = behind_white(end_of_name()); at < text.size();) {
      const std::size_t end_of_key = find_of(" \t\r\n=", at), sign = behind_white(end_of_key);
      const bool has_value = sign < text.size() && text[sign] == '=';
      const std::size_t close = has_value ? end_of_value(sign) : sign;
      if (has_value && text.substr(at, end_of_key - at) == attribute)
        return std::array{behind_white(sign + 1) + 1, close};
      at = behind_white(close + (has_value ? 1 : 0));
    }
    return std::nullopt;
  }

 private:
  /// The quote that closes the value behind a sign.
  [[nodiscard]] std::size_t end_of_value(std::size_t sign) const {
    const std::size_t quote = behind_white(sign + 1);
    const bool is_quoted = quote < text.size() && (text[quote] == '"' || text[quote] == '\'');
    const std::size_t close = is_quoted ? find_of(text.substr(quote, 1), quote + 1) : text.size();
    if (close == text.size()) io::fail_at_line(sign, "expected a quoted value of an attribute");
    return close;
  }
  [[nodiscard]] std::size_t find_of(std::string_view any, std::size_t from) const {
    return std::min(text.find_first_of(any, from), text.size());
  }
  [[nodiscard]] std::size_t behind_white(std::size_t from) const {
    return std::min(text.find_first_not_of(white, from), text.size());
  }
};

/// Behind the next occurrence of a text.
std::size_t behind(std::string_view text, std::string_view what, std::size_t from) {
  const std::size_t at = text.find(what, from);
  if (at == std::string_view::npos) io::fail_at_line(from, "expected '" + std::string(what) + "'");
  return at + what.size();
}

/// The tags of elements in a text, in order. Comments, character data, instructions and declarations are passed over.
class Tags {
 public:
  explicit Tags(std::string_view text) : text_(text) {}

  std::optional<Tag> next() {
    while (true) {
      const std::size_t begin = text_.find('<', at_);
      if (begin == std::string_view::npos) return std::nullopt;
      const std::string_view rest = text_.substr(begin);
      if (const auto end = behind_hidden(begin)) {
        at_ = *end;
      } else if (rest.starts_with("<![CDATA[")) {
        at_ = behind(text_, "]]>", begin);
      } else if (rest.starts_with("<!")) {
        at_ = behind_declaration(begin);
      } else {
        at_ = end_of_tag(begin);
        return Tag{begin, text_.substr(0, at_)};
      }
    }
  }

 private:
  /// Behind a comment or an instruction, in which quotes mean nothing.
  [[nodiscard]] std::optional<std::size_t> behind_hidden(std::size_t begin) const {
    const std::string_view rest = text_.substr(begin);
    if (rest.starts_with("<!--")) return behind(text_, "-->", begin + 4);
    if (rest.starts_with("<?")) return behind(text_, "?>", begin + 2);
    return std::nullopt;
  }
  /// Declarations may hold others, comments and instructions.
  [[nodiscard]] std::size_t behind_declaration(std::size_t begin) const {
    std::size_t at = begin + 1;
    for (std::size_t depth = 1; depth > 0;) {
      at = text_.find_first_of("\"'<>", at);
      if (at == std::string_view::npos) io::fail_at_line(begin, "expected '>' behind a declaration");
      const char c = text_[at];
      if (c == '<') {
        const auto end = behind_hidden(at);
        depth += end ? 0 : 1;
        at = end.value_or(at + 1);
      } else if (c == '>') {
        --depth;
        ++at;
      } else {
        at = behind(text_, text_.substr(at, 1), at + 1);
      }
    }
    return at;
  }
  [[nodiscard]] std::size_t end_of_tag(std::size_t begin) const {
    for (std::size_t at = begin;;) {
      at = text_.find_first_of("\"'>", at);
      if (at == std::string_view::npos) io::fail_at_line(begin, "expected '>' behind a tag");
      if (text_[at] == '>') return at;
      at = behind(text_, text_.substr(at, 1), at + 1);
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

void read_paths(std::string_view text, RingCollector& rings, std::vector<std::string>& notes) {
  constexpr std::array<std::string_view, 5> shapes{"polygon", "rect", "circle", "ellipse", "polyline"};
  std::array<bool, shapes.size()> is_there{};
  Tags tags(text);
  while (const std::optional<Tag> tag = tags.next()) {
    if (const auto transform = tag->value("transform"))
      io::fail_at_line((*transform)[0], "transformations are not applied: write the path with its own coordinates");
    const std::string_view name = tag->name();
    for (std::size_t i = 0; i < shapes.size(); ++i) is_there[i] = is_there[i] || name == shapes[i];
    if (name != "path") continue;
    if (const auto data = tag->value("d")) PathReader(text, (*data)[0], (*data)[1], rings).read();
  }
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (is_there[i]) notes.push_back("only paths are read: " + std::string(shapes[i]) + " was left out");
}

}  // namespace

Loops read_svg(std::string_view text, std::vector<std::string>& notes) {
  RingCollector rings;
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && text[first] != '<') {
    PathReader(text, 0, text.size(), rings).read();  // bare path data
  } else {
    read_paths(text, rings, notes);
  }
  return rings.finish();
}

}  // namespace strata::plane
