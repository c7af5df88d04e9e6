#include "verify/fuzz/question.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "common/write_case.h"
#include "strata/solid.h"
#include "support/random_recipe.h"
#include "support/shapes.h"
#include "support/touching.h"
#include "support/transform.h"

namespace fuzz {
namespace {

using strata::ExactMesh;
using strata::Mesh;
using strata::Vertex;
using strata::test::Random;
using strata::test::Recipe;

/// The rounds of a seed are far from one another, and from those of the next seed.
std::uint64_t mixed(const Round& round) {
  Random first(round.seed);
  Random second(first.next() ^ round.number);
  return second.next();
}

std::pair<std::vector<ExactMesh>, std::string> exact(const strata::test::Operands& operands) {
  std::vector<ExactMesh> solids;
  for (const Mesh& mesh : operands.meshes) solids.push_back({mesh, {}});
  return {std::move(solids), operands.kind};
}

/// One value of a coordinate becomes its neighbour, in all vertices that have it: planes stay planes, and a contact
/// becomes a gap or an overlap of one ulp.
void step_aside(Random& random, Mesh& mesh) {
  const std::size_t axis = random.below(3);
  const double value = random.pick(mesh.vertices)[axis];
  const double infinity = std::numeric_limits<double>::infinity();
  const double neighbour = std::nextafter(value, random.once_in(2) ? infinity : -infinity);
  // Next to 0 there are no numbers but those that are next to nothing: a gap as wide as elsewhere is hard enough.
  double largest = 0;
  for (const Vertex& v : mesh.vertices) largest = std::max(largest, std::abs(v[axis]));
  const double other = value == 0 ? std::copysign(largest * 0x1p-53, neighbour) : neighbour;
  for (Vertex& v : mesh.vertices)
    if (v[axis] == value) v[axis] = other;
}

/// A single vertex becomes its neighbour: planes that were common are nearly common.
void nudge(Random& random, Mesh& mesh) {
  double& x = mesh.vertices[random.below(mesh.vertices.size())][random.below(3)];
  if (x != 0) x = std::nextafter(x, random.once_in(2) ? 2 * x : 0);
}

/// All solids by one linear map in doubles, each coordinate rounded: what was coplanar is so but for the last digits,
/// as in meshes that a modeller has turned. The map is near enough to a rotation that solids stay solids, nearly
/// always.
void turn_roughly(Random& random, Question& q) {
  std::array<std::array<double, 3>, 3> map{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) map[i][k] = (i == k ? 2 : 0) + random.unit() - 0.5;
  for (ExactMesh& solid : q.recipe.solids)
    for (Vertex& v : solid.mesh.vertices) {
      const Vertex old = v;
      for (std::size_t i = 0; i < 3; ++i) v[i] = map[i][0] * old[0] + map[i][1] * old[1] + map[i][2] * old[2];
    }
  q.kind += ", turned roughly";
}

void disturb(Random& random, Question& q) {
  for (ExactMesh& solid : q.recipe.solids) {
    if (!solid.exact.empty() || !random.once_in(2)) continue;
    if (random.once_in(3)) {
      nudge(random, solid.mesh);
    } else {
      step_aside(random, solid.mesh);
    }
  }
  q.kind += ", neighbours";
}

/// Some solids list the edges and vertices in which they touch themselves for each part.
void list_apart(Random& random, Question& q) {
  for (ExactMesh& solid : q.recipe.solids)
    if (random.once_in(2)) solid = strata::Solid::trusted(std::move(solid)).separated().exact_mesh();
  q.kind += ", listed apart";
}

/// Solids of unit cells: many parts, holes, and edges and vertices where they only touch; whole or half cells apart.
strata::test::Operands blocks(Random& random) {
  strata::test::Operands operands{"blocks", {}};
  for (std::size_t i = 2 + random.below(2); i > 0; --i) {
    strata::test::CellGrid grid(random.between(1, 4), random.between(1, 3), random.between(1, 3), false);
    for (std::size_t n = 0; n < grid.filled.size(); ++n) grid.filled[n] = random.once_in(2);
    grid.filled[random.below(grid.filled.size())] = true;
    const double step = random.once_in(3) ? 0.5 : 1;
    const Vertex by{random.between(-1, 1) * step, random.between(-1, 1) * step, random.between(-1, 1) * step};
    operands.meshes.push_back(strata::test::translated(strata::test::cell_solid(grid), by));
  }
  strata::test::stretch(random, operands);
  return operands;
}

std::pair<std::vector<ExactMesh>, std::string> solids_of(Random& random) {
  const std::uint64_t seed = random.next();
  switch (random.below(6)) {
    case 0:
    case 1:
      return exact(strata::test::touching_pair(seed));
    case 2:
      return exact(strata::test::touching_operands(seed));
    case 3:
      return exact(blocks(random));
    case 4:
      return exact(strata::test::about_a_line(random));
    default:
      return {strata::test::touching_family(random, 2 + random.below(5)), "family"};
  }
}

/// Two solids in one operation: the plain question, which half of the rounds ask.
Recipe plain(Random& random, std::vector<ExactMesh> solids) {
  using Kind = Recipe::Kind;
  static constexpr std::array kinds{Kind::union_, Kind::intersection, Kind::difference, Kind::symmetric_difference};
  Recipe recipe;
  solids.resize(2);
  recipe.solids = std::move(solids);
  recipe.steps = {{Kind::solid, 0, 0}, {Kind::solid, 1, 0}, {random.pick(kinds), 0, 1}};
  return recipe;
}

}  // namespace

Question question_of(const Round& round) {
  Random random(mixed(round));
  auto [solids, kind] = solids_of(random);
  Question q;
  q.kind = std::move(kind);
  if (random.once_in(2)) {
    q.recipe = plain(random, std::move(solids));
  } else {
    q.recipe =
        strata::test::random_recipe(random, std::move(solids), {.solids = 6, .leaves = 8, .depth = 5, .maps = false});
  }
  if (random.once_in(4)) list_apart(random, q);
  const bool is_doubles =
      std::all_of(q.recipe.solids.begin(), q.recipe.solids.end(), [](const ExactMesh& s) { return s.exact.empty(); });
  if (is_doubles && random.once_in(4)) turn_roughly(random, q);
  if (random.once_in(4)) disturb(random, q);
  return q;
}

std::size_t face_count(const Question& question) {
  std::size_t count = 0;
  for (const std::string& name : verify::steps_of(text(question.recipe)).names)
    count += question.recipe.solids[std::stoul(name.substr(1))].mesh.triangles.size();
  return count;
}

void write_case(const std::filesystem::path& folder, const Question& question, const std::string& why,
                const std::vector<std::string>& tags) {
  std::filesystem::create_directories(folder);
  verify::NewCase c{why, text(question.recipe), tags, {}};
  for (const std::string& name : verify::steps_of(c.expression).names)
    c.operands.emplace_back(name, &question.recipe.solids[std::stoul(name.substr(1))]);
  verify::write_case(folder, c);
}

}  // namespace fuzz
