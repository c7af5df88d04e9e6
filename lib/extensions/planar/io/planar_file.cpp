#include <algorithm>
#include <limits>
#include <utility>

#include "core/io/file.h"
#include "extensions/planar/io/scanner.h"
#include "strata/planar.h"

namespace strata::planar {
namespace {

std::string_view name_of(PlanarFormat format) {
  switch (format) {
    case PlanarFormat::wkt:
      return "WKT";
    case PlanarFormat::geojson:
      return "GeoJSON";
    case PlanarFormat::svg:
      return "SVG";
  }
  return "";
}

/// Negative zero is the number zero.
void append_number(std::string& text, double x) { io::append_coordinate(text, x + 0.0); }

/// Writes points of a region.
class Points {
 public:
  Points(const Region& region, Coordinates coordinates) : places_(region.loops.places), coordinates_(coordinates) {}

  void append(std::string& text, std::uint32_t v, char separator) const {
    const PlanePoint nearest = places_.place[v];
    if (coordinates_ == Coordinates::nearest || places_.is_double(v)) {
      append_number(text, nearest[0]);
      text.push_back(separator);
      append_number(text, nearest[1]);
    } else {
      const RationalPlacement exact = exact_position(places_, v);
      io::append_coordinate(text, exact[0], nearest[0] + 0.0);
      text.push_back(separator);
      io::append_coordinate(text, exact[1], nearest[1] + 0.0);
    }
  }

 private:
  const Places& places_;
  Coordinates coordinates_;
};

/// Rings with the first vertex repeated, in brackets: WKT and GeoJSON.
void append_polygons(std::string& text, const Region& region, const Points& points, std::string_view open,
                     std::string_view close, char separator, bool wrapped) {
  const bool is_json = open == "[";
  for (std::uint32_t p = 0; p < region.polygons(); ++p) {
    text.append(p > 0 ? "," : "");
    if (wrapped) text.append(open);
    for (std::uint32_t l = region.first_loop[p]; l < region.first_loop[p + 1]; ++l) {
      text.append(l > region.first_loop[p] ? "," : "").append(open);
      const auto loop = region.loops.loop(l);
      for (std::size_t i = 0; i <= loop.size(); ++i) {
        text.append(i > 0 ? "," : "").append(is_json ? "[" : "");
        points.append(text, loop[i < loop.size() ? i : 0], separator);
        text.append(is_json ? "]" : "");
      }
      text.append(close);
    }
    if (wrapped) text.append(close);
  }
}

std::string to_wkt(const Region& region, const Points& points) {
  if (region.empty()) return "POLYGON EMPTY\n";
  const bool is_single = region.polygons() == 1;
  std::string text = is_single ? "POLYGON (" : "MULTIPOLYGON (";
  append_polygons(text, region, points, "(", ")", ' ', !is_single);
  return text + ")\n";
}

std::string to_geojson(const Region& region, const Points& points) {
  const bool is_single = region.polygons() == 1;
  std::string text = is_single ? R"({"type":"Polygon","coordinates":[)" : R"({"type":"MultiPolygon","coordinates":[)";
  append_polygons(text, region, points, "[", "]", ',', !is_single);
  return text + "]}\n";
}

std::string path_of(const Region& region, const Points& points) {
  std::string text;
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    char command = 'M';
    for (const std::uint32_t v : region.loops.loop(l)) {
      text.push_back(std::exchange(command, 'L'));
      points.append(text, v, ' ');
    }
    text.append("Z\n");
  }
  return text;
}

std::string to_svg(const Region& region, const Points& points) {
  double box[4] = {0, 0, 0, 0};
  for (std::size_t i = 0; i < region.loops.vertices.size(); ++i) {
    const PlanePoint& p = region.loops.places.place[region.loops.vertices[i]];
    box[0] = i == 0 ? p[0] : std::min(box[0], p[0]);
    box[1] = i == 0 ? p[1] : std::min(box[1], p[1]);
    box[2] = i == 0 ? p[0] : std::max(box[2], p[0]);
    box[3] = i == 0 ? p[1] : std::max(box[3], p[1]);
  }
  std::string text = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox=")";
  constexpr double largest = std::numeric_limits<double>::max();
  for (const double x : {box[0], box[1], std::min(box[2] - box[0], largest), std::min(box[3] - box[1], largest)}) {
    append_number(text, x);
    text.push_back(' ');
  }
  text.back() = '"';
  return text + ">\n<path d=\"" + path_of(region, points) + "\"/>\n</svg>\n";
}

}  // namespace

std::optional<PlanarFormat> planar_format_named(std::string_view name) {
  if (name == "wkt" || name == "txt") return PlanarFormat::wkt;
  if (name == "geojson" || name == "json") return PlanarFormat::geojson;
  if (name == "svg") return PlanarFormat::svg;
  return std::nullopt;
}

std::optional<PlanarFormat> planar_format_of(const FilePath& path) {
  std::string extension = std::filesystem::path(path.text()).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension.empty() ? std::nullopt : planar_format_named(std::string_view(extension).substr(1));
}

PlanarFile read_planar(std::string_view data, PlanarFormat format, std::string name) {
  if (constexpr std::string_view mark = "\xEF\xBB\xBF"; data.starts_with(mark)) data.remove_prefix(mark.size());
  const io::Input input{std::move(name), data};
  PlanarFile file;
  try {
    switch (format) {
      case PlanarFormat::wkt:
        file.loops = read_wkt(data, file.notes);
        break;
      case PlanarFormat::geojson:
        file.loops = read_geojson(data, file.notes);
        break;
      case PlanarFormat::svg:
        file.loops = read_svg(data, file.notes);
        break;
    }
  } catch (const io::Malformed& e) {
    throw input.error(e);
  }
  return file;
}

PlanarFile read_planar(const FilePath& given, std::optional<PlanarFormat> format) {
  const std::filesystem::path path(given.text());
  if (!format) format = planar_format_of(path);
  if (!format) throw IoError(path.string(), {}, "unknown format: .wkt, .geojson and .svg are known");
  const io::File file(path);
  const io::FileBytes bytes(file);
  return read_planar(bytes.view(), *format, path.string());
}

std::string to_text(const Region& region, PlanarFormat format, Coordinates coordinates) {
  if (coordinates == Coordinates::exact && format != PlanarFormat::wkt)
    throw IoError("output", {}, std::string(name_of(format)) + " has no exact coordinates: write WKT");
  const Points points(region, coordinates);
  switch (format) {
    case PlanarFormat::wkt:
      return to_wkt(region, points);
    case PlanarFormat::geojson:
      return to_geojson(region, points);
    case PlanarFormat::svg:
      return to_svg(region, points);
  }
  return {};
}

std::string svg_path(const Region& region) { return path_of(region, Points(region, Coordinates::nearest)); }

}  // namespace strata::planar
