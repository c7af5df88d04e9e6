// cgal_bench KERNEL CASE [options]: what CGAL takes for the same operation, from arrays to arrays; prints JSON like
// strata-bench. Kernels: corefine_epick, corefine_epeck, nef; of the first mesh alone autorefine_epick and
// autorefine_epeck (cut where it crosses itself) and remove_epick and remove_epeck (the same, then inner parts go).
// CGAL works on one thread.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include <array>
#include <deque>
#include <exception>
#include <iostream>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "case_file.h"
#include "combine_nef.h"
#include "measure.h"
#include "request.h"

namespace {

namespace corefinement = CGAL::Polygon_mesh_processing;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using strata::Mesh;
using strata::Operation;
using strata::oracle::combine;
using strata::oracle::Nef;

template <typename Kernel>
using Surface = CGAL::Surface_mesh<typename Kernel::Point_3>;

template <typename Kernel>
Surface<Kernel> to_surface(const Mesh& mesh) {
  Surface<Kernel> surface;
  const auto vertices = static_cast<unsigned>(mesh.vertices.size());
  const auto triangles = static_cast<unsigned>(mesh.triangles.size());
  surface.reserve(vertices, vertices + triangles, triangles);
  using Index = typename Surface<Kernel>::Vertex_index;
  for (const auto& [x, y, z] : mesh.vertices) surface.add_vertex({x, y, z});
  for (const auto& [a, b, c] : mesh.triangles) {
    if (surface.add_face(Index(a), Index(b), Index(c)) == Surface<Kernel>::null_face()) {
      throw std::runtime_error("CGAL refuses a face of an operand");
    }
  }
  return surface;
}

template <typename Point>
strata::Vertex to_doubles(const Point& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

template <typename Kernel>
Mesh to_arrays(const Surface<Kernel>& surface) {
  Mesh mesh;
  std::vector<std::uint32_t> number(surface.number_of_vertices() + surface.number_of_removed_vertices());
  for (const auto v : surface.vertices()) {
    number[v] = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(to_doubles(surface.point(v)));
  }
  for (const auto f : surface.faces()) {
    strata::Triangle triangle{};
    auto corner = triangle.begin();
    for (const auto v : surface.vertices_around_face(surface.halfedge(f))) *corner++ = number[v];
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

/// Edges and vertices of several sheets need no case: the triangles need not make a surface of CGAL's.
Mesh to_arrays(const Nef& nef) {
  std::vector<Epeck::Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  CGAL::convert_nef_polyhedron_to_polygon_soup(nef, points, triangles, true);
  Mesh mesh;
  for (const auto& p : points) mesh.vertices.push_back(to_doubles(p));
  for (const auto& t : triangles) {
    const auto corner = [&](std::size_t k) { return static_cast<std::uint32_t>(t.at(k)); };
    mesh.triangles.push_back({corner(0), corner(1), corner(2)});
  }
  return mesh;
}

/// Of two surfaces, which may be changed.
template <typename Point>
CGAL::Surface_mesh<Point> combine(Operation operation, CGAL::Surface_mesh<Point>& a, CGAL::Surface_mesh<Point>& b) {
  CGAL::Surface_mesh<Point> result;
  bool manifold = false;
  switch (operation) {
    case Operation::union_:
      manifold = corefinement::corefine_and_compute_union(a, b, result);
      break;
    case Operation::intersection:
      manifold = corefinement::corefine_and_compute_intersection(a, b, result);
      break;
    case Operation::difference:
      manifold = corefinement::corefine_and_compute_difference(a, b, result);
      break;
    case Operation::symmetric_difference:
      throw std::runtime_error("CGAL's corefinement has no symmetric difference");
  }
  if (!manifold) throw std::runtime_error("CGAL refuses: the result is not manifold");
  return result;
}

/// The first operand and what each further one does to it.
template <typename Solid>
Solid in_order(Operation operation, std::deque<Solid> operands) {
  while (operands.size() > 1) {
    operands[1] = combine(operation, operands[0], operands[1]);
    operands.pop_front();
  }
  return std::move(operands.front());
}

/// Neighbours first, so that operands stay small; what is subtracted is united first.
template <typename Solid>
Solid in_a_tree(Operation operation, std::deque<Solid> operands) {
  if (operation == Operation::difference && operands.size() > 2) {
    Solid whole = std::move(operands.front());
    operands.pop_front();
    Solid rest = in_a_tree(Operation::union_, std::move(operands));
    return combine(operation, whole, rest);
  }
  while (operands.size() > 1) {
    operands.push_back(combine(operation, operands[0], operands[1]));
    operands.pop_front();
    operands.pop_front();
  }
  return std::move(operands.front());
}

template <typename Solid>
Solid combine_all(const bench::Request& request, std::deque<Solid> operands) {
  return request.one_by_one ? in_order(request.operation, std::move(operands))
                            : in_a_tree(request.operation, std::move(operands));
}

template <typename Kernel>
Mesh corefined(const bench::Request& request, std::span<const Mesh> meshes) {
  std::deque<Surface<Kernel>> operands;
  for (const Mesh& mesh : meshes) operands.push_back(to_surface<Kernel>(mesh));
  return to_arrays<Kernel>(combine_all(request, std::move(operands)));
}

Mesh by_nef_polyhedra(const bench::Request& request, std::span<const Mesh> meshes) {
  std::deque<Nef> operands;
  for (const Mesh& mesh : meshes) {
    Surface<Epeck> surface = to_surface<Epeck>(mesh);
    operands.push_back(Nef(surface));
  }
  return to_arrays(combine_all(request, std::move(operands)));
}

/// Of any closed mesh: edges and vertices of several sheets are doubled, since CGAL's surfaces have none.
template <typename Kernel>
Surface<Kernel> to_divided_surface(const Mesh& mesh) {
  std::vector<typename Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const auto& [x, y, z] : mesh.vertices) points.emplace_back(x, y, z);
  for (const auto& [a, b, c] : mesh.triangles) triangles.push_back({a, b, c});
  corefinement::orient_polygon_soup(points, triangles);
  Surface<Kernel> surface;
  corefinement::polygon_soup_to_polygon_mesh(points, triangles, surface);
  return surface;
}

/// The first mesh, with its faces cut where they cross. Experimental in CGAL.
template <typename Kernel>
Mesh autorefined(const bench::Request& /*request*/, std::span<const Mesh> meshes) {
  Surface<Kernel> surface = to_divided_surface<Kernel>(meshes.front());
  corefinement::experimental::autorefine(surface);
  return to_arrays<Kernel>(surface);
}

/// The same, without what is not seen from outside, as far as CGAL finds it. Experimental, too.
template <typename Kernel>
Mesh without_crossings(const bench::Request& /*request*/, std::span<const Mesh> meshes) {
  Surface<Kernel> surface = to_divided_surface<Kernel>(meshes.front());
  if (!corefinement::experimental::autorefine_and_remove_self_intersections(surface))
    throw std::runtime_error("CGAL says that crossings are left");
  return to_arrays<Kernel>(surface);
}

using Engine = Mesh (*)(const bench::Request&, std::span<const Mesh>);

const std::map<std::string, Engine>& engines() {
  static const std::map<std::string, Engine> all = {{"corefine_epick", corefined<Epick>},
                                                    {"corefine_epeck", corefined<Epeck>},
                                                    {"nef", by_nef_polyhedra},
                                                    {"autorefine_epick", autorefined<Epick>},
                                                    {"autorefine_epeck", autorefined<Epeck>},
                                                    {"remove_epick", without_crossings<Epick>},
                                                    {"remove_epeck", without_crossings<Epeck>}};
  return all;
}

void run(Engine engine, const bench::Request& request) {
  const std::vector<Mesh> meshes = bench::read_case(request.case_file);
  Mesh result;
  const bench::Subject subject = {[&] { result = {}; }, [&] { result = engine(request, meshes); }};
  const bench::Measurement measurement = bench::measure(subject, request);
  nlohmann::json answer = to_json(measurement);
  answer["threads"] = 1;
  answer["version"] = CGAL_VERSION_STR;
  answer["triangles"] = result.triangles.size();
  answer["vertices"] = result.vertices.size();
  if (!request.result_file.empty()) bench::write_case(request.result_file, {&result, 1});
  std::cout << answer.dump() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures CGAL on a case file; prints JSON", "cgal_bench");
  std::string engine;
  bench::Request request;
  app.add_option("KERNEL", engine, "corefine_epick, corefine_epeck, nef, autorefine_epick, ...")
      ->required()
      ->check(CLI::IsMember(engines()));
  add_options(app, request);
  CLI11_PARSE(app, argc, argv);
  try {
    CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
    run(engines().at(engine), request);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
