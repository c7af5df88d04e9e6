#include "core/kernel/exact_evaluation.h"

#include <bit>

namespace strata {

PointWidth width_of(const SymbolicPoint& name, int b) {
  const PointWidth input{b, 0};
  const PlaneWidth face = width_of_plane(input, input, input);
  switch (name.kind) {
    case SymbolicPoint::Kind::input:
    case SymbolicPoint::Kind::free:
      return input;
    case SymbolicPoint::Kind::edge_edge: {
      const int value = width_of_value({b + 1, 2 * b + 2}, input);
      return {value + b + 1, value + 1};
    }
    case SymbolicPoint::Kind::edge_face: {
      const int value = width_of_value(face, input);
      return {value + b + 1, value + 1};
    }
    case SymbolicPoint::Kind::three_faces:
      return {2 * face.abc + 1 + face.d + 2, 2 * face.abc + 1 + face.abc + 2};
    case SymbolicPoint::Kind::weighted: {
      const int t = static_cast<int>(std::bit_width(name.id[1]));
      return {b + 2 * t + 2, 2 * t + 2};
    }
  }
  return input;
}

PlaneWidth width_of_plane(PointWidth p, PointWidth q, PointWidth r) {
  const int u = std::max(q.xyz + p.w, p.xyz + q.w) + 1;
  const int v = std::max(r.xyz + p.w, p.xyz + r.w) + 1;
  const int normal = u + v + 1;
  return {normal + p.w, normal + p.xyz + 2};
}

int width_of_value(PlaneWidth plane, PointWidth p) { return std::max(plane.abc + p.xyz, plane.d + p.w) + 2; }

int width_of_orientation(PointWidth p, PointWidth q, PointWidth r) {
  const int qr = q.xyz + r.xyz + 1 + p.w, rp = r.xyz + p.xyz + 1 + q.w, pq = p.xyz + q.xyz + 1 + r.w;
  return std::max({qr, rp, pq, 2 * std::max({p.xyz, q.xyz, r.xyz}) + 3}) + 2;
}

Ground::Ground(const InputComplex& input, std::span<const Point* const> points) {
  for (const Point* p : points) {
    const auto& id = p->name.id;
    switch (p->name.kind) {
      case SymbolicPoint::Kind::input:
        add_vertex(input, id[0]);
        break;
      case SymbolicPoint::Kind::edge_edge:
        for (const std::uint32_t v : id) add_vertex(input, v);
        break;
      case SymbolicPoint::Kind::edge_face:
        add_vertex(input, id[0]);
        add_vertex(input, id[1]);
        add_face(input, id[2]);
        break;
      case SymbolicPoint::Kind::three_faces:
        for (int i = 0; i < 3; ++i) add_face(input, id[static_cast<std::size_t>(i)]);
        break;
      case SymbolicPoint::Kind::weighted:
        add_face(input, id[0]);
        break;
      case SymbolicPoint::Kind::free:
        for (const Bounded& x : p->at) lattice_.add(x.value);
        break;
    }
  }
}

void Ground::add_vertex(const InputComplex& input, std::uint32_t v) {
  const VertexPosition place = input.place(v);
  if (!place.has_doubles() && place.remainder == nullptr) {
    rational_ = true;
    return;
  }
  for (const double x : *place.nearest) lattice_.add(x);
  if (place.remainder != nullptr)
    for (const double x : *place.remainder) lattice_.add(x);
}

void Ground::add_face(const InputComplex& input, std::uint32_t f) {
  if (input.source_plane(f) != nullptr) rational_ = true;
  for (const std::uint32_t v : input.face(f)) add_vertex(input, v);
}

}  // namespace strata
