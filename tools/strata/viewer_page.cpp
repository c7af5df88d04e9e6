#include "viewer_page.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string_view>

#include "common/base64.h"
#include "common/json_report.h"
#include "strata/measure.h"
#include "viewer_texts.h"

namespace {

using strata::Vertex;

constexpr std::array<std::array<int, 3>, 8> palette{{{122, 166, 216},
                                                     {232, 161, 90},
                                                     {127, 191, 123},
                                                     {217, 128, 128},
                                                     {169, 145, 204},
                                                     {201, 180, 88},
                                                     {111, 191, 191},
                                                     {213, 143, 184}}};

/// The middle of all parts, and half the diagonal of their box: places are relative to these, so that they fit floats.
struct Frame {
  Vertex middle{};
  double unit = 1;

  [[nodiscard]] std::array<float, 3> operator()(const Vertex& v) const {
    std::array<float, 3> place;
    for (std::size_t i = 0; i < 3; ++i) place[i] = static_cast<float>(v[i] / unit - middle[i] / unit);
    return place;
  }
};

Frame frame_of(const std::vector<ViewerPart>& parts) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vertex lower{infinity, infinity, infinity}, upper{-infinity, -infinity, -infinity}, half{};
  for (const ViewerPart& part : parts) {
    const strata::BoundingBox box = part.solid.bounding_box();
    for (std::size_t i = 0; i < 3; ++i) {
      lower[i] = std::min(lower[i], box.lower[i]);
      upper[i] = std::max(upper[i], box.upper[i]);
    }
  }
  Frame frame;
  if (lower[0] > upper[0]) return frame;
  for (std::size_t i = 0; i < 3; ++i) {
    frame.middle[i] = lower[i] / 2 + upper[i] / 2;
    half[i] = upper[i] / 2 - lower[i] / 2;
  }
  const double length = std::hypot(half[0], half[1], half[2]);
  if (length > 0 && std::isfinite(length)) frame.unit = length;
  return frame;
}

/// Arrays as they are in memory, little endian.
template <class T>
void append(std::string& bytes, T number) {
  static_assert(sizeof(T) == 4);
  const auto bits = std::bit_cast<std::uint32_t>(number);
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(bits >> shift & 255);
}

/// The arrays of all parts, one after the other.
class Arrays {
 public:
  explicit Arrays(const Frame& frame) : frame_(frame) {}

  void add(const strata::Solid& solid, const strata::Monitor& monitor) {
    const auto first = static_cast<std::uint32_t>(vertices_);
    for (const Vertex& v : solid.mesh().vertices) add_vertex(v);
    for (const strata::Triangle& t : solid.mesh().triangles)
      for (const std::uint32_t corner : t) append(triangle_bytes_, first + corner);
    triangles_ += solid.mesh().triangles.size();
    add_edges(strata::canonical_form(solid.exact_mesh(), monitor));
  }

  /// How many vertices, triangles and edges there are so far.
  [[nodiscard]] std::array<std::size_t, 3> ends() const { return {vertices_, triangles_, edges_}; }
  [[nodiscard]] const std::string& position_bytes() const { return position_bytes_; }
  [[nodiscard]] const std::string& triangle_bytes() const { return triangle_bytes_; }
  [[nodiscard]] const std::string& edge_bytes() const { return edge_bytes_; }

 private:
  void add_vertex(const Vertex& v) {
    for (const float x : frame_(v)) append(position_bytes_, x);
    ++vertices_;
  }

  /// Each side of a facet once: that of the neighbour runs the other way.
  void add_edges(const strata::CanonicalForm& form) {
    const auto first = static_cast<std::uint32_t>(vertices_);
    for (const strata::RationalPoint& p : form.vertices)
      add_vertex({strata::to_nearest_double(p[0]), strata::to_nearest_double(p[1]), strata::to_nearest_double(p[2])});
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (const strata::CanonicalFacets& facets : form.planes)
      for (const std::vector<std::uint32_t>& loop : facets.loops)
        for (std::size_t i = 0; i < loop.size(); ++i) sides.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
    for (const auto& [a, b] : sides) {
      append(edge_bytes_, first + a);
      append(edge_bytes_, first + b);
    }
    edges_ += sides.size();
  }

  Frame frame_;
  std::string position_bytes_, triangle_bytes_, edge_bytes_;
  std::size_t vertices_ = 0, triangles_ = 0, edges_ = 0;
};

/// JSON that may stand in HTML.
std::string embedded(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

}  // namespace

std::string viewer_page(const std::string& title, const std::vector<ViewerPart>& parts,
                        const strata::Monitor& monitor) {
  const Frame frame = frame_of(parts);
  Arrays arrays(frame);
  Json listed = Json::array();
  for (const ViewerPart& part : parts) {
    arrays.add(part.solid, monitor);
    listed.push_back({{"name", part.name},
                      {"color", palette[listed.size() % palette.size()]},
                      {"away", std::array{0, 0, 0}},
                      {"ends", arrays.ends()},
                      {"facts", part.facts},
                      {"shown", part.is_shown}});
  }
  const Json data = {{"title", title},
                     {"slider", "one"},
                     {"frame", {{"middle", frame.middle}, {"unit", frame.unit}}},
                     {"positions", base64(arrays.position_bytes())},
                     {"triangles", base64(arrays.triangle_bytes())},
                     {"edges", base64(arrays.edge_bytes())},
                     {"parts", std::move(listed)}};
  return std::string(viewer_texts::before_data) + embedded(data) + std::string(viewer_texts::after_data);
}
