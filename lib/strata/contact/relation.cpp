#include "strata/contact/relation.h"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <optional>

#include "strata/contact/face_proof.h"
#include "strata/contact/lining.h"
#include "strata/contact/near_pairs.h"
#include "strata/contact/separation.h"
#include "strata/contact/twins.h"
#include "strata/kernel/predicates.h"

namespace strata::contact {
namespace {

/// What is learned of two parts, one pair of faces that meet after the other.
class Inquiry {
 public:
  Inquiry(const Parts& parts, std::uint32_t a, std::uint32_t b)
      : parts_(parts), a_(a), b_(b), are_beside_(parts.are_beside(a, b)) {}

  Relation find() {
    const auto skip = [this](std::uint32_t f, std::uint32_t g) { return twins_ && twins_->tell(f, g); };
    const auto visit = [this](const FilteredFace& f, const FilteredFace& g, const Meetings& m) {
      look_at(f, g, m);
      return !is_decided_;
    };
    const bool is_open = for_each_meeting(parts_, a_, b_, skip, visit);
    if (!is_open) return relation_;
    const bool do_interfere = linings_ ? linings_->show_interference()
                                       : parts_.has_piece_inside(a_, b_) || parts_.has_piece_inside(b_, a_);
    return do_interfere ? Relation::interfering : relation_;
  }

 private:
  void look_at(const FilteredFace& f, const FilteredFace& g, const Meetings& meetings) {
    relation_ = Relation::contact;
    is_decided_ = are_beside_;
    if (is_decided_) return;
    if (prove_interference(parts_.carriers(), f, g, meetings)) {
      relation_ = Relation::interfering;
      is_decided_ = true;
      return;
    }
    is_decided_ = try_plane(f.face, a_, b_) || try_plane(g.face, b_, a_);
    if (is_decided_) return;
    if (!linings_) linings_.emplace(parts_, a_, b_);
    linings_->note(meetings);
    if (++undecided_ == many) find_twins();
  }

  /// From now on, what twins tell is not asked.
  void find_twins() {
    twins_.emplace(parts_, a_, b_);
    for (const Twins::Pair& pair : twins_->pairs()) {
      if (pair.look_the_same_way) {
        relation_ = Relation::interfering;
        is_decided_ = true;
        return;
      }
      linings_->note_twins(pair.f, pair.g);
    }
  }

  /// Tries few planes, each once: where these do not separate, hardly any does.
  bool try_plane(std::uint32_t face, std::uint32_t below, std::uint32_t above) {
    if (tried_.size() == most_planes) return false;
    for (const std::uint32_t f : tried_)
      if (has_plane_of(f, face)) return false;
    tried_.push_back(face);
    return separates(parts_, face, below, above);
  }
  /// True when a face lies in the plane of another one.
  [[nodiscard]] bool has_plane_of(std::uint32_t face, std::uint32_t other) const {
    const auto f = parts_.carriers().face(face), g = parts_.carriers().face(other);
    return std::all_of(g.begin(), g.end(),
                       [&](std::uint32_t v) { return orient3d(parts_.carriers(), f[0], f[1], f[2], v) == Sign::zero; });
  }

  static constexpr std::size_t most_planes = 8;
  static constexpr int many = 32;
  const Parts& parts_;
  std::uint32_t a_, b_;
  bool are_beside_;
  Relation relation_ = Relation::apart;
  bool is_decided_ = false;
  std::optional<Linings> linings_;  ///< once faces share something that decides nothing
  int undecided_ = 0;               ///< such pairs of faces
  std::optional<Twins> twins_;      ///< once these are many
  boost::container::static_vector<std::uint32_t, most_planes> tried_;
};

}  // namespace

Relation relation_of(const Parts& parts, std::uint32_t a, std::uint32_t b) {
  if (parts.common_box(a, b).empty()) return Relation::apart;
  return Inquiry(parts, a, b).find();
}

}  // namespace strata::contact
