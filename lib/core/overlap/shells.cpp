#include "core/overlap/shells.h"

#include <span>
#include <utility>
#include <vector>

#include "core/kernel/disjoint_sets.h"
#include "core/mesh/edge_table.h"

namespace strata {
namespace {

constexpr std::uint32_t no_number = 0xffffffffu;

/// Sets of faces. Around an embedded star, faces are connected across edges that two of them have, so its vertex stands
/// for all of them; a face that crosses others, or is in no such star, stands for itself.
class ConnectedFaces {
 public:
  ConnectedFaces(std::span<const Triangle> faces, std::size_t vertex_count, const EmbeddedStars& stars,
                 const std::vector<bool>& crossing)
      : size_(vertex_count + faces.size()), sets_(size_) {
    const auto first_face = static_cast<std::uint32_t>(vertex_count);
    member_.reserve(faces.size());
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      const bool crosses = !crossing.empty() && crossing[f];
      std::uint32_t embedded = 0, member = first_face + f;
      for (const std::uint32_t v : faces[f]) {
        if (!stars.at(v)) continue;
        ++embedded;
        if (crosses) continue;
        if (member < first_face) sets_.unite(member, v);
        member = v;
      }
      member_.push_back(member);
      if (embedded < 2 && !repeats_vertex(faces[f])) rest_.push_back(f);
    }
  }

  /// Faces with an edge both of whose ends are not in embedded stars. All faces of such an edge are among them.
  [[nodiscard]] const std::vector<std::uint32_t>& rest() const { return rest_; }
  void unite(std::uint32_t face, std::uint32_t other) { sets_.unite(member_[face], member_[other]); }

  /// The number of each face's set, by first faces.
  [[nodiscard]] std::vector<std::uint32_t> numbers(std::uint32_t& count) && {
    std::vector<std::uint32_t> number(size_, no_number);
    for (std::uint32_t& member : member_) {
      std::uint32_t& n = number[sets_.find(member)];
      if (n == no_number) n = count++;
      member = n;
    }
    return std::move(member_);
  }

 private:
  std::size_t size_;
  DisjointSets<std::uint32_t> sets_;
  std::vector<std::uint32_t> member_;  ///< of each face: what stands for it, vertices first
  std::vector<std::uint32_t> rest_;
};

}  // namespace

Shells find_patches(const InputComplex& input, const EmbeddedStars& stars, const std::vector<bool>& crossing) {
  const auto faces = input.faces(0);
  const auto crosses = [&](std::uint32_t f) { return !crossing.empty() && crossing[f]; };
  ConnectedFaces connected(faces, input.points(0).size(), stars, crossing);
  const std::vector<std::uint32_t>& rest = connected.rest();
  std::vector<Triangle> triangles;
  triangles.reserve(rest.size());
  for (const std::uint32_t f : rest) triangles.push_back(faces[f]);
  Shells result;
  for_each_edge(edge_table(triangles, input.points(0).size()), [&](std::span<const EdgeUse> uses) {
    result.share_edges = result.share_edges || uses.size() > 2;
    if (uses.size() != 2) return;
    const std::uint32_t f = rest[uses[0].triangle], g = rest[uses[1].triangle];
    if (!crosses(f) && !crosses(g)) connected.unite(f, g);
  });
  result.of_face = std::move(connected).numbers(result.count);
  return result;
}

Shells find_shells(const InputComplex& input, const EmbeddedStars& stars) { return find_patches(input, stars, {}); }

}  // namespace strata
