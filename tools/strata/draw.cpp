#include "draw.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "common/progress.h"
#include "common/stopwatch.h"
#include "common/view.h"
#include "common/watch.h"
#include "face_colors.h"
#include "files.h"
#include "report.h"
#include "scene_input.h"
#include "strata/query.h"
#include "strata/solid.h"
#include "svg.h"
#include "svg_to_png.h"
#include "threads.h"

namespace {

using strata::Vertex;

Vertex vertex(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

strata::Origin origin_of(const DrawSettings& draw) {
  if (draw.from.empty() == draw.direction.empty()) throw UsageError("give either --from or --direction");
  if (!draw.from.empty()) return strata::Origin::point(vertex(draw.from));
  if (vertex(draw.direction) == Vertex{}) throw UsageError("--direction is zero");
  return strata::Origin::direction(vertex(draw.direction));
}

std::vector<strata::Solid> make_solids(std::span<const LoadedMesh> operands, const Settings& settings) {
  std::vector<strata::Solid> solids;
  for (std::size_t k = 0; k < operands.size(); ++k) solids.push_back(make_attributed_solid(operands, k, settings));
  return solids;
}

/// Layers of solids. Seen from outside, solids that cross look like their union, which has the curves where they cross
/// as edges, and becomes the only solid.
strata::LayerDecomposition decompose(std::vector<strata::Solid>& solids, const strata::Origin& origin,
                                     const strata::Monitor& monitor) {
  strata::LayerDecomposition layers(strata::scene_of(solids), origin, monitor);
  if (layers.cuts_at_crossings() == 0 || layers.windings_of_origin() != strata::WindingNumbers()) return layers;
  solids = {strata::union_(solids)};
  return strata::LayerDecomposition(strata::scene_of(solids), origin, monitor);
}

struct Box {
  Vertex lower{HUGE_VAL, HUGE_VAL, HUGE_VAL}, upper{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
};

Vertex centre_of(std::span<const strata::Solid> solids) {
  Box box;
  for (const strata::Solid& s : solids)
    for (const Vertex& v : s.mesh().vertices)
      for (std::size_t i = 0; i < 3; ++i) {
        box.lower[i] = std::min(box.lower[i], v[i]);
        box.upper[i] = std::max(box.upper[i], v[i]);
      }
  Vertex centre{};
  for (std::size_t i = 0; i < 3; ++i)
    if (box.lower[i] <= box.upper[i]) centre[i] = box.lower[i] / 2 + box.upper[i] / 2;
  return centre;
}

Vertex rounded(const strata::RationalPoint& p) {
  return {strata::to_nearest_double(p[0]), strata::to_nearest_double(p[1]), strata::to_nearest_double(p[2])};
}

/// Lines of one kind: the stretches' ends are exact until they are projected.
std::vector<PaperPath> draw_lines(const strata::Visibility& visibility, std::span<const strata::SeenEdge> edges,
                                  strata::EdgeKind kind, const View& view) {
  const strata::Scene& scene = visibility.decomposition().scene();
  std::vector<PaperPath> lines;
  for (const strata::SeenEdge& e : edges) {
    if (e.kind != kind) continue;
    const strata::RationalPoint a = scene.position(e.a), b = scene.position(e.b);
    const auto at = [&](const strata::Rational& t) {
      if (t == 0) return rounded(a);
      if (t == 1) return rounded(b);
      strata::RationalPoint p;
      for (std::size_t i = 0; i < 3; ++i) p[i] = a[i] + t * (b[i] - a[i]);
      return rounded(p);
    };
    for (const strata::Stretch& s : e.seen) {
      PaperPath line = view.segment(at(s.from), at(s.to));
      if (!line.empty()) lines.push_back(std::move(line));
    }
  }
  return lines;
}

Vertex unit_normal(const std::array<Vertex, 3>& t) {
  const Vertex u{t[1][0] - t[0][0], t[1][1] - t[0][1], t[1][2] - t[0][2]};
  const Vertex w{t[2][0] - t[0][0], t[2][1] - t[0][1], t[2][2] - t[0][2]};
  const Vertex n{u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  return length > 0 ? Vertex{n[0] / length, n[1] / length, n[2] / length} : Vertex{};
}

/// A bluish grey for a shade from 0 to 240, or a color at this brightness.
std::string fill_of(int shade, const std::optional<ScreenColor>& color) {
  if (!color) return fmt::format("#{0:02x}{0:02x}{1:02x}", shade, std::min(shade + 6, 255));
  const auto byte = [&](double x) { return static_cast<int>(std::lround(255 * x * shade / 240)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte((*color)[0]), byte((*color)[1]), byte((*color)[2]));
}

/// The painter's way: everything that faces the eye, back to front.
void fill_back_to_front(std::span<const strata::Solid> solids, const strata::LayerDecomposition& layers,
                        const View& view, SvgPage& page) {
  const strata::Scene& scene = layers.scene();
  const std::vector<FaceColors> colors(solids.begin(), solids.end());
  const bool from_outside = layers.windings_of_origin() == strata::WindingNumbers();
  for (const std::uint32_t p : layers.back_to_front()) {
    if (from_outside && layers.sign(p) > 0) continue;  // turned away: something is before it
    const auto exact = layers.triangle(p);
    const std::array<Vertex, 3> corners{rounded(exact[0]), rounded(exact[1]), rounded(exact[2])};
    Vertex normal = unit_normal(corners);
    if (layers.sign(p) > 0)
      for (double& x : normal) x = -x;
    const int shade = static_cast<int>(std::lround(view.brightness(normal) * 48)) * 5;
    const std::uint32_t face = layers.face_of(p);
    page.add_polygon(view.polygon({corners.begin(), corners.end()}),
                     fill_of(shade, colors[scene.solid_of(face)].of(scene.local(face))));
  }
}

SvgPage draw_page(const DrawSettings& draw, std::span<const strata::Solid> solids, const strata::Visibility& visibility,
                  std::span<const strata::SeenEdge> edges, const View& view) {
  SvgPage page;
  if (draw.style != "lines") fill_back_to_front(solids, visibility.decomposition(), view, page);
  if (draw.style != "fill") {
    page.add_lines(draw_lines(visibility, edges, strata::EdgeKind::crease, view), draw.width / 1250, "#333");
    page.add_lines(draw_lines(visibility, edges, strata::EdgeKind::loop, view), draw.width / 500, "#000");
  }
  return page;
}

}  // namespace

void add_draw_options(CLI::App& verb, DrawSettings& draw) {
  const auto three = [&](const char* name, std::vector<double>& numbers, const char* what) {
    verb.add_option(name, numbers, what)->delimiter(',')->expected(3)->type_name("x,y,z");
  };
  three("--from", draw.from, "Perspective from this point");
  three("--direction", draw.direction, "Parallel projection: the direction in which one looks");
  three("--towards", draw.towards, "Where a perspective looks; by default the middle of the meshes");
  three("--up", draw.up, "What is upwards in the picture; by default 0,0,1");
  verb.add_option("--style", draw.style,
                  "lines: hidden lines removed; fill: shaded faces, in their colors if they have any; both")
      ->check(CLI::IsMember({"lines", "fill", "both"}))
      ->capture_default_str();
  verb.add_option("--crease", draw.crease_angle, "Edges are drawn where faces meet at more than this angle")
      ->check(CLI::Range(0.0, 180.0))
      ->type_name("DEGREES")
      ->capture_default_str();
  verb.add_option("--width", draw.width, "Longer side of the picture in units; pixels of a PNG")
      ->check(CLI::Range(10.0, 20000.0))
      ->capture_default_str();
}

ExitCode run_draw(const DrawSettings& draw, const Settings& settings) {
  Watch watch(settings.timeout);
  Stopwatch stopwatch;
  Json report = {{"operation", "draw"}, {"operands", Json::array()}, {"seconds", Json::object()}};
  const strata::Origin origin = origin_of(draw);
  const bool png = settings.output.ends_with(".png");
  const std::vector<LoadedMesh> operands = read_operands(settings);
  for (const LoadedMesh& o : operands) report["operands"].push_back(o.path);
  report["seconds"]["read"] = stopwatch.lap();

  watch.on_stop(OnStop::ask);
  ProgressBar bar(settings.progress, settings.quiet);
  const strata::Progress progress = [&bar](double fraction) { bar.show(fraction); };
  const strata::Monitor monitor(&watch.token(), &progress);
  std::string svg;
  try {
    svg = on_threads(settings, [&] {
      std::vector<strata::Solid> solids = make_solids(operands, settings);
      const Vertex centre = draw.towards.empty() ? centre_of(solids) : vertex(draw.towards);
      const View view(origin, centre, draw.up.empty() ? Vertex{0, 0, 1} : vertex(draw.up));
      const strata::Visibility visibility(decompose(solids, origin, monitor));
      report["layers"] = visibility.decomposition().layer_count();
      report["cuts"] = visibility.decomposition().cuts_of_cycles();
      report["seconds"]["layers"] = stopwatch.lap();
      std::vector<strata::SeenEdge> edges;
      if (draw.style != "fill") edges = strata::find_seen_edges(visibility, draw.crease_angle, monitor);
      report["seen_edges"] = edges.size();
      report["seconds"]["visibility"] = stopwatch.lap();
      return draw_page(draw, solids, visibility, edges, view).text(draw.width, "strata draw");
    });
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  const std::string picture = png ? svg_to_png(svg) : svg;
  report["seconds"]["draw"] = stopwatch.lap();
  watch.on_stop(OnStop::finish);
  write_text(settings.output, picture);
  report["bytes"] = picture.size();
  if (!settings.report.empty()) write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
