#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/line_blocks.h"

/// Reads numbers from a table: a header that names the columns, then one row per line, fields separated by commas.
/// The columns asked for may stand in any order and among others, which are passed over. Blank lines are too, blanks
/// around fields do not matter, lines end with LF or CR LF. Numbers are doubles, finite, in no locale.
///
///     CsvReader table(source, {"x", "y", "z"});
///     LineBlock block;
///     std::vector<double> values;
///     while (table.next(block)) {
///       values.clear();
///       table.parse(block, values);  // x0 y0 z0 x1 y1 z1 ...
///     }
class CsvReader {
 public:
  /// Reads the header. Throws strata::IoError: no header, a column that is missing or there twice.
  CsvReader(ByteSource& source, std::vector<std::string> columns);

  /// The next rows as text, in the order of the table; false at the end. Throws strata::IoError.
  bool next(LineBlock& block) { return lines_.next(block); }
  /// Appends the numbers of the rows, those of a row in the order in which the columns were asked for. Safe to call
  /// from many threads. Throws strata::IoError with the line: too few or too many fields, not a number, not finite.
  void parse(const LineBlock& block, std::vector<double>& values) const;

 private:
  void read_header(std::string_view line, std::uint64_t number);
  void parse_row(const char* at, const char* end, std::uint64_t line, std::vector<double>& values) const;
  const char* parse_number(const char* at, const char* end, std::size_t column, std::uint64_t line,
                           double& value) const;
  [[noreturn]] void fail(std::uint64_t line, const std::string& reason) const;

  static constexpr std::size_t is_unused = ~std::size_t{0};

  std::string name_;
  LineBlocks lines_;
  std::vector<std::string> columns_;  ///< asked for
  std::vector<std::size_t> targets_;  ///< per field of a row: the column that it is
};

/// Characters of the longest number: "-2.2250738585072014e-308".
inline constexpr std::size_t longest_number = 24;

/// Puts the shortest digits that read back as the same double. Returns the place behind.
[[nodiscard]] char* append_number(char* at, double value);
