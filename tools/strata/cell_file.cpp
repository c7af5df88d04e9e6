#include "cell_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "common/output_file.h"
#include "palette.h"

namespace {

using Point = std::array<double, 3>;

Point operator-(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

/// The smallest box around points.
struct Extent {
  Point lower{HUGE_VAL, HUGE_VAL, HUGE_VAL}, upper{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(const Point& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      lower[i] = std::min(lower[i], p[i]);
      upper[i] = std::max(upper[i], p[i]);
    }
  }
  [[nodiscard]] Point middle() const {
    return {lower[0] / 2 + upper[0] / 2, lower[1] / 2 + upper[1] / 2, lower[2] / 2 + upper[2] / 2};
  }
  [[nodiscard]] double size() const {
    const Point d = upper - lower;
    return std::max({d[0], d[1], d[2]});
  }
};

/// Triangles as glTF has them: positions, flat normals, colours.
class Picture {
 public:
  Picture(const Extent& all, double distance) : all_(all), middle_(all.middle()), distance_(distance) {}

  /// Without colours: the next one of the palette.
  void add_cell(const CellPolygons& polygons, const std::vector<Colour>& colours = {}) {
    Extent cell;
    for (const auto& polygon : polygons)
      for (const Point& p : polygon) cell.add(p);
    const Point away = placed(cell.middle());
    for (std::size_t p = 0; p < polygons.size(); ++p) {
      const auto& polygon = polygons[p];
      const Colour colour = colours.empty() ? palette_colour(cells_) : colours[p];
      for (std::size_t i = 2; i < polygon.size(); ++i)
        add_triangle({polygon[0], polygon[i - 1], polygon[i]}, away, colour);
    }
    ++cells_;
  }

  [[nodiscard]] std::string glb() const {
    using Json = nlohmann::ordered_json;
    const std::size_t count = colours_.size() / 4;
    const auto view = [](std::size_t from, std::size_t length) {
      return Json{{"buffer", 0}, {"byteOffset", from}, {"byteLength", length}, {"target", 34962}};
    };
    Json position = {{"bufferView", 0}, {"componentType", 5126}, {"count", count}, {"type", "VEC3"}};
    position["min"] = {extent_.lower[0], extent_.lower[1], extent_.lower[2]};
    position["max"] = {extent_.upper[0], extent_.upper[1], extent_.upper[2]};
    const Json primitive = {{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"COLOR_0", 2}}}};
    Json document = {{"asset", {{"version", "2.0"}, {"generator", "strata"}}}, {"scene", 0}};
    document["scenes"] = {{{"nodes", Json::array({0})}}};
    document["nodes"] = {{{"mesh", 0}, {"name", "cells"}}};
    document["meshes"] = {{{"primitives", Json::array({primitive})}}};
    document["accessors"] = {
        position,
        {{"bufferView", 1}, {"componentType", 5126}, {"count", count}, {"type", "VEC3"}},
        {{"bufferView", 2}, {"componentType", 5121}, {"normalized", true}, {"count", count}, {"type", "VEC4"}}};
    const std::size_t floats = positions_.size();
    document["bufferViews"] = {view(0, floats), view(floats, floats), view(2 * floats, colours_.size())};
    document["buffers"] = {{{"byteLength", 2 * floats + colours_.size()}}};
    std::string text = document.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::string binary = positions_ + normals_ + colours_;  // all lengths are multiples of four
    std::string file = "glTF";
    append(file, 2);
    append(file, 12 + 8 + text.size() + 8 + binary.size());
    append(file, text.size());
    file += "JSON" + text;
    append(file, binary.size());
    file += std::string("BIN\0", 4) + binary;
    return file;
  }

 private:
  [[nodiscard]] Point placed(const Point& p) const {
    const double size = all_.size();
    return {(p[0] - middle_[0]) / size, (p[1] - middle_[1]) / size, (p[2] - middle_[2]) / size};
  }
  void add_triangle(const std::array<Point, 3>& corners, const Point& away, const Colour& colour) {
    std::array<Point, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] = placed(corners[k]);
      for (std::size_t i = 0; i < 3; ++i) at[k][i] = static_cast<float>(at[k][i] + distance_ * away[i]);
    }
    const Point u = at[1] - at[0], v = at[2] - at[0];
    Point normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    if (!(length > 0)) return;  // too thin for floats
    for (const Point& p : at) {
      extent_.add(p);
      for (std::size_t i = 0; i < 3; ++i) {
        append_float(positions_, p[i]);
        append_float(normals_, normal[i] / length);
        colours_ += static_cast<char>(colour[i]);
      }
      colours_ += '\xff';
    }
  }
  static void append_float(std::string& bytes, double x) {
    append(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(x)));
  }
  static void append(std::string& bytes, std::size_t x) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(x >> shift);
  }

  Extent all_;
  Point middle_;
  double distance_;
  Extent extent_;
  std::string positions_, normals_, colours_;
  std::size_t cells_ = 0;
};

}  // namespace

void write_cells(const std::string& path, const std::vector<CellPolygons>& cells,
                 const std::vector<std::vector<Colour>>& colours, double distance) {
  Extent all;
  for (const CellPolygons& cell : cells)
    for (const auto& polygon : cell)
      for (const Point& p : polygon) all.add(p);
  Picture picture(all, distance);
  for (std::size_t c = 0; c < cells.size(); ++c)
    picture.add_cell(cells[c], colours.empty() ? std::vector<Colour>{} : colours[c]);
  OutputFile file(path);
  file.write(picture.glb());
  file.finish();
}

void write_cells(const std::string& path, const std::vector<CellPolygons>& cells, double distance) {
  write_cells(path, cells, {}, distance);
}
