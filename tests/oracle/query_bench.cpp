// query_bench MESH [--rays N] [--points N]: rates of exact first hits and of membership, Strata beside CGAL's AABB tree
// (EPICK), one thread each, on the same random rays and points. Differences are counted: CGAL constructs in doubles.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "extensions/scene/ray_caster_data.h"
#include "extensions/scene/signed_covering.h"
#include "strata/io.h"
#include "strata/query.h"
#include "support/random.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Surface>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using strata::Ray;
using strata::Vertex;

template <class Work>
double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Surface to_surface(const strata::Mesh& mesh) {
  Surface surface;
  for (const auto& [x, y, z] : mesh.vertices) surface.add_vertex({x, y, z});
  for (const auto& [a, b, c] : mesh.triangles)
    if (surface.add_face(Surface::Vertex_index(a), Surface::Vertex_index(b), Surface::Vertex_index(c)) ==
        Surface::null_face())
      throw std::runtime_error("CGAL refuses a face");
  return surface;
}

/// Random points of the bounding box, and rays between two of the box twice as large.
struct Questions {
  std::vector<Ray> rays;
  std::vector<Vertex> points;
};

Questions questions(const strata::Box& box, std::size_t rays, std::size_t points) {
  strata::test::Random random(1);
  const auto point = [&](double size) {
    Vertex p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = (box.lower[i] + box.upper[i]) / 2 + (random.unit() - 0.5) * size * (box.upper[i] - box.lower[i]);
    return p;
  };
  Questions q;
  for (std::size_t n = 0; n < rays; ++n) {
    Ray ray{point(2), point(1)};
    for (std::size_t i = 0; i < 3; ++i) ray.direction[i] -= ray.from[i];
    q.rays.push_back(ray);
  }
  for (std::size_t n = 0; n < points; ++n) q.points.push_back(point(1));
  return q;
}

void print(const char* what, std::size_t count, double strata, double cgal, std::size_t different) {
  std::printf("%-24s strata %10.0f /s   cgal %10.0f /s   ratio %5.2f   different %zu\n", what,
              static_cast<double>(count) / strata, static_cast<double>(count) / cgal, cgal / strata, different);
}

/// Hits of both, each as the distance along the ray in units of the direction; NaN for none.
void compare_rays(const strata::RayCaster& caster, Tree& tree, const std::vector<Ray>& rays) {
  std::vector<std::optional<strata::RoundedHit>> ours(rays.size());
  std::vector<double> theirs(rays.size(), NAN);
  const double strata = seconds_of([&] { caster.first_rounded(rays, ours); });
  const double cgal = seconds_of([&] {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto& [o, d] = rays[i];
      const Kernel::Ray_3 ray(Kernel::Point_3(o[0], o[1], o[2]), Kernel::Vector_3(d[0], d[1], d[2]));
      const auto hit = tree.first_intersection(ray);
      if (!hit) continue;
      if (const auto* p = boost::get<Kernel::Point_3>(&hit->first))
        theirs[i] = (*p - ray.source()) * ray.to_vector() / ray.to_vector().squared_length();
    }
  });
  std::size_t different = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
    different += ours[i].has_value() == std::isnan(theirs[i]) || (ours[i] && std::abs(ours[i]->t - theirs[i]) > 1e-9);
  print("first hit", rays.size(), strata, cgal, different);
}

void compare_points(const strata::SignedCovering& covering, const strata::Locator& locator, const Tree& tree,
                    const std::vector<Vertex>& points) {
  std::vector<strata::Where> ours(points.size()), local(points.size());
  std::vector<CGAL::Bounded_side> theirs(points.size());
  const double about_one = seconds_of([&] { covering.membership(points, ours); });
  const double about_many = seconds_of([&] { locator.membership(points, local); });
  const CGAL::Side_of_triangle_mesh<Surface, Kernel, CGAL::Default, Tree> side(tree);
  const double cgal = seconds_of([&] {
    for (std::size_t i = 0; i < points.size(); ++i)
      theirs[i] = side(Kernel::Point_3(points[i][0], points[i][1], points[i][2]));
  });
  const auto different = [&](const std::vector<strata::Where>& answers) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      count += (answers[i] == strata::Where::in) != (theirs[i] == CGAL::ON_BOUNDED_SIDE);
    return count;
  };
  print("membership, one origin", points.size(), about_one, cgal, different(ours));
  print("membership, locator", points.size(), about_many, cgal, different(local));
}

void run(const std::string& path, std::size_t rays, std::size_t points) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const strata::Mesh mesh = strata::read_mesh(path).mesh;
  std::printf("%zu triangles, one thread\n", mesh.triangles.size());
  const strata::Scene scene({{mesh, {}}});
  std::unique_ptr<strata::RayCaster> caster;
  std::unique_ptr<strata::SignedCovering> covering;
  const double tree_time = seconds_of([&] { caster = std::make_unique<strata::RayCaster>(scene); });
  const strata::Box& box = tree_of(*caster).bounds();
  Vertex middle;
  for (std::size_t i = 0; i < 3; ++i) middle[i] = (box.lower[i] + box.upper[i]) / 2;
  const double covering_time =
      seconds_of([&] { covering = std::make_unique<strata::SignedCovering>(scene, strata::Origin::point(middle)); });
  std::unique_ptr<strata::Locator> locator;
  const double locator_time = seconds_of([&] { locator = std::make_unique<strata::Locator>(scene); });
  const Surface surface = to_surface(mesh);
  Tree tree(faces(surface).begin(), faces(surface).end(), surface);
  const double cgal_time = seconds_of([&] { tree.build(); });
  const auto per_face = [&](std::size_t bytes) {
    return static_cast<double>(bytes) / static_cast<double>(mesh.triangles.size());
  };
  std::printf(
      "built in s (bytes per face): box tree %.3f (%.1f), covering %.3f (%.1f), locator %.3f (%.1f), CGAL's tree "
      "%.3f\n",
      tree_time, per_face(tree_of(*caster).bytes()), covering_time, per_face(covering->bytes()), locator_time,
      per_face(locator->bytes()), cgal_time);
  const Questions q = questions(box, rays, points);
  compare_rays(*caster, tree, q.rays);
  compare_points(*covering, *locator, tree, q.points);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Rates of exact queries beside CGAL's", "query_bench");
  std::string path;
  std::size_t rays = 300'000, points = 1'000'000;
  app.add_option("MESH", path, "A closed mesh")->required();
  app.add_option("--rays", rays, "How many rays");
  app.add_option("--points", points, "How many points");
  CLI11_PARSE(app, argc, argv);
  try {
    run(path, rays, points);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
