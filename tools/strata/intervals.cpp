#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iostream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/run.h"
#include "common/text_file.h"
#include "core/system/decimal.h"
#include "report.h"
#include "strata/bsp.h"
#include "strata/rational.h"
#include "verbs.h"

namespace {

using strata::Rational;
using strata::bsp::Interval;
using Line = strata::bsp::Partition<1>;

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The rows of a table with the columns lower and upper.
class Table {
 public:
  Table(std::string name, std::string_view text) : name_(std::move(name)), text_(text) {}

  std::vector<Interval> read() {
    std::vector<Interval> intervals;
    bool has_header = false;
    while (!text_.empty()) {
      const std::string_view row = without_blanks(next_line());
      if (row.empty()) continue;
      const std::size_t comma = row.find(',');
      if (comma == row.npos || row.find(',', comma + 1) != row.npos) fail("expected two fields: lower,upper");
      const std::string_view lower = without_blanks(row.substr(0, comma)),
                             upper = without_blanks(row.substr(comma + 1));
      if (!has_header && (lower != "lower" || upper != "upper")) fail("expected the header lower,upper");
      if (has_header) intervals.push_back({end(lower, "-inf"), end(upper, "inf")});
      has_header = true;
    }
    if (!has_header) fail("expected the header lower,upper");
    return intervals;
  }

 private:
  std::string_view next_line() {
    ++line_;
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    const std::string_view row = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    return row;
  }
  [[nodiscard]] std::optional<Rational> end(std::string_view text, std::string_view infinite) const {
    if (text == infinite) return std::nullopt;
    if (const auto quotient = strata::parse_quotient(text)) return quotient;
    double x = 0;
    const auto [last, error] = strata::system::from_chars(text.data(), text.data() + text.size(), x);
    if (error != std::errc{} || last != text.data() + text.size() || !std::isfinite(x))
      fail(fmt::format("expected a number, a quotient or {}, found '{}'", infinite, text.substr(0, 40)));
    return strata::to_rational(x);
  }
  [[noreturn]] void fail(const std::string& reason) const { throw strata::IoError(name_, {line_, {}}, reason); }

  std::string name_;
  std::string_view text_;
  std::uint64_t line_ = 0;
};

Line read_line(const std::string& path) {
  const bool is_input = path == "-";
  const std::string text = is_input ? std::string{std::istreambuf_iterator<char>(std::cin), {}} : read_file(path);
  return strata::bsp::partition_of(Table(is_input ? "standard input" : path, text).read());
}

std::string text_of(const std::optional<Rational>& end, const char* infinite) {
  if (!end) return infinite;
  const double x = strata::to_nearest_double(*end);
  return strata::to_rational(x) == *end ? fmt::format("{}", x) : end->str();
}

}  // namespace

ExitCode run_intervals(strata::Operation operation, const Settings& settings) {
  std::vector<Line> operands;
  for (const std::string& path : settings.operands) operands.push_back(read_line(path));
  Line result = operands.front();
  for (std::size_t k = 1; k < operands.size(); ++k) result = rebuilt_if_deep(combined(operation, result, operands[k]));
  const std::vector<Interval> intervals = strata::bsp::intervals_of(result);
  std::string rows = "lower,upper\n";
  for (const Interval& i : intervals) rows += text_of(i.lower, "-inf") + "," + text_of(i.upper, "inf") + "\n";
  write_text(settings.output, rows);
  const auto length = strata::bsp::size(result);
  const Json facts = {{"intervals", intervals.size()}, {"length_exact", length ? Json(length->str()) : Json(nullptr)}};
  if (!settings.quiet && settings.report != "-")
    for (const auto& [key, value] : facts.items())
      fmt::print(settings.output == "-" ? stderr : stdout, "{:13} {}\n", key, value.dump());
  if (!settings.report.empty())
    write_report(settings.report, {{"operation", fmt::format("intervals {}", strata::name(operation))},
                                   {"operands", settings.operands},
                                   {"result", facts}});
  return ExitCode::ok;
}
