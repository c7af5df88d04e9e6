#pragma once
#include "strata/planar/region.h"

namespace strata::plane {

/// How two regions are to each other (source document, 3.4).
enum class Relation {
  apart,        ///< their closures have no common point
  contact,      ///< their boundaries have, their interiors have not
  interfering,  ///< their interiors have
};

/// The contact region A.b n B.b of two regions that do not interfere: closed edges, as long as they go straight and
/// nothing else comes in, and isolated points. Both are exact, in lexicographic order.
struct Contact {
  Relation relation = Relation::apart;
  std::vector<std::array<RationalPlacement, 2>> edges;  ///< the lesser end first
  std::vector<RationalPlacement> points;
};

/// O((n + k) log n). Of interfering regions neither edges nor points are told.
[[nodiscard]] Contact contact_of(const Region& a, const Region& b);

}  // namespace strata::plane
