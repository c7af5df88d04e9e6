#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common/output_file.h"
#include "settings.h"
#include "strata/monitor.h"
#include "strata/planar.h"

/// Polygons of many planes and meshes in one file, written as they come:
///
/// | format  | what is written                                                                       |
/// |---------|---------------------------------------------------------------------------------------|
/// | wkt     | a geometry per line                                                                   |
/// | csv     | plane,at,mesh,area,wkt: a row per plane and mesh                                      |
/// | geojson | a FeatureCollection; features have the properties plane, at, mesh and area            |
/// | svg     | a group per plane and mesh, with data-plane, data-at and data-mesh                    |
class LayerStack {
 public:
  enum class Format { wkt, csv, geojson, svg };
  /// By the extension of -o or by --format. Throws UsageError, also for exact coordinates where there are none.
  [[nodiscard]] static Format format_of(const Settings& settings);

  /// Refers to the settings. `lower`, `upper`: corners of everything in the planes' coordinates, for pictures. Throws
  /// strata::IoError.
  LayerStack(const Settings& settings, strata::planar::PlanePoint lower, strata::planar::PlanePoint upper);

  /// The polygons of a mesh in a plane.
  struct Layer {
    std::size_t plane = 0;
    std::string at;  ///< where the plane is
    std::size_t mesh = 0;
    strata::planar::Region region;
    std::optional<double> area;  ///< computed from the region where it is not given
  };
  /// Unless quotients are written, the region is rounded such that it is one again. Layers are made text in parallel,
  /// some at a time, and written in the order in which they came.
  void add(Layer layer, const strata::Monitor& monitor);
  /// Writes the layers that wait for others.
  void flush(const strata::Monitor& monitor);
  void finish();

  /// How many regions with their vertices at the nearest doubles would meet themselves, and were rearranged.
  [[nodiscard]] std::size_t rearranged() const { return rearranged_; }

 private:
  const Settings& settings_;
  Format format_;
  strata::planar::Coordinates coordinates_;
  OutputFile file_;
  struct Text {
    std::string text;
    bool is_rearranged = false;
  };
  [[nodiscard]] Text text_of(Layer layer, const strata::Monitor& monitor) const;

  std::vector<Layer> waiting_;
  bool is_first_ = true;
  std::size_t rearranged_ = 0;
};
