#include "core/mesh/prepare.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "shapes.h"
#include "strata/measure.h"

using namespace strata;
using namespace strata::shapes;

namespace {

CanonicalForm form(const Mesh& mesh) { return canonical_form(ExactMesh{mesh, {}}); }

const Mesh& cube() {
  static const Mesh mesh = box({0, 0, 0}, {4, 4, 4});
  return mesh;
}

std::uint64_t count_of(const std::vector<Defect>& defects, DefectKind kind) {
  for (const Defect& d : defects) {
    if (d.kind == kind) return d.count;
  }
  return 0;
}

std::vector<Defect> errors_of(const Mesh& mesh) {
  try {
    (void)prepare_closed(mesh, false);
  } catch (const InputError& error) {
    return error.defects();
  }
  return {};
}

/// Replaces a triangle by two that share a new vertex on its first side, and closes the slit with a zero-area triangle.
void slit(Mesh& mesh, std::size_t face, const Vertex& middle) {
  const auto [a, b, c] = mesh.triangles[face];
  const auto m = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(middle);
  mesh.triangles[face] = {a, m, c};
  mesh.triangles.push_back({m, b, c});
  mesh.triangles.push_back({a, b, m});
}

void check_clean(const Prepared& prepared, const Mesh& expected) {
  REQUIRE(prepared.mesh);
  CHECK(prepared.source_face.size() == prepared.mesh->triangles.size());
  const Screening facts = screen(*prepared.mesh);
  CHECK(facts.chain_closed);
  CHECK_FALSE(facts.degenerate);
  CHECK(volume({*prepared.mesh, {}}) == volume({expected, {}}));
  CHECK(form(*prepared.mesh) == form(expected));
}

}  // namespace

TEST_CASE("a solid is used as it is", "[mesh]") {
  CHECK_FALSE(prepare_closed(cube(), false).mesh);
  CHECK(prepare_closed(cube(), false).notes.empty());
  CHECK_FALSE(prepare_closed(Mesh{}, false).mesh);
}

TEST_CASE("seams are welded on equal coordinates, with a note", "[mesh]") {
  const Prepared prepared = prepare_closed(shattered(cube()), false);
  check_clean(prepared, cube());
  REQUIRE(prepared.notes.size() == 1);
  CHECK(prepared.notes[0].severity == Severity::note);
  CHECK(prepared.notes[0].count == 28);
  CHECK(prepared.source_face[7] == 7);
  Mesh signs = shattered(cube());
  for (std::size_t v = 0; v < signs.vertices.size(); v += 2) {
    for (double& x : signs.vertices[v]) x = x == 0 ? -0.0 : x;
  }
  check_clean(prepare_closed(signs, false), cube());
}

TEST_CASE("a mesh that is not closed is refused with its open edges", "[mesh]") {
  Mesh mesh = shattered(cube());
  mesh.triangles.erase(mesh.triangles.begin() + 2);
  const std::vector<Defect> errors = errors_of(mesh);
  REQUIRE(errors.size() == 3);
  for (const Defect& defect : errors) {
    CHECK(defect.kind == DefectKind::open_edge);
    CHECK(defect.severity == Severity::error);
    CHECK(defect.count == 3);
    CHECK(defect.faces.size() == 1);
    CHECK(defect.where);
    CHECK_FALSE(defect.remedy.empty());
  }
  try {
    (void)prepare_closed(mesh, false, 3);
    FAIL("accepted");
  } catch (const InputError& error) {
    CHECK(error.operand() == 3);
  }
}

TEST_CASE("a reversed face is an inconsistent orientation", "[mesh]") {
  Mesh mesh = cube();
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  const std::vector<Defect> errors = errors_of(mesh);
  CHECK(count_of(errors, DefectKind::inconsistent_orientation) == 3);
  CHECK(count_of(errors, DefectKind::open_edge) == 0);
  CHECK(std::find(errors[0].faces.begin(), errors[0].faces.end(), 4U) != errors[0].faces.end());
}

TEST_CASE("indices out of range and coordinates that are not finite are errors", "[mesh]") {
  Mesh mesh = cube();
  mesh.triangles[1] = {0, 1, 99};
  mesh.vertices[7][1] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Defect> errors = errors_of(mesh);
  CHECK(count_of(errors, DefectKind::index_out_of_range) == 1);
  CHECK(count_of(errors, DefectKind::non_finite_coordinate) == 6);
  CHECK(errors[0].faces == std::vector<std::uint32_t>{1});
}

TEST_CASE("an inside-out mesh is refused unless allowed", "[mesh]") {
  CHECK(count_of(errors_of(flipped(cube())), DefectKind::inside_out) == 1);
  CHECK_FALSE(prepare_closed(flipped(cube()), true).mesh);
  CHECK(count_of(diagnose(flipped(cube())), DefectKind::inside_out) == 1);
}

TEST_CASE("a diagnosis of a solid is empty, that of an empty mesh is a note", "[mesh]") {
  CHECK(diagnose(cube()).empty());
  CHECK(diagnose(shattered(cube())).empty());
  REQUIRE(diagnose(Mesh{}).size() == 1);
  CHECK(diagnose(Mesh{})[0].severity == Severity::note);
}

TEST_CASE("non-manifold edges and opposite faces are legal", "[mesh]") {
  const Mesh touching = joined(cube(), moved(cube(), {4, 4, 0}));
  CHECK(diagnose(touching).empty());
  Mesh welded = *prepare_soup(touching, Holes::refused).mesh;
  CHECK(diagnose(welded).empty());
  CHECK_FALSE(prepare_closed(welded, false).mesh);
  Mesh with_fin = cube();
  with_fin.vertices.push_back({9, 9, 9});
  with_fin.triangles.insert(with_fin.triangles.end(), {{0, 1, 8}, {1, 0, 8}});
  CHECK(diagnose(with_fin).empty());
}

TEST_CASE("faces that repeat others are counted and located", "[mesh]") {
  Mesh twice = cube();
  for (std::size_t i = 0; i < 12; ++i) {
    const auto [a, b, c] = twice.triangles[i];
    twice.triangles.push_back({b, c, a});
  }
  const std::vector<Defect> defects = diagnose(twice);
  CHECK(count_of(defects, DefectKind::duplicate_face) == 12);
  CHECK(defects.size() == 5);  // the first few only
  CHECK(defects[0].faces.size() == 2);
}

TEST_CASE("a slit closed by a zero-area triangle becomes a vertex of both neighbours", "[mesh]") {
  Mesh mesh = cube();
  slit(mesh, 0, {0, 1, 0});  // face 0 runs from (0,0,0) to (0,4,0)
  const Prepared prepared = prepare_closed(mesh, false);
  check_clean(prepared, cube());
  CHECK(prepared.mesh->triangles.size() == 14);
  REQUIRE(prepared.notes.size() == 1);
  CHECK(prepared.notes[0].kind == DefectKind::degenerate_triangle);
  CHECK(prepared.notes[0].faces == std::vector<std::uint32_t>{13});
}

TEST_CASE("a triangle divided on all three sides is cut without zero-area pieces", "[mesh]") {
  Mesh mesh = corner_tetrahedron();
  for (Vertex& v : mesh.vertices) v = {v[0] * 8, v[1] * 8, v[2] * 8};
  const auto middle = [&](std::uint32_t a, std::uint32_t b, double t) {
    const Vertex &p = mesh.vertices[a], &q = mesh.vertices[b];
    return Vertex{p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t, p[2] + (q[2] - p[2]) * t};
  };
  const Mesh coarse = mesh;
  for (std::size_t face = 0; face < 3; ++face) {  // slits along the sides of face 3
    Triangle& t = mesh.triangles[face];
    while (std::count(t.begin(), t.begin() + 2, 0U) != 0) std::rotate(t.begin(), t.begin() + 1, t.end());
    const std::uint32_t a = t[0], b = t[1];
    slit(mesh, face, middle(a, b, 0.25));
    const std::size_t second = mesh.triangles.size() - 2;
    slit(mesh, second, middle(a, b, 0.5));
  }
  check_clean(prepare_closed(mesh, false), coarse);
  CHECK(prepare_closed(mesh, false).mesh->triangles.size() == 4 + 6 + 6);
}

TEST_CASE("zero-length slivers vanish", "[mesh]") {
  Mesh mesh = cube();
  slit(mesh, 0, mesh.vertices[mesh.triangles[0][0]]);
  slit(mesh, 3, mesh.vertices[mesh.triangles[3][1]]);
  check_clean(prepare_closed(mesh, false), cube());
  mesh.triangles.push_back({5, 5, 5});
  mesh.triangles.push_back({1, 7, 1});
  check_clean(prepare_closed(mesh, false), cube());
}

TEST_CASE("any web of zero-area triangles is resolved without moving a point", "[mesh][property]") {
  const auto seed = GENERATE(take(300, random(0, 1'000'000)));
  CAPTURE(seed);
  std::mt19937 random(static_cast<unsigned>(seed));
  Mesh mesh = joined(scaled(cube(), 1 << 16), moved(scaled(cube(), 1 << 15), {1 << 18, 0, 0}));
  const Mesh coarse = mesh;
  for (int step = 0; step < 40; ++step) {
    const std::size_t face = random() % 3 == 0 ? mesh.triangles.size() - 1 : random() % mesh.triangles.size();
    Triangle& t = mesh.triangles[face];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    const Vertex &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]];
    const double weight = std::array{0.0, 0.5, 1.0, 0.25}[random() % 4];
    slit(mesh, face, {a[0] + (b[0] - a[0]) * weight, a[1] + (b[1] - a[1]) * weight, a[2] + (b[2] - a[2]) * weight});
  }
  const Prepared prepared = prepare_closed(mesh, false);
  check_clean(prepared, coarse);
  for (std::size_t i = 0; i < prepared.source_face.size(); ++i) CHECK(prepared.source_face[i] < mesh.triangles.size());
  check_clean(prepare_closed(shattered(mesh), false), coarse);
}

TEST_CASE("a soup is welded, oriented and cleaned, with notes", "[mesh]") {
  Mesh soup = shattered(cube());
  for (const std::size_t i : {1U, 4U, 5U, 10U}) std::swap(soup.triangles[i][0], soup.triangles[i][2]);
  soup.vertices.push_back({std::numeric_limits<double>::infinity(), 0, 0});
  soup.triangles.push_back({0, 1, 36});         // not finite
  soup.triangles.push_back({0, 1, 1000});       // out of range
  soup.triangles.push_back({0, 0, 5});          // degenerate
  soup.triangles.push_back(soup.triangles[2]);  // duplicate
  soup.vertices.insert(soup.vertices.end(), {{9, 9, 9}, {10, 9, 9}, {11, 9, 9}});
  soup.triangles.push_back({37, 38, 39});  // zero area, loose
  const Prepared prepared = prepare_soup(soup, Holes::refused);
  check_clean(prepared, cube());
  CHECK(count_of(prepared.notes, DefectKind::non_finite_coordinate) == 1);
  CHECK(count_of(prepared.notes, DefectKind::index_out_of_range) == 1);
  CHECK(count_of(prepared.notes, DefectKind::duplicate_face) == 1);
  CHECK(count_of(prepared.notes, DefectKind::degenerate_triangle) == 1);
  CHECK(count_of(prepared.notes, DefectKind::inconsistent_orientation) > 0);
  for (const Defect& note : prepared.notes) CHECK(note.severity == Severity::note);
}

TEST_CASE("a soup in any orientation faces outwards", "[mesh][property]") {
  const auto seed = GENERATE(take(30, random(0, 1'000'000)));
  std::mt19937 random(static_cast<unsigned>(seed));
  const Mesh parts = joined(globe(9), joined(box({2, 0, 0}, {3, 1, 1}), box({3, 1, 0}, {4, 2, 1})));
  Mesh soup = parts;
  for (Triangle& t : soup.triangles) {
    if (random() % 2 == 0) std::swap(t[0], t[1]);
  }
  std::shuffle(soup.triangles.begin(), soup.triangles.end(), random);
  check_clean(prepare_soup(soup, Holes::refused), parts);
}

TEST_CASE("shells inside others become cavities by parity", "[mesh]") {
  const auto ball = [](double r) { return globe(10, r); };
  const Mesh nested = joined(ball(4), joined(ball(3), joined(ball(2), moved(ball(1), {9, 0, 0}))));
  const Mesh expected = joined(ball(4), joined(flipped(ball(3)), joined(ball(2), moved(ball(1), {9, 0, 0}))));
  check_clean(prepare_soup(nested, Holes::refused), expected);
  check_clean(prepare_soup(flipped(nested), Holes::refused), expected);
  const Mesh touching = joined(cube(), box({0, 1, 1}, {1, 2, 2}));  // from inside, in a face
  const Mesh crossing = joined(cube(), box({1, 1, 1}, {2, 2, 6}));
  check_clean(prepare_soup(flipped(crossing), Holes::refused), crossing);
  CHECK(screen(*prepare_soup(touching, Holes::refused).mesh).chain_closed);
}

TEST_CASE("a soup that stays open is refused with the edges", "[mesh]") {
  Mesh soup = cube();
  soup.triangles.pop_back();
  try {
    (void)prepare_soup(soup, Holes::refused, 1);
    FAIL("accepted");
  } catch (const InputError& error) {
    CHECK(error.operand() == 1);
    CHECK(count_of(error.defects(), DefectKind::open_edge) == 3);
  }
}

TEST_CASE("a surface that cannot be oriented is refused", "[mesh]") {
  Mesh strip;  // a Moebius band
  for (int i = 0; i < 5; ++i) {
    strip.vertices.push_back({std::cos(i * 1.25), std::sin(i * 1.25), 0});
    strip.vertices.push_back({std::cos(i * 1.25), std::sin(i * 1.25), 1});
  }
  for (std::uint32_t i = 0; i < 5; ++i) {
    const std::uint32_t c = i == 4 ? 1 : 2 * i + 2, d = i == 4 ? 0 : 2 * i + 3;
    strip.triangles.insert(strip.triangles.end(), {{2 * i, c, d}, {2 * i, d, 2 * i + 1}});
  }
  CHECK_THROWS_AS(prepare_soup(strip, Holes::refused), InputError);
}

TEST_CASE("preparing, screening and diagnosis stop when they are told to") {
  const Mesh mesh = globe(100);  // more steps than there are between two looks
  Mesh open = mesh;
  open.triangles.pop_back();
  CancelToken token;
  token.cancel();
  const Monitor monitor(&token);
  Options options;
  options.cancel = &token;
  CHECK_THROWS_AS(screen(mesh, monitor), Cancelled);
  CHECK_THROWS_AS(prepare_closed(mesh, false, 0, monitor), Cancelled);
  CHECK_THROWS_AS(prepare_soup(open, Holes::filled, 0, 99, monitor), Cancelled);
  CHECK_THROWS_AS(prepare_exact(ExactMeshView(mesh, {}), 0, monitor), Cancelled);
  CHECK_THROWS_AS(diagnose(open, 5, monitor), Cancelled);
  for (const InputClass input : {InputClass::solid, InputClass::soup}) {
    options.input = input;
    CHECK_THROWS_AS(prepare(ExactMeshView(open, {}), options), Cancelled);
  }
}
