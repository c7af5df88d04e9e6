#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strata/io/io_error.h"
#include "strata/planar/region.h"

namespace strata::plane {

/// Files of the plane.
enum class PlanarFormat {
  wkt,      ///< POLYGON, MULTIPOLYGON, GEOMETRYCOLLECTION of these; coordinates may be quotients: 1/3
  geojson,  ///< Polygon, MultiPolygon, GeometryCollection, Feature, FeatureCollection
  svg,      ///< paths of straight lines: M L H V Z and m l h v z
};

/// By a file's extension (.wkt, .txt; .geojson, .json; .svg) or by a name ("wkt", "geojson", "svg"), in lower case.
[[nodiscard]] std::optional<PlanarFormat> planar_format_of(const std::filesystem::path& path);
[[nodiscard]] std::optional<PlanarFormat> planar_format_named(std::string_view name);

/// What a file says: loops whose nonzero winding is the point set meant. Rings of polygons (WKT, GeoJSON) are turned so
/// that shells go counter-clockwise and holes clockwise, by the signs of their areas; paths (SVG) are as they are. A
/// repeated last vertex is left out.
struct PlanarFile {
  Loops loops;
  std::vector<std::string> notes;  ///< what was left out, one sentence each
};

/// Reads polygons; coordinates become their nearest doubles, quotients and sums of relative coordinates stay exact.
/// Of SVG, paths that are drawn where they stand; clip paths, fill rules and other shapes are told in notes. A byte
/// order mark is passed over. Throws IoError: missing, unreadable or malformed files, other geometries, curves in paths, and
/// transformations. O(size of the file).
[[nodiscard]] PlanarFile read_planar(const std::filesystem::path& path, std::optional<PlanarFormat> format = {});
[[nodiscard]] PlanarFile read_planar(std::string_view data, PlanarFormat format, std::string name);

/// How coordinates are written that are no doubles.
enum class Coordinates {
  nearest,  ///< as the nearest doubles, in the shortest digits that read back the same
  exact,    ///< as quotients in lowest terms; WKT only
};

/// A region as text; negative zeros are zeros. Throws IoError for exact coordinates in formats that have none.
[[nodiscard]] std::string to_text(const Region& region, PlanarFormat format,
                                  Coordinates coordinates = Coordinates::nearest);

}  // namespace strata::plane
