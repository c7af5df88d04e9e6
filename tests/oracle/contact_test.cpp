#include "strata/contact.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>

#include "core/kernel/filters.h"
#include "oracle/comparison.h"
#include "oracle/isolated.h"
#include "oracle/nef.h"
#include "support/touching.h"
#include "support/transform.h"

// Contacts beside the intersections of boundaries of Nef polyhedra, distances beside CGAL's of triangles.
namespace strata::oracle {
namespace {

using Segments = std::vector<std::array<RationalPoint, 2>>;

bool are_collinear(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) {
  const RationalPoint n = cross<Rational>(q - p, r - p);
  return n == RationalPoint{};
}

/// Segments that continue one another become one.
Segments joined(Segments list) {
  for (auto& s : list)
    if (s[1] < s[0]) std::swap(s[0], s[1]);
  for (std::size_t i = 0; i < list.size(); ++i)
    for (std::size_t k = 0; k < list.size(); ++k)
      if (i != k && list[i][1] == list[k][0] && are_collinear(list[i][0], list[i][1], list[k][1])) {
        list[i][1] = list[k][1];
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(k));
        return joined(std::move(list));
      }
  std::sort(list.begin(), list.end());
  return list;
}

/// Turned so that the first coordinate of the normal that is not 0 is positive. The first loop is the outer one here,
/// the largest one in general.
void turn_to_front(ExactFacet& facet) {
  RationalPoint sum;
  for (const auto& loop : facet)
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
      const RationalPoint v = cross<Rational>(loop[k] - loop[0], loop[k + 1] - loop[0]);
      for (std::size_t i = 0; i < 3; ++i) sum[i] += v[i];
    }
  if (sum < RationalPoint{})
    for (auto& loop : facet) std::reverse(loop.begin(), loop.end());
}

std::string text_of(NefContact contact) {
  if (contact.interiors_meet) return "interfering";
  for (ExactFacet& f : contact.facets) turn_to_front(f);
  std::string text = canonical_form(contact.facets).text();  // CGAL leaves some facets divided
  const auto add = [&](const RationalPoint& p) {
    for (const Rational& x : p) text.append(" ").append(x.str());
  };
  for (const auto& s : joined(contact.edges)) {
    text += "\nedge";
    add(s[0]);
    add(s[1]);
  }
  std::sort(contact.vertices.begin(), contact.vertices.end());
  for (const RationalPoint& p : contact.vertices) {
    text += "\nvertex";
    add(p);
  }
  return text;
}

/// What the library says, in the same words.
std::string found_by_strata(const Solid& a, const Solid& b) {
  const Solid both[] = {a, b};
  const contact::Assembly assembly(both);
  NefContact found;
  found.interiors_meet = assembly.relation(0, 1) == contact::Relation::interfering;
  if (found.interiors_meet) return text_of(found);
  const contact::ContactRegion region = assembly.contact_region(0, 1);
  for (const auto& f : region.facets) {
    ExactFacet& facet = found.facets.emplace_back();
    for (const auto& loop : f.loops) {
      auto& points = facet.emplace_back();
      for (const std::uint32_t p : loop) points.push_back(region.points[p]);
    }
  }
  for (const auto& e : region.edges) found.edges.push_back({region.points[e.ends[0]], region.points[e.ends[1]]});
  for (const std::uint32_t v : region.vertices) found.vertices.push_back(region.points[v]);
  CHECK(region.facets.size() == canonical_form(found.facets).facet_count());
  CHECK((assembly.relation(0, 1) == contact::Relation::apart) == region.is_empty());
  return text_of(found);
}

void compare_contact(const Solid& a, const Solid& b, Tally& tally) {
  const std::string found = found_by_strata(a, b);
  try {
    const std::string expected =
        in_child([&] { return text_of(nef_contact(NefSolid(a.exact_mesh()), NefSolid(b.exact_mesh()))); }, 20);
    CHECK(found == expected);
    ++(found == expected ? tally.equal : tally.different);
  } catch (const OracleFailed&) {
    ++tally.oracle_failed;
  }
}

void compare_contacts(SeedRange range) {
  Tally tally;
  for (std::uint64_t seed = range.first; seed < range.last; ++seed) {
    CAPTURE(seed);
    const test::Operands two = test::touching_pair(seed);
    const Solid a{two.meshes[0]}, b{two.meshes[1]};
    compare_contact(a, b, tally);
    if (const Solid rest = b - a; !rest.is_empty()) compare_contact(a, rest, tally);
  }
  print("contacts " + std::to_string(range.first) + "-" + std::to_string(range.last), tally);
  CHECK(tally.equal > tally.oracle_failed);
}

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

std::vector<Kernel::Triangle_3> triangles_of(const Mesh& mesh) {
  std::vector<Kernel::Triangle_3> list;
  const auto point = [&](std::uint32_t v) {
    return Kernel::Point_3(mesh.vertices[v][0], mesh.vertices[v][1], mesh.vertices[v][2]);
  };
  for (const Triangle& t : mesh.triangles) list.emplace_back(point(t[0]), point(t[1]), point(t[2]));
  return list;
}

/// The least of the distances of all pairs of triangles.
Kernel::FT least_distance(const Mesh& a, const Mesh& b) {
  std::optional<Kernel::FT> least;
  const auto of_b = triangles_of(b);
  for (const auto& f : triangles_of(a))
    for (const auto& g : of_b)
      if (const Kernel::FT d = CGAL::squared_distance(f, g); !least || d < *least) least = d;
  return *least;
}

}  // namespace

// Catches: verdicts from pairs of faces that do not hold around an edge or a vertex; cells told twice, or not at all.
TEST_CASE("contacts of 120 random pairs are those of Nef polyhedra", "[oracle][contact]") {
  compare_contacts(seeds({0, 120}));
}

TEST_CASE("contacts of 1,500 more random pairs are those of Nef polyhedra", "[oracle][contact][slow]") {
  compare_contacts(seeds({120, 1620}));
}

TEST_CASE("distances of random solids are the least of those of their triangles by CGAL", "[oracle][contact]") {
  Tally tally;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Mesh a = test::lattice_solid(random);
    const Vertex by{0.125 * random.between(-40, 40), 0.125 * random.between(-40, 40), 0.375 * random.between(-20, 20)};
    const Mesh b = test::translated(test::lattice_solid(random), by);
    if (a.triangles.empty() || b.triangles.empty() || a.triangles.size() * b.triangles.size() > 1000) continue;
    const Solid both[] = {Solid(a), Solid(b)};
    const contact::Assembly assembly(both);
    if (assembly.relation(0, 1) != contact::Relation::apart) continue;
    const contact::Nearest nearest = assembly.nearest(0, 1);
    const Kernel::FT expected = least_distance(a, b);
    std::ostringstream text;
    text << CGAL::exact(expected);
    const bool equal = Rational(text.str()) == nearest.squared;
    CHECK(equal);
    ++(equal ? tally.equal : tally.different);
  }
  print("distances", tally);
  CHECK(tally.equal > 30);
}

}  // namespace strata::oracle
