#include "support/random_recipe.h"

#include <algorithm>
#include <array>

#include "support/shapes.h"
#include "support/touching.h"

namespace strata::test {
namespace {

using Kind = Recipe::Kind;

Mesh lattice_prism(Random& random) {
  static constexpr std::array<std::array<double, 2>, 3> triangle{{{0, 0}, {2, 0}, {0, 2}}};
  static constexpr std::array<std::array<double, 2>, 6> hexagon{{{1, 0}, {2, 0}, {3, 1}, {2, 2}, {1, 2}, {0, 1}}};
  const double bottom = random.between(0, 2), top = bottom + random.between(1, 2);
  return turned(random.once_in(2) ? prism(triangle, bottom, top) : prism(hexagon, bottom, top), random.between(0, 47));
}

Mesh lattice_tetrahedron(Random& random) {
  Mesh mesh;
  while (mesh.triangles.empty()) {
    std::array<Vertex, 4> p;
    for (Vertex& v : p)
      for (double& x : v) x = random.between(0, 3);
    mesh = tetrahedron(p[0], p[1], p[2], p[3]);
  }
  return mesh;
}

Mesh lattice_octahedron(Random& random) {
  const Vertex centre{double(random.between(0, 4)), double(random.between(0, 4)), double(random.between(0, 4))};
  return octahedron(centre, random.between(1, 2));
}

Mesh lattice_box(Random& random) {
  Vertex lower{}, upper{};
  for (std::size_t k = 0; k < 3; ++k) {
    lower[k] = random.between(0, 3);
    upper[k] = lower[k] + random.between(1, 2);
  }
  return box(lower, upper);
}

Mesh family_member(Random& random) {
  switch (random.below(8)) {
    case 0:
    case 1:
    case 2:
      return lattice_box(random);
    case 3:
      return lattice_tetrahedron(random);
    case 4:
      return lattice_octahedron(random);
    case 5:
      return lattice_prism(random);
    default:
      return lattice_solid(random);
  }
}

/// The solid with one of its vertices at the point (2, 2, 2).
Mesh through_one_point(Random& random, const Mesh& mesh) {
  const Vertex v = random.pick(mesh.vertices);
  return translated(mesh, {2 - v[0], 2 - v[1], 2 - v[2]});
}

ExactMesh copy_of(Random& random, const ExactMesh& mesh) {
  if (random.once_in(4)) return mapped(mesh, map_by_thirds(random));
  if (mesh.exact.empty() && random.once_in(3)) return exact(turned(mesh.mesh, random.between(0, 47)));
  if (mesh.exact.empty() && random.once_in(2)) return exact(relisted(mesh.mesh));
  return mesh;
}

/// Writes steps so that every one is above those it needs.
class Grower {
 public:
  Grower(Random& random, std::vector<ExactMesh> solids, const RecipeSize& size) : random_(random), size_(size) {
    recipe_.solids = std::move(solids);
  }

  [[nodiscard]] Recipe grow() {
    const auto leaves = size_.leaves / 2 + random_.below(size_.leaves - size_.leaves / 2) + 1;
    const std::uint32_t root = grow(leaves, size_.depth - 1);
    recipe_.steps.resize(root + 1);
    if (!is_bounded(recipe_)) add({Kind::complement, root, 0});
    return std::move(recipe_);
  }

 private:
  /// Solids and steps below, for subexpressions that are used again.
  struct Extent {
    std::size_t leaves, depth;
  };

  std::uint32_t add(Recipe::Step step) {
    const auto extent = [&](std::uint32_t n) { return extents_[n]; };
    Extent e{1, 0};
    if (step.kind != Kind::solid) {
      e = {extent(step.first).leaves, extent(step.first).depth + 1};
      if (joins_two(step.kind))
        e = {e.leaves + extent(step.second).leaves, std::max(e.depth, extent(step.second).depth + 1)};
    }
    extents_.push_back(e);
    recipe_.steps.push_back(step);
    return static_cast<std::uint32_t>(recipe_.steps.size() - 1);
  }

  std::uint32_t grow(std::size_t leaves, std::size_t depth) {
    if (leaves <= 1 || depth == 0)
      return add({Kind::solid, static_cast<std::uint32_t>(random_.below(recipe_.solids.size())), 0});
    if (!recipe_.steps.empty() && random_.once_in(8)) {
      const auto known = static_cast<std::uint32_t>(random_.below(recipe_.steps.size()));
      if (extents_[known].leaves <= leaves && extents_[known].depth <= depth) return known;
    }
    if (random_.once_in(8)) return add({Kind::complement, grow(leaves, depth - 1), 0});
    if (size_.maps && random_.once_in(12)) {
      recipe_.maps.push_back(map_by_thirds(random_));
      const auto map = static_cast<std::uint32_t>(recipe_.maps.size() - 1);
      return add({Kind::map, grow(leaves, depth - 1), map});
    }
    return grow_joint(leaves, depth);
  }

  std::uint32_t grow_joint(std::size_t leaves, std::size_t depth) {
    // Chains are as good as bushes; intersections are seldom, or nothing would be left.
    static constexpr std::array kinds{Kind::union_,
                                      Kind::union_,
                                      Kind::union_,
                                      Kind::intersection,
                                      Kind::difference,
                                      Kind::difference,
                                      Kind::symmetric_difference,
                                      Kind::symmetric_difference};
    const std::size_t part = random_.once_in(2) ? 1 + random_.below(2) : 1 + random_.below(leaves);
    const std::size_t small = std::min(part, leaves - 1);
    std::uint32_t first = grow(leaves - small, depth - 1);
    std::uint32_t second = grow(small, depth - 1);
    if (random_.once_in(2)) std::swap(first, second);
    return add({random_.pick(kinds), first, second});
  }

  Random& random_;
  const RecipeSize size_;
  Recipe recipe_;
  std::vector<Extent> extents_;
};

}  // namespace

Affine map_by_thirds(Random& random) {
  Affine map{};
  const bool even = random.once_in(2);
  const auto factor = [&] {
    static constexpr std::array thirds{1, 2, 3, 3, 3, 4, 6, -1, -3};
    return Rational(random.pick(thirds), 3);
  };
  const Rational all = factor();
  for (std::size_t k = 0; k < 3; ++k) {
    map.columns[k][k] = even ? all : factor();
    map.columns[3][k] = Rational(random.between(-4, 6), 3);
  }
  if (random.once_in(4)) map.columns[random.below(2)][2] = Rational(random.between(-2, 2), 3);
  return map;
}

std::vector<ExactMesh> touching_family(Random& random, std::size_t count) {
  std::vector<ExactMesh> solids;
  const bool one_point = random.once_in(3);
  while (solids.size() < count) {
    if (!solids.empty() && random.once_in(4)) {
      const std::size_t of = random.below(solids.size());
      solids.push_back(copy_of(random, solids[of]));
      continue;
    }
    const Mesh mesh = family_member(random);
    ExactMesh solid = exact(one_point ? through_one_point(random, mesh) : mesh);
    solids.push_back(random.once_in(6) ? mapped(solid, map_by_thirds(random)) : std::move(solid));
  }
  return solids;
}

Recipe random_recipe(Random& random, std::vector<ExactMesh> solids, const RecipeSize& size) {
  return Grower(random, std::move(solids), size).grow();
}

Recipe touching_recipe(std::uint64_t seed, const RecipeSize& size) {
  Random random(seed);
  auto solids = touching_family(random, 2 + random.below(size.solids - 1));
  return random_recipe(random, std::move(solids), size);
}

}  // namespace strata::test
