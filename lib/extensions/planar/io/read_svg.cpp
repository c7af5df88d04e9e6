#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "extensions/planar/io/scanner.h"

namespace strata::planar {
namespace {

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
    const Rational x = to_rational(scanner_.number(false).nearest);
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

/// The part of a file that is the value of an attribute or of a property.
struct Range {
  std::size_t begin = 0, end = 0;
};

/// An XML document over a copy of a file. Values of attributes begin at the same offsets as in the file. Entities that
/// a document declares are not replaced; nothing else is read.
class XmlDocument {
 public:
  explicit XmlDocument(std::string_view text) : text_(text) {
    const pugi::xml_parse_result result = document_.load_buffer_inplace(
        text_.data(), text_.size(), pugi::parse_minimal | pugi::parse_escapes, pugi::encoding_utf8);
    if (!result)
      io::fail_at_line(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)),
                       std::string("no XML: ") + result.description());
  }

  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] pugi::xml_node root() const { return document_; }
  [[nodiscard]] std::string_view text_of(const Range& r) const { return text().substr(r.begin, r.end - r.begin); }

  [[nodiscard]] std::optional<Range> value(pugi::xml_node element, const char* attribute) const {
    const pugi::xml_attribute found = element.attribute(attribute);
    if (!found) return std::nullopt;
    const std::string_view value = found.value();
    if (value.empty()) return Range{};
    const auto begin = static_cast<std::size_t>(value.data() - text_.data());
    return Range{begin, begin + value.size()};
  }
  /// The value of a property, as an attribute or in a style.
  [[nodiscard]] std::optional<Range> property(pugi::xml_node element, const char* name) const {
    if (const auto own = value(element, name)) return own;
    const auto style = value(element, "style");
    if (!style) return std::nullopt;
    const std::string_view all = text();
    for (std::size_t at = style->begin; at < style->end;) {
      const std::size_t end = std::min(all.find(';', at), style->end), colon = std::min(all.find(':', at), end);
      std::string_view key = all.substr(at, colon - at);
      key = key.substr(std::min(key.find_first_not_of(white), key.size()));
      if (key.substr(0, key.find_last_not_of(white) + 1) == name) return Range{std::min(colon + 1, end), end};
      at = end + 1;
    }
    return std::nullopt;
  }

 private:
  std::string text_;
  pugi::xml_document document_;
};

/// Without the prefix of a name space.
std::string_view local_name(pugi::xml_node element) {
  const std::string_view whole = element.name();
  return whole.substr(whole.find(':') + 1);  // all of it, if there is none
}

/// Reads the paths of a document that are drawn.
class DocumentReader {
 public:
  DocumentReader(const XmlDocument& xml, RingCollector& rings) : xml_(xml), rings_(rings) {}

  /// In the order of the document, without recursion: elements may be nested as deep as they like.
  void read() {
    for (pugi::xml_node at = xml_.root().first_child(); at;) {
      if (at.type() == pugi::node_element) enter(at);
      pugi::xml_node next = at.first_child();
      while (!next && at && at != xml_.root()) {
        leave(at);
        next = at.next_sibling();
        at = at.parent();
      }
      at = next;
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

  void enter(pugi::xml_node element) {
    const std::string_view name = local_name(element);
    if (hiding_) {
      has_hidden_path_ = has_hidden_path_ || name == "path";
      return;
    }
    if (element.first_child() && std::find(hiding.begin(), hiding.end(), name) != hiding.end()) {
      hiding_ = element;
      return;
    }
    refuse_placement(element, name);
    look_at(element, name);
  }
  void leave(pugi::xml_node node) {
    if (node == hiding_) hiding_ = {};
    if (!hiding_ && node.type() == pugi::node_element && local_name(node) == "svg") --depth_;
  }

  void refuse_placement(pugi::xml_node element, std::string_view name) {
    if (const auto transform = xml_.property(element, "transform"))
      io::fail_at_line(transform->begin, "transformations are not applied: write the path with its own coordinates");
    if (name != "svg") return;
    for (const char* placement : {"x", "y", "viewBox"})
      if (const auto value = xml_.value(element, placement); value && depth_ > 0)
        io::fail_at_line(value->begin, "svg elements inside of others are not placed: write one with paths alone");
    ++depth_;
  }

  void look_at(pugi::xml_node element, std::string_view name) {
    for (std::size_t i = 0; i < unread.size(); ++i) has_unread_[i] = has_unread_[i] || name == unread[i];
    if (const auto rule = xml_.property(element, "fill-rule"))
      has_parity_ = has_parity_ || xml_.text_of(*rule).find("evenodd") != std::string_view::npos;
    has_clip_ = has_clip_ || xml_.property(element, "clip-path") || xml_.property(element, "mask");
    if (name != "path") return;
    if (const auto data = xml_.value(element, "d")) PathReader(xml_.text(), data->begin, data->end, rings_).read();
  }

  const XmlDocument& xml_;
  RingCollector& rings_;
  pugi::xml_node hiding_;  ///< the outermost element that is not drawn
  int depth_ = 0;          ///< how many svg elements are open
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
    const XmlDocument xml(text);
    DocumentReader document(xml, rings);
    document.read();
    notes = document.notes();
  }
  return rings.finish();
}

}  // namespace strata::planar
