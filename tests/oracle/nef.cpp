#include "oracle/nef.h"

#include <CGAL/Nef_2/debug.h>  // minkowski_sum_3.h uses what it does not include
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/minkowski_sum_3.h>

#include <algorithm>
#include <deque>
#include <tuple>

#include "oracle/nef_parts.h"
#include "oracle/sheets.h"

namespace strata::oracle {
namespace {

using Kernel = Nef::Kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

/// Hands a sheet to CGAL's polyhedron, facet by facet.
class SheetBuilder : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  explicit SheetBuilder(const Sheet& sheet) : sheet_(sheet) {}

  void operator()(Polyhedron::HalfedgeDS& target) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(target, false);
    builder.begin_surface(sheet_.points.size(), sheet_.triangles.size());
    for (const RationalPoint& p : sheet_.points) builder.add_vertex(to_cgal(p));
    for (const Triangle& t : sheet_.triangles) builder.add_facet(t.begin(), t.end());
    builder.end_surface();
  }

 private:
  const Sheet& sheet_;
};

Nef to_nef(const Sheet& sheet) {
  Polyhedron polyhedron;
  SheetBuilder builder(sheet);
  polyhedron.delegate(builder);
  if (!polyhedron.is_closed() || polyhedron.size_of_facets() != sheet.triangles.size()) {
    throw OracleFailed("a sheet is no closed polyhedron");
  }
  return Nef(polyhedron);
}

/// Points inside an odd number of sheets. Neighbours in the list are joined first, so that operands stay small.
Nef parity(const std::vector<Sheet>& sheets) {
  std::deque<Nef> queue;
  for (const Sheet& sheet : sheets) queue.push_back(to_nef(sheet));
  if (queue.empty()) return Nef(Nef::EMPTY);
  while (queue.size() > 1) {
    queue.push_back(queue[0] ^ queue[1]);
    queue.pop_front();
    queue.pop_front();
  }
  return queue.front();
}

/// The same as combine(), by way of other operations.
Nef combine_otherwise(Operation operation, const Nef& a, const Nef& b) {
  switch (operation) {
    case Operation::union_:
      return (a - b) + b;
    case Operation::intersection:
      return a - (a - b);
    case Operation::difference:
      return a ^ (a * b);
    case Operation::symmetric_difference:
      return (a + b) - (a * b);
  }
  throw OracleFailed("unknown operation");
}

/// All facets with the inside behind them and the outside in front.
std::vector<ExactFacet> boundary_facets(const Nef& nef) {
  std::vector<ExactFacet> facets;
  for (auto f = nef.halffacets_begin(); f != nef.halffacets_end(); ++f) {
    if (f->incident_volume()->mark() || !f->twin()->incident_volume()->mark()) continue;
    facets.push_back(facet_of(f));
  }
  return facets;
}

/// The cells of a set without volume. Of a facet one side is listed.
void list_cells(const Nef& set, NefContact& cells) {
  for (auto f = set.halffacets_begin(); f != set.halffacets_end(); ++f)
    if (f->mark() && &*f < &*f->twin()) cells.facets.push_back(facet_of(f));
  for (auto e = set.halfedges_begin(); e != set.halfedges_end(); ++e)
    if (e->mark() && &*e < &*e->twin() && e->out_sedge() == Nef::SHalfedge_const_handle())
      cells.edges.push_back({from_cgal(e->source()->point()), from_cgal(e->twin()->source()->point())});
  for (auto v = set.vertices_begin(); v != set.vertices_end(); ++v)
    if (v->mark() && v->svertices_begin() == v->svertices_end()) cells.vertices.push_back(from_cgal(v->point()));
}

}  // namespace

struct NefSolid::Data {
  Nef nef;
};

NefSolid::NefSolid(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

NefSolid::NefSolid(const ExactMesh& mesh) {
  data_ = guarded([&] {
    const auto sheets = manifold_sheets(mesh);
    return std::make_shared<const Data>(Data{parity(sheets ? *sheets : tetrahedra_over_faces(mesh))});
  });
}

NefSolid NefSolid::from_tetrahedra(const ExactMesh& mesh) {
  return NefSolid(guarded([&] { return std::make_shared<const Data>(Data{parity(tetrahedra_over_faces(mesh))}); }));
}

std::vector<ExactFacet> NefSolid::facets() const {
  return guarded([&] { return boundary_facets(data_->nef); });
}

NefSolid nef_combine(Operation operation, std::span<const NefSolid> operands, Way way) {
  std::vector<const Nef*> list;
  for (const NefSolid& solid : operands) list.push_back(&solid.data_->nef);
  if (way == Way::backwards && !list.empty()) {
    std::reverse(list.begin() + (operation == Operation::difference ? 1 : 0), list.end());
  }
  return NefSolid(guarded([&] {
    Nef result = list.empty() ? Nef(Nef::EMPTY) : *list[0];
    for (std::size_t i = 1; i < list.size(); ++i) {
      result = way == Way::other_formula ? combine_otherwise(operation, result, *list[i])
                                         : combine(operation, result, *list[i]);
      if (way == Way::regularized) result = result.regularization();
    }
    return std::make_shared<const NefSolid::Data>(NefSolid::Data{result});
  }));
}

NefSolid nef_minkowski_sum(const NefSolid& a, const NefSolid& b) {
  return NefSolid(guarded([&] {
    Nef x = a.data_->nef, y = b.data_->nef;  // they are changed
    return std::make_shared<const NefSolid::Data>(NefSolid::Data{CGAL::minkowski_sum_3(x, y)});
  }));
}

NefContact nef_contact(const NefSolid& a, const NefSolid& b) {
  return guarded([&] {
    const Nef x = a.data_->nef.regularization(), y = b.data_->nef.regularization();
    NefContact contact;
    contact.interiors_meet = !(x.interior() * y.interior()).is_empty();
    if (!contact.interiors_meet) list_cells(x.boundary() * y.boundary(), contact);
    return contact;
  });
}

CanonicalForm nef_boolean(Operation operation, std::span<const ExactMesh> operands, Way way) {
  const std::vector<NefSolid> solids(operands.begin(), operands.end());
  return canonical_form(nef_combine(operation, solids, way).facets());
}

Rational facet_volume(const std::vector<ExactFacet>& facets) {
  Rational six = 0;
  for (const ExactFacet& facet : facets) {
    for (const auto& loop : facet) {
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        const auto& [a, b, c] = std::tie(loop[0], loop[i], loop[i + 1]);
        six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
      }
    }
  }
  return six / 6;
}

}  // namespace strata::oracle
