#pragma once
#include <vector>

#include "strata/contact.h"
#include "support/shapes.h"
#include "support/transform.h"

/// Two parts at a time, and boxes.
namespace strata::contact::test_parts {

inline Assembly pair(const Solid& a, const Solid& b) {
  const Solid both[] = {a, b};
  return Assembly(both);
}
inline Relation relation(const Solid& a, const Solid& b) { return pair(a, b).relation(0, 1); }
inline ContactRegion region(const Solid& a, const Solid& b) { return pair(a, b).contact_region(0, 1); }
inline Nearest nearest(const Solid& a, const Solid& b) { return pair(a, b).nearest(0, 1); }
inline Solid box(const Vertex& lower, const Vertex& upper) { return Solid(test::box(lower, upper)); }

/// The number of facets, edges and vertices of a contact.
inline std::vector<std::size_t> counts(const ContactRegion& r) {
  return {r.facets.size(), r.edges.size(), r.vertices.size()};
}

}  // namespace strata::contact::test_parts
