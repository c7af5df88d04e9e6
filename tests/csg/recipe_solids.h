#pragma once
#include "strata/expression.h"
#include "support/recipe.h"

namespace strata::test {

[[nodiscard]] inline Transform transform_of(const Affine& map) {
  std::array<Transform::Row, 3> rows;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 4; ++c) rows[r][c] = map.columns[c][r];
  return Transform(rows);
}

[[nodiscard]] inline std::vector<Solid> solids_of(const Recipe& recipe) {
  std::vector<Solid> solids;
  for (const ExactMesh& mesh : recipe.solids) solids.emplace_back(mesh);
  return solids;
}

/// All of it as one expression; solids are named as in the recipe's text.
[[nodiscard]] inline Expression expression_of(const Recipe& recipe, const std::vector<Solid>& solids) {
  using Kind = Recipe::Kind;
  return value_of<Expression>(
      recipe, [&](std::uint32_t n) { return Expression(solids[n], std::string("s").append(std::to_string(n))); },
      [](Kind kind, const Expression& a, const Expression& b) {
        return kind == Kind::union_         ? a | b
               : kind == Kind::intersection ? a & b
               : kind == Kind::difference   ? a - b
                                            : a ^ b;
      },
      [](const Expression& a) { return ~a; },
      [](const Expression& a, const Affine& map) { return a.transformed(transform_of(map)); });
}

/// A solid or, flagged, everything else.
struct SolidOrRest {
  Solid solid;
  bool is_rest = false;
};

[[nodiscard]] inline SolidOrRest intersection_of(const SolidOrRest& a, const SolidOrRest& b) {
  if (a.is_rest && b.is_rest) return {a.solid | b.solid, true};
  if (b.is_rest) return {a.solid - b.solid, false};
  return a.is_rest ? SolidOrRest{b.solid - a.solid, false} : SolidOrRest{a.solid & b.solid, false};
}

/// One operation of two solids after the other: every step a solid that is mapped, where it is, as a mesh.
[[nodiscard]] inline Solid by_steps(const Recipe& recipe, const std::vector<Solid>& solids) {
  using Kind = Recipe::Kind;
  const auto rest_of = [](const SolidOrRest& a) { return SolidOrRest{a.solid, !a.is_rest}; };
  return value_of<SolidOrRest>(
             recipe, [&](std::uint32_t n) { return SolidOrRest{solids[n]}; },
             [&](Kind kind, const SolidOrRest& a, const SolidOrRest& b) -> SolidOrRest {
               if (kind == Kind::intersection) return intersection_of(a, b);
               if (kind == Kind::difference) return intersection_of(a, rest_of(b));
               if (kind == Kind::union_) return rest_of(intersection_of(rest_of(a), rest_of(b)));
               return {a.solid ^ b.solid, a.is_rest != b.is_rest};
             },
             rest_of,
             [](const SolidOrRest& a, const Affine& map) -> SolidOrRest {
               return {Solid(transform(a.solid.exact_mesh(), transform_of(map), Placement::exact)), a.is_rest};
             })
      .solid;
}

}  // namespace strata::test
