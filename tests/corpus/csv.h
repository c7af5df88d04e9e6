#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace strata::test {

/// One row, by the names in the first line.
using Row = std::map<std::string, std::string>;

/// Fields are parted by commas; a field in double quotes may hold commas, line ends and doubled quotes.
/// Missing fields are empty. Throws std::runtime_error when the file cannot be read.
[[nodiscard]] std::vector<Row> read_csv(const std::filesystem::path& path);
[[nodiscard]] std::vector<Row> parse_csv(std::string_view text);

}  // namespace strata::test
