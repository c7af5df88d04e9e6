#include "strata/query.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <memory>

#include "arrays.h"
#include "module.h"
#include "names.h"
#include "run.h"

namespace strata::python {

namespace {

using namespace nb::literals;

Scene scene(const SolidList& solids) {
  const std::vector<Solid> operands = solids.value();
  return run(Watch{}, [&](const Computation& c) { return scene_of(operands, c.monitor()); });
}

/// Points that are doubles.
std::span<const Vertex> doubles_of(const ArrayMesh& points, const char* role) {
  if (!points.owned.exact.empty())
    throw std::invalid_argument(std::string(role) + ": expected numbers that are doubles");
  for (const Vertex& p : points.view.vertices)
    for (const double x : p)
      if (!std::isfinite(x)) throw std::invalid_argument(std::string(role) + ": expected finite numbers");
  return points.view.vertices;
}

/// -1 outside, 0 on the boundary, 1 in the interior.
nb::object membership(const Locator& locator, const ArrayLike& points) {
  const MeshHandle held = points_of(points.object, "points");
  const std::span<const Vertex> positions = doubles_of(*held, "points");
  std::vector<std::int8_t> sides(positions.size());
  run([&] {
    std::vector<Where> answers(positions.size());
    locator.membership(positions, answers);
    for (std::size_t i = 0; i < answers.size(); ++i)
      sides[i] = answers[i] == Where::in ? std::int8_t{1} : answers[i] == Where::on ? std::int8_t{0} : std::int8_t{-1};
  });
  return nb::cast(column_of(std::move(sides)));
}

nb::list located(const Locator& locator, const ArrayLike& points) {
  const MeshHandle held = points_of(points.object, "points");
  const std::span<const Vertex> positions = doubles_of(*held, "points");
  const std::vector<Location> locations = run([&] { return locator.locate(positions); });
  nb::list records;
  for (const Location& location : locations) {
    nb::dict windings, faces;
    for (const auto& [solid, number] : location.windings) windings[nb::int_(solid)] = number;
    for (const Contact& contact : location.contacts)
      faces[nb::int_(contact.solid)] = locator.scene().local(contact.face);
    records.append(nb::make_tuple(windings, faces));
  }
  return records;
}

std::vector<Ray> rays_of(const ArrayLike& origins, const ArrayLike& directions) {
  const MeshHandle from = points_of(origins.object, "origins"), along = points_of(directions.object, "directions");
  const auto starts = doubles_of(*from, "origins"), steps = doubles_of(*along, "directions");
  if (starts.size() != steps.size()) throw std::invalid_argument("directions: expected as many as origins");
  std::vector<Ray> rays(starts.size());
  for (std::size_t i = 0; i < rays.size(); ++i) rays[i] = {starts[i], steps[i]};
  return rays;
}

const char* name_of(Passage passage) {
  constexpr std::array names{"entering", "leaving", "touching", "along"};
  return names[static_cast<std::size_t>(passage)];
}

/// The first hits as arrays: solid and face (-1: none), parameter (infinite: none) and place.
nb::dict first_hits(const RayCaster& caster, const ArrayLike& origins, const ArrayLike& directions) {
  const std::vector<Ray> rays = rays_of(origins, directions);
  std::vector<std::int64_t> solids(rays.size(), -1), faces(rays.size(), -1);
  std::vector<double> parameters(rays.size(), std::numeric_limits<double>::infinity());
  auto places = std::make_unique<std::vector<Vertex>>(rays.size(), Vertex{NAN, NAN, NAN});
  run([&] {
    std::vector<std::optional<RoundedHit>> hits(rays.size());
    caster.first_rounded(rays, hits);
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (hits[i]) {
        solids[i] = hits[i]->solid;
        faces[i] = caster.scene().local(hits[i]->face);
        parameters[i] = hits[i]->t;
        (*places)[i] = hits[i]->place;
      }
  });
  const std::vector<Vertex>& kept = *places;
  const nb::capsule owner(places.release(), [](void* p) noexcept { delete static_cast<std::vector<Vertex>*>(p); });
  nb::dict hits;
  hits["solid"] = column_of(std::move(solids));
  hits["face"] = column_of(std::move(faces));
  hits["t"] = column_of(std::move(parameters));
  hits["place"] = rows_of(kept, owner);
  return hits;
}

nb::list all_hits(const RayCaster& caster, const Point& origin, const Point& direction) {
  const Ray ray{origin.doubles("origin"), direction.doubles("direction")};
  const std::vector<RayHit> hits = run([&] { return caster.all(ray); });
  nb::list records;
  for (const RayHit& hit : hits)
    records.append(nb::make_tuple(to_python(hit.t), hit.solid, caster.scene().local(hit.face), name_of(hit.passage),
                                  to_python(hit.place)));
  return records;
}

Origin origin_of(const Scene& scene, const nb::object& origin, const nb::object& direction) {
  if (!origin.is_none() && !direction.is_none())
    throw std::invalid_argument("layers: expected an origin or a direction, found both");
  if (!direction.is_none()) return Origin::direction(Point{direction}.doubles("direction"));
  if (!origin.is_none()) return Origin::point(Point{origin}.doubles("origin"));
  return choose_origin(scene);
}

LayerDecomposition layers(const SolidList& solids, nb::object origin, nb::object direction, ProgressOption progress,
                          std::optional<double> timeout) {
  const Scene all = scene(solids);
  const Origin from = origin_of(all, origin, direction);
  return run({0, std::move(progress), timeout},
             [&](const Computation& c) { return LayerDecomposition(all, from, c.monitor()); });
}

/// The pieces of a layer as an exact mesh, with the solid and face of each.
MeshHandle layer_mesh(const LayerDecomposition& layers, std::uint32_t layer) {
  if (layer < 1 || layer > layers.layer_count())
    throw nb::index_error(("there are layers from 1 to " + std::to_string(layers.layer_count())).c_str());
  ExactMesh mesh;
  std::vector<Source> sources;
  for (const std::uint32_t piece : layers.layer_pieces(layer)) {
    Triangle corners{};
    const auto triangle = layers.triangle(piece);
    for (std::size_t i = 0; i < 3; ++i) corners[i] = add_vertex(mesh, triangle[i]);
    mesh.mesh.triangles.push_back(corners);
    const std::uint32_t face = layers.face_of(piece);
    sources.push_back({layers.scene().solid_of(face), layers.scene().local(face)});
  }
  BooleanResult result;
  result.mesh = std::move(mesh.mesh);
  result.exact = std::move(mesh.exact);
  result.sources = std::move(sources);
  return mesh_of(std::move(result));
}

void bind_locator(nb::module_& m) {
  nb::class_<Locator>(m, "Locator", nb::is_weak_referenceable(), R"(Locates points in solids: in, on or out. Exact.

Parameters
----------
solids : iterable of Solid

Examples
--------
>>> locator = Locator([box((0, 0, 0), (1, 1, 1))])
>>> locator.membership([[.5, .5, .5], [1, .5, .5], [2, 0, 0]]).tolist()
[1, 0, -1]
)")
      .def(
          "__init__",
          [](Locator* self, const SolidList& solids) {
            const Scene all = scene(solids);
            new (self) Locator(run({}, [&](const Computation& c) { return Locator(all, c.monitor()); }));
          },
          "solids"_a)
      .def("membership", membership, "points"_a,
           nb::sig("def membership(self, points: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.int8]"),
           "Per point (n, 3): 0 on the boundary of a solid, else 1 in the interior of one, -1 outside of all. In "
           "parallel.")
      .def("locate", located, "points"_a,
           nb::sig("def locate(self, points: numpy.typing.ArrayLike) -> list[tuple[dict[int, int], dict[int, int]]]"),
           R"(Per point the solids that it is in, with winding numbers, and those that it lies on, with a face.

Examples
--------
>>> Locator([box((0, 0, 0), (1, 1, 1)), box((0, 0, 0), (2, 2, 2))]).locate([[.5, .5, .5]])
[({0: 1, 1: 1}, {})]
)");
}

void bind_ray_caster(nb::module_& m) {
  nb::class_<RayCaster>(m, "RayCaster", nb::is_weak_referenceable(), R"(Exact ray queries over solids, from any point.

Parameters
----------
solids : iterable of Solid

Examples
--------
>>> caster = RayCaster([box((0, 0, 0), (1, 1, 1))])
>>> caster.first([[-1, .5, .5]], [[1, 0, 0]])["place"].tolist()
[[0.0, 0.5, 0.5]]
>>> [(t, passage) for t, _, _, passage, _ in caster.all((-1, .5, .5), (1, 0, 0))]
[(Fraction(1, 1), 'entering'), (Fraction(2, 1), 'leaving')]
)")
      .def(
          "__init__",
          [](RayCaster* self, const SolidList& solids) {
            const Scene all = scene(solids);
            new (self) RayCaster(run([&] { return RayCaster(all); }));
          },
          "solids"_a)
      .def("first", first_hits, "origins"_a, "directions"_a,
           nb::sig("def first(self, origins: numpy.typing.ArrayLike, directions: numpy.typing.ArrayLike) -> dict[str, "
                   "numpy.typing.NDArray[typing.Any]]"),
           R"(The first events of many rays, in parallel.

Returns
-------
dict of arrays
    ``solid`` and ``face``, -1 where a ray meets nothing; ``t``, in lengths of the direction, and ``place`` (n, 3),
    each rounded to the nearest double.
)")
      .def(
          "all", all_hits, "origin"_a, "direction"_a,
          nb::sig(
              "def all(self, origin: PointLike, direction: PointLike) -> list[tuple[fractions.Fraction, int, int, str, "
              "tuple[fractions.Fraction, fractions.Fraction, fractions.Fraction]]]"),
          "All events of one ray, exactly: (t, solid, face, passage, place); passage is entering, leaving, touching or "
          "along.");
}

}  // namespace

void bind_query(nb::module_& m) {
  bind_locator(m);
  bind_ray_caster(m);
  nb::class_<LayerDecomposition>(m, "Layers", nb::is_weak_referenceable(),
                                 R"(Faces in layers as seen from an origin: `layers` makes them.

Layer 1 has the faces that nothing is behind of, on any ray; going through the layers from the first to the last is the
painter's order. Faces that cross, or that dominate one another in a cycle, are cut.
)")
      .def_prop_ro("count", &LayerDecomposition::layer_count, "How many layers there are; they are numbered from 1.")
      .def("__len__", &LayerDecomposition::layer_count)
      .def("mesh", layer_mesh, "layer"_a,
           "The pieces of a layer, 1 to `count`, as a Mesh with exact vertices; sources are the solid and its face.")
      .def_prop_ro(
          "origin",
          [](const LayerDecomposition& layers) {
            const Vertex& p = layers.origin().at;
            return nb::make_tuple(p[0], p[1], p[2]);
          },
          nb::sig("def origin(self) -> tuple[float, float, float]"), "The point, or the direction, of the view.")
      .def(
          "_repr_html_",
          [](nb::object thing) { return nb::module_::import_("strata_csg._notebook").attr("html_of")(thing); },
          nb::sig("def _repr_html_(self) -> str"), "A viewer, for notebooks.")
      .def_prop_ro(
          "is_direction", [](const LayerDecomposition& layers) { return !layers.origin().is_point(); },
          "Whether `origin` is the direction of parallel rays.")
      .def("__repr__", [](const LayerDecomposition& layers) {
        return "Layers(" + std::to_string(layers.layer_count()) + " of " + std::to_string(layers.piece_count()) +
               " pieces)";
      });
  m.def("layers", layers, "solids"_a, nb::kw_only(), "origin"_a = nb::none(), "direction"_a = nb::none(),
        "progress"_a = nb::none(), "timeout"_a = nb::none(),
        nb::sig("def layers(solids: collections.abc.Iterable[Solid], *, origin: PointLike | None = None, direction: "
                "PointLike | None = None, progress: Progress = None, timeout: float | None = None) -> Layers"),
        R"(The faces of solids in layers as seen from a point, or along a direction. Exact.

Parameters
----------
solids : iterable of Solid
origin, direction : three numbers, optional
    The point of view, or the direction of parallel rays; without either, a point with few layers is chosen.
progress, timeout
    As for Solid.

Examples
--------
>>> layers([box((0, 0, 0), (1, 1, 1))], direction=(0, 0, 1)).count
2
)");
}

}  // namespace strata::python
