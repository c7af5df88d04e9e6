#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "core/cells/raster.h"
#include "core/kernel/input_complex.h"
#include "strata/options.h"

namespace strata {

/// The bricks of all vertices.
class BrickCodes {
 public:
  /// One streaming pass over vertices.
  BrickCodes(const InputComplex& input, const Grid& grid, const BrickGrid& bricks, const Monitor& monitor);

  [[nodiscard]] BrickCode of(std::uint32_t vertex) const { return codes_[vertex]; }
  /// Box of a face of an operand.
  [[nodiscard]] BrickBox box(std::uint32_t first_vertex, const InputComplex::Indices& face) const {
    const BrickCode* codes = codes_.get() + first_vertex;
    const BrickCode a = codes[face[0]], b = codes[face[1]], c = codes[face[2]];
    return {lower_corner(lower_corner(a, b), c), upper_corner(upper_corner(a, b), c)};
  }

 private:
  std::unique_ptr<BrickCode[]> codes_;
};

/// Which operands have faces in which bricks.
class Occupancy {
 public:
  using Owner = std::uint16_t;
  static constexpr Owner nobody = 0;
  static constexpr Owner mixed = 0xfffe;    ///< faces that may meet
  static constexpr Owner outside = 0xffff;  ///< the layer around the bricks

  /// One streaming pass over faces. `self`: every brick with a face counts as mixed.
  Occupancy(const InputComplex& input, const BrickGrid& bricks, const Raster& raster, const BrickCodes& codes,
            bool self, const Monitor& monitor);

  /// No operand, mixed, outside, or one operand's number + 1.
  [[nodiscard]] Owner owner(std::uint32_t brick) const { return owners_[brick]; }

  /// Faces of a block are grouped into runs of this length; the last one may be shorter.
  static constexpr std::size_t run_length = 32;
  /// The box of all bricks of a run of faces. In most meshes the faces of a run are near each other.
  [[nodiscard]] const BrickBox& run(std::size_t block, std::size_t number) const { return runs_[block][number]; }

 private:
  void mark(std::uint32_t brick, Owner own);
  void mark_outside(const BrickGrid& bricks);

  std::vector<Owner> owners_;
  std::vector<std::vector<BrickBox>> runs_;  ///< per block
};

}  // namespace strata
