#pragma once
#include <cstdint>

#include "core/containers/box_tree.h"
#include "core/kernel/box.h"
#include "core/kernel/input_complex.h"

namespace strata::contact {

/// The box one step of doubles further out.
[[nodiscard]] Box widened(Box box);

/// A box that holds a face wherever its vertices are: one step of doubles outwards where they are rational.
[[nodiscard]] inline Box box_of_face(const InputComplex& input, std::uint32_t part, std::uint32_t face) {
  const auto points = input.points(part);
  Box box;
  for (const std::uint32_t v : input.faces(part)[face - input.first_face(part)]) box.include(points[v]);
  return input.has_rationals() && !input.has_doubles(input.face(face)) ? widened(box) : box;
}
/// The same for a vertex.
[[nodiscard]] Box box_of_vertex(const InputComplex& input, std::uint32_t vertex);

/// A tree over the faces of one part, by their global numbers, in the order of a Z-curve. Decides nothing. O(n).
[[nodiscard]] BoxTree tree_of_part(const InputComplex& input, std::uint32_t part);

}  // namespace strata::contact
