#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "extensions/planar/io/scanner.h"

namespace strata::planar {
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

  /// True for the tag that ends an element, </name>.
  [[nodiscard]] bool is_end() const { return text.substr(begin).starts_with("</"); }
  /// True for an element that has nothing in it, <name/>.
  [[nodiscard]] bool is_empty() const { return text.back() == '/'; }
  /// Without the prefix of a name space.
  [[nodiscard]] std::string_view name() const {
    const std::size_t first = begin + (is_end() ? 2 : 1);
    const std::string_view whole = text.substr(first, end_of_name() - first);
    return whole.substr(whole.find(':') + 1);  // all of it, if there is none
  }
  /// The value of an attribute, as a range of the text.
  [[nodiscard]] std::optional<std::array<std::size_t, 2>> value(std::string_view attribute) const {
    if (is_end()) return std::nullopt;
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
  [[nodiscard]] std::size_t end_of_name() const { return find_of(" \t\r\n/", begin + (is_end() ? 2 : 1)); }
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

/// Reads the paths of a document that are drawn.
class DocumentReader {
 public:
  DocumentReader(std::string_view text, RingCollector& rings) : text_(text), rings_(rings) {}

  void read() {
    Tags tags(text_);
    while (const std::optional<Tag> tag = tags.next()) {
      if (hides(*tag)) continue;
      refuse_placement(*tag);
      look_at(*tag);
    }
  }
  /// What was left out.
  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < unread.size(); ++i)
      if (has_unread_[i]) notes.push_back("only paths are read: " + std::string(unread[i]) + " was left out");
    if (has_hidden_path_) notes.emplace_back("paths that are only defined and not drawn were left out");
    if (has_parity_) notes.emplace_back("fill-rule evenodd is not applied: give the rule with the operation");
    if (has_clip_) notes.emplace_back("clip paths and masks are not applied");
    return notes;
  }

 private:
  static constexpr std::array<std::string_view, 8> unread{"polygon",  "rect", "circle", "ellipse",
                                                          "polyline", "text", "image",  "use"};
  static constexpr std::array<std::string_view, 6> hiding{"defs", "symbol", "clipPath", "mask", "pattern", "marker"};

  /// True inside of elements that are not drawn where they are.
  bool hides(const Tag& tag) {
    const std::string_view name = tag.name();
    if (hidden_depth_ == 0) {
      if (tag.is_end() || tag.is_empty() || std::find(hiding.begin(), hiding.end(), name) == hiding.end()) return false;
      hiding_ = name;
      hidden_depth_ = 1;
      return true;
    }
    has_hidden_path_ = has_hidden_path_ || (name == "path" && !tag.is_end());
    if (name == hiding_ && !tag.is_empty()) hidden_depth_ += tag.is_end() ? -1 : 1;
    return true;
  }

  [[nodiscard]] std::string_view text_of(const std::array<std::size_t, 2>& range) const {
    return text_.substr(range[0], range[1] - range[0]);
  }
  /// The value of a property, as an attribute or in a style.
  [[nodiscard]] std::optional<std::array<std::size_t, 2>> property(const Tag& tag, std::string_view name) const {
    if (const auto value = tag.value(name)) return value;
    const auto style = tag.value("style");
    if (!style) return std::nullopt;
    for (std::size_t at = (*style)[0]; at < (*style)[1];) {
      const std::size_t end = std::min(text_.find(';', at), (*style)[1]), colon = std::min(text_.find(':', at), end);
      std::string_view key = text_.substr(at, colon - at);
      key = key.substr(std::min(key.find_first_not_of(white), key.size()));
      if (key.substr(0, key.find_last_not_of(white) + 1) == name) return std::array{std::min(colon + 1, end), end};
      at = end + 1;
    }
    return std::nullopt;
  }

  void refuse_placement(const Tag& tag) {
    if (const auto transform = property(tag, "transform"))
      io::fail_at_line((*transform)[0], "transformations are not applied: write the path with its own coordinates");
    if (tag.name() != "svg") return;
    for (const std::string_view placement : {"x", "y", "viewBox"})
      if (const auto value = tag.value(placement); value && depth_ > 0)
        io::fail_at_line((*value)[0], "svg elements inside of others are not placed: write one with paths alone");
    if (!tag.is_empty()) depth_ += tag.is_end() ? -1 : 1;
  }

  void look_at(const Tag& tag) {
    const std::string_view name = tag.name();
    for (std::size_t i = 0; i < unread.size(); ++i) has_unread_[i] = has_unread_[i] || name == unread[i];
    if (const auto rule = property(tag, "fill-rule"))
      has_parity_ = has_parity_ || text_of(*rule).find("evenodd") != std::string_view::npos;
    has_clip_ = has_clip_ || property(tag, "clip-path") || property(tag, "mask");
    if (name != "path") return;
    if (const auto data = tag.value("d")) PathReader(text_, (*data)[0], (*data)[1], rings_).read();
  }

  std::string_view text_;
  RingCollector& rings_;
  std::string_view hiding_;  ///< the outermost element that is not drawn
  int hidden_depth_ = 0;     ///< how many of that name are open
  int depth_ = 0;            ///< how many svg elements are open
  std::array<bool, unread.size()> has_unread_{};
  bool has_hidden_path_ = false, has_parity_ = false, has_clip_ = false;
};

}  // namespace

Loops read_svg(std::string_view text, std::vector<std::string>& notes) {
  RingCollector rings;
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && text[first] != '<') {
    PathReader(text, 0, text.size(), rings).read();  // bare path data
  } else {
    DocumentReader document(text, rings);
    document.read();
    notes = document.notes();
  }
  return rings.finish();
}

}  // namespace strata::planar
