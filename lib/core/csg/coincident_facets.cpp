#include "core/csg/coincident_facets.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "core/containers/box_sweep.h"
#include "core/containers/hash_index.h"
#include "core/containers/point_hash.h"
#include "core/exact/pace.h"
#include "core/kernel/disjoint_sets.h"

namespace strata {
namespace {

/// More operands than this in one arrangement cost more than a second round.
constexpr std::size_t most_in_group = 32;

/// The operands whose box meets that of another one.
std::vector<std::uint32_t> with_neighbours(std::span<const OperandBox> united) {
  std::vector<Box> boxes;
  for (const OperandBox& b : united) boxes.push_back(b.box);
  std::vector<bool> has_neighbour(boxes.size());
  for_each_overlapping_pair(boxes,
                            [&](std::uint32_t a, std::uint32_t b) { has_neighbour[a] = has_neighbour[b] = true; });
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (has_neighbour[i]) found.push_back(united[i].operand);
  std::sort(found.begin(), found.end());
  return found;
}

/// Finds pairs of coincident faces with opposite orientation in a hash table of all faces.
class Walls {
 public:
  Walls(std::span<const Operand> operands, std::span<const std::uint32_t> united, const Monitor& monitor)
      : operands_(operands), monitor_(monitor), sets_(operands.size()) {
    std::size_t faces = 0;
    for (const std::uint32_t o : united) faces += operands[o].mesh.triangles.size();
    faces_.reserve(faces);
    table_ = HashIndex(faces);
    monitor.check();
    for (const std::uint32_t o : united) add(o);
  }

  [[nodiscard]] std::uint32_t set_of(std::uint32_t operand) { return sets_.find(operand); }
  [[nodiscard]] bool any() const { return any_; }

 private:
  struct Face {
    std::uint64_t key = 0;
    std::uint32_t operand = 0, face = 0;
  };

  void add(std::uint32_t operand) {
    const MeshView& mesh = operands_[operand].mesh;
    hashes_.clear();
    Pace pace(monitor_);
    for (const Vertex& v : mesh.vertices) {
      pace.step();
      hashes_.push_back(hash_of(v));
    }
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
      pace.step();
      std::uint64_t key = 0;
      for (const std::uint32_t v : mesh.triangles[f]) {
        if (v >= hashes_.size()) return;  // refused later
        key += hashes_[v];
      }
      add(Face{key, operand, f});
    }
  }
  /// Every face is kept, equal or not.
  void add(const Face& f) {
    table_.find_or_add(f.key, static_cast<std::uint32_t>(faces_.size()), [&](std::uint32_t number) {
      const Face& known = faces_[number];
      if (known.key != f.key || known.operand == f.operand || !are_opposite(known, f)) return false;
      sets_.unite(known.operand, f.operand);
      any_ = true;
      return false;
    });
    faces_.push_back(f);
  }

  [[nodiscard]] std::array<Vertex, 3> corners(const Face& f) const {
    const MeshView& mesh = operands_[f.operand].mesh;
    const Triangle& t = mesh.triangles[f.face];
    return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
  }
  [[nodiscard]] bool are_opposite(const Face& f, const Face& g) const {
    const auto a = corners(f), b = corners(g);
    for (std::size_t i = 0; i < 3; ++i)
      if (a[0] == b[i] && a[1] == b[(i + 2) % 3] && a[2] == b[(i + 1) % 3]) return true;
    return false;
  }

  std::span<const Operand> operands_;
  const Monitor& monitor_;
  DisjointSets<std::uint32_t> sets_;
  std::vector<Face> faces_;
  HashIndex table_;  ///< numbers of faces_
  std::vector<std::uint64_t> hashes_;
  bool any_ = false;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> groups_with_coincident_facets(std::span<const Operand> operands,
                                                                      std::span<const OperandBox> united,
                                                                      const Monitor& monitor) {
  const std::vector<std::uint32_t> near = with_neighbours(united);
  if (near.empty()) return {};
  Walls walls(operands, near, monitor);
  if (!walls.any()) return {};
  std::unordered_map<std::uint32_t, std::size_t> last_group;  // per set
  std::vector<std::vector<std::uint32_t>> groups;
  for (const std::uint32_t o : near) {
    const auto [at, is_new] = last_group.try_emplace(walls.set_of(o), groups.size());
    if (is_new || groups[at->second].size() == most_in_group) {
      at->second = groups.size();
      groups.emplace_back();
    }
    groups[at->second].push_back(o);
  }
  std::erase_if(groups, [&](const auto& g) { return g.size() < 2 || 2 * g.size() > operands.size(); });
  return groups;
}

}  // namespace strata
