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
        scanner_.fail(std::string("expected a path command, found '") + c + "'");
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

/// The value of an attribute in [begin, end), as a range of the text.
std::optional<std::array<std::size_t, 2>> attribute(std::string_view text, std::size_t begin, std::size_t end,
                                                    std::string_view name) {
  for (std::size_t at = text.find(name, begin); at < end; at = text.find(name, at + 1)) {
    std::size_t i = at + name.size();
    const bool is_name = std::string_view(" \t\r\n").find(text[at - 1]) != std::string_view::npos;
    while (i < end && std::string_view(" \t\r\n").find(text[i]) != std::string_view::npos) ++i;
    if (!is_name || i >= end || text[i] != '=') continue;
    const std::size_t quote = text.find_first_of("\"'", i);
    if (quote >= end) io::fail_at_line(at, "expected a quoted value of " + std::string(name));
    const std::size_t close = text.find(text[quote], quote + 1);
    if (close == std::string_view::npos) io::fail_at_line(at, "expected a quoted value of " + std::string(name));
    return std::array{quote + 1, close};
  }
  return std::nullopt;
}

void read_paths(std::string_view text, RingCollector& rings) {
  if (const std::size_t at = text.find(" transform="); at != std::string_view::npos)
    io::fail_at_line(at, "transformations are not applied: write the path with its own coordinates");
  for (std::size_t at = text.find("<path"); at != std::string_view::npos; at = text.find("<path", at + 1)) {
    std::size_t end = at;
    for (char quote = 0; end < text.size() && (quote != 0 || text[end] != '>'); ++end)
      if (quote != 0 ? text[end] == quote : text[end] == '"' || text[end] == '\'')
        quote = quote != 0 ? '\0' : text[end];
    if (end == text.size()) io::fail_at_line(at, "expected '>' behind a path");
    if (const auto data = attribute(text, at + 5, end, "d")) PathReader(text, (*data)[0], (*data)[1], rings).read();
  }
}

}  // namespace

Loops read_svg(std::string_view text, std::vector<std::string>& notes) {
  RingCollector rings;
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && text[first] != '<') {
    PathReader(text, 0, text.size(), rings).read();  // bare path data
  } else {
    read_paths(text, rings);
    for (const char* shape : {"<polygon", "<rect", "<circle", "<ellipse", "<polyline"})
      if (text.find(shape) != std::string_view::npos)
        notes.push_back(std::string("only paths are read: ") + (shape + 1) + " was left out");
  }
  return rings.finish();
}

}  // namespace strata::plane
