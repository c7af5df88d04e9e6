#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "common/point_source.h"
#include "core/io/ply_header.h"
#include "core/io/text_cursor.h"

namespace {

using strata::io::PlyElement;
using strata::io::PlyHeader;
using strata::io::PlyProperty;

constexpr std::array<const char*, 3> axes{"x", "y", "z"};

/// The header, as its text; what was read beyond it is put back.
PlyHeader read_header(ByteSource& bytes, std::string& text) {
  constexpr std::size_t piece = 1 << 12, longest = 1 << 20;
  constexpr std::string_view last_word = "end_header";
  std::size_t end = std::string::npos;
  while (end == std::string::npos && text.size() < longest) {
    const std::size_t before = text.size();
    text.resize(before + piece);
    const std::size_t got = bytes.read(text.data() + before, piece);
    text.resize(before + got);
    if (got == 0) break;
    const std::size_t word = text.find(last_word);
    if (word != std::string::npos) end = text.find('\n', word);
  }
  const strata::io::Input input{bytes.name(), text};
  try {
    PlyHeader header = strata::io::read_ply_header(input);
    bytes.put_back(text.substr(header.data));
    text.resize(header.data);
    return header;
  } catch (const strata::io::Malformed& malformed) {
    throw input.error(malformed);
  }
}

/// What is common to vertices as text and as bytes.
class PlyPoints : public PointSource {
 public:
  PlyPoints(ByteSource& bytes, PlyElement element) : bytes_(bytes), vertex_(std::move(element)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto property = vertex_.find(axes[axis]);
      if (!property) fail({}, fmt::format("expected the property {} of vertices", axes[axis]));
      properties_[axis] = *property;
    }
  }
  [[nodiscard]] std::optional<std::uint64_t> count() const override { return vertex_.count; }

 protected:
  [[noreturn]] void fail(strata::IoError::Place place, const std::string& reason) const {
    throw strata::IoError(bytes_.name(), place, reason);
  }
  [[noreturn]] void fail_short(std::uint64_t found) const {
    fail({}, fmt::format("expected {} vertices, found {}", vertex_.count, found));
  }

  ByteSource& bytes_;
  PlyElement vertex_;
  std::array<std::size_t, 3> properties_{};  ///< x, y and z
};

/// Records of one size. The "line" of a block is the number of its first record.
class BinaryPoints : public PlyPoints {
 public:
  BinaryPoints(ByteSource& bytes, const PlyHeader& header)
      : PlyPoints(bytes, header.elements.front()),
        order_(*header.order),
        data_(header.data),
        size_(vertex_.least_size()) {
    std::size_t offset = 0;
    for (std::size_t i = 0; i < vertex_.properties.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (properties_[axis] == i) offsets_[axis] = offset;
      offset += strata::io::size_of(vertex_.properties[i].type);
    }
  }

  bool next(LineBlock& block) override {
    constexpr std::uint64_t most = 1 << 14;
    const std::uint64_t count = std::min(most, vertex_.count - done_);
    block.first_line = done_;
    block.text.resize(count * size_);
    for (std::size_t filled = 0; filled < block.text.size();) {
      const std::size_t got = bytes_.read(block.text.data() + filled, block.text.size() - filled);
      if (got == 0) fail_short(done_ + filled / size_);
      filled += got;
    }
    done_ += count;
    return count > 0;
  }

  void parse(const LineBlock& block, std::vector<double>& coordinates) const override {
    for (std::size_t at = 0; at < block.text.size(); at += size_)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t place = at + offsets_[axis];
        const double x = strata::io::load_scalar(block.text.data() + place, type(axis), order_);
        if (!std::isfinite(x))
          fail({{}, data_ + block.first_line * size_ + place},
               fmt::format("expected a finite {} of vertex {}", axes[axis], block.first_line + at / size_));
        coordinates.push_back(x);
      }
  }

 private:
  [[nodiscard]] strata::io::PlyScalar type(std::size_t axis) const {
    return vertex_.properties[properties_[axis]].type;
  }

  std::endian order_;
  std::size_t data_;  ///< offset of the first record in the file
  std::size_t size_;  ///< bytes of a record
  std::array<std::size_t, 3> offsets_{};
  std::uint64_t done_ = 0;
};

/// One record per line.
class TextPoints : public PlyPoints {
 public:
  TextPoints(ByteSource& bytes, const PlyHeader& header, std::uint64_t first_line)
      : PlyPoints(bytes, header.elements.front()), lines_(bytes, first_line) {}

  bool next(LineBlock& block) override {
    if (done_ == vertex_.count) return false;
    if (!lines_.next(block)) fail_short(done_);
    std::size_t used = 0;
    for_each_line(block, [&](const char* first, const char* last, std::uint64_t) {
      if (done_ == vertex_.count) return;
      done_ += !is_blank({first, static_cast<std::size_t>(last - first)});
      used = static_cast<std::size_t>(last - block.text.data());
    });
    block.text.resize(used);
    return true;
  }

  void parse(const LineBlock& block, std::vector<double>& coordinates) const override {
    for_each_line(block, [&](const char* first, const char* last, std::uint64_t line) {
      const std::string_view text(first, static_cast<std::size_t>(last - first));
      if (!is_blank(text)) parse_line(text, line, coordinates);
    });
  }

 private:
  static bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\v\f") == std::string_view::npos; }

  void parse_line(std::string_view text, std::uint64_t line, std::vector<double>& coordinates) const try {
    strata::io::TextCursor cursor(text, {});
    std::array<double, 3> x{};
    for (std::size_t i = 0; i < vertex_.properties.size(); ++i) {
      const auto axis = std::find(properties_.begin(), properties_.end(), i) - properties_.begin();
      if (axis < 3)
        x[static_cast<std::size_t>(axis)] = cursor.number("a number for a coordinate");
      else if (cursor.word().empty())
        cursor.fail_expected("a number");
    }
    if (!cursor.at_line_end()) cursor.fail_expected("the end of the line");
    coordinates.insert(coordinates.end(), x.begin(), x.end());
  } catch (const strata::io::Malformed& malformed) {
    fail({line, {}}, malformed.reason);
  }

  LineBlocks lines_;
  std::uint64_t done_ = 0;
};

}  // namespace

std::unique_ptr<PointSource> make_ply_points(ByteSource& bytes) {
  std::string text;
  const PlyHeader header = read_header(bytes, text);
  const auto fail = [&](const char* reason) { throw strata::IoError(bytes.name(), {}, reason); };
  if (header.elements.empty() || header.elements.front().name != "vertex")
    fail("expected vertices as the first element");
  if (header.elements.front().has_lists()) fail("expected vertices without lists");
  if (header.order) return std::make_unique<BinaryPoints>(bytes, header);
  const auto lines = static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
  return std::make_unique<TextPoints>(bytes, header, lines + 1);
}
