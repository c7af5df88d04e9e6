#include <algorithm>
#include <map>

#include "extensions/planar/gather.h"
#include "extensions/planar/labels.h"
#include "extensions/planar/predicates.h"
#include "strata/planar.h"

namespace strata::planar {
namespace {

/// A piece in both boundaries.
struct CommonPiece {
  std::uint32_t low = 0, high = 0;  ///< lexicographically
  std::uint32_t line = 0;
};

class ContactFinder {
 public:
  ContactFinder(const Arrangement& a, const Gathered& gathered) : a_(a), gathered_(gathered) {}

  Contact find() {
    find_common();
    Contact contact;
    std::map<std::uint32_t, std::vector<std::size_t>> at;
    for (std::size_t i = 0; i < common_.size(); ++i) {
      at[common_[i].low].push_back(i);
      at[common_[i].high].push_back(i);
    }
    add_edges(at, contact);
    for (std::uint32_t v = 0; v < touched_by_.size(); ++v)
      if (touched_by_[v] == 3 && !at.contains(v)) contact.points.push_back(exact_position(a_.places, v));
    std::sort(contact.edges.begin(), contact.edges.end());
    std::sort(contact.points.begin(), contact.points.end());
    const bool none_found = contact.edges.empty() && contact.points.empty();
    contact.relation = none_found ? Relation::apart : Relation::contact;
    return contact;
  }

 private:
  /// Finds the pieces and vertices that both operands have.
  void find_common() {
    touched_by_.assign(a_.places.size(), 0);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> operands;
    for (std::uint32_t s = 0; s < a_.ends.size(); ++s)
      for (std::uint32_t k = a_.first_piece[s]; k < a_.first_piece[s + 1]; ++k) {
        const auto [p, q] = a_.pieces[k];
        const std::uint32_t mask = 1u << gathered_.operand_of[s];
        touched_by_[p] |= static_cast<std::uint8_t>(mask);
        touched_by_[q] |= static_cast<std::uint8_t>(mask);
        std::uint32_t& seen = operands[std::minmax(p, q)];
        if (seen != 0 && (seen & mask) == 0) {
          const bool forward = compare_xy(a_.places, p, q) == Sign::negative;
          common_.push_back({forward ? p : q, forward ? q : p, s});
        }
        seen |= mask;
      }
  }
  /// Adds runs of common pieces on one line, divided where another part of the contact starts.
  void add_edges(const std::map<std::uint32_t, std::vector<std::size_t>>& at, Contact& contact) const {
    const auto continues = [&](std::uint32_t v) {
      const auto& pieces = at.at(v);
      if (pieces.size() != 2) return false;
      const CommonPiece &p = common_[pieces[0]], &q = common_[pieces[1]];
      return (p.high == q.low || q.high == p.low) && cross(a_.places, p.line, q.line) == Sign::zero;
    };
    for (std::size_t i = 0; i < common_.size(); ++i) {
      if (continues(common_[i].low)) continue;
      std::size_t last = i;
      while (continues(common_[last].high)) {
        const auto& pieces = at.at(common_[last].high);
        last = pieces[pieces[0] == last ? 1 : 0];
      }
      contact.edges.push_back(
          {exact_position(a_.places, common_[i].low), exact_position(a_.places, common_[last].high)});
    }
  }

  const Arrangement& a_;
  const Gathered& gathered_;
  std::vector<std::uint8_t> touched_by_;  ///< of every vertex: bit i for operand i
  std::vector<CommonPiece> common_;
};

}  // namespace

Contact contact_of(const Region& a, const Region& b) {
  const std::array<Operand, 2> operands{a, b};
  Gathered gathered = gather(operands);
  const Arrangement arrangement = arrange(std::move(gathered.segments));
  const Subdivision subdivision = subdivide(arrangement, gathered.first_segment);
  const std::vector<std::uint8_t> common =
      Labels(gathered, subdivision, operands).evaluate([](const Inside& inside) { return inside.count == 2; });
  if (std::find(common.begin(), common.end(), 1) != common.end()) return {Relation::interfering, {}, {}};
  return ContactFinder(arrangement, gathered).find();
}

}  // namespace strata::planar
