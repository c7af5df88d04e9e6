#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/containers/ray_slabs.h"
#include "core/exact/double_double.h"
#include "core/kernel/input_complex.h"
#include "core/kernel/predicates.h"
#include "strata/query.h"

namespace strata {

/// A parameter at which a line meets a face, or where a stretch within a face begins or ends.
struct FaceHit {
  std::uint32_t face = 0;
  Bounded t;  ///< an interval that contains the parameter; nothing is certain where it is infinite or NaN
  std::optional<Rational> exact;  ///< the parameter, once it has been computed
  /// The change of the winding number about the face's solid, along the line translated by (e, e^2, e^3).
  std::int8_t change = 0;
  std::int8_t stretch = 0;  ///< 1: a stretch within the face begins, -1: ends, 0: neither
  bool is_inside = false;   ///< the line crosses the interior of the face
};

/// A ray or a segment, and its intersections with closed faces. Exact: rays.md has the theory of the filter, of the
/// perturbed line and of stretches. Stores a reference to the input complex.
class RayLine {
 public:
  RayLine(const InputComplex& input, const Ray& ray);
  RayLine(const InputComplex& input, const Segment& segment);

  /// For a tree whose boxes are in `all`.
  [[nodiscard]] RaySlabs slabs(const Box& all) const { return {from_, direction_, all}; }
  /// The greatest parameter: infinite for a ray, 1 for a segment.
  [[nodiscard]] double end() const { return end_; }

  /// Calls `take(FaceHit&&)` for all hits of a face at parameters of [0, end]: none, one, or two for a stretch. For a
  /// stretch that begins before 0 and ends after it, the point at 0 is a hit that neither begins nor ends.
  template <class Take>
  void meet(std::uint32_t face, const Take& take) const {
    const Look look = look_at(input_.face(face));
    if (look.orientation == Turn::apart) return;
    FaceHit hit;
    if (look.orientation != Turn::open && settle(look, face, hit)) {
      if (hit.t.lower() <= end_ && hit.t.upper() >= 0) take(std::move(hit));
      return;
    }
    for (std::optional<FaceHit>& h : meet_exactly(face))
      if (h) take(std::move(*h));
  }

  /// Computes the exact parameter of a hit, if it is not known.
  const Rational& exact(FaceHit& hit) const;
  [[nodiscard]] RationalPoint place_at(const Rational& t) const;
  /// The nearest doubles to the parameter and the position of a hit.
  [[nodiscard]] std::pair<double, Vertex> rounded(FaceHit& hit) const;

 private:
  /// The decision of doubles about the line and the interior of a triangle: it passes by; or it crosses, and the
  /// triangle is seen from the start of the line counter-clockwise (leaves) or clockwise (enters); or doubles do not
  /// decide.
  enum class Turn : std::uint8_t { apart, leaves, enters, open };
  struct Look {
    Turn orientation = Turn::open;
    std::array<double, 3> weight{}, depth{};
    double weight_error = 0, depth_error = 0;
  };

  void find_shear();
  [[nodiscard]] Look look_at(const InputComplex::Indices& corners) const;
  /// Decides whether a hit's parameter is in [0, end]. False if this is not certain.
  [[nodiscard]] bool settle(const Look& look, std::uint32_t face, FaceHit& hit) const;

  using Hits = std::array<std::optional<FaceHit>, 2>;
  [[nodiscard]] Hits meet_exactly(std::uint32_t face) const;
  [[nodiscard]] Hits meet_within(std::uint32_t face) const;
  [[nodiscard]] Hits at(std::uint32_t face, const Rational& t, std::int8_t change, bool is_inside) const;
  [[nodiscard]] Sign orientation(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] Sign moved_turn(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] Rational crossing_parameter(std::uint32_t face) const;
  [[nodiscard]] RationalPoint position(std::uint32_t vertex) const;
  [[nodiscard]] RationalPoint rational_direction() const;

  const InputComplex& input_;
  Vertex from_;
  Vertex to_{};         ///< of a segment
  Vertex direction_{};  ///< of a segment: to - from, rounded
  bool is_segment_ = false;
  double end_ = HUGE_VAL;

  /// The axis in which the direction is longest, the two others in cyclic order, and their slopes.
  std::array<std::size_t, 3> axis_{};
  std::array<double, 2> slope_{};
  double vertex_error_ = 0;  ///< of the scene's vertices, relative
};

}  // namespace strata
