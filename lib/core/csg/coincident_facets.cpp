#include "core/csg/coincident_facets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>
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
constexpr std::size_t most_facets_together = 32;

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

/// Finds pairs of coincident faces of different operands with opposite orientation. Faces are divided into buckets by a
/// key that does not depend on the order of corners; the faces of a bucket are compared through a hash table.
class Walls {
 public:
  Walls(std::span<const Operand> operands, std::span<const std::uint32_t> united, const Monitor& monitor)
      : operands_(operands), sets_(operands.size()) {
    std::size_t faces = 0;
    for (const std::uint32_t o : united) {
      const std::size_t count = operands[o].mesh.triangles.size();
      for (std::size_t f = 0; f < count; f += block_faces)
        blocks_.push_back({o, static_cast<std::uint32_t>(f), std::min(count - f, block_faces), {}, {}});
      faces += count;
    }
    std::vector<std::vector<Pair>> pairs(faces > block_faces ? most_buckets : 1);
    tbb::parallel_for(std::size_t{0}, blocks_.size(), [&](std::size_t b) {
      monitor.check();
      fill(blocks_[b], pairs.size());
    });
    tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t bucket) {
      monitor.check();
      pairs[bucket] = pairs_of(bucket, Pace(monitor));
    });
    for (const std::vector<Pair>& of_bucket : pairs)
      for (const auto& [a, b] : of_bucket) {
        sets_.unite(a, b);
        any_ = true;
      }
  }

  [[nodiscard]] std::uint32_t set_of(std::uint32_t operand) { return sets_.find(operand); }
  [[nodiscard]] bool any() const { return any_; }

 private:
  static constexpr int bucket_bits = 6;
  static constexpr std::size_t most_buckets = 1 << bucket_bits, block_faces = 1 << 12;

  using Pair = std::pair<std::uint32_t, std::uint32_t>;  // of operands

  struct Face {
    std::uint64_t key;
    std::uint32_t operand, face;
  };
  /// Some successive faces of an operand. When filled: by bucket; those of bucket k begin at begin[k].
  struct Block {
    std::uint32_t operand, first;
    std::size_t count;
    std::vector<Face> faces;
    std::array<std::uint32_t, most_buckets + 1> begin;

    [[nodiscard]] std::span<const Face> bucket(std::size_t k) const {
      return std::span(faces).subspan(begin[k], begin[k + 1] - begin[k]);
    }
  };

  static std::size_t bucket_of(const Face& f, std::size_t buckets) {
    return f.key >> (64 - bucket_bits) & (buckets - 1);
  }

  void fill(Block& block, std::size_t buckets) const {
    const MeshView& mesh = operands_[block.operand].mesh;
    std::vector<Face> faces;
    faces.reserve(block.count);
    for (std::size_t i = 0; i < block.count; ++i) {
      const auto f = static_cast<std::uint32_t>(block.first + i);
      const Triangle& t = mesh.triangles[f];
      if (std::max({t[0], t[1], t[2]}) >= mesh.vertices.size()) break;  // refused later
      faces.push_back({hash_of(mesh.vertices[t[0]]) + hash_of(mesh.vertices[t[1]]) + hash_of(mesh.vertices[t[2]]),
                       block.operand, f});
    }
    block.begin.fill(0);
    for (const Face& f : faces) ++block.begin[bucket_of(f, buckets) + 1];
    std::partial_sum(block.begin.begin(), block.begin.end(), block.begin.begin());
    block.faces.resize(faces.size());
    auto next = block.begin;
    for (const Face& f : faces) block.faces[next[bucket_of(f, buckets)]++] = f;
  }

  /// The operands of opposite faces in a bucket. Every face is kept in the table, equal to another one or not.
  [[nodiscard]] std::vector<Pair> pairs_of(std::size_t bucket, Pace pace) const {
    std::vector<Face> faces;
    for (const Block& block : blocks_) {
      const auto of_block = block.bucket(bucket);
      faces.insert(faces.end(), of_block.begin(), of_block.end());
    }
    std::vector<Pair> pairs;
    HashIndex table(faces.size());
    for (std::uint32_t n = 0; n < faces.size(); ++n)
      table.find_or_add(faces[n].key, n, [&](std::uint32_t there) {
        pace.step();
        const Face &f = faces[n], &known = faces[there];
        const Pair pair(known.operand, f.operand);
        if (known.key == f.key && known.operand != f.operand && (pairs.empty() || pairs.back() != pair) &&
            are_opposite(known, f))
          pairs.push_back(pair);
        return false;
      });
    return pairs;
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
  std::vector<Block> blocks_;
  DisjointSets<std::uint32_t> sets_;
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
    if (is_new || groups[at->second].size() == most_facets_together) {
      at->second = groups.size();
      groups.emplace_back();
    }
    groups[at->second].push_back(o);
  }
  std::erase_if(groups, [&](const auto& g) { return g.size() < 2 || 2 * g.size() > operands.size(); });
  return groups;
}

}  // namespace strata
