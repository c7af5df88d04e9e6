#pragma once
#include <cstdint>
#include <string>

#include "strata/measure.h"
#include "strata/mesh.h"
#include "strata/rational.h"
#include "verify/non_manifold.h"

namespace verify {

/// What is known of a solid's boundary from its canonical form alone: equal for equal point sets.
struct FormFacts {
  std::uint64_t vertices = 0, edges = 0, facets = 0;
  std::uint64_t hash = 0;
  strata::Rational edge_length;  ///< of all edges; correct to about 15 digits

  [[nodiscard]] bool same_form(const FormFacts& other) const {
    return vertices == other.vertices && edges == other.edges && facets == other.facets && hash == other.hash;
  }
};

/// Facts about a closed boundary that survive re-triangulation.
struct Facts {
  strata::Rational volume;  ///< exact
  strata::Rational area;    ///< correct to about 15 digits, at any scale
  FormFacts form;
  std::uint64_t components = 0;  ///< of the boundary: a cavity is one of its own
  std::int64_t euler = 0;
  NonManifold touching;
};

[[nodiscard]] FormFacts facts_of(const strata::CanonicalForm& form);

/// Requires a closed mesh.
[[nodiscard]] Facts facts_of(const strata::ExactMesh& mesh);

/// A fraction as text. Long ones, of more than 1,000 characters, as "sha256:" and the digest of that text.
[[nodiscard]] std::string volume_text(const strata::Rational& volume);

/// Surface area at any scale: found on an exact copy of moderate size.
[[nodiscard]] strata::Rational area_of(const strata::ExactMesh& mesh);

}  // namespace verify
