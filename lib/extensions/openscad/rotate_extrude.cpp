#include "extensions/openscad/rotate_extrude.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/mesh/circle.h"
#include "extensions/openscad/cap.h"
#include "extensions/openscad/primitives.h"
#include "extensions/openscad/rational_mesh.h"

namespace strata::openscad {
namespace {

class Turner {
 public:
  Turner(const planar::Region& region, const RotateExtrusion& extrusion)
      : cap_(cap_of(region)), extrusion_(extrusion), is_full_(extrusion.angle == 360) {
    double least = 0, largest = 0;
    for (const auto& [x, y] : cap_.nearest) {
      least = std::min(least, x);
      largest = std::max(largest, x);
    }
    is_turned_round_ = (least < 0) != (extrusion.angle < 0);
    const double circle = sides_of_circle(largest - least, extrusion.resolution);
    steps_ = static_cast<std::uint32_t>(std::max(circle * std::abs(extrusion.angle) / 360, 1.0));
    if (cap_.exact.size() > most_corners / (steps_ + std::size_t{1}))
      throw std::length_error("a rotation of more than ten million corners");
  }

  Mesh turn() {
    for (std::uint32_t v = 0; v < cap_.nearest.size(); ++v)
      on_axis_.push_back(cap_.nearest[v][0] == 0 ? mesh_.add(Vertex{0, 0, cap_.nearest[v][1]}) : none);
    const std::vector<std::uint32_t> first = profile(0);
    std::vector<std::uint32_t> last = first;
    for (std::uint32_t j = 1; j <= steps_; ++j) {
      const std::vector<std::uint32_t> next = is_full_ && j == steps_ ? first : profile(j);
      for (const auto& loop : cap_.loops) wall(loop, last, next);
      last = next;
    }
    if (!is_full_) {
      for (const auto& [a, b, c] : triangles_of(cap_)) {
        triangle(first[a], first[b], first[c]);
        triangle(last[a], last[c], last[b]);
      }
    }
    return mesh_.take().mesh;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<std::uint32_t> profile(std::uint32_t j) {
    double turn = std::fmod(extrusion_.start + extrusion_.angle * j / steps_, 360);
    const CosineSine d = cosine_sine(turn < 0 ? turn + 360 : turn);
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t v = 0; v < cap_.nearest.size(); ++v) {
      const auto& [x, y] = cap_.nearest[v];
      numbers.push_back(on_axis_[v] != none ? on_axis_[v] : mesh_.add(Vertex{x * d.cosine, x * d.sine, y}));
    }
    return numbers;
  }
  void wall(const std::vector<std::uint32_t>& loop, const std::vector<std::uint32_t>& before,
            const std::vector<std::uint32_t>& after) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t p = loop[i], q = loop[(i + 1) % loop.size()];
      triangle(before[p], after[q], before[q]);
      triangle(before[p], after[p], after[q]);
    }
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (is_turned_round_) std::swap(b, c);
    mesh_.triangle(a, b, c);
  }

  Cap cap_;
  const RotateExtrusion& extrusion_;
  bool is_full_, is_turned_round_ = false;
  std::uint32_t steps_ = 1;
  VertexCollector mesh_;
  std::vector<std::uint32_t> on_axis_;  ///< the one vertex of a point on the axis
};

}  // namespace

bool crosses_axis(const planar::Region& region) {
  bool is_left = false, is_right = false;
  for (const std::uint32_t v : region.loops.vertices) {
    const int side = position(region, v)[0].sign();
    is_left = is_left || side < 0;
    is_right = is_right || side > 0;
  }
  return is_left && is_right;
}

Solid rotate_extrude(const planar::Region& region, const RotateExtrusion& extrusion, const Options& options) {
  Options checked = options;
  checked.input = InputClass::automatic;
  return Solid(Turner(region, extrusion).turn(), checked);
}

}  // namespace strata::openscad
