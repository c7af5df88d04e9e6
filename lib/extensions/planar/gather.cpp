#include "extensions/planar/gather.h"

#include "core/containers/hash_index.h"
#include "core/containers/point_hash.h"
#include "core/exact/arithmetic.h"
#include "extensions/planar/predicates.h"

namespace strata::planar {
namespace {

/// The positions of an operand's points and lines in the common numbering.
struct Offsets {
  std::uint32_t doubles = 0, rationals = 0, meets = 0, lines = 0;

  [[nodiscard]] std::uint32_t point(const Places& own, std::uint32_t p) const {
    if (own.is_double(p)) return doubles + p;
    if (!own.is_meet(p)) return rationals + (p - own.doubles());
    return meets + (p - own.given());
  }
};

bool are_equal(const RationalPlace& p, const RationalPlace& q) {
  if (const auto* a = p.between(), *b = q.between(); a != nullptr && b != nullptr && *a == *b) return true;
  return p.exact() == q.exact();
}

class Gatherer {
 public:
  explicit Gatherer(std::span<const Operand> operands) : operands_(operands), offsets_(operands.size()) {}

  Gathered gather(bool keep_names) {
    add_given();
    count_segments();
    add_lines_and_meets();
    for (std::size_t i = 0; i < operands_.size(); ++i) add_segments(i);
    if (keep_names) add_names();
    return std::move(result_);
  }

 private:
  Places& places() { return result_.segments.places; }

  void add_given() {
    std::size_t points = 0;
    for (const Operand& o : operands_) points += o.loops->places.size();
    places().place.reserve(points + points / 2);  // for crossings, too
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      const Places& own = operands_[i].loops->places;
      offsets_[i].doubles = places().size();
      for (std::uint32_t p = 0; p < own.doubles(); ++p)  // -0 becomes 0
        places().place.push_back({own.place[p][0] + 0.0, own.place[p][1] + 0.0});
    }
    name_ = first_equal(places().place);
    std::size_t rationals = 0;
    for (const Operand& o : operands_) rationals += o.loops->places.rationals.size();
    HashIndex known(rationals);
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      const Places& own = operands_[i].loops->places;
      offsets_[i].rationals = places().size();
      for (std::uint32_t p = own.doubles(); p < own.given(); ++p) {
        places().place.push_back(own.place[p]);
        places().error.push_back(own.error[p - own.doubles()]);
        places().rationals.push_back(own.rational(p));
        name_.push_back(known.find_or_add(hash_of(own.place[p]), places().size() - 1, [&](std::uint32_t q) {
          return places().place[q] == own.place[p] && are_equal(places().rational(q), own.rational(p));
        }));
      }
    }
    std::uint32_t meets = places().size();
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      offsets_[i].meets = meets;
      meets += static_cast<std::uint32_t>(operands_[i].loops->places.meets.size());
    }
  }

  [[nodiscard]] std::uint32_t name(std::uint32_t p) const { return p < name_.size() ? name_[p] : p; }

  /// Calls visit(from, to, edge) for every edge with a length.
  template <class Visit>
  void for_each_edge(std::size_t operand, std::uint32_t loop, const Visit& visit) const {
    const Loops& loops = *operands_[operand].loops;
    const std::uint32_t begin = loops.first_vertex[loop], end = loops.first_vertex[loop + 1];
    if (begin == end) return;
    const auto named = [&](std::uint32_t i) { return name(offsets_[operand].point(loops.places, loops.vertices[i])); };
    const std::uint32_t start = named(begin);
    std::uint32_t from = start;
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t to = i + 1 < end ? named(i + 1) : start;
      if (from != to) visit(from, to, i);
      from = to;
    }
  }

  void count_segments() {
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      for (std::uint32_t l = 0; l < operands_[i].loops->size(); ++l) {
        for_each_edge(i, l, [&](auto...) { ++segments_; });
        result_.first_segment.push_back(segments_);
      }
      result_.first_ring.push_back(static_cast<std::uint32_t>(result_.first_segment.size() - 1));
    }
  }

  /// Lines of segments are first, then those on which meets of operands lie.
  void add_lines_and_meets() {
    std::vector<Line>& lines = places().lines;
    lines.resize(segments_);
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      const Places& own = operands_[i].loops->places;
      offsets_[i].lines = static_cast<std::uint32_t>(lines.size());
      for (const Line& l : own.lines)
        lines.push_back({name(offsets_[i].point(own, l.from)), name(offsets_[i].point(own, l.to))});
    }
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      const Places& own = operands_[i].loops->places;
      for (std::uint32_t p = own.given(); p < own.size(); ++p) {
        places().place.push_back(own.place[p]);
        places().error.push_back(own.error[p - own.doubles()]);
        const Meet& m = own.meet(p);
        places().meets.push_back({m.first + offsets_[i].lines, m.second + offsets_[i].lines});
      }
    }
  }

  void add_segments(std::size_t operand) {
    const Loops& loops = *operands_[operand].loops;
    Segments& segments = result_.segments;
    segments.ends.reserve(segments_);
    result_.operand_of.reserve(segments_);
    result_.edge_of.reserve(segments_);
    for (std::uint32_t l = 0; l < loops.size(); ++l)
      for_each_edge(operand, l, [&](std::uint32_t from, std::uint32_t to, std::uint32_t edge) {
        const std::uint32_t given_line = loops.edge_line[edge];
        Line line{from, to};
        if (given_line != none) line = directed(segments.places.lines[offsets_[operand].lines + given_line], from, to);
        segments.places.lines[segments.ends.size()] = line;
        segments.ends.push_back({from, to});
        result_.operand_of.push_back(static_cast<std::uint32_t>(operand));
        result_.edge_of.push_back(edge);
      });
  }

  void add_names() {
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      const Places& own = operands_[i].loops->places;
      auto& names = result_.name_of.emplace_back();
      for (std::uint32_t p = 0; p < own.size(); ++p) names.push_back(name(offsets_[i].point(own, p)));
    }
  }

  [[nodiscard]] Line directed(const Line& line, std::uint32_t from, std::uint32_t to) {
    const bool is_along = compare_xy(places(), from, to) == compare_xy(places(), line.from, line.to);
    return is_along ? line : Line{line.to, line.from};
  }

  std::span<const Operand> operands_;
  std::vector<Offsets> offsets_;
  std::vector<std::uint32_t> name_;  ///< of given points
  std::uint32_t segments_ = 0;
  Gathered result_;
};

}  // namespace

Gathered gather(std::span<const Operand> operands, bool keep_names) {
  ensure_ieee_arithmetic();
  return Gatherer(operands).gather(keep_names);
}

Gathered gather(Thinned thinned) {
  Gathered gathered = gather(thinned.operands);
  if (thinned.chains.empty()) return gathered;
  MonotoneChains& chains = gathered.segments.chains;
  chains.chains = std::move(thinned.chains);
  chains.chain_of.reserve(gathered.edge_of.size());
  for (std::size_t s = 0; s < gathered.edge_of.size(); ++s) {
    const auto& chain_of = thinned.chain_of[gathered.operand_of[s]];
    chains.chain_of.push_back(chain_of.empty() ? none : chain_of[gathered.edge_of[s]]);
  }
  return gathered;
}

}  // namespace strata::planar
