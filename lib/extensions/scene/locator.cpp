#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/cells/cell_tree.h"
#include "core/cells/walk.h"
#include "core/kernel/input_complex.h"
#include "extensions/scene/location.h"
#include "extensions/scene/scene_data.h"
#include "extensions/scene/walk_step.h"
#include "strata/query.h"

namespace strata {

struct Locator::Data {
  Data(Scene s, const Monitor& monitor)
      : scene(std::move(s)),
        cells(input_complex_of(scene), {.self = true, .everywhere = true, .leaf_faces = 12, .monitor = monitor}) {}

  Scene scene;
  CellTree cells;

  /// Walks from the origin of q's cell to q: `start(windings)`, then `step(face, WalkStep)` for the faces that may
  /// be met.
  template <class Start, class Step>
  void walk(const Vertex& q, const Start& start, const Step& step) const {
    const InputComplex& input = input_complex_of(scene);
    const auto target = cells.grid().at(q);
    const Cell& cell = cells.cells()[cells.cell_at(target)];
    start(*cell.windings);
    if (cell.faces.empty()) return;
    const GridBox way = GridBox::between(cells.grid().at(cell.origin), target);
    const Point point = Point::free(q);
    for (const CellFace& f : cell.faces)
      if (f.box.overlaps(way))
        step(f.face, walk_step(
                         input, f.face, q, point, [&](const FilteredPlane& plane) { return plane.side(cell.origin); },
                         [&] { return crossing(input, f.face, cell.origin, point); }));
  }
};

Locator::Locator(Scene scene, const Monitor& monitor) : data_(Shared<Data>::make(std::move(scene), monitor)) {}

const Scene& Locator::scene() const { return data_->scene; }

Where Locator::membership(const Vertex& q) const {
  bool on = false, in = false;
  if (scene().solid_count() == 1) {
    int w = 0;
    data_->walk(
        q, [&](const Windings& windings) { w = windings[0]; },
        [&](std::uint32_t, const WalkStep& step) {
          on = on || step.on;
          w += step.change;
        });
    in = w != 0;
  } else {
    Windings w;
    data_->walk(
        q, [&](const Windings& windings) { w = windings; },
        [&](std::uint32_t face, const WalkStep& step) {
          on = on || step.on;
          w.add(input_complex_of(data_->scene).operand_of_face(face), step.change);
        });
    in = w.begin() != w.end();
  }
  return on ? Where::on : in ? Where::in : Where::out;
}

Location Locator::locate(const Vertex& q) const {
  Windings windings;
  std::vector<Contact> faces;
  data_->walk(
      q, [&](const Windings& w) { windings = w; },
      [&](std::uint32_t face, const WalkStep& step) {
        const std::uint32_t solid = input_complex_of(data_->scene).operand_of_face(face);
        windings.add(solid, step.change);
        if (step.on) faces.push_back({solid, face});
      });
  return location_of(std::move(windings), std::move(faces));
}

void Locator::membership(std::span<const Vertex> q, std::span<Where> answers) const {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, std::min(q.size(), answers.size()), 1024),
                    [&](const auto& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) answers[i] = membership(q[i]);
                    });
}

std::vector<Location> Locator::locate(std::span<const Vertex> q) const {
  std::vector<Location> answers(q.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, q.size(), 1024), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) answers[i] = locate(q[i]);
  });
  return answers;
}

std::size_t Locator::bytes() const { return sizeof(Data) + data_->cells.bytes(); }

}  // namespace strata
