#include "core/select/sheet_windings.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace strata {

Sheets::Sheets(const InputComplex& input, const EmbeddedStars& stars, const Shells& patches,
               std::span<const Constraint> constraints)
    : patches_(patches),
      is_free_(input.vertex_count()),
      is_subdivided_(input.face_count()),
      first_(patches.count, no_face) {
  for (std::uint32_t v = 0; v < is_free_.size(); ++v) is_free_[v] = stars.at(v);
  for (const Constraint& c : constraints) {
    is_subdivided_[c.face] = true;
    for (const PointId p : {c.tail, c.head})
      if (c.kind != ConstraintKind::coplanar && p < is_free_.size()) is_free_[p] = false;
  }
  for (std::uint32_t f = 0; f < is_subdivided_.size(); ++f)
    if (std::uint32_t& first = first_[patches.of_face[f]]; first == no_face && !is_subdivided_[f]) first = f;
}

std::vector<std::uint32_t> Sheets::asked(const InputComplex& input) const {
  const auto faces = input.faces(0);
  std::vector<bool> is_known(is_free_.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    if (!is_subdivided_[f])
      for (const std::uint32_t v : faces[f]) is_known[v] = is_free_[v];
  std::vector<std::uint32_t> asked;
  for (const std::uint32_t f : first_)
    if (f != no_face) asked.push_back(f);
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    if (is_subdivided_[f] && std::none_of(faces[f].begin(), faces[f].end(), [&](auto v) { return is_known[v]; }))
      asked.push_back(f);
  return asked;
}

SheetWindings::SheetWindings(const InputComplex& input, Sheets sheets, const WindingOracle& oracle,
                             const Monitor& monitor)
    : sheets_(std::move(sheets)), of_patch_(sheets_.patches().count, 0), of_vertex_(input.vertex_count(), unknown) {
  tbb::parallel_for(std::size_t{0}, of_patch_.size(), [&](std::size_t p) {
    monitor.check();
    const std::uint32_t face = sheets_.first_faces()[p];
    if (face == Sheets::no_face) return;
    of_patch_[p] = oracle.above(face, make_point(input, SymbolicPoint::weighted(face, 1)), {&face, 1})[0];
  });
  const auto faces = input.faces(0);
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    if (!sheets_.is_subdivided(f))
      for (const std::uint32_t v : faces[f])
        if (sheets_.is_free(v)) of_vertex_[v] = of_patch_[sheets_.patches().of_face[f]];
}

std::optional<std::int32_t> SheetWindings::above_vertex(std::uint32_t vertex) const {
  return of_vertex_[vertex] == unknown ? std::nullopt : std::optional(of_vertex_[vertex]);
}

}  // namespace strata
