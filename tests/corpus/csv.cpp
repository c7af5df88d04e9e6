#include "corpus/csv.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace strata::test {
namespace {

using Record = std::vector<std::string>;

/// Reads one field from `at` on, and leaves `at` on what ended it: a comma, a line end, or the end of the text.
std::string read_field(std::string_view text, std::size_t& at) {
  std::string field;
  bool quoted = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') {
      if (quoted && at + 1 < text.size() && text[at + 1] == '"') {
        field += text[++at];
      } else {
        quoted = !quoted;
      }
    } else if (!quoted && (c == ',' || c == '\n')) {
      break;
    } else if (c != '\r') {
      field += c;
    }
  }
  return field;
}

std::vector<Record> records(std::string_view text) {
  std::vector<Record> all;
  for (std::size_t at = 0; at < text.size(); ++at) {
    Record record{read_field(text, at)};
    while (at < text.size() && text[at] == ',') record.push_back(read_field(text, ++at));
    all.push_back(std::move(record));
  }
  return all;
}

}  // namespace

std::vector<Row> parse_csv(std::string_view text) {
  const std::vector<Record> all = records(text);
  std::vector<Row> rows;
  for (std::size_t i = 1; i < all.size(); ++i) {
    Row row;
    for (std::size_t k = 0; k < all[0].size(); ++k) row[all[0][k]] = k < all[i].size() ? all[i][k] : "";
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Row> read_csv(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  const std::string text(std::istreambuf_iterator<char>(file), {});
  return parse_csv(text);
}

}  // namespace strata::test
