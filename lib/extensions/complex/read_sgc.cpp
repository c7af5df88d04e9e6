#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <istream>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/input.h"
#include "core/kernel/rational_point.h"
#include "core/system/decimal.h"
#include "extensions/complex/validate.h"
#include "strata/complex.h"
#include "strata/rational.h"

namespace strata::complex {
namespace {

using Index = std::uint32_t;

/// The words of a text, line by line.
class Lines {
 public:
  Lines(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {}

  [[noreturn]] void fail(const std::string& what) const { throw IoError(name_, {number_, {}}, what); }
  [[noreturn]] void fail_all(const std::string& what) const { throw IoError(name_, {}, what); }

  /// Advances to the next line with a word.
  void next() {
    for (words_.clear(), at_ = 0; words_.empty();) {
      if (!std::getline(in_, line_)) fail("the file ends too early");
      ++number_;
      split();
    }
  }
  /// Requires that only comments and blank lines follow.
  void end_file() {
    end_line();
    while (std::getline(in_, line_)) {
      ++number_;
      words_.clear();
      split();
      if (!words_.empty()) fail("expected the end of the file, found " + io::quoted(words_[0]));
    }
  }
  [[nodiscard]] bool is_done() const { return at_ == words_.size(); }
  [[nodiscard]] std::string_view word(const char* what) {
    if (is_done()) fail(std::string("expected ") + what + ", found the end of the line");
    return words_[at_++];
  }
  void end_line() const {
    if (!is_done()) fail("expected the end of the line, found " + io::quoted(words_[at_]));
  }
  void expect(std::string_view keyword) {
    if (const auto found = word(keyword.data()); found != keyword)
      fail("expected '" + std::string(keyword) + "', found " + io::quoted(found));
  }
  [[nodiscard]] Index number(const char* what) { return number(word(what), what); }
  [[nodiscard]] Index number(std::string_view text, const char* what) const {
    Index value = 0;
    const auto [end, error] = system::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value == none)
      fail(std::string("expected ") + what + ", found " + io::quoted(text));
    return value;
  }
  [[nodiscard]] std::uint8_t mark() {
    const auto text = word("a mark");
    if (text != "0" && text != "1") fail("expected a mark, 0 or 1, found " + io::quoted(text));
    return text == "1" ? 1 : 0;
  }
  [[nodiscard]] Rational rational() {
    const auto text = word("a coordinate");
    const auto value = text.starts_with('+') ? std::nullopt : parse_quotient(text);
    if (!value) fail("expected an integer or a fraction, found " + io::quoted(text));
    if (!std::isfinite(to_nearest_double(*value))) fail("a coordinate is beyond all doubles");
    return *value;
  }

 private:
  void split() {
    std::string_view rest = std::string_view(line_).substr(0, line_.find('#'));
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!rest.empty()) {
      std::size_t length = 0;
      while (length < rest.size() && !is_blank(rest[length])) ++length;
      if (length > 0) words_.push_back(rest.substr(0, length));
      rest.remove_prefix(std::min(length + 1, rest.size()));
    }
  }

  std::istream& in_;
  std::string name_, line_;
  std::uint64_t number_ = 0;
  std::vector<std::string_view> words_;
  std::size_t at_ = 0;
};

class Reader {
 public:
  Reader(std::istream& in, const std::string& name) : lines_(in, name) {}

  SelectiveComplex read() {
    lines_.next();
    lines_.expect("SGC");
    lines_.expect("1");
    lines_.end_line();
    lines_.next();
    lines_.expect("dimension");
    const Index dimension = lines_.number("2 or 3");
    if (dimension != 2 && dimension != 3) lines_.fail("the dimension is neither 2 nor 3");
    lines_.end_line();
    cells_.dimension = static_cast<int>(dimension);
    read_list("vertices", [this] { read_vertex(); });
    read_list("edges", [this] { read_edge(); });
    read_list("faces", [this] { read_face(); });
    if (dimension == 3) {
      read_list("volumes", [this] { cells_.marks[3].push_back(lines_.mark()); });
      read_list("isolated", [this] { read_isolated(); });
    }
    lines_.next();
    lines_.expect("end");
    lines_.end_file();
    return checked();
  }

 private:
  template <class Read>
  void read_list(const char* name, const Read& read) {
    lines_.next();
    lines_.expect(name);
    const Index count = lines_.number("how many there are");
    lines_.end_line();
    for (Index i = 0; i < count; ++i) {
      lines_.next();
      read();
      lines_.end_line();
    }
  }

  void read_vertex() {
    RationalPoint p;
    Vertex rounded;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = lines_.rational();
      rounded[i] = to_nearest_double(p[i]) + 0.0;
    }
    cells_.marks[0].push_back(lines_.mark());
    if (p != to_rational(rounded)) cells_.exact.push_back({static_cast<Index>(cells_.points.size()), p});
    cells_.points.push_back(rounded);
  }

  void read_edge() {
    const Index low = lines_.number("a vertex"), high = lines_.number("a vertex");
    cells_.edges.push_back({low, high});
    cells_.marks[1].push_back(lines_.mark());
  }

  void read_face() {
    const Index face = cells_.count(2);
    if (cells_.dimension == 3) {
      const Index above = lines_.number("the volume above");
      cells_.sides.push_back({above, lines_.number("the volume below")});
    }
    cells_.marks[2].push_back(lines_.mark());
    while (!lines_.is_done()) {
      const std::string_view text = lines_.word("a wing");
      const Index number = lines_.number(text.substr(1), "L, R or V and a number");
      if (text[0] == 'L' || text[0] == 'R') {
        cells_.wings.push_back({number, face, text[0] == 'L'});
      } else if (text[0] == 'V') {
        cells_.vertices_in_faces.push_back({number, face});
      } else {
        lines_.fail("expected L, R or V and a number, found " + io::quoted(text));
      }
    }
  }

  void read_isolated() {
    const std::string_view text = lines_.word("V or E and a number");
    const Index number = lines_.number(text.substr(1), "V or E and a number"), volume = lines_.number("a volume");
    if (text[0] != 'V' && text[0] != 'E') lines_.fail("expected V or E and a number, found " + io::quoted(text));
    (text[0] == 'V' ? cells_.vertices_in_volumes : cells_.edges_in_volumes).push_back({number, volume});
  }

  SelectiveComplex checked() {
    try {
      return validated(std::move(cells_));
    } catch (const ComplexError& error) {
      static constexpr std::array<const char*, 4> names{"vertex ", "edge ", "face ", "volume "};
      lines_.fail_all(names[static_cast<std::size_t>(error.where().dimension)] + std::to_string(error.where().index) +
                      ": " + error.what());
    }
  }

  Lines lines_;
  Cells cells_;
};

}  // namespace

SelectiveComplex read_sgc(std::istream& in, const std::string& name) { return Reader(in, name).read(); }

SelectiveComplex read_sgc(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw IoError(path, {}, "cannot be read");
  return read_sgc(in, path);
}

}  // namespace strata::complex
