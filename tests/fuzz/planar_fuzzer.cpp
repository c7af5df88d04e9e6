// One target per format of the plane: STRATA_FUZZ_FORMAT is wkt, geojson or svg.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "fuzz.h"
#include "io_error_law.h"
#include "strata/planar.h"

namespace strata::fuzz {
namespace {

using planar::Coordinates;
using planar::PlanarFile;
using planar::PlanarFormat;
using planar::Region;

constexpr PlanarFormat tested = PlanarFormat::STRATA_FUZZ_FORMAT;
constexpr const char* file_name = "fuzz";

/// The law of PlanarFile.
void check(const PlanarFile& file) {
  const planar::Loops& loops = file.loops;
  require(loops.places.meets.empty(), "points are given");
  require(loops.edge_line.size() == loops.vertices.size(), "every edge has a line, or none");
  for (std::uint32_t p = 0; p < loops.places.size(); ++p)
    for (std::size_t i = 0; i < 2; ++i) {
      const double nearest = loops.places.place[p][i];
      require(std::isfinite(nearest), "coordinates are finite");
      require(nearest == to_nearest_double(planar::exact_position(loops.places, p)[i]),
              "places are the nearest doubles");
    }
  for (const std::uint32_t v : loops.vertices) require(v < loops.places.size(), "vertices are points");
  require(loops.first_vertex.back() == loops.vertices.size(), "loops have all vertices");
  for (std::uint32_t l = 0; l < loops.size(); ++l) require(!loops.loop(l).empty(), "loops have vertices");
  for (const std::string& note : file.notes) require(!note.empty(), "notes say something");
}

bool same(const Region& a, const Region& b) { return planar::canonical_form(a) == planar::canonical_form(b); }

Region read_region(const std::string& text, PlanarFormat format) {
  return planar::fill(planar::read_planar(text, format, "written").loops);
}

bool has_doubles_only(const Region& region) {
  const auto& vertices = region.loops.vertices;
  return std::all_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) {
    const planar::RationalPlacement p = planar::exact_position(region.loops.places, v);
    const planar::PlanePoint& nearest = region.loops.places.place[v];
    return to_rational(nearest[0]) == p[0] && to_rational(nearest[1]) == p[1];
  });
}

void check_written(const Region& region, PlanarFormat format, Coordinates coordinates) {
  const std::string text = planar::to_text(region, format, coordinates);
  require(text.find("inf") == text.npos && text.find("nan") == text.npos, "numbers that are written are finite");
  const Region again = read_region(text, format);
  require(same(again, region), "what is written reads back the same");
  require(planar::to_text(again, format, coordinates) == text, "what was written is written again");
}

void check_region(const Region& region) {
  require(region.empty() ? area(region) == 0 : area(region) > 0, "polygons have an area");
  check_written(region, PlanarFormat::wkt, Coordinates::exact);
  if (has_doubles_only(region)) {
    for (const PlanarFormat format : {PlanarFormat::wkt, PlanarFormat::geojson, PlanarFormat::svg})
      check_written(region, format, Coordinates::nearest);
  } else {  // rounded polygons may cross themselves, but can be read
    (void)read_region(planar::to_text(region, tested), tested);
  }
}

/// A short text may ask for very many crossings; such files are read, and not filled.
bool is_costly(const PlanarFile& file) { return file.loops.vertices.size() > 40; }

void check(std::string_view text) {
  try {
    const PlanarFile file = planar::read_planar(text, tested, file_name);
    check(file);
    if (!is_costly(file)) check_region(planar::fill(file.loops));
  } catch (const IoError& error) {
    check_error(error, file_name);
  }
}

}  // namespace
}  // namespace strata::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return strata::fuzz::run(data, size, [](std::string_view text) { strata::fuzz::check(text); });
}
