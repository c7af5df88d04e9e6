#include "core/kernel/known_planes.h"

#include <algorithm>

namespace strata {

KnownPlanes::KnownPlanes(const InputComplex& input, const Point& p) : input_(input) {
  const auto& id = p.name.id;
  switch (p.name.kind) {
    case SymbolicPoint::Kind::input:
      if (const MeetOfPlanes* meet = input.meet(id[0]))
        for (const SourcePlane* plane : meet->planes) add(plane);
      break;
    case SymbolicPoint::Kind::edge_edge:
      add_edge(id[0], id[1]);
      add_edge(id[2], id[3]);
      break;
    case SymbolicPoint::Kind::edge_face:
      add_edge(id[0], id[1]);
      add_face(id[2]);
      break;
    case SymbolicPoint::Kind::three_faces:
      for (std::size_t i = 0; i < 3; ++i) add_face(id[i]);
      break;
    case SymbolicPoint::Kind::weighted:
      add_face(id[0]);
      break;
    case SymbolicPoint::Kind::free:
      break;
  }
}

bool KnownPlanes::has(const SourcePlane* plane) const {
  const auto all = list();
  return std::find(all.begin(), all.end(), plane) != all.end();
}

void KnownPlanes::add(const SourcePlane* plane) {
  if (plane != nullptr && count_ < planes_.size()) planes_[count_++] = plane;
}

/// Adds the planes that contain both ends.
void KnownPlanes::add_edge(std::uint32_t a, std::uint32_t b) {
  const MeetOfPlanes *at_a = input_.meet(a), *at_b = input_.meet(b);
  if (at_a == nullptr || at_b == nullptr) return;
  for (const SourcePlane* p : at_a->planes)
    if (std::find(at_b->planes.begin(), at_b->planes.end(), p) != at_b->planes.end()) add(p);
}

}  // namespace strata
