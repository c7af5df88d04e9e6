#include "cases.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "chains.h"
#include "placement.h"
#include "random.h"
#include "solids.h"
#include "spheres.h"
#include "subdivision.h"

namespace bench {
namespace {

using strata::Mesh;
using strata::Operation;
using strata::Vertex;
using Meshes = std::vector<Mesh>;

constexpr Vertex far_offset = {0.5, 0.1, 0.05};

/// In the same direction, 0.01 long.
Vertex near_offset() {
  const double length = std::hypot(far_offset[0], far_offset[1], far_offset[2]);
  Vertex offset = far_offset;
  for (double& x : offset) x *= 0.01 / length;
  return offset;
}

Meshes pair_of_spheres(unsigned levels, const Vertex& offset) {
  const Mesh sphere = icosphere(levels);
  return {sphere, shifted(sphere, offset)};
}

void add_pairs_of_spheres(std::vector<Case>& cases) {
  struct Size {
    unsigned levels;
    const char* name;
    const char* triangles;
    Group group;
    Group near_group;
  };
  const Size sizes[] = {{0, "20", "20", Group::tiny, Group::tiny},
                        {5, "20k", "20,480", Group::pair, Group::pair},
                        {6, "80k", "81,920", Group::pair, Group::pair},
                        {7, "327k", "327,680", Group::pair, Group::pair},
                        {8, "1310k", "1,310,720", Group::largest, Group::pair}};
  for (const auto& [levels, name, triangles, group, near_group] : sizes) {
    const std::string spheres = std::string("two spheres of ") + triangles + " triangles, ";
    cases.push_back({.name = std::string("a") + name,
                     .about = spheres + "offset by (0.5, 0.1, 0.05)",
                     .group = group,
                     .make = [levels = levels](const Corpus&) { return pair_of_spheres(levels, far_offset); }});
    cases.push_back({.name = std::string("near") + name,
                     .about = spheres + "offset by 0.01",
                     .group = near_group,
                     .make = [levels = levels](const Corpus&) { return pair_of_spheres(levels, near_offset()); }});
  }
  cases.push_back({.name = "far327k",
                   .about = "two spheres of 327,680 triangles, far apart",
                   .group = Group::pair,
                   .make = [](const Corpus&) {
                     return pair_of_spheres(7, {10, 2, 1});
                   }});
}

void add_scan(std::vector<Case>& cases, const std::string& name, const std::string& about, const std::string& file,
              unsigned subdivisions) {
  const char* const finer[] = {"", ", Loop-subdivided", ", Loop-subdivided twice", ", Loop-subdivided three times"};
  cases.push_back({.name = name,
                   .about = about + finer[subdivisions] + ", and a rotated copy",
                   .group = Group::pair,
                   .from_corpus = true,
                   .make = [file, subdivisions](const Corpus& corpus) {
                     Mesh mesh = corpus.read(file);
                     for (unsigned i = 0; i < subdivisions; ++i) mesh = loop_subdivided(mesh);
                     Mesh copy = turned_copy(mesh);
                     return Meshes{std::move(mesh), std::move(copy)};
                   }});
}

void add_scans(std::vector<Case>& cases) {
  const char* const armadillo = "csg/irmb/data/armadillo.obj";
  const char* const nefertiti = "meshes/common-3d-test-models/data/nefertiti.obj";
  const char* const rocker_arm = "meshes/common-3d-test-models/data/rocker-arm.obj";
  add_scan(cases, "c_rocker20k", "rocker arm", rocker_arm, 0);
  add_scan(cases, "c_armadillo100k", "armadillo", armadillo, 0);
  add_scan(cases, "c_nefertiti100k", "Nefertiti", nefertiti, 0);
  add_scan(cases, "c_rocker321k", "rocker arm", rocker_arm, 2);
  add_scan(cases, "c_armadillo400k", "armadillo", armadillo, 1);
  add_scan(cases, "c_nefertiti400k", "Nefertiti", nefertiti, 1);
  add_scan(cases, "c_rocker1286k", "rocker arm", rocker_arm, 3);
}

Meshes notch() { return {box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0.5}, {0.5, 0.5, 1})}; }

void add_coinciding(std::vector<Case>& cases) {
  const auto same = [](unsigned levels) {
    return [levels](const Corpus&) { return Meshes{icosphere(levels), icosphere(levels)}; };
  };
  cases.push_back({.name = "d_same20k",
                   .about = "a sphere of 20,480 triangles and itself",
                   .group = Group::dense,
                   .make = same(5)});
  cases.push_back({.name = "d_same80k",
                   .about = "a sphere of 81,920 triangles and itself",
                   .group = Group::dense,
                   .make = same(6)});
  cases.push_back({.name = "d_minus20k",
                   .about = "a sphere of 20,480 triangles minus itself",
                   .group = Group::dense,
                   .operation = Operation::difference,
                   .volume = 0,
                   .make = same(5)});
  cases.push_back({.name = "d_facecubes",
                   .about = "two cubes that share a face",
                   .group = Group::small,
                   .volume = 2,
                   .make = [](const Corpus&) {
                     return Meshes{box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})};
                   }});
  cases.push_back({.name = "d_notch",
                   .about = "a cube minus one in its corner, three faces in common",
                   .group = Group::small,
                   .operation = Operation::difference,
                   .volume = 0.875,
                   .make = [](const Corpus&) { return notch(); }});
  cases.push_back({.name = "d_fineboxes100k",
                   .about = "two boxes of 97,200 and 99,372 triangles that share a face, split differently",
                   .group = Group::dense,
                   .volume = 2,
                   .make = [](const Corpus&) {
                     return Meshes{fine_box({0, 0, 0}, {1, 1, 1}, 90), fine_box({1, 0, 0}, {2, 1, 1}, 91)};
                   }});
}

/// Right through the unit sphere. 92 triangles.
Mesh drill() {
  return rotated(prism({.sides = 24, .radius = 0.05, .bottom = -1.2, .top = 1.2}), rotation({3, -1, 2}, 77));
}

void add_crossings(std::vector<Case>& cases) {
  const auto noisy = [](std::uint64_t seed) { return with_noise(geodesic_sphere(71), 1e-3, seed); };
  cases.push_back({.name = "e_noisy100k",
                   .about = "one sphere of 100,820 triangles twice, with independent noise of 0.001",
                   .group = Group::dense,
                   .make = [noisy](const Corpus&) {
                     return Meshes{noisy(1), noisy(2)};
                   }});
  cases.push_back({.name = "e_rot100k",
                   .about = "the same, the second one rotated",
                   .group = Group::dense,
                   .make = [noisy](const Corpus&) {
                     return Meshes{noisy(1), rotated(noisy(2), rotation({3, -1, 2}, 77))};
                   }});
  cases.push_back({.name = "h_cut1m",
                   .about = "a cube of 12 triangles minus a bumpy sphere of 1,003,520, all crossings in one side",
                   .group = Group::dense,
                   .operation = Operation::difference,
                   .make = [](const Corpus&) {
                     return Meshes{box({-2, -2, -2}, {2, 2, 0.3}), bumpy_sphere(224)};
                   }});
  cases.push_back({.name = "h_drill2m",
                   .about = "a sphere of 1,997,120 triangles minus a drill of 92 right through it",
                   .group = Group::drill,
                   .operation = Operation::difference,
                   .make = [](const Corpus&) {
                     return Meshes{geodesic_sphere(316), drill()};
                   }});
}

/// Apart from each other.
Meshes spheres_of_the_corpus(const Corpus& corpus) {
  Meshes spheres;
  for (int i = 0; i < 500; ++i) spheres.push_back(corpus.read("csg/irmb/data/spheres/" + std::to_string(i) + ".obj"));
  return spheres;
}

/// Of 320 triangles each, in a cube; the more there are, the more overlap.
Meshes overlapping_spheres(int count) {
  Random random(11);
  const Mesh sphere = icosphere(2);
  Meshes spheres;
  for (int i = 0; i < count; ++i) {
    const double radius = random.uniform(0.08, 0.12);
    const Mesh turned = rotated(sphere, random_rotation(random));
    spheres.push_back(shifted(scaled(turned, radius), random.in_box(0, 1)));
  }
  return spheres;
}

constexpr unsigned holes_along = 37;
constexpr unsigned holes_across = 27;
constexpr std::uint32_t hole_sides = 16;
constexpr double hole_radius = 0.3;

/// A plate and 999 drills with room between them, each turned and placed a little differently.
Meshes perforated_plate() {
  Random random(13);
  Meshes meshes = {box({0, 0, 0}, {holes_along, holes_across, 1})};
  for (unsigned i = 0; i < holes_along; ++i)
    for (unsigned j = 0; j < holes_across; ++j) {
      const double angle = random.uniform(0, 1);
      const Mesh drill =
          prism({.sides = hole_sides, .radius = hole_radius, .angle = angle, .bottom = -0.5, .top = 1.5});
      const double x = i + 0.5 + random.uniform(-0.1, 0.1);
      const double y = j + 0.5 + random.uniform(-0.1, 0.1);
      meshes.push_back(shifted(drill, {x, y, random.uniform(-0.1, 0.1)}));
    }
  return meshes;
}

double perforated_volume() {
  const double sector = 2 * std::numbers::pi / hole_sides;
  const double hole = 0.5 * hole_sides * hole_radius * hole_radius * std::sin(sector);
  return holes_along * holes_across * (1 - hole);
}

void add_many(std::vector<Case>& cases) {
  const auto grid = [](const Corpus&) { return cube_grid(10); };
  cases.push_back({.name = "n_grid1000",
                   .about = "10 x 10 x 10 touching cubes, in one call",
                   .group = Group::many,
                   .volume = 1000,
                   .make = grid});
  cases.push_back({.name = "n_grid1000_one_by_one",
                   .about = "the same, one cube after the other",
                   .group = Group::one_by_one,
                   .volume = 1000,
                   .make = grid});
  cases.push_back({.name = "n_spheres500",
                   .about = "500 random spheres of 320 triangles apart from each other, in one call",
                   .group = Group::many,
                   .from_corpus = true,
                   .make = spheres_of_the_corpus});
  cases.push_back({.name = "n_overlap500",
                   .about = "500 random spheres of 320 triangles that overlap, in one call",
                   .group = Group::many,
                   .make = [](const Corpus&) { return overlapping_spheres(500); }});
  cases.push_back({.name = "n_drill1000",
                   .about = "a plate minus 999 drills of 60 triangles, in one call",
                   .group = Group::many,
                   .operation = Operation::difference,
                   .volume = perforated_volume(),
                   .make = [](const Corpus&) { return perforated_plate(); }});
}

void add_chains(std::vector<Case>& cases) {
  const auto add = [&](const char* name, const char* about, auto make) {
    cases.push_back({.name = name,
                     .about = about,
                     .group = Group::chain,
                     .operation = Operation::difference,
                     .make = [make](const Corpus&) { return make(); }});
  };
  add("k_nine", "a sphere minus three tori and six spheres, 9 cuts in one call", nine_cuts);
  add("k_terrain223", "a block minus 223 sweeps with seams in common, in one call", terrain);
  add("k_dome100", "a ball minus 100 capsules on its upper half, in one call", [] { return dome(100); });
  add("k_dome1000", "the same with 1,000 capsules", [] { return dome(1000); });
  const auto add_steps = [&](const char* name, const char* about, auto make) {
    add(name, about, make);
    cases.back().group = Group::one_by_one;
  };
  add_steps("k_nine_steps", "k_nine, one cut after the other", nine_cuts);
  add_steps("k_terrain223_steps", "k_terrain223, one cut after the other", terrain);
  add_steps("k_dome100_steps", "k_dome100, one cut after the other", [] { return dome(100); });
  add_steps("k_dome1000_steps", "k_dome1000, one cut after the other", [] { return dome(1000); });
  const auto add_slow = [&](const char* name, const char* about, std::uint32_t capsules) {
    add(name, about, [capsules] { return dome(capsules); });
    cases.back().group = Group::slow;
  };
  add_slow("k_dome250_steps", "k_dome100_steps with 250 capsules", 250);
  add_slow("k_dome5000_steps", "the same with 5,000 capsules", 5000);
  add_slow("k_dome10000_steps", "the same with 10,000 capsules", 10'000);
}

void add_smoke(std::vector<Case>& cases) {
  const auto add = [&](const char* name, const char* about, auto make) {
    cases.push_back(
        {.name = name, .about = about, .group = Group::smoke, .make = [make](const Corpus&) { return make(); }});
  };
  const auto add_difference = [&](const char* name, const char* about, auto make) {
    add(name, about, make);
    cases.back().operation = Operation::difference;
  };
  add("smoke_tiny", "two icosahedra", [] { return pair_of_spheres(0, far_offset); });
  add("smoke_spheres", "two spheres of 1,280 triangles", [] { return pair_of_spheres(3, far_offset); });
  add("smoke_noisy", "crossings everywhere, 2 x 1,280 triangles", [] {
    return Meshes{with_noise(icosphere(3), 1e-3, 1), with_noise(icosphere(3), 1e-3, 2)};
  });
  add("smoke_grid", "27 touching cubes", [] { return cube_grid(3); });
  add("smoke_same", "a sphere of 1,280 triangles and itself", [] { return Meshes{icosphere(3), icosphere(3)}; });
  add("smoke_boxes", "a face shared by boxes split differently", [] {
    return Meshes{fine_box({0, 0, 0}, {1, 1, 1}, 8), fine_box({1, 0, 0}, {2, 1, 1}, 7)};
  });
  add("smoke_near", "two spheres of 20,480 triangles that nearly coincide",
      [] { return pair_of_spheres(5, near_offset()); });
  add("smoke_large", "two spheres of 20,480 triangles", [] { return pair_of_spheres(5, far_offset); });
  add("smoke_overlap", "60 random spheres of 320 triangles, most of which overlap",
      [] { return overlapping_spheres(60); });
  add_difference("smoke_notch", "a cube minus one in its corner, three faces in common", notch);
  add_difference("smoke_drill", "a sphere of 20,480 triangles minus a drill of 92 right through it", [] {
    return Meshes{icosphere(5), drill()};
  });
  add_difference("smoke_cuts", "a sphere minus three tori and six spheres", nine_cuts);
}

std::vector<Case> make_cases() {
  std::vector<Case> cases;
  add_pairs_of_spheres(cases);
  add_scans(cases);
  add_coinciding(cases);
  add_crossings(cases);
  add_many(cases);
  add_chains(cases);
  add_smoke(cases);
  return cases;
}

}  // namespace

std::span<const Case> all_cases() {
  static const std::vector<Case> cases = make_cases();
  return cases;
}

const Case& case_named(const std::string& name) {
  for (const Case& c : all_cases())
    if (c.name == name) return c;
  throw std::invalid_argument("there is no case " + name);
}

std::string name(Group group) {
  switch (group) {
    case Group::largest:
      return "largest";
    case Group::pair:
      return "pair";
    case Group::tiny:
      return "tiny";
    case Group::small:
      return "small";
    case Group::dense:
      return "dense";
    case Group::many:
      return "many";
    case Group::one_by_one:
      return "one_by_one";
    case Group::chain:
      return "chain";
    case Group::drill:
      return "drill";
    case Group::slow:
      return "slow";
    case Group::smoke:
      return "smoke";
  }
  return {};
}

}  // namespace bench
