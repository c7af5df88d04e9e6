#include "core/overlap/triangle.h"

namespace strata {

std::optional<Feature> locate(const Signs& sides, Sign inner) {
  int zeros = 0, zero = 0, other = 0;
  for (int i = 0; i < 3; ++i) {
    const Sign s = sides[static_cast<std::size_t>(i)];
    if (s == -inner) return std::nullopt;
    if (s == Sign::zero) {
      ++zeros;
      zero = i;
    } else {
      other = i;
    }
  }
  if (zeros == 0) return Feature::inside();
  if (zeros == 1) return Feature::edge(zero);
  // On two edges: the vertex opposite to the third.
  return Feature::vertex(previous(other));
}

std::optional<Feature> locate(const Signs& sides) {
  for (const Sign s : sides)
    if (s != Sign::zero) return locate(sides, s);
  return std::nullopt;
}

SymbolicPoint name_of(SharedPoint p, std::uint32_t f, const InputComplex::Indices& vf, std::uint32_t g,
                      const InputComplex::Indices& vg) {
  using Kind = Feature::Kind;
  const auto at = [](const InputComplex::Indices& v, int i) { return v[static_cast<std::size_t>(i)]; };
  const int i = p.on_f.index, k = p.on_g.index;
  if (p.on_f.kind == Kind::vertex) return SymbolicPoint::input(at(vf, i));
  if (p.on_g.kind == Kind::vertex) return SymbolicPoint::input(at(vg, k));
  if (p.on_f.kind == Kind::edge && p.on_g.kind == Kind::edge)
    return SymbolicPoint::edge_edge(at(vf, i), at(vf, next(i)), at(vg, k), at(vg, next(k)));
  if (p.on_f.kind == Kind::edge) return SymbolicPoint::edge_face(at(vf, i), at(vf, next(i)), g);
  return SymbolicPoint::edge_face(at(vg, k), at(vg, next(k)), f);
}

}  // namespace strata
