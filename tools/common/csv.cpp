#include "common/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/system/decimal.h"
#include "strata/errors.h"

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

const char* behind_blanks(const char* at, const char* end) {
  while (at != end && is_blank(*at)) ++at;
  return at;
}

/// Without blanks and quotes around it.
std::string_view bare(std::string_view field) {
  while (!field.empty() && is_blank(field.front())) field.remove_prefix(1);
  while (!field.empty() && is_blank(field.back())) field.remove_suffix(1);
  const bool quoted = field.size() >= 2 && field.front() == '"' && field.back() == '"';
  return quoted ? field.substr(1, field.size() - 2) : field;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t comma = line.find(',');
    fields.push_back(bare(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

/// The field that starts here, short enough for a message.
std::string shown(const char* at, const char* end) {
  constexpr std::size_t most = 40;
  const std::string_view field = bare({at, static_cast<std::size_t>(std::find(at, end, ',') - at)});
  return field.size() <= most ? std::string(field) : fmt::format("{}...", field.substr(0, most));
}

}  // namespace

CsvReader::CsvReader(ByteSource& source, std::vector<std::string> columns)
    : name_(source.name()), lines_(source), columns_(std::move(columns)) {
  LineBlock block;
  while (targets_.empty() && lines_.next(block)) {
    std::size_t used = 0;
    std::uint64_t number = block.first_line;
    while (targets_.empty() && used < block.text.size()) {
      const std::size_t end = std::min(block.text.find('\n', used), block.text.size());
      read_header(std::string_view(block.text).substr(used, end - used), number);
      used = std::min(end + 1, block.text.size());
      ++number;
    }
    lines_.put_back({block.text.substr(used), number});
  }
  if (targets_.empty()) fail(1, fmt::format("expected a header with {}, found nothing", fmt::join(columns_, ",")));
}

void CsvReader::read_header(std::string_view line, std::uint64_t number) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (number == 1 && line.substr(0, 3) == byte_order_mark) line.remove_prefix(3);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (bare(line).empty()) return;
  const std::vector<std::string_view> fields = fields_of(line);
  for (const std::string& column : columns_) {
    const auto count = std::count(fields.begin(), fields.end(), column);
    const std::string_view header = line.substr(0, 80);
    if (count == 0) fail(number, fmt::format("expected a header with the column {}, found '{}'", column, header));
    if (count > 1) fail(number, fmt::format("the column {} is there {} times", column, count));
  }
  for (const std::string_view field : fields) {
    const auto column = std::find(columns_.begin(), columns_.end(), field);
    targets_.push_back(column == columns_.end() ? is_unused : static_cast<std::size_t>(column - columns_.begin()));
  }
}

void CsvReader::parse(const LineBlock& block, std::vector<double>& values) const {
  for_each_line(block, [&](const char* first, const char* last, std::uint64_t number) {
    if (behind_blanks(first, last) != last) parse_row(first, last, number, values);
  });
}

void CsvReader::parse_row(const char* at, const char* end, std::uint64_t line, std::vector<double>& values) const {
  const std::size_t row = values.size();
  values.resize(row + columns_.size());
  const char* const first = at;
  const auto fail_count = [&] {
    const auto found = 1 + std::count(first, end, ',');
    fail(line, fmt::format("expected {} fields, found {}", targets_.size(), found));
  };
  for (std::size_t field = 0; field < targets_.size(); ++field) {
    const std::size_t column = targets_[field];
    at = column == is_unused ? std::find(at, end, ',') : parse_number(at, end, column, line, values[row + column]);
    const bool is_last = field + 1 == targets_.size();
    if ((at == end) != is_last) fail_count();
    if (!is_last) ++at;
  }
}

/// Returns the place of the comma behind the number, or the end.
const char* CsvReader::parse_number(const char* at, const char* end, std::size_t column, std::uint64_t line,
                                    double& value) const {
  const char* const start = at;
  at = behind_blanks(at, end);
  if (end - at > 1 && at[0] == '+' && at[1] != '-') ++at;
  auto [last, error] = strata::system::from_chars(at, end, value);
  const char* const stop = behind_blanks(last, end);
  if (error == std::errc::invalid_argument || (stop != end && *stop != ','))
    fail(line, fmt::format("expected a number for {}, found '{}'", columns_[column], shown(start, end)));
  // Beyond the range of doubles, or so close to zero that it is zero.
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(at, last).c_str(), nullptr);
  if (!std::isfinite(value))
    fail(line, fmt::format("expected a finite number for {}, found '{}'", columns_[column], shown(start, end)));
  return stop;
}

void CsvReader::fail(std::uint64_t line, const std::string& reason) const {
  throw strata::IoError(name_, {line, {}}, reason);
}

char* append_number(char* at, double value) { return std::to_chars(at, at + longest_number, value).ptr; }
