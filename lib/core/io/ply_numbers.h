#pragma once
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/io/face_list.h"
#include "core/io/input.h"
#include "core/io/number_in.h"
#include "core/io/ply_plan.h"
#include "core/io/ply_store.h"
#include "core/io/text_cursor.h"

namespace strata::io {

/// The numbers of an ASCII file. Skipped values need not be numbers.
class TextNumbers {
 public:
  /// `one_per_line`: a record is malformed if something follows on its line.
  TextNumbers(const Input& input, Piece piece, bool one_per_line)
      : text_(input.data, {}, piece), one_per_line_(one_per_line) {}

  double next(PlyScalar type, const char* what) {
    seek(what);
    return is_integer(type) ? text_.whole_number(what) : text_.number(what);
  }
  /// A number of a channel, which may be infinite or NaN. Nothing where the word is no number of the type.
  template <class T>
  std::optional<T> value(PlyScalar type) {
    seek("a number");
    if constexpr (std::is_floating_point_v<T>)
      if (!is_integer(type)) return number_in<T>(text_.word());
    const auto number = number_in<double>(text_.word());
    return number && has_number(type, *number) ? std::optional(static_cast<T>(*number)) : std::nullopt;
  }
  void skip(PlyScalar, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      seek("a number");
      text_.word();
    }
  }
  void end_record() {
    if (!one_per_line_) return;
    if (!text_.at_line_end()) text_.fail_expected("the end of the line");
    text_.skip_line();
  }
  /// The largest number of values in the rest: a digit and a blank each.
  [[nodiscard]] std::uint64_t room(PlyScalar) const { return (text_.remaining() + 1) / 2; }
  [[nodiscard]] std::uint64_t records(const PlyElement& e) const {
    return (text_.remaining() + 1) / (2 * e.properties.size());
  }
  [[nodiscard]] bool has_more() { return text_.next_word_anywhere(); }
  /// Offset of the next number.
  [[nodiscard]] std::size_t offset() {
    (void)text_.next_word_anywhere();
    return text_.offset();
  }
  [[noreturn]] static void fail_at(std::size_t offset, std::string reason) { fail_at_line(offset, std::move(reason)); }

 private:
  void seek(const char* what) {
    if (!text_.next_word_anywhere()) text_.fail_expected(what);
  }

  TextCursor text_;
  bool one_per_line_;
};

/// The numbers of a binary file.
class BinaryNumbers {
 public:
  BinaryNumbers(std::string_view data, std::size_t offset, std::endian order)
      : data_(data), offset_(offset), order_(order) {}

  double next(PlyScalar type, const char* what) {
    if (remaining() < size_of(type)) fail_at(offset_, std::string("expected ") + what + ", found the end of the file");
    const double value = load_scalar(data_.data() + offset_, type, order_);
    offset_ += size_of(type);
    return value;
  }
  template <class T>
  std::optional<T> value(PlyScalar type) {
    return static_cast<T>(next(type, "a number"));
  }
  void skip(PlyScalar type, std::uint64_t count) {
    if (count > room(type)) fail_at(offset_, "expected a number, found the end of the file");
    offset_ += count * size_of(type);
  }
  void end_record() {}
  [[nodiscard]] std::uint64_t room(PlyScalar type) const { return remaining() / size_of(type); }
  [[nodiscard]] std::uint64_t records(const PlyElement& e) const { return remaining() / e.least_size(); }
  [[nodiscard]] bool has_more() const { return remaining() > 0; }
  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[noreturn]] static void fail_at(std::size_t offset, std::string reason) { fail_at_byte(offset, std::move(reason)); }

  /// Reads the records of vertices `first` and so on, property by property. Returns false and reads nothing if that is
  /// impossible: lists, too little data, coordinates that are not finite.
  bool take_points(const PlyElementPlan& plan, PlyStore& store, std::uint64_t first, std::uint64_t count);
  /// Reads records, at most `count`, while they are usual lists of three vertices in range. Returns how many.
  std::uint64_t take_triangles(const PlyElementPlan& plan, std::uint64_t vertex_count, std::uint64_t count,
                               FaceList& faces);

 private:
  [[nodiscard]] std::size_t remaining() const { return data_.size() - offset_; }

  std::string_view data_;
  std::size_t offset_;
  std::endian order_;
};

}  // namespace strata::io
