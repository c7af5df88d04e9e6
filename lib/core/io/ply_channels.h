#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/io/ply_header.h"
#include "strata/attributes.h"

namespace strata::io {

/// What becomes of a property of a record.
struct PlyUse {
  enum class Kind { none, coordinate, indices, value, corner_values };
  Kind kind = Kind::none;
  std::size_t channel = 0;     ///< of the plan; of values
  std::size_t components = 0;  ///< of the channel, or of a point
  std::size_t component = 0;   ///< of these, the one that this is
  std::size_t offset = 0;      ///< bytes before it in a binary record whose lists are empty

  /// Where the value of a record is in those of the channel.
  [[nodiscard]] std::size_t place(std::uint64_t record) const { return record * components + component; }
};

/// A channel that properties make. Its values have no number yet, but their type.
struct PlyChannel {
  Channel channel;
  bool is_unsigned = false;  ///< of integers that int32 may not hold: doubles, until all are known
};

/// Finds the channels of the elements of a header.
class PlyChannels {
 public:
  /// The channels of an element, whose properties that are used already are left alone. `element` is what a record
  /// stands for: vertex or face.
  void add(const PlyElement& element, Element kind, std::vector<PlyUse>& uses);
  /// Counts an element of which nothing is read, or whose properties beside a list of vertices are not.
  void leave_out(const PlyElement& element) { elements_.add(element.name); }
  void leave_out_properties(const PlyElement& element, const std::vector<PlyUse>& uses);

  [[nodiscard]] std::vector<PlyChannel> take() { return std::move(channels_); }
  /// One for each kind of things that are left out.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  struct LeftOut {
    std::size_t count = 0;
    std::string first;
    void add(const std::string& name) {
      if (count++ == 0) first = name;
    }
  };
  class OfElement;

  std::vector<PlyChannel> channels_;
  std::map<std::string, Element> names_;  ///< of channels, and whether they are of vertices or faces
  LeftOut elements_, lists_, twice_, apart_, beyond_;
};

}  // namespace strata::io
