#include <algorithm>
#include <catch2/catch.hpp>

#include "core/kernel/input_complex.h"
#include "extensions/scene/layer_decomposition_data.h"
#include "extensions/scene/pieces.h"
#include "extensions/scene/scene_data.h"
#include "extensions/scene/signed_covering.h"
#include "scene/rational_rays.h"
#include "scene/scenes.h"
#include "strata/query.h"

using namespace strata;

namespace {

/// Every face of a scene in rationals, and what a ray meets.
class PlainView {
 public:
  PlainView(const Scene& scene, const Origin& origin) : origin_(origin) {
    for (std::uint32_t s = 0; s < scene.solid_count(); ++s)
      for (auto& t : test::triangles_of(scene.solid(s))) triangles_.push_back(std::move(t));
  }
  const test::RationalTriangle& triangle(std::uint32_t f) const { return triangles_[f]; }

  enum class Seen { yes, no, unclear };
  /// Is a point of a face seen?
  Seen is_seen(const RationalPoint& p, std::uint32_t face) const {
    const bool far = !origin_.is_point();
    const RationalPoint o = test::rational(origin_.at);
    const test::RationalVector d = far ? o : test::minus(p, o);
    for (std::uint32_t f = 0; f < triangles_.size(); ++f) {
      if (f == face) continue;
      test::RationalHit hit;
      const auto m = test::meet(triangles_[f], p, d, hit);
      if (m == test::RayMeets::rim_or_plane) return Seen::unclear;
      if (m == test::RayMeets::inside && hit.t < 0 && (far || hit.t > -1)) return Seen::no;
    }
    return Seen::yes;
  }

 private:
  const Origin origin_;
  std::vector<test::RationalTriangle> triangles_;
};

RationalPoint between(const RationalPoint& a, const RationalPoint& b, const Rational& t) {
  RationalPoint p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = a[i] + t * (b[i] - a[i]);
  return p;
}

bool holds(const ExactPolygon& polygon, const test::RationalVector& normal, const RationalPoint& p) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& a = polygon[i];
    const auto& b = polygon[(i + 1) % polygon.size()];
    if (test::dot(normal, test::cross(test::minus(b, a), test::minus(p, a))) < 0) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("seen stretches and regions agree with rational rays", "[layers][property]") {
  const auto seed = GENERATE(range(0, 60));
  CAPTURE(seed);
  test::Random random(static_cast<std::uint64_t>(seed) + 11);
  const auto meshes = test::touching_operands(static_cast<std::uint64_t>(seed)).meshes;
  const Origin origin = test::awkward_origin(meshes, random);
  CAPTURE(origin.is_point(), origin.at[0], origin.at[1], origin.at[2]);
  const Scene scene = test::scene_of(meshes);
  const Visibility visibility{LayerDecomposition(scene, origin)};
  const PlainView plain(scene, origin);
  const auto& input = input_complex_of(scene);
  for (int n = 0; n < 40; ++n) {
    const auto face = static_cast<std::uint32_t>(random.below(scene.face_count()));
    if (covering_of(visibility.decomposition()).orientation(face) == Sign::zero) {
      REQUIRE(visibility.seen_region(face).empty());
      continue;
    }
    const auto& t = plain.triangle(face);
    const auto side = static_cast<std::size_t>(random.below(3));
    const auto seen = visibility.seen_along(face, input.face(face)[side], input.face(face)[(side + 1) % 3]);
    const Rational at = Rational(random.between(1, 996), 997);
    const RationalPoint on_edge = between(t[side], t[(side + 1) % 3], at);
    const RationalPoint beside = between(on_edge, t[(side + 2) % 3], Rational(1, 1 << 30));
    const auto is_seen = plain.is_seen(beside, face);
    CAPTURE(face, side, at);
    if (is_seen != PlainView::Seen::unclear) {
      const bool listed =
          std::any_of(seen.begin(), seen.end(), [&](const Stretch& s) { return s.from <= at && at <= s.to; });
      REQUIRE(listed == (is_seen == PlainView::Seen::yes));
    }
    const RationalPoint inside = between(between(t[0], t[1], Rational(random.between(1, 990), 991)), t[2],
                                         Rational(random.between(1, 982), 983));
    const auto inside_seen = plain.is_seen(inside, face);
    if (inside_seen != PlainView::Seen::unclear) {
      const auto region = visibility.seen_region(face);
      const auto normal = test::cross(test::minus(t[1], t[0]), test::minus(t[2], t[0]));
      const auto count =
          std::count_if(region.begin(), region.end(), [&](const ExactPolygon& p) { return holds(p, normal, inside); });
      REQUIRE(count == (inside_seen == PlainView::Seen::yes ? 1 : 0));
    }
  }
}

TEST_CASE("an edge seen end on is not drawn", "[layers][visibility][degenerate]") {
  const Scene scene = test::scene_of({test::box({0, 0, 0}, {1, 1, 1})});
  const Visibility visibility{LayerDecomposition(scene, Origin::point({0, 0, 5}))};
  std::size_t drawn = 0;
  for (const SeenEdge& e : find_seen_edges(visibility, 30)) {
    const auto at = [&](std::uint32_t v) { return input_complex_of(scene).vertex(v); };
    CHECK_FALSE((at(e.a)[0] == 0 && at(e.b)[0] == 0 && at(e.a)[1] == 0 && at(e.b)[1] == 0));
    drawn += e.seen.empty() ? 0 : 1;
  }
  CHECK(drawn == 4);  // the top
}

TEST_CASE("an edge that bends less than the crease angle is drawn where it is an outline only",
          "[layers][visibility]") {
  const Scene scene = test::scene_of({test::box({0, 0, 0}, {1, 1, 1})});
  const Visibility visibility{LayerDecomposition(scene, Origin::point({3, 4, 5}))};
  const auto count = [&](double crease_angle, EdgeKind kind) {
    const std::vector<SeenEdge> edges = find_seen_edges(visibility, crease_angle);
    return std::count_if(edges.begin(), edges.end(), [&](const SeenEdge& e) { return e.kind == kind; });
  };
  CHECK(count(89, EdgeKind::loop) == 6);
  CHECK(count(89, EdgeKind::crease) == 3);
  CHECK(count(91, EdgeKind::loop) == 6);
  CHECK(count(91, EdgeKind::crease) == 0);
}

TEST_CASE("edges that coincide as seen are hidden by what lies on their own side", "[layers][degenerate]") {
  // A cube right behind another of the same size: seen along an axis, nothing of it is seen.
  const Scene scene = test::scene_of({test::box({0, 0, 4}, {1, 1, 5}), test::box({0, 0, 0}, {1, 1, 1})});
  const Visibility visibility{LayerDecomposition(scene, Origin::direction({0, 0, -1}))};
  const std::vector<std::uint32_t> faces = visibility.seen_faces();
  REQUIRE(faces.size() == 2);
  for (const std::uint32_t f : faces) CHECK(scene.solid_of(f) == 0);
  for (std::uint32_t f = 12; f < 24; ++f) {
    const auto v = input_complex_of(scene).face(f);
    for (std::size_t i = 0; i < 3; ++i) CHECK(visibility.seen_along(f, v[i], v[(i + 1) % 3]).empty());
  }
}
