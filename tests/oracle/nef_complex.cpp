#include "oracle/nef_complex.h"

#include <CGAL/Cartesian.h>
#include <CGAL/Extended_cartesian.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Nef_polyhedron_2.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>

#include <stdexcept>

#include "core/exact/big_integer.h"

namespace strata::oracle {
namespace {

using Number = CGAL::Gmpq;

Number to_cgal(const Rational& q) {
  Number result;
  mpq_set(result.mpq(), native(q).backend().data());
  return result;
}
Rational to_strata(const Number& x) {
  Rational result;
  mpq_set(native(result).backend().data(), x.mpq());
  return result;
}

using Space = CGAL::Cartesian<Number>;
using Nef3 = CGAL::Nef_polyhedron_3<Space>;
using Polyhedron = CGAL::Polyhedron_3<Space>;
using Nef2 = CGAL::Nef_polyhedron_2<CGAL::Extended_cartesian<Number>>;

/// The mark of the cell that a point lies in.
bool is_in(const Nef3& nef, const Space::Point_3& p) {
  const auto place = nef.locate(p);
  Nef3::Vertex_const_handle v;
  Nef3::Halfedge_const_handle e;
  Nef3::Halffacet_const_handle f;
  Nef3::Volume_const_handle c;
  if (CGAL::assign(v, place)) return v->mark();
  if (CGAL::assign(e, place)) return e->mark();
  if (CGAL::assign(f, place)) return f->mark();
  if (!CGAL::assign(c, place)) throw std::logic_error("a point is nowhere");
  return c->mark();
}

class Builder : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  explicit Builder(const Mesh& mesh) : mesh_(mesh) {}
  void operator()(Polyhedron::HalfedgeDS& target) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(target, false);
    builder.begin_surface(mesh_.vertices.size(), mesh_.triangles.size());
    for (const Vertex& p : mesh_.vertices) builder.add_vertex(Space::Point_3(p[0], p[1], p[2]));
    for (const Triangle& t : mesh_.triangles) builder.add_facet(t.begin(), t.end());
    builder.end_surface();
  }

 private:
  const Mesh& mesh_;
};

Nef3 tetrahedron(const std::array<Space::Point_3, 4>& p) {
  Polyhedron polyhedron;
  polyhedron.make_tetrahedron(p[0], p[1], p[2], p[3]);
  if (CGAL::orientation(p[0], p[1], p[2], p[3]) == CGAL::POSITIVE) polyhedron.inside_out();
  Nef3 nef(polyhedron);
  return nef;
}

/// Lower simplices are common parts of higher ones on either side.
Nef3 closed_simplex(std::vector<Space::Point_3> p) {
  if (p.size() == 4) {
    const Nef3 nef = tetrahedron({p[0], p[1], p[2], p[3]});
    // The bounded part, however the polyhedron was turned.
    const auto middle = CGAL::centroid(p[0], p[1], p[2], p[3]);
    return is_in(nef, middle) ? nef : Nef3(nef.complement().closure());
  }
  std::vector<Space::Point_3> q = p;
  if (p.size() == 3) {
    const auto normal = CGAL::cross_product(p[1] - p[0], p[2] - p[0]);
    p.push_back(p[0] + normal);
    q.push_back(p[0] - normal);
  } else if (p.size() == 2) {
    const auto d = p[1] - p[0];
    const Space::Vector_3 aside = d.y() != 0 || d.z() != 0 ? Space::Vector_3(1, 0, 0) : Space::Vector_3(0, 1, 0);
    p.push_back(p[0] + aside);
    q.push_back(p[0] - aside);
  } else {
    p.push_back(p[0] + Space::Vector_3(1, 0, 0));
    q.push_back(p[0] - Space::Vector_3(1, 0, 0));
  }
  return closed_simplex(p) * closed_simplex(q);
}

Nef3 open_simplex(const std::vector<Space::Point_3>& p) {
  Nef3 nef = closed_simplex(p);
  if (p.size() == 1) return nef;
  if (p.size() == 4) return nef.interior();
  for (std::size_t i = 0; i < p.size(); ++i) {
    std::vector<Space::Point_3> facet = p;
    facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
    nef = nef - closed_simplex(facet);
  }
  return nef;
}

}  // namespace

template <>
struct NefComplex<3>::Data {
  Nef3 nef;
};
template <>
struct NefComplex<2>::Data {
  Nef2 nef;
};

template <>
NefComplex<3> NefComplex<3>::simplex(std::span<const Vertex> corners, bool closed) {
  std::vector<Space::Point_3> p;
  for (const Vertex& c : corners) p.emplace_back(c[0], c[1], c[2]);
  return NefComplex(std::make_shared<Data>(Data{closed ? closed_simplex(p) : open_simplex(p)}));
}

template <>
NefComplex<2> NefComplex<2>::simplex(std::span<const Vertex> corners, bool closed) {
  std::vector<Nef2::Point> p;
  for (const Vertex& c : corners) p.emplace_back(Number(c[0]), Number(c[1]));
  if (p.size() == 3 &&
      CGAL::Cartesian<Number>::Orientation_2()({Number(corners[0][0]), Number(corners[0][1])},
                                               {Number(corners[1][0]), Number(corners[1][1])},
                                               {Number(corners[2][0]), Number(corners[2][1])}) == CGAL::RIGHT_TURN)
    std::swap(p[1], p[2]);
  Nef2 nef(p.begin(), p.end(), closed || p.size() < 3 ? Nef2::INCLUDED : Nef2::EXCLUDED);
  if (!closed && p.size() == 2)
    for (const Nef2::Point& end : p) nef = nef - Nef2(&end, &end + 1, Nef2::INCLUDED);
  return NefComplex(std::make_shared<Data>(Data{nef}));
}

template <>
NefComplex<3> NefComplex<3>::solid(const Mesh& mesh) {
  Polyhedron polyhedron;
  Builder builder(mesh);
  polyhedron.delegate(builder);
  return NefComplex(std::make_shared<Data>(Data{Nef3(polyhedron)}));
}

#define STRATA_OPERATIONS(D)                                                        \
  template <>                                                                       \
  NefComplex<D> NefComplex<D>::unite(const NefComplex& other) const {               \
    return NefComplex(std::make_shared<Data>(Data{data_->nef + other.data_->nef})); \
  }                                                                                 \
  template <>                                                                       \
  NefComplex<D> NefComplex<D>::intersect(const NefComplex& other) const {           \
    return NefComplex(std::make_shared<Data>(Data{data_->nef * other.data_->nef})); \
  }                                                                                 \
  template <>                                                                       \
  NefComplex<D> NefComplex<D>::subtract(const NefComplex& other) const {            \
    return NefComplex(std::make_shared<Data>(Data{data_->nef - other.data_->nef})); \
  }                                                                                 \
  template <>                                                                       \
  NefComplex<D> NefComplex<D>::exclude(const NefComplex& other) const {             \
    return NefComplex(std::make_shared<Data>(Data{data_->nef ^ other.data_->nef})); \
  }                                                                                 \
  template <>                                                                       \
  NefComplex<D> NefComplex<D>::complement() const {                                 \
    return NefComplex(std::make_shared<Data>(Data{data_->nef.complement()}));       \
  }                                                                                 \
  template <>                                                                       \
  NefComplex<D> NefComplex<D>::interior() const {                                   \
    return NefComplex(std::make_shared<Data>(Data{data_->nef.interior()}));         \
  }                                                                                 \
  template <>                                                                       \
  NefComplex<D> NefComplex<D>::closure() const {                                    \
    return NefComplex(std::make_shared<Data>(Data{data_->nef.closure()}));          \
  }                                                                                 \
  template <>                                                                       \
  NefComplex<D> NefComplex<D>::boundary() const {                                   \
    return NefComplex(std::make_shared<Data>(Data{data_->nef.boundary()}));         \
  }                                                                                 \
  template <>                                                                       \
  NefComplex<D> NefComplex<D>::regularization() const {                             \
    return NefComplex(std::make_shared<Data>(Data{data_->nef.regularization()}));   \
  }
STRATA_OPERATIONS(2)
STRATA_OPERATIONS(3)

template <>
std::array<std::size_t, 4> NefComplex<3>::counts() const {
  const Nef3& n = data_->nef;
  return {n.number_of_vertices(), n.number_of_edges(), n.number_of_facets(), n.number_of_volumes()};
}

template <>
std::array<std::size_t, 4> NefComplex<2>::counts() const {
  const auto explorer = data_->nef.explorer();
  std::array<std::size_t, 4> counts{};
  for (auto v = explorer.vertices_begin(); v != explorer.vertices_end(); ++v)
    counts[0] += explorer.is_standard(v) ? 1 : 0;
  for (auto e = explorer.halfedges_begin(); e != explorer.halfedges_end(); ++e)
    counts[1] += explorer.is_frame_edge(e) ? 0 : 1;
  counts[1] /= 2;
  for (auto f = explorer.faces_begin(); f != explorer.faces_end(); ++f) ++counts[2];
  --counts[2];  // beyond the frame
  return counts;
}

template <>
std::vector<RationalPoint> NefComplex<3>::vertices() const {
  std::vector<RationalPoint> points;
  for (auto v = data_->nef.vertices_begin(); v != data_->nef.vertices_end(); ++v)
    points.push_back({to_strata(v->point().x()), to_strata(v->point().y()), to_strata(v->point().z())});
  return points;
}

template <>
std::vector<RationalPoint> NefComplex<2>::vertices() const {
  const auto explorer = data_->nef.explorer();
  std::vector<RationalPoint> points;
  for (auto v = explorer.vertices_begin(); v != explorer.vertices_end(); ++v)
    if (explorer.is_standard(v))
      points.push_back({to_strata(explorer.point(v).x()), to_strata(explorer.point(v).y()), Rational(0)});
  return points;
}

template <>
bool NefComplex<3>::contains(const RationalPoint& p) const {
  return is_in(data_->nef, Space::Point_3(to_cgal(p[0]), to_cgal(p[1]), to_cgal(p[2])));
}
template <>
bool NefComplex<2>::contains(const RationalPoint& p) const {
  return data_->nef.contains(data_->nef.locate(Nef2::Point(to_cgal(p[0]), to_cgal(p[1]))));
}

}  // namespace strata::oracle
