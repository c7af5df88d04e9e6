#include "extensions/contact/relation.h"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <optional>

#include "core/exact/failure.h"
#include "core/kernel/predicates.h"
#include "extensions/contact/coincident_faces.h"
#include "extensions/contact/common_points.h"
#include "extensions/contact/face_proof.h"
#include "extensions/contact/interior_side.h"
#include "extensions/contact/near_pairs.h"
#include "extensions/contact/separation.h"
#include "extensions/contact/sole_face.h"

namespace strata::contact {
namespace {

/// The decision about two parts, from pairs of faces that meet, one after the other.
class Inquiry {
 public:
  Inquiry(const Parts& parts, std::uint32_t a, std::uint32_t b, const Monitor& monitor)
      : parts_(parts), a_(a), b_(b), monitor_(monitor), are_beside_(parts.are_beside(a, b)) {}

  /// Nullopt where faces would prove interference if their parts had no other faces there, and no others do prove it.
  std::optional<Relation> find() {
    const auto skip = [this](std::uint32_t f, std::uint32_t g) { return coincident_ && coincident_->tell(f, g); };
    const auto visit = [this](const FilteredFace& f, const FilteredFace& g, const PairIntersections& m) {
      look_at(f, g, m);
      return !is_decided_;
    };
    const bool is_open = for_each_meeting(parts_, a_, b_, monitor_, skip, visit);
    if (!is_open) return relation_;
    if (is_doubtful_) return std::nullopt;
    const bool do_interfere = interior_sides_ ? interior_sides_->show_interference(monitor_)
                                              : parts_.has_piece_inside(a_, b_) || parts_.has_piece_inside(b_, a_);
    return do_interfere ? Relation::interfering : relation_;
  }

 private:
  void look_at(const FilteredFace& f, const FilteredFace& g, const PairIntersections& intersections) {
    relation_ = Relation::contact;
    is_decided_ = are_beside_;
    if (is_decided_) return;
    if (const auto sole = prove_interference(parts_.input(), f, g, intersections)) {
      conclude(f, g, *sole, common_points(parts_.input(), intersections));
      return;
    }
    is_decided_ = try_plane(f.face, a_, b_) || try_plane(g.face, b_, a_);
    if (is_decided_ || is_doubtful_) return;
    if (!interior_sides_) interior_sides_.emplace(parts_, a_, b_);
    interior_sides_->note(intersections);
    if (++undecided_ == many) find_coincident_faces();
  }

  /// The faces have the form of a proof. Decides whether they are one, around the middle of their intersection.
  void conclude(const FilteredFace& f, const FilteredFace& g, SoleFaces sole, const CommonPoints& shared) {
    const bool holds_f = sole.first && is_sole_face(parts_, f, shared);
    const bool holds_g = sole.second && !(sole.either && holds_f) && is_sole_face(parts_, g, shared);
    const bool holds = sole.either ? holds_f || holds_g : holds_f == sole.first && holds_g == sole.second;
    if (holds) relation_ = Relation::interfering;
    is_decided_ = holds;
    is_doubtful_ |= !holds;
  }

  /// After this, pairs that coincident faces decide are skipped.
  void find_coincident_faces() {
    coincident_.emplace(parts_, a_, b_);
    const InputComplex& input = parts_.input();
    for (const Twins::Pair& pair : coincident_->pairs()) {
      monitor_.check();
      if (pair.look_the_same_way) {
        CommonPoints corners;
        for (const std::uint32_t v : input.face(pair.f)) corners.push_back(SymbolicPoint::input(v));
        conclude(FilteredFace(input, a_, pair.f), FilteredFace(input, b_, pair.g), {.first = true, .second = true},
                 corners);
        if (is_decided_) return;
      }
      interior_sides_->note_coincident_faces(pair.f, pair.g);
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
    const auto f = parts_.input().face(face), g = parts_.input().face(other);
    return std::all_of(g.begin(), g.end(),
                       [&](std::uint32_t v) { return orient3d(parts_.input(), f[0], f[1], f[2], v) == Sign::zero; });
  }

  static constexpr std::size_t most_planes = 8;
  static constexpr int many = 32;
  const Parts& parts_;
  std::uint32_t a_, b_;
  const Monitor& monitor_;
  bool are_beside_;
  Relation relation_ = Relation::apart;
  bool is_decided_ = false;
  bool is_doubtful_ = false;  ///< some faces have the form of a proof, and are none: interior sides decide nothing
  std::optional<InteriorSides> interior_sides_;  ///< once faces share a set that decides nothing
  int undecided_ = 0;                            ///< the number of such pairs of faces
  std::optional<Twins> coincident_;              ///< once these are many
  boost::container::static_vector<std::uint32_t, most_planes> tried_;
};

}  // namespace

Relation relation_of(const Parts& parts, std::uint32_t a, std::uint32_t b, const Monitor& monitor) {
  if (parts.common_box(a, b).empty()) return Relation::apart;
  if (const auto relation = Inquiry(parts, a, b, monitor).find()) return *relation;
  const Solid resolved[] = {Solid(parts.solid(a).exact_mesh(), InputClass::overlapping),
                            Solid(parts.solid(b).exact_mesh(), InputClass::overlapping)};
  if (const auto relation = Inquiry(Parts(resolved), 0, 1, monitor).find()) return *relation;
  throw LogicError("faces of a resolved solid lie on one another");
}

}  // namespace strata::contact
