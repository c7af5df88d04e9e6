#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/io/affine_map.h"
#include "core/io/tally.h"
#include "strata/io.h"

namespace strata::io {

/// A mesh of a scene in its own coordinates, with channels that fit it.
struct ScenePart {
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  std::vector<Channel> channels;

  /// Drops triangles with equal corners, and their values. Adds them to the tally, counted from `first`.
  void drop_degenerate(Tally& dropped, std::uint64_t first);
};

/// A channel on vertices with the values of one on corners, where all corners of each vertex have the same; else what
/// was given. Vertices without corners get zeros.
[[nodiscard]] Channel on_vertices_if_possible(Channel channel, const ScenePart& part);

/// Puts meshes into one, each any number of times. Files of few bytes may name many copies: so at most four million
/// things are placed, and 64 for each that the file holds.
class SceneMesh {
 public:
  /// `things` that the file holds: vertices, triangles, nodes. `name` is the file's.
  SceneMesh(std::uint64_t things, std::string name);

  /// Counts a node that is visited: as 32 things, for its transform takes time. Throws IoError if there are too many.
  void visit() { count(32); }
  /// Places a part, which is kept until finish(), which empties it if it is the only one. `object` is an index into the
  /// objects of the file, or -1.
  void place(ScenePart& part, const ExactMap& map, std::int32_t object);
  /// A part may have a channel "object": its values are added to the `object` of its placement.
  /// All that was placed, in this order. Channels of one name become one; where parts lack it, colours are white,
  /// indices -1, other numbers 0. Adds a note if transforms round coordinates. Throws IoError for coordinates beyond
  /// the range of doubles.
  void finish(MeshFile& file);

 private:
  struct Placed {
    ScenePart* part;
    PointMap map;
    std::int32_t object;
  };
  void count(std::uint64_t things);
  void add_vertices(MeshFile& file) const;
  void add_triangles(MeshFile& file) const;
  void add_objects(MeshFile& file) const;
  [[nodiscard]] bool is_one_as_it_is() const;

  std::string name_;
  std::uint64_t left_;
  std::vector<Placed> placed_;
};

}  // namespace strata::io
