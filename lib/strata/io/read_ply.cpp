#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "strata/io/face_list.h"
#include "strata/io/ply_header.h"
#include "strata/io/readers.h"
#include "strata/io/text_cursor.h"

namespace strata::io {
namespace {

/// The numbers of an ASCII file. Values that are skipped need not be numbers.
class TextNumbers {
 public:
  TextNumbers(const Input& input, std::size_t offset) : text_(input, {}, offset) {}

  double next(PlyScalar, const char* what) {
    seek(what);
    return text_.number(what);
  }
  void skip(PlyScalar, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      seek("a number");
      text_.word();
    }
  }
  /// How many values the rest can hold at most: a digit and a blank each.
  [[nodiscard]] std::uint64_t room(PlyScalar) const { return (text_.remaining() + 1) / 2; }
  [[nodiscard]] std::uint64_t records(const PlyElement& e) const {
    return (text_.remaining() + 1) / (2 * e.properties.size());
  }
  [[nodiscard]] bool has_more() { return text_.next_word_anywhere(); }
  /// Of the next number.
  [[nodiscard]] std::size_t offset() {
    (void)text_.next_word_anywhere();
    return text_.offset();
  }
  [[noreturn]] void fail_at(std::size_t offset, const std::string& reason) const { text_.fail_at(offset, reason); }

 private:
  void seek(const char* what) {
    if (!text_.next_word_anywhere()) text_.fail_expected(what);
  }
  TextCursor text_;
};

/// The numbers of a binary file.
class BinaryNumbers {
 public:
  BinaryNumbers(const Input& input, std::size_t offset, std::endian order)
      : input_(&input), offset_(offset), order_(order) {}

  double next(PlyScalar type, const char* what) {
    if (input_->data.size() - offset_ < size_of(type))
      fail_at(offset_, std::string("expected ") + what + ", found the end of the file");
    const double value = load_scalar(input_->data.data() + offset_, type, order_);
    offset_ += size_of(type);
    return value;
  }
  void skip(PlyScalar type, std::uint64_t count) {
    if (count > room(type)) fail_at(offset_, "expected a number, found the end of the file");
    offset_ += count * size_of(type);
  }
  [[nodiscard]] std::uint64_t room(PlyScalar type) const { return (input_->data.size() - offset_) / size_of(type); }
  [[nodiscard]] std::uint64_t records(const PlyElement& e) const {
    return (input_->data.size() - offset_) / e.least_size();
  }
  [[nodiscard]] bool has_more() const { return offset_ < input_->data.size(); }
  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[noreturn]] void fail_at(std::size_t offset, const std::string& reason) const {
    input_->fail_at_byte(offset, reason);
  }

 private:
  const Input* input_;
  std::size_t offset_;
  std::endian order_;
};

template <class Numbers>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Numbers numbers) : header_(header), numbers_(numbers) {}

  MeshFile read(const Input& input) {
    bool has_vertices = false;
    for (const PlyElement& element : header_.elements)
      if (element.name == "vertex") {
        if (has_vertices) input.fail("two elements are called 'vertex'");
        has_vertices = true;
        vertex_count_ = element.count;
      }
    for (const PlyElement& element : header_.elements) read_element(element);
    if (numbers_.has_more()) file_.notes.push_back("data behind the last element was ignored");
    faces_.finish(file_, input.name);
    return std::move(file_);
  }

 private:
  void read_element(const PlyElement& element) {
    if (element.count == 0) return;
    if (element.properties.empty()) return;
    const std::uint64_t room = numbers_.records(element);
    if (element.count > room)
      numbers_.fail_at(numbers_.offset(), "the header promises " + std::to_string(element.count) + " elements '" +
                                              element.name + "', but the rest of the file has room for " +
                                              std::to_string(room) + " at most: truncated, or the count is wrong");
    if (element.name == "vertex")
      read_vertices(element);
    else if (element.name == "face")
      read_lists(element, [&] { faces_.add(list_); });
    else if (element.name == "tristrips")
      read_lists(element, [&] { add_strip(); });
    else
      for (std::uint64_t i = 0; i < element.count; ++i)
        for (const PlyProperty& p : element.properties) skip(p);
  }

  void read_vertices(const PlyElement& element) {
    // Which coordinate every property is, 3 for none.
    std::vector<std::size_t> axis(element.properties.size(), 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto place = element.find(std::string(1, "xyz"[k]));
      if (!place || element.properties[*place].list_count)
        numbers_.fail_at(0, "expected a property " + std::string(1, "xyz"[k]) + " of the element 'vertex'");
      axis[*place] = k;
    }
    file_.mesh.vertices.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      Vertex p{};
      for (std::size_t k = 0; k < axis.size(); ++k) {
        if (axis[k] == 3)
          skip(element.properties[k]);
        else
          p[axis[k]] = coordinate(element.properties[k].type);
      }
      file_.mesh.vertices.push_back(p);
    }
  }

  double coordinate(PlyScalar type) {
    const std::size_t place = numbers_.offset();
    const double x = numbers_.next(type, "a number for a coordinate");
    if (!std::isfinite(x))
      numbers_.fail_at(place, "expected a finite coordinate of vertex " + std::to_string(file_.mesh.vertices.size()));
    return x;
  }

  /// Reads the list of vertices of every record into list_ and calls `use`.
  template <class Use>
  void read_lists(const PlyElement& element, const Use& use) {
    auto wanted = element.find("vertex_indices");
    if (!wanted) wanted = element.find("vertex_index");
    if (!wanted || !element.properties[*wanted].list_count)
      numbers_.fail_at(0, "expected a list 'vertex_indices' of the element '" + element.name + "'");
    const bool strips = element.name == "tristrips";
    if (!strips) faces_.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (std::size_t k = 0; k < element.properties.size(); ++k)
        if (k == *wanted)
          read_list(element.properties[k], strips);
        else
          skip(element.properties[k]);
      use();
    }
  }

  void read_list(const PlyProperty& property, bool strips) {
    const std::uint64_t count = list_size(property);
    list_.clear();
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::size_t place = numbers_.offset();
      const double value = numbers_.next(property.type, "a vertex index");
      if (strips && value == -1)
        list_.push_back(restart);
      else if (!(value >= 0 && value < static_cast<double>(vertex_count_)) || value != std::floor(value))
        numbers_.fail_at(place, "vertex index " + shown(value) + " is out of range: the file has " +
                                    std::to_string(vertex_count_) + " vertices, counted from 0");
      else
        list_.push_back(static_cast<std::uint32_t>(value));
    }
  }

  std::uint64_t list_size(const PlyProperty& property) {
    const std::size_t place = numbers_.offset();
    const double count = numbers_.next(*property.list_count, "the length of a list");
    const std::uint64_t room = numbers_.room(property.type);
    if (!(count >= 0 && count <= static_cast<double>(room)) || count != std::floor(count))
      numbers_.fail_at(place, "the length of a list is " + shown(count) + ", but the rest of the file has room for " +
                                  std::to_string(room) + " at most");
    return static_cast<std::uint64_t>(count);
  }

  void skip(const PlyProperty& property) {
    numbers_.skip(property.type, property.list_count ? list_size(property) : 1);
  }

  /// Every vertex makes a triangle with the two before it, whose order alternates; -1 starts a new strip.
  void add_strip() {
    std::size_t start = 0;
    for (std::size_t i = 0; i < list_.size(); ++i) {
      if (list_[i] == restart) start = i + 1;
      if (i < start + 2) continue;
      const bool odd = (i - start) % 2 != 0;
      const Triangle t{list_[i - 2 + odd], list_[i - 1 - odd], list_[i]};
      // Strips repeat vertices on purpose, to turn.
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) faces_.add(t);
    }
  }

  static std::string shown(double value) {
    return value == std::floor(value) && std::abs(value) < 1e15 ? std::to_string(static_cast<std::int64_t>(value))
                                                                : std::to_string(value);
  }

  static constexpr std::uint32_t restart = 0xffff'ffff;

  const PlyHeader& header_;
  Numbers numbers_;
  MeshFile file_;
  FaceList faces_;
  std::uint64_t vertex_count_ = 0;
  std::vector<std::uint32_t> list_;
};

}  // namespace

MeshFile read_ply(const Input& input) {
  const PlyHeader header = read_ply_header(input);
  if (header.order) return PlyReader(header, BinaryNumbers(input, header.data, *header.order)).read(input);
  return PlyReader(header, TextNumbers(input, header.data)).read(input);
}

}  // namespace strata::io
