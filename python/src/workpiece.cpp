#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>
#include <strata/incremental.h>

#include "attributes.h"
#include "module.h"
#include "names.h"
#include "run.h"

namespace strata::python {

void bind_workpiece(nb::module_& m) {
  using namespace nb::literals;
  nb::class_<IncrementalSolid>(m, "Workpiece", nb::is_weak_referenceable(),
                               R"(A solid that is combined with one tool after the other, in thousands of steps.

A step costs about what the surfaces cost where tool and workpiece meet; all versions may be kept, and coordinates do
not grow. Immutable: every step gives a new version.

Parameters
----------
solid : Solid

Examples
--------
>>> work = Workpiece(box((0, 0, 0), (10, 10, 2)))
>>> for i in range(1, 10):
...     work = work.cut(box((i, 1, 1), (i + .5, 9, 3)))
>>> work.solid.volume
Fraction(164, 1)
)")
      .def(nb::init<>())
      .def(
          "__init__",
          [](IncrementalSolid* self, const Solid& solid) {
            new (self) IncrementalSolid(run([&] { return IncrementalSolid(solid); }));
          },
          "solid"_a)
      .def(
          "combined",
          [](const IncrementalSolid& w, const OperationName& name, const SolidList& tools, unsigned threads,
             ProgressOption progress, std::optional<double> timeout) {
            const Operation operation = name.value();
            const std::vector<Solid> solids = tools.value("tools");
            return run({threads, std::move(progress), timeout},
                       [&](const Computation& c) { return w.with(operation, solids, c.options()); });
          },
          "operation"_a, "tools"_a, nb::kw_only(), STRATA_WATCH_ARGUMENTS,
          R"(Combined with tools, those near each other in one step.

Union: with all; difference: all are taken away; intersection: what is in all; symmetric difference: what is in an odd
number of them and this solid together.
)")
      .def(
          "cut",
          [](const IncrementalSolid& w, const Solid& tool) {
            return run({}, [&](const Computation& c) { return w.with(Operation::difference, tool, c.options()); });
          },
          "tool"_a, "Without a tool: one step of machining.")
      .def_prop_ro(
          "solid", [](const IncrementalSolid& w) { return run([&] { return w.solid(); }); },
          "The solid, with exact vertices and the attributes of what it was made of. O(n).")
      .def(
          "finished",
          [](const IncrementalSolid& w, const MaterialOption& cut_material, unsigned threads, ProgressOption progress,
             std::optional<double> timeout) {
            return run({threads, std::move(progress), timeout, cut_material.value("cut_material")},
                       [&](const Computation& c) { return w.solid(c.options()); });
          },
          nb::kw_only(), "cut_material"_a = nb::none(), STRATA_WATCH_ARGUMENTS,
          R"(`solid`, with cut faces made of a material.

Parameters
----------
cut_material : Material, optional
    What the faces that tools left are made of, where the tool has no material.
threads, progress, timeout
    As for Solid.

Examples
--------
>>> work = Workpiece(box((0, 0, 0), (2, 2, 2))).cut(box((1, 1, 1), (3, 3, 3)))
>>> sorted(set(work.finished(cut_material=Material("steel")).attributes["material"].tolist()))
[-1, 0]
)")
      .def_prop_ro("nearest_volume", &IncrementalSolid::volume,
                   "The volume to a few units in the last place, unless nearly all of the solid cancels. O(1).")
      .def_prop_ro("triangle_count", &IncrementalSolid::triangle_count, "How many triangles the boundary has.")
      .def("__bool__", [](const IncrementalSolid& w) { return !w.is_empty(); })
      .def("__repr__",
           [](const IncrementalSolid& w) { return "Workpiece(" + std::to_string(w.triangle_count()) + " triangles)"; });
}

}  // namespace strata::python
