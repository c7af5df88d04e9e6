#include "extensions/openscad/surface.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "core/system/decimal.h"
#include "extensions/openscad/arguments.h"
#include "extensions/openscad/model_file.h"
#include "extensions/openscad/picture.h"
#include "extensions/openscad/rational_mesh.h"

namespace strata::openscad {
namespace {

using Rows = std::vector<std::vector<double>>;

Rows rows_of(std::string_view text, const Arguments& arguments) {
  Rows rows;
  std::size_t line = 0;
  while (!text.empty()) {
    std::string_view row = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(row.size() + 1, text.size()));
    ++line;
    std::vector<double> heights;
    const auto skip_space = [&] { row.remove_prefix(std::min(row.find_first_not_of(" \t\r,"), row.size())); };
    for (skip_space(); !row.empty() && row.front() != '#'; skip_space()) {
      double height = 0;
      const auto [end, error] = system::from_chars(row.data(), row.data() + row.size(), height);
      if (error != std::errc{} || !std::isfinite(height))
        arguments.fail("file", "has no number in line " + std::to_string(line) + ": '" +
                                   std::string(row.substr(0, std::min<std::size_t>(row.find(' '), 32))) + "'");
      heights.push_back(height);
      row.remove_prefix(static_cast<std::size_t>(end - row.data()));
    }
    if (!heights.empty()) rows.push_back(std::move(heights));
  }
  return rows;
}

Rows rows_of_picture(const std::string& bytes, const Arguments& arguments) {
  const bool is_inverted = arguments.truth("invert", false);
  try {
    return heights_of(picture_of_png(bytes), is_inverted);
  } catch (const std::runtime_error& e) {
    arguments.fail("file", "is a picture that is not read: " + std::string(e.what()));
  }
}

class Field {
 public:
  Field(Rows rows, bool is_centred) : rows_(std::move(rows)) {
    for (const auto& row : rows_) columns_ = std::max(columns_, row.size());
    for (auto& row : rows_) row.resize(columns_, 0);
    x_ = is_centred ? -static_cast<double>(columns_ - 1) / 2 : 0;
    y_ = is_centred ? -static_cast<double>(rows_.size() - 1) / 2 : 0;
    base_ = 1;
    for (const auto& row : rows_) base_ = std::min(base_, *std::min_element(row.begin(), row.end()));
    base_ -= 1;
  }

  Mesh mesh() {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (std::size_t j = 0; j < columns_; ++j) mesh_.add(Vertex{x_ + at(j), y_ + at(i), rows_[i][j]});
    for (std::size_t i = 1; i < rows_.size(); ++i)
      for (std::size_t j = 1; j < columns_; ++j) cell(i, j);
    skirt();
    return mesh_.take().mesh;
  }

 private:
  static double at(std::size_t i) { return static_cast<double>(i); }
  [[nodiscard]] std::uint32_t top(std::size_t i, std::size_t j) const {
    return static_cast<std::uint32_t>(i * columns_ + j);
  }
  void cell(std::size_t i, std::size_t j) {
    const double mean = (rows_[i - 1][j - 1] + rows_[i - 1][j] + rows_[i][j - 1] + rows_[i][j]) / 4;
    const std::uint32_t centre = mesh_.add(Vertex{x_ + at(j) - 0.5, y_ + at(i) - 0.5, mean});
    const std::uint32_t corners[4] = {top(i - 1, j - 1), top(i - 1, j), top(i, j), top(i, j - 1)};
    for (std::size_t k = 0; k < 4; ++k) mesh_.triangle(corners[k], corners[(k + 1) % 4], centre);
  }
  /// The walls and the base, a fan.
  void skirt() {
    std::vector<std::uint32_t> rim;
    const std::size_t last = rows_.size() - 1, end = columns_ - 1;
    for (std::size_t j = 0; j < end; ++j) rim.push_back(top(0, j));
    for (std::size_t i = 0; i < last; ++i) rim.push_back(top(i, end));
    for (std::size_t j = end; j > 0; --j) rim.push_back(top(last, j));
    for (std::size_t i = last; i > 0; --i) rim.push_back(top(i, 0));
    std::vector<std::uint32_t> foot;
    for (const std::uint32_t v : rim) {
      const Vertex p = mesh_.mesh().mesh.vertices[v];
      foot.push_back(mesh_.add(Vertex{p[0], p[1], base_}));
    }
    const std::uint32_t centre = mesh_.add(Vertex{x_ + at(end) / 2, y_ + at(last) / 2, base_});
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const std::size_t next = (k + 1) % rim.size();
      mesh_.triangle(foot[k], foot[next], rim[next]);
      mesh_.triangle(foot[k], rim[next], rim[k]);
      mesh_.triangle(foot[next], foot[k], centre);
    }
  }

  Rows rows_;
  std::size_t columns_ = 0;
  double x_ = 0, y_ = 0, base_ = 0;
  VertexCollector mesh_;
};

}  // namespace

Part surface(const SyntaxNode& node, const std::string& name, const CsgOptions& options, Report& report) {
  const Arguments arguments(node, {"file", "center", "invert", "convexity", "timestamp"}, report);
  if (arguments.text("file", {}).empty()) {
    arguments.note("without a file makes nothing");
    return {};
  }
  const std::string path = path_of_file(arguments, options);
  const std::string bytes = bytes_of(path);
  Rows rows = is_png(bytes) ? rows_of_picture(bytes, arguments) : rows_of(bytes, arguments);
  const bool has_cells =
      rows.size() >= 2 && std::any_of(rows.begin(), rows.end(), [](const auto& r) { return r.size() >= 2; });
  if (!has_cells) {
    arguments.note("of less than two rows or columns makes nothing");
    return {};
  }
  Field field(std::move(rows), arguments.truth("center", false));
  return Part::of(Expression(Solid(field.mesh(), InputClass::solid), name), true);
}

}  // namespace strata::openscad
