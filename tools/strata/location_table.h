#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "scene_input.h"
#include "strata/mesh.h"
#include "strata/query.h"

/// How many points are out, on and in: by strata::Where.
using WhereCounts = std::array<std::uint64_t, 3>;

/// Answers points and writes rows about them: x, y, z, where (in, on, out), solid and face.
/// The solid is the lowest one that the point is on, else in; the face the lowest face of that solid that it is on.
class LocationTable {
 public:
  enum class Form {
    csv,      ///< coordinates with the shortest digits that read back the same; what there is not is empty
    csv_all,  ///< all solids that the point is on or in, joined by ';', and as many faces, empty where it is in
    ply,      ///< double x y z, uchar where (0 out, 1 on, 2 in), int solid, int face; what there is not is -1
  };

  using Locate = std::function<strata::Location(const strata::Vertex&)>;

  /// The nearest point of a boundary, and how far it is: negative inside.
  struct Nearest {
    strata::Vertex point{};
    double distance = 0;
  };
  using FindNearest = std::function<std::optional<Nearest>(const strata::Vertex&)>;

  /// `locate` is asked from many threads. Keeps a reference to the input.
  /// Where there is a `nearest`, rows of CSV end with its distance and its coordinates; empty where there is none.
  LocationTable(Locate locate, const SceneInput& input, Form form, FindNearest nearest = {})
      : locate_(std::move(locate)), nearest_(std::move(nearest)), input_(input), form_(form) {}

  /// What stands before the rows; a PLY file says how many there are.
  [[nodiscard]] std::string header(std::uint64_t count) const;
  /// Appends a row per point (x0 y0 z0 x1 ...) and counts them. Safe to call from many threads.
  void append_rows(std::span<const double> coordinates, std::string& rows, WhereCounts& counts) const;

 private:
  void append_csv(const strata::Vertex& q, const strata::Location& location, std::string& rows) const;
  void append_all(const strata::Location& location, std::string& rows) const;
  void append_nearest(const strata::Vertex& q, std::string& rows) const;
  void append_ply(const strata::Vertex& q, const strata::Location& location, std::string& rows) const;

  Locate locate_;
  FindNearest nearest_;
  const SceneInput& input_;
  Form form_;
};
