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
#include "common/tell.h"
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
#include "textured_face.h"
#include "threads.h"

namespace {

using strata::Vertex;

constexpr double units_of_textures =
    5;  ///< of a picture: how long parts of one color are at most, where there is an image

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

/// How long parts of faces with images may be on paper, for a picture of so many units.
double longest_side(std::span<const strata::Solid> solids, const View& view, double width) {
  PaperPoint lower{HUGE_VAL, HUGE_VAL}, upper{-HUGE_VAL, -HUGE_VAL};
  for (const strata::Solid& s : solids)
    for (const Vertex& v : s.mesh().vertices)
      if (const auto at = view.place(v))
        for (std::size_t i = 0; i < 2; ++i) {
          lower[i] = std::min(lower[i], (*at)[i]);
          upper[i] = std::max(upper[i], (*at)[i]);
        }
  return std::max(upper[0] - lower[0], upper[1] - lower[1]) / width * units_of_textures;
}

/// Fills pages back to front.
class Painter {
 public:
  Painter(std::span<const strata::Solid> solids, const View& view, double width)
      : solids_(solids),
        colors_(solids.begin(), solids.end()),
        view_(view),
        longest_side_(longest_side(solids, view, width)) {}

  [[nodiscard]] std::span<const FaceColors> colors() const { return colors_; }

  /// Paints a part of a face of a solid.
  void paint(const std::array<Vertex, 3>& corners, std::uint32_t solid, std::uint32_t face, int shade,
             SvgPage& page) const {
    const FaceColors& colors = colors_[solid];
    const auto polygon = [&](const std::array<Vertex, 3>& t, const std::optional<ScreenColor>& color) {
      page.add_polygon(view_.polygon({t.begin(), t.end()}), fill_of(shade, color));
    };
    if (!colors.has_image(face)) return polygon(corners, colors.of(face));
    const strata::Mesh& mesh = solids_[solid].mesh();
    const auto [a, b, c] = mesh.triangles[face];
    const std::array<Vertex, 3> whole{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    TexturedTriangle triangle{corners, {}};
    for (std::size_t k = 0; k < 3; ++k) triangle.places[k] = place_in(whole, corners[k]);
    for (const ColoredTriangle& part : divided(triangle, colors, face, view_, longest_side_))
      polygon(part.corners, part.color);
  }

 private:
  std::span<const strata::Solid> solids_;
  std::vector<FaceColors> colors_;
  const View& view_;
  double longest_side_;
};

/// The painter's way: everything that faces the eye, back to front.
void fill_back_to_front(const Painter& painter, const strata::LayerDecomposition& layers, const View& view,
                        SvgPage& page) {
  const strata::Scene& scene = layers.scene();
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
    painter.paint(corners, scene.solid_of(face), scene.local(face), shade, page);
  }
}

SvgPage draw_page(const DrawSettings& draw, std::span<const strata::Solid> solids, const strata::Visibility& visibility,
                  std::span<const strata::SeenEdge> edges, const View& view, std::vector<std::string>& notes) {
  SvgPage page;
  if (draw.style != "lines") {
    const Painter painter(solids, view, draw.width);
    for (const FaceColors& c : painter.colors()) notes.insert(notes.end(), c.notes().begin(), c.notes().end());
    fill_back_to_front(painter, visibility.decomposition(), view, page);
  }
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
  verb.add_option(
          "--style", draw.style,
          "lines: hidden lines removed; fill: shaded faces, in their colors and textures if they have any; both")
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
  std::vector<std::string> notes;
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
      return draw_page(draw, solids, visibility, edges, view, notes).text(draw.width, "strata draw");
    });
  } catch (const strata::Cancelled&) {
    watch.on_stop(OnStop::leave);  // says why
    throw;
  }
  if (!settings.quiet)
    for (const std::string& note : notes) tell("strata: note: {}\n", note);
  const std::string picture = png ? svg_to_png(svg) : svg;
  report["seconds"]["draw"] = stopwatch.lap();
  watch.on_stop(OnStop::finish);
  write_text(settings.output, picture);
  report["bytes"] = picture.size();
  if (!settings.report.empty()) write_report(settings.report, std::move(report));
  return ExitCode::ok;
}
