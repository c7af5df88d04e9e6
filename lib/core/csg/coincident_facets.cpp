#include "core/csg/coincident_facets.h"

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_map>
#include <utility>

#include "core/kernel/disjoint_sets.h"

namespace strata {
namespace {

/// More operands than this in one arrangement cost more than a second round.
constexpr std::size_t most_in_group = 32;

std::uint64_t hash_of(const Vertex& p) {
  std::uint64_t h = 0;
  for (const double x : p)
    h = (h ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15u + (h >> 29);  // -0 is 0
  return h ^ h >> 32;
}

/// The operands whose box meets that of another one.
std::vector<std::uint32_t> with_neighbours(std::span<const OperandBox> united) {
  std::vector<OperandBox> sorted(united.begin(), united.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const OperandBox& a, const OperandBox& b) { return a.box.lower[0] < b.box.lower[0]; });
  std::vector<bool> has_neighbour(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (std::size_t k = i + 1; k < sorted.size() && sorted[k].box.lower[0] <= sorted[i].box.upper[0]; ++k)
      if (sorted[i].box.overlaps(sorted[k].box)) has_neighbour[i] = has_neighbour[k] = true;
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    if (has_neighbour[i]) found.push_back(sorted[i].operand);
  std::sort(found.begin(), found.end());
  return found;
}

/// Finds pairs of coincident faces with opposite orientation in a hash table of all faces.
class Walls {
 public:
  Walls(std::span<const Operand> operands, std::span<const std::uint32_t> united)
      : operands_(operands), sets_(operands.size()) {
    std::size_t faces = 0;
    for (const std::uint32_t o : united) faces += operands[o].mesh.triangles.size();
    slots_.resize(std::bit_ceil(2 * faces + 1));
    for (const std::uint32_t o : united) add(o);
  }

  [[nodiscard]] std::uint32_t set_of(std::uint32_t operand) { return sets_.find(operand); }
  [[nodiscard]] bool any() const { return any_; }

 private:
  struct Face {
    std::uint64_t key = 0;
    std::uint32_t operand = none, face = 0;
  };
  static constexpr std::uint32_t none = 0xffffffffu;

  void add(std::uint32_t operand) {
    const MeshView& mesh = operands_[operand].mesh;
    hashes_.clear();
    for (const Vertex& v : mesh.vertices) hashes_.push_back(hash_of(v));
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
      std::uint64_t key = 0;
      for (const std::uint32_t v : mesh.triangles[f]) {
        if (v >= hashes_.size()) return;  // refused later
        key += hashes_[v];
      }
      add(Face{key, operand, f});
    }
  }
  void add(const Face& f) {
    for (std::size_t s = f.key;; ++s) {
      Face& slot = slots_[s & (slots_.size() - 1)];
      if (slot.operand == none) {
        slot = f;
        return;
      }
      if (slot.key != f.key || slot.operand == f.operand || !are_opposite(slot, f)) continue;
      sets_.unite(slot.operand, f.operand);
      any_ = true;
    }
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
  DisjointSets<std::uint32_t> sets_;
  std::vector<Face> slots_;  ///< a hash table with open addresses
  std::vector<std::uint64_t> hashes_;
  bool any_ = false;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> groups_with_coincident_facets(std::span<const Operand> operands,
                                                                      std::span<const OperandBox> united) {
  const std::vector<std::uint32_t> near = with_neighbours(united);
  if (near.empty()) return {};
  Walls walls(operands, near);
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
