#include "layer_stack.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "common/csv.h"
#include "rounded_region.h"
#include "threads.h"

namespace {

namespace planar = strata::planar;
using planar::PlanarFormat;

constexpr std::array<std::pair<const char*, LayerStack::Format>, 4> formats{{{"wkt", LayerStack::Format::wkt},
                                                                             {"csv", LayerStack::Format::csv},
                                                                             {"geojson", LayerStack::Format::geojson},
                                                                             {"svg", LayerStack::Format::svg}}};

std::string number(double x) {
  std::string text(longest_number, ' ');
  text.resize(static_cast<std::size_t>(append_number(text.data(), x + 0.0) - text.data()));
  return text;
}

/// The area, exact and rounded once with --exact, else from the rounded vertices, relative to the first of each loop.
double area_of(const planar::Region& region, const Settings& settings) {
  if (settings.exact) return strata::to_nearest_double(planar::area(region));
  double twice = 0;
  for (std::uint32_t l = 0; l < region.loops.size(); ++l) {
    const std::span<const std::uint32_t> loop = region.loops.loop(l);
    const planar::PlanePoint& o = region.loops.places.place[loop.front()];
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const planar::PlanePoint &p = region.loops.places.place[loop[i]], &q = region.loops.places.place[loop[i + 1]];
      twice += (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
    }
  }
  return twice / 2;
}

std::string without_line_end(std::string text) {
  if (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace

LayerStack::Format LayerStack::format_of(const Settings& settings) {
  std::string name = settings.output_format;
  if (name.empty()) name = settings.output == "-" ? "wkt" : settings.output.substr(settings.output.rfind('.') + 1);
  std::optional<Format> format;
  for (const auto& [known, f] : formats)
    if (name == known) format = f;
  if (!format)
    throw UsageError(
        fmt::format("cannot tell a format from {}; use --format with one of: wkt, csv, geojson, svg", name));
  if (settings.exact && *format != Format::wkt && *format != Format::csv)
    throw UsageError("--exact is for wkt and csv: other formats have no quotients");
  return *format;
}

LayerStack::LayerStack(const Settings& settings, planar::PlanePoint lower, planar::PlanePoint upper)
    : settings_(settings),
      format_(format_of(settings)),
      coordinates_(settings.exact ? planar::Coordinates::exact : planar::Coordinates::nearest),
      file_(settings.output) {
  if (format_ == Format::csv) file_.write("plane,at,mesh,area,wkt\n");
  if (format_ == Format::geojson) file_.write("{\"type\":\"FeatureCollection\",\"features\":[");
  if (format_ == Format::svg)
    file_.write(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\">\n", number(lower[0]),
                            number(lower[1]), number(upper[0] - lower[0]), number(upper[1] - lower[1])));
}

void LayerStack::add(Layer layer, const strata::Monitor& monitor) {
  waiting_.push_back(std::move(layer));
  constexpr std::size_t most_waiting = 64;
  if (waiting_.size() == most_waiting) flush(monitor);
}

void LayerStack::flush(const strata::Monitor& monitor) {
  std::vector<Text> texts(waiting_.size());
  on_threads(settings_, [&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, texts.size(), 1), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) texts[i] = text_of(std::move(waiting_[i]), monitor);
    });
  });
  waiting_.clear();
  for (const Text& layer : texts) {
    if (format_ == Format::geojson && !is_first_) file_.write(",");
    file_.write(layer.text);
    rearranged_ += layer.is_rearranged ? 1 : 0;
    is_first_ = false;
  }
}

LayerStack::Text LayerStack::text_of(Layer layer, const strata::Monitor& monitor) const {
  monitor.check();
  const double area = layer.area ? *layer.area : area_of(layer.region, settings_);
  const OutputRegion output = output_region(std::move(layer.region), settings_, monitor);
  const planar::Region& region = output.rounded.region;
  const bool is_rearranged = settings_.makes_solids() && !output.conflicts.empty();
  const auto wkt = [&] { return without_line_end(to_text(region, PlanarFormat::wkt, coordinates_)); };
  switch (format_) {
    case Format::wkt:
      return {wkt() + "\n", is_rearranged};
    case Format::csv:
      return {fmt::format("{},\"{}\",{},{},\"{}\"\n", layer.plane, layer.at, layer.mesh, number(area), wkt()),
              is_rearranged};
    case Format::geojson:
      return {
          fmt::format("\n{{\"type\":\"Feature\",\"properties\":{{\"plane\":{},\"at\":\"{}\",\"mesh\":{},\"area\":{}}},"
                      "\"geometry\":{}}}",
                      layer.plane, layer.at, layer.mesh, number(area),
                      without_line_end(to_text(region, PlanarFormat::geojson))),
          is_rearranged};
    case Format::svg:
      return {fmt::format("<g data-plane=\"{}\" data-at=\"{}\" data-mesh=\"{}\"><path d=\"{}\"/></g>\n", layer.plane,
                          layer.at, layer.mesh, svg_path(region)),
              is_rearranged};
  }
  return {};
}

void LayerStack::finish() {
  flush({});
  if (format_ == Format::geojson) file_.write("\n]}\n");
  if (format_ == Format::svg) file_.write("</svg>\n");
  file_.finish();
}
