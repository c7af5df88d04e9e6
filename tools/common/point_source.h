#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/byte_source.h"
#include "common/line_blocks.h"

/// A file of points, read block by block in bounded memory: CSV with the columns x, y and z, or PLY, whose vertices are
/// the points.
class PointSource {
 public:
  virtual ~PointSource() = default;

  /// The next points as they stand in the file; false at the end. Throws strata::IoError, strata::Cancelled.
  virtual bool next(LineBlock& block) = 0;
  /// Appends the coordinates of the points: x0 y0 z0 x1 y1 z1 ... Finite. Safe to call from many threads. Throws
  /// strata::IoError with the place.
  virtual void parse(const LineBlock& block, std::vector<double>& coordinates) const = 0;
  /// Where the file says so.
  [[nodiscard]] virtual std::optional<std::uint64_t> count() const = 0;
};

/// PLY for the extension .ply, else CSV. Reads the header. Throws strata::IoError, strata::Cancelled.
[[nodiscard]] std::unique_ptr<PointSource> make_point_source(const std::string& path, ByteSource& bytes);

/// The vertices of a PLY file; they are its first element and have no lists.
[[nodiscard]] std::unique_ptr<PointSource> make_ply_points(ByteSource& bytes);
