#include "extensions/planar/thinning.h"

#include <algorithm>

#include "extensions/planar/strips.h"

namespace strata::planar {
namespace {

/// Consecutive edges of a loop, by their first vertices as indices of `Loops::vertices`: first .. last - 1. The end of
/// an edge is the next vertex, or, of a loop's last edge, the loop's first vertex.
struct Stretch {
  std::uint32_t operand = 0, first = 0, last = 0;
};

/// The closed quadrant of directions of an edge. A vertical edge that goes up counts as directed to the right, a
/// horizontal one to the right as directed upwards. So points of a chain within one quadrant are also in order by x,
/// then y.
enum class Quadrant : std::uint8_t { left_down, right_down, left_up, right_up, none };

Quadrant quadrant(const PlanePoint& p, const PlanePoint& q) {
  const bool is_level = p[1] == q[1], is_vertical = p[0] == q[0];
  if (is_level && is_vertical) return Quadrant::none;
  const bool is_right = is_vertical ? p[1] < q[1] : p[0] < q[0], is_up = is_level ? is_right : p[1] < q[1];
  return static_cast<Quadrant>(static_cast<int>(is_right) + 2 * static_cast<int>(is_up));
}

/// Cuts loops into monotone chains: edges within one quadrant. Only long ones are used; a loop's last edge is in none.
class ChainFinder {
 public:
  ChainFinder(std::span<const Operand> operands, std::uint32_t shortest) : shortest_(shortest) {
    for (std::uint32_t i = 0; i < operands.size(); ++i) {
      const Loops& loops = *operands[i].loops;
      for (std::uint32_t l = 0; l < loops.size(); ++l)
        if (loops.first_vertex[l + 1] - loops.first_vertex[l] > shortest) cut(loops, i, l);
    }
  }
  std::vector<Stretch> take() { return std::move(chains_); }

 private:
  void cut(const Loops& loops, std::uint32_t operand, std::uint32_t loop) {
    const bool is_plain = loops.places.error.empty();
    const auto is_fit = [&](std::uint32_t i) {
      return is_plain || (loops.places.is_double(loops.vertices[i]) && loops.places.is_double(loops.vertices[i + 1]));
    };
    const std::uint32_t last = loops.first_vertex[loop + 1] - 1;
    Stretch chain{operand, loops.first_vertex[loop], loops.first_vertex[loop]};
    Quadrant now = Quadrant::none;
    const PlanePoint* from = &loops.places.place[loops.vertices[chain.first]];
    for (; chain.last < last; ++chain.last) {
      const PlanePoint* to = &loops.places.place[loops.vertices[chain.last + 1]];
      const Quadrant next = is_fit(chain.last) ? quadrant(*from, *to) : Quadrant::none;
      from = to;
      if (next == now) continue;
      add(chain, now);
      chain.first = chain.last;
      now = next;
    }
    add(chain, now);
  }
  void add(const Stretch& chain, Quadrant q) {
    if (q != Quadrant::none && chain.last - chain.first >= shortest_) chains_.push_back(chain);
  }

  std::uint32_t shortest_;
  std::vector<Stretch> chains_;
};

/// All edges that are not in chains, as stretches of up to eight edges each.
std::vector<Stretch> others(std::span<const Operand> operands, const std::vector<Stretch>& chains) {
  constexpr std::uint32_t longest = 8;
  std::vector<Stretch> stretches;
  auto chain = chains.begin();
  for (std::uint32_t i = 0; i < operands.size(); ++i) {
    const Loops& loops = *operands[i].loops;
    for (std::uint32_t l = 0; l < loops.size(); ++l) {
      const std::uint32_t end = loops.first_vertex[l + 1];
      for (std::uint32_t first = loops.first_vertex[l]; first < end;) {
        const bool has_chain = chain != chains.end() && chain->operand == i && chain->first < end;
        if (has_chain && chain->first == first) {
          first = (chain++)->last;
          continue;
        }
        const std::uint32_t last = std::min(has_chain ? chain->first : end, first + longest);
        stretches.push_back({i, first, last});
        first = last;
      }
    }
  }
  return stretches;
}

/// An edge of a chain, by their numbers.
struct Listed {
  std::uint32_t chain = 0, edge = 0;
  friend auto operator<=>(const Listed&, const Listed&) = default;
};

/// Lists the edges of chains that may meet other edges than their neighbours in the chain: those whose boxes meet the
/// box of an edge of another chain, or of another stretch. The first and last edges are listed too.
class Encounters {
 public:
  Encounters(std::span<const Operand> operands, const std::vector<Stretch>& chains, std::size_t most_pairs)
      : operands_(operands), chains_(chains), most_pairs_(most_pairs) {}

  /// The listed edges in order; an empty list if that takes too many pairs.
  std::vector<Listed> find() {
    std::vector<Box> boxes;
    std::vector<std::array<PlanePoint, 2>> ends;  // as for points: nothing is straight here
    for (const Stretch& c : chains_) boxes.push_back(box_of_part(c));
    for (const Stretch& s : others(operands_, chains_)) boxes.push_back(box_around(s));
    for (const Box& b : boxes) ends.push_back({PlanePoint{b.left, b.low}, PlanePoint{b.left, b.low}});
    Strips strips(std::move(boxes), std::move(ends));
    strips_ = &strips;
    strips.sort(*this);
    if (pairs_ > most_pairs_) return {};
    std::sort(listed_.begin(), listed_.end());
    listed_.erase(std::unique(listed_.begin(), listed_.end()), listed_.end());
    return std::move(listed_);
  }

  void enter(std::uint32_t strip) {
    strip_ = strip;
    seen_ = 0;
  }
  void visit(std::uint32_t a, std::uint32_t b) {
    if (a >= chains_.size() && b >= chains_.size()) return;
    if (strips_->strip_of(std::max(strips_->box(a).low, strips_->box(b).low)) != strip_) return;  // once is enough
    compare(part(a), strips_->box(a), part(b), strips_->box(b));
  }
  bool is_enough(std::size_t pairs) {
    pairs_ += pairs - seen_;
    seen_ = pairs;
    return pairs_ > most_pairs_;
  }

 private:
  /// Edges of a chain, or a whole stretch that is in no chain as one edge.
  struct Part {
    std::uint32_t chain = none, first = 0, last = 1;
    [[nodiscard]] std::uint32_t edges() const { return last - first; }
  };
  [[nodiscard]] Part part(std::uint32_t item) const {
    return item < chains_.size() ? Part{item, chains_[item].first, chains_[item].last} : Part{};
  }
  void compare(const Part& a, const Box& box_a, const Part& b, const Box& box_b) {
    if (!overlap(box_a, box_b) || ++pairs_ > most_pairs_) return;
    if (a.edges() < b.edges()) return compare(b, box_b, a, box_a);
    if (a.edges() == 1) {
      for (const Part& p : {a, b})
        if (p.chain != none) listed_.push_back({p.chain, p.first});
      return;
    }
    const std::uint32_t operand = chains_[a.chain].operand, middle = a.first + a.edges() / 2;
    compare({a.chain, a.first, middle}, box_of_part({operand, a.first, middle}), b, box_b);
    compare({a.chain, middle, a.last}, box_of_part({operand, middle, a.last}), b, box_b);
  }
  /// The box of the two ends of a part of a chain.
  [[nodiscard]] Box box_of_part(const Stretch& s) const {
    const Loops& loops = *operands_[s.operand].loops;
    return hull(box_of(loops.places, loops.vertices[s.first]), box_of(loops.places, loops.vertices[s.last]));
  }
  [[nodiscard]] Box box_around(const Stretch& s) const {
    const Loops& loops = *operands_[s.operand].loops;
    const auto end = std::upper_bound(loops.first_vertex.begin(), loops.first_vertex.end(), s.first);
    Box box = box_of(loops.places, loops.vertices[s.last < *end ? s.last : *(end - 1)]);
    for (std::uint32_t i = s.first; i < s.last; ++i) box = hull(box, box_of(loops.places, loops.vertices[i]));
    return box;
  }

  std::span<const Operand> operands_;
  const std::vector<Stretch>& chains_;
  std::size_t most_pairs_, pairs_ = 0;
  const Strips* strips_ = nullptr;
  std::uint32_t strip_ = 0;
  std::size_t seen_ = 0;  ///< pairs in this strip
  std::vector<Listed> listed_;
};

/// The stretches between listed edges of a chain, shortened until they have corners at both ends, if they have an inner
/// vertex.
std::vector<Stretch> quiet_stretches(std::span<const Operand> operands, const std::vector<Stretch>& chains,
                                     const std::vector<Listed>& listed) {
  std::vector<Stretch> quiet;
  for (std::size_t i = 1; i < listed.size(); ++i) {
    if (listed[i - 1].chain != listed[i].chain) continue;
    const std::uint32_t operand = chains[listed[i].chain].operand;
    MonotoneChain s{operands[operand].loops, listed[i - 1].edge + 1, listed[i].edge};
    const auto turns_at = [&](std::uint32_t v) {
      return orientation(s.point(v - 1), s.point(v), s.point(v + 1)) != Sign::zero;
    };
    while (s.first + 1 < s.last && !turns_at(s.first)) ++s.first;
    while (s.first + 1 < s.last && !turns_at(s.last)) --s.last;
    if (s.first + 1 < s.last) quiet.push_back({operand, s.first, s.last});
  }
  return quiet;
}

/// The places of loops without the doubles that are not needed. The remaining points get new numbers; `vertices` are
/// updated.
Places places_for(std::vector<std::uint32_t>& vertices, const Places& from) {
  const auto is_double = [&](std::uint32_t p) { return from.is_double(p); };
  auto doubles = static_cast<std::uint32_t>(std::count_if(vertices.begin(), vertices.end(), is_double));
  for (const Line& l : from.lines) doubles += static_cast<std::uint32_t>(is_double(l.from) + is_double(l.to));
  Places to;
  to.place.reserve(doubles + from.error.size());
  const auto number = [&](std::uint32_t p) {
    return is_double(p) ? to.add(from.place[p]) : p - from.doubles() + doubles;
  };
  for (std::uint32_t& p : vertices) p = number(p);
  for (const Line& l : from.lines) {
    const std::uint32_t first = number(l.from);
    to.lines.push_back({first, number(l.to)});
  }
  to.place.insert(to.place.end(), from.place.begin() + from.doubles(), from.place.end());
  to.error = from.error;
  to.rationals = from.rationals;
  to.meets = from.meets;
  return to;
}

/// Loops with an edge in place of every isolated chain. Appends to `chain_of` for every edge the number of its chain,
/// from `first` on, or none.
Loops without(const Loops& from, std::span<const Stretch> quiet, std::uint32_t first,
              std::vector<std::uint32_t>& chain_of) {
  Loops to;
  std::size_t next = 0;
  for (std::uint32_t l = 0; l < from.size(); ++l) {
    for (std::uint32_t i = from.first_vertex[l]; i < from.first_vertex[l + 1];) {
      const bool is_chain = next < quiet.size() && quiet[next].first == i;
      to.vertices.push_back(from.vertices[i]);
      to.edge_line.push_back(from.edge_line[i]);
      chain_of.push_back(is_chain ? first + static_cast<std::uint32_t>(next) : none);
      i = is_chain ? quiet[next++].last : i + 1;
    }
    to.first_vertex.push_back(static_cast<std::uint32_t>(to.vertices.size()));
  }
  to.places = places_for(to.vertices, from.places);
  return to;
}

std::vector<Stretch> find_quiet(std::span<const Operand> operands, std::uint32_t shortest_chain,
                                std::size_t most_pairs) {
  const std::vector<Stretch> chains = ChainFinder(operands, shortest_chain).take();
  std::size_t edges = 0, in_chains = 0;
  for (const Operand& o : operands) edges += o.loops->vertices.size();
  for (const Stretch& c : chains) in_chains += c.last - c.first;
  if (chains.empty() || 4 * in_chains < edges) return {};
  return quiet_stretches(operands, chains, Encounters(operands, chains, most_pairs * edges).find());
}

}  // namespace

Thinned thin(std::span<const Operand> operands, std::uint32_t shortest_chain, std::size_t most_pairs) {
  const std::vector<Stretch> quiet = find_quiet(operands, shortest_chain, most_pairs);
  Thinned thinned;
  thinned.operands.assign(operands.begin(), operands.end());
  thinned.loops.resize(operands.size());
  thinned.chain_of.resize(operands.size());
  for (const Stretch& s : quiet) thinned.chains.push_back({operands[s.operand].loops, s.first, s.last});
  for (std::uint32_t i = 0; i < operands.size(); ++i) {
    const auto first = std::ranges::lower_bound(quiet, i, {}, &Stretch::operand);
    const auto last = std::ranges::upper_bound(quiet, i, {}, &Stretch::operand);
    if (first == last) continue;
    thinned.loops[i] = without(*operands[i].loops, {first, last}, static_cast<std::uint32_t>(first - quiet.begin()),
                               thinned.chain_of[i]);
    thinned.operands[i].loops = &thinned.loops[i];
  }
  return thinned;
}

}  // namespace strata::planar
