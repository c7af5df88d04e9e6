// Solids beside each other: layers as seen from an origin, contacts.
#include "call.h"
#include "handle.h"
#include "strata/contact.h"
#include "strata/query.h"

using namespace strata;
using namespace strata::web;

namespace {

void append(const RationalPoint& p) {
  for (const Rational& x : p) answer().reals.push_back(to_nearest_double(x));
}

Monitor monitor_of(const Options& options) { return Monitor(options.cancel, &options.progress); }

/// Of parts that touch: coordinates and triangles of the facets of their contact.
void append(const contact::ContactRegion& region) {
  const contact::FacetTriangles facets = contact::triangles_of(region);
  auto& [bytes, reals, ints, error] = answer();
  reals.push_back(region.area());
  for (const RationalPoint& p : region.points) append(p);
  ints.push_back(static_cast<unsigned>(region.points.size()));
  ints.push_back(static_cast<unsigned>(facets.triangles.size()));
  for (const Triangle& t : facets.triangles) ints.insert(ints.end(), t.begin(), t.end());
}

}  // namespace

/// As seen from a point, along a direction, or from a point that is chosen: kind 0, 1 or 2. The answer has the corners
/// of all pieces, back to front, and for each layer how many pieces it has; behind these the solid of each piece.
STRATA_WEB(layers)
unsigned strata_layers(const Handle* handles, std::size_t count, unsigned kind, double x, double y, double z) {
  return guarded([&] {
    std::vector<ExactMesh> meshes;
    for (const Solid& solid : solids_of(handles, count)) meshes.push_back(solid.exact_mesh());
    const Scene scene(std::move(meshes));
    const Origin origin = kind == 0   ? Origin::point({x, y, z})
                          : kind == 1 ? Origin::direction({x, y, z})
                                      : choose_origin(scene);
    const Options options = watched();
    const LayerDecomposition layers(scene, origin, monitor_of(options));
    auto& ints = answer().ints;
    for (std::uint32_t n = 1; n <= layers.layer_count(); ++n)
      ints.push_back(static_cast<unsigned>(layers.layer_pieces(n).size()));
    for (const std::uint32_t piece : layers.back_to_front()) {
      for (const RationalPoint& corner : layers.triangle(piece)) append(corner);
      ints.push_back(scene.solid_of(layers.face_of(piece)));
    }
    return layers.layer_count();
  });
}

/// Every pair that is not apart. The answer has the numbers of both, 1 if they touch or 2 if they interfere, and, where
/// they touch, how many points and triangles the contact has, and its triangles; its area, and its points.
STRATA_WEB(contacts) unsigned strata_contacts(const Handle* handles, std::size_t count) {
  return guarded([&] {
    const contact::Assembly assembly(solids_of(handles, count));
    const Options options = watched();
    const Monitor monitor = monitor_of(options);
    const std::vector<contact::RelatedPair> pairs = assembly.pairs(monitor);
    for (const auto& [a, b, relation] : pairs) {
      answer().ints.insert(answer().ints.end(), {a, b, static_cast<unsigned>(relation)});
      if (relation == contact::Relation::contact) append(assembly.contact_region(a, b, monitor));
    }
    return static_cast<unsigned>(pairs.size());
  });
}
