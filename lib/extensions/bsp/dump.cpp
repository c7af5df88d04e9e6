#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/system/decimal.h"
#include "extensions/bsp/prune.h"

namespace strata::bsp {
namespace {

/// The words of consecutive lines.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  /// The next line with words.
  std::vector<std::string_view> next() {
    while (!rest_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++number_;
      std::vector<std::string_view> words;
      while (true) {
        const std::size_t from = line.find_first_not_of(" \t\r");
        if (from == std::string_view::npos) break;
        const std::size_t length = std::min(line.find_first_of(" \t\r", from), line.size()) - from;
        words.push_back(line.substr(from, length));
        line.remove_prefix(from + length);
      }
      if (!words.empty()) return words;
    }
    fail("the tree ends too early");
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error("line " + std::to_string(number_) + ": " + why);
  }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

class DumpReader {
 public:
  explicit DumpReader(std::string_view text) : lines_(text) {}

  Partition<3> read() {
    if (lines_.next() != std::vector<std::string_view>{"PolyhedronsSet"}) lines_.fail("no PolyhedronsSet");
    const auto tolerance = lines_.next();
    if (tolerance.size() != 2 || tolerance[0] != "tolerance") lines_.fail("no tolerance");
    tree_.root = node(0);
    return pruned(table_, tree_);
  }

 private:
  static constexpr int most_depth = 10'000;

  /// "minus|plus internal p n tolerance" and its children, or "minus|plus leaf true|false".
  Link node(int depth) {
    if (depth > most_depth) lines_.fail("more than 10,000 nodes above one another");
    const auto words = lines_.next();
    if (words.size() == 3 && words[1] == "leaf" && (words[2] == "true" || words[2] == "false"))
      return leaf(words[2] == "true");
    if (words.size() != 9 || words[1] != "internal") lines_.fail("neither a plane nor a leaf");
    RationalVector<3> p, n;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = number(words[2 + i]);
      n[i] = number(words[5 + i]);
    }
    if (n[0] == 0 && n[1] == 0 && n[2] == 0) lines_.fail("a plane without a normal");
    OrientedHyperplane<3> plane =
        oriented_hyperplane<3>(std::array<Rational, 4>{n[0], n[1], n[2], -(n[0] * p[0] + n[1] * p[1] + n[2] * p[2])});
    const std::uint32_t h = table_.add(std::move(plane.hyperplane));
    const Link minus = node(depth + 1), plus = node(depth + 1);
    tree_.nodes.push_back({h, plane.is_reversed ? plus : minus, plane.is_reversed ? minus : plus});
    return static_cast<Link>(tree_.nodes.size() - 1);
  }

  Rational number(std::string_view word) const {
    double x = 0;
    const auto [end, error] = system::from_chars(word.data(), word.data() + word.size(), x);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(x))
      lines_.fail("no number: " + std::string(word));
    return to_rational(x);
  }

  Lines lines_;
  HyperplaneTable<3> table_;
  Tree tree_;
};

}  // namespace

Partition<3> read_polyhedrons_set(std::string_view text) { return DumpReader(text).read(); }

}  // namespace strata::bsp
