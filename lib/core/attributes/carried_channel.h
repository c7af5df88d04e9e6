#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/attributes/face_frame.h"
#include "core/attributes/joined_channels.h"
#include "core/attributes/triangle_origins.h"

namespace strata {

/// The values of one channel of a result, while they are written. Threads may write different triangles at once.
class CarriedChannel {
 public:
  /// Memory for the values. Refers to both.
  [[nodiscard]] static std::unique_ptr<CarriedChannel> make(const JoinedChannel& joined,
                                                            const TriangleOrigins& origins);
  virtual ~CarriedChannel() = default;
  CarriedChannel(const CarriedChannel&) = delete;
  CarriedChannel& operator=(const CarriedChannel&) = delete;

  /// True when the values of parts depend on the places of their corners.
  [[nodiscard]] bool needs_places() const { return element_ != Element::face; }
  /// Writes the values of whole triangles, and of all triangles if they are on faces.
  virtual void write_triangles(std::size_t first, std::size_t last) = 0;
  /// Writes a corner (3 t + k) of a part that is a corner of its source face.
  virtual void write_corner(std::size_t corner, std::size_t source_corner, const FaceFrame& frame) = 0;
  /// Writes a corner of a part at a place in its source face.
  virtual void write_corner(std::size_t corner, const FaceFrame::Place& place, const FaceFrame& frame) = 0;
  /// Writes a corner with the values of one that was written.
  virtual void copy_corner(std::size_t corner, std::size_t from) = 0;
  /// The channel, on vertices if it may be.
  [[nodiscard]] virtual Channel finish() = 0;

 protected:
  explicit CarriedChannel(Element element) : element_(element) {}
  Element element_;
};

}  // namespace strata
