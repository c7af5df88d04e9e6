#pragma once
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "core/attributes/index_lists.h"
#include "strata/attributes.h"
#include "strata/carry_attributes.h"

namespace strata {

/// A channel of a result and where its values come from.
struct JoinedChannel {
  Channel form;  ///< without values, of the right type
  /// Per operand the channel with the values: of the name, type, components and element of the form. Null: it has none.
  std::vector<const Channel*> of_operand;
  std::vector<double> missing;     ///< the value, per component, in operands that have none
  bool missing_is_normal = false;  ///< it is the normal of the face
};

/// The channels of several operands as those of a result, as `carry_attributes` says. Refers to the operands.
class JoinedChannels {
 public:
  /// Requires attributes that fit their meshes. Indices follow the joined lists, to which numbers may be added.
  JoinedChannels(std::span<const AttributedMesh> operands, JoinedLists& lists);

  [[nodiscard]] const std::vector<JoinedChannel>& channels() const { return channels_; }
  /// Adds a channel that no operand has.
  void add(Channel form);
  [[nodiscard]] const JoinedChannel* find(std::string_view name) const;

 private:
  std::vector<JoinedChannel> channels_;
  std::size_t operands_;
  std::deque<Channel> converted_;  ///< channels of operands in the form of the result
};

}  // namespace strata
