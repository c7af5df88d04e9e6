#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/kernel/input_complex.h"
#include "extensions/scene/scene_data.h"
#include "extensions/scene/sight.h"
#include "strata/query.h"

namespace strata {

/// a x + b y + c z = d, in rationals.
struct RationalPlane {
  std::array<Rational, 3> normal;
  Rational offset;
};

/// The triangles that are ordered: the faces of a scene, with their numbers there, and after them the parts into which
/// faces were cut. The parts of a piece replace it. Cuts are exact: new corners are rational points.
class Pieces {
 public:
  explicit Pieces(const Scene& scene) : scene_(scene), input_(input_complex_of(scene)) {}
  Pieces(const Pieces&) = delete;
  Pieces& operator=(const Pieces&) = delete;

  [[nodiscard]] std::uint32_t face_count() const { return input_complex_of(scene_).face_count(); }
  [[nodiscard]] std::uint32_t count() const { return face_count() + static_cast<std::uint32_t>(parts_.size()); }
  [[nodiscard]] Corners corners(std::uint32_t p) const {
    return p < face_count() ? input_.face(p) : parts_[p - face_count()].corners;
  }
  /// The face that a piece comes from.
  [[nodiscard]] std::uint32_t face_of(std::uint32_t p) const {
    return p < face_count() ? p : parts_[p - face_count()].face;
  }
  [[nodiscard]] bool is_replaced(std::uint32_t p) const { return !replaced_.empty() && replaced_[p]; }
  [[nodiscard]] std::uint32_t cuts() const { return cuts_; }

  /// The scene's vertices and faces, and the corners constructed by cuts as vertices of one more operand.
  [[nodiscard]] const InputComplex& input() const { return input_; }

  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;
  [[nodiscard]] RationalPlane plane_of(std::uint32_t piece) const;
  /// The plane through the origin and two vertices.
  [[nodiscard]] RationalPlane plane_of_sight(const Origin& origin, std::uint32_t a, std::uint32_t b) const;

  /// Replaces a piece by two or three parts along a plane. Returns false and changes nothing if the piece lies on one
  /// side. The parts get the next numbers.
  bool cut(std::uint32_t p, const RationalPlane& plane);
  /// A state to which `undo` returns.
  struct Mark {
    std::size_t parts, points, exact;
  };
  [[nodiscard]] Mark mark() const { return {parts_.size(), points_.size(), exact_.size()}; }
  /// Undoes the last cut, which was one of p.
  void undo(std::uint32_t p, const Mark& before);

 private:
  struct Part {
    Corners corners;
    std::uint32_t face;
  };
  std::uint32_t add_point(const RationalPoint& p);
  void renew_input();

  Scene scene_;
  InputComplex input_;
  std::vector<Part> parts_;
  std::vector<InputComplex::Coordinates> points_;  ///< made by cuts, rounded
  std::vector<ExactVertex> exact_;
  std::vector<bool> replaced_;
  std::uint32_t cuts_ = 0;
};

}  // namespace strata
