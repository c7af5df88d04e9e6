#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/io/tally.h"
#include "strata/io.h"

namespace strata::io {

/// What the letters before OFF say that stands behind the coordinates of vertices, in this order.
struct OffLetters {
  bool normals = false;    ///< N: 3 numbers
  bool colors = false;     ///< C: 3 or 4 numbers
  bool texcoords = false;  ///< ST: 2 numbers

  [[nodiscard]] bool any() const { return normals || colors || texcoords; }
};

/// Colours of vertices or faces, in order.
class OffColors {
 public:
  /// Returns false, and adds nothing, if the words are not 3 or 4 numbers.
  bool add(std::uint64_t element, std::span<const std::string_view> words);
  void add(const OffColors& later);

  [[nodiscard]] bool empty() const { return colors_.empty(); }
  /// The channel "color": bytes if all numbers are integers from 0 to 255, else floats. Elements without a colour are
  /// white and opaque.
  [[nodiscard]] Channel channel(Element element, std::uint64_t count) const;

 private:
  struct Color {
    std::uint64_t element;
    std::array<float, 4> numbers;
    std::size_t count;
  };
  template <class T>
  [[nodiscard]] std::vector<T> values(std::uint64_t count, T opaque) const;

  std::vector<Color> colors_;
  bool are_bytes_ = true;
  std::size_t components_ = 3;
};

/// What stands behind coordinates and corners in an OFF file, or in a piece of it.
class OffExtras {
 public:
  explicit OffExtras(OffLetters letters) : letters_(letters) {}

  /// Words behind the coordinates of the next vertex of the piece, which has this number in the file.
  void add_vertex(std::uint64_t number, std::span<const std::string_view> words);
  void add_face(std::uint64_t number, std::span<const std::string_view> words);
  void add(const OffExtras& later);

  /// Gives the channels to the file, which has its mesh, and notes what is left out.
  void move_to(MeshFile& file, std::uint64_t face_count) &&;

 private:
  bool add_values(std::uint64_t number, std::span<const std::string_view> words);

  OffLetters letters_;
  std::vector<double> normals_, texcoords_;  ///< of the vertices so far
  bool has_values_ = false;                  ///< one of them has some
  OffColors of_vertices_, of_faces_;
  Tally other_vertices_, indexed_faces_, other_faces_;
};

}  // namespace strata::io
