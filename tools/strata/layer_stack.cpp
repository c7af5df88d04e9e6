#include "layer_stack.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

#include "common/csv.h"
#include "rounded_region.h"

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

void LayerStack::add(std::size_t plane, const std::string& at, std::size_t mesh, const planar::Region& region,
                     double area, const strata::Monitor& monitor) {
  const OutputRegion output = output_region(region, settings_, monitor);
  const planar::Region& written = output.rounded.region;
  rearranged_ += settings_.makes_solids() && !output.conflicts.empty() ? 1 : 0;
  const auto wkt = [&] { return without_line_end(to_text(written, PlanarFormat::wkt, coordinates_)); };
  switch (format_) {
    case Format::wkt:
      file_.write(wkt() + "\n");
      break;
    case Format::csv:
      file_.write(fmt::format("{},\"{}\",{},{},\"{}\"\n", plane, at, mesh, number(area), wkt()));
      break;
    case Format::geojson:
      file_.write(fmt::format(
          "{}\n{{\"type\":\"Feature\",\"properties\":{{\"plane\":{},\"at\":\"{}\",\"mesh\":{},\"area\":{}}},"
          "\"geometry\":{}}}",
          is_first_ ? "" : ",", plane, at, mesh, number(area),
          without_line_end(to_text(written, PlanarFormat::geojson))));
      break;
    case Format::svg:
      file_.write(fmt::format("<g data-plane=\"{}\" data-at=\"{}\" data-mesh=\"{}\"><path d=\"{}\"/></g>\n", plane, at,
                              mesh, svg_path(written)));
      break;
  }
  is_first_ = false;
}

void LayerStack::finish() {
  if (format_ == Format::geojson) file_.write("\n]}\n");
  if (format_ == Format::svg) file_.write("</svg>\n");
  file_.finish();
}
