#include "svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace {

/// The numbers of the segments that end at each place.
using Ends = std::map<PaperPoint, std::vector<std::size_t>>;

/// Follows segments from an end of one on, as long as exactly one other goes on.
void follow(PaperPath& run, const std::vector<PaperPath>& segments, const Ends& ends, std::vector<bool>& used) {
  while (true) {
    const auto& here = ends.at(run.back());
    if (here.size() != 2) return;
    const auto next = std::find_if(here.begin(), here.end(), [&](std::size_t i) { return !used[i]; });
    if (next == here.end()) return;
    used[*next] = true;
    const PaperPath& s = segments[*next];
    run.push_back(s.front() == run.back() ? s.back() : s.front());
  }
}

bool is_straight(const PaperPoint& a, const PaperPoint& b, const PaperPoint& c) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - b[0], vy = c[1] - b[1];
  const double size = std::hypot(ux, uy) * std::hypot(vx, vy);
  return std::abs(ux * vy - uy * vx) <= 1e-9 * size && ux * vx + uy * vy >= 0;
}

PaperPath straightened(const PaperPath& run) {
  PaperPath path;
  for (const PaperPoint& p : run) {
    if (!path.empty() && p == path.back()) continue;
    if (path.size() >= 2 && is_straight(path[path.size() - 2], path.back(), p)) path.pop_back();
    path.push_back(p);
  }
  return path;
}

struct Bounds {
  PaperPoint lower{HUGE_VAL, HUGE_VAL}, upper{-HUGE_VAL, -HUGE_VAL};

  void add(const PaperPoint& p) {
    for (std::size_t i = 0; i < 2; ++i) {
      lower[i] = std::min(lower[i], p[i]);
      upper[i] = std::max(upper[i], p[i]);
    }
  }
};

/// Places on the page in units of it.
struct Fit {
  PaperPoint lower;
  double scale, margin;

  void print(std::string& out, const PaperPoint& p) const {
    fmt::format_to(std::back_inserter(out), "{:.7g} {:.7g}", (p[0] - lower[0]) * scale + margin,
                   (p[1] - lower[1]) * scale + margin);
  }
};

void print_path(std::string& out, const PaperPath& path, bool closed, const Fit& fit) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    out += i == 0 ? 'M' : 'L';
    fit.print(out, path[i]);
  }
  if (closed) out += 'Z';
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::vector<PaperPath> join_runs(std::vector<PaperPath> segments) {
  std::erase_if(segments, [](const PaperPath& s) { return s.size() != 2 || s[0] == s[1]; });
  Ends ends;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    ends[segments[i][0]].push_back(i);
    ends[segments[i][1]].push_back(i);
  }
  std::vector<bool> used(segments.size(), false);
  std::vector<PaperPath> runs;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (used[i]) continue;
    used[i] = true;
    PaperPath run = segments[i];
    follow(run, segments, ends, used);
    std::reverse(run.begin(), run.end());
    follow(run, segments, ends, used);
    runs.push_back(straightened(run));
  }
  return runs;
}

void SvgPage::add_lines(std::vector<PaperPath> segments, double width, std::string_view colour) {
  auto runs = join_runs(std::move(segments));
  if (!runs.empty()) layers_.push_back({std::move(runs), width, std::string(colour)});
}

void SvgPage::add_polygon(const PaperPath& corners, std::string_view colour) {
  if (corners.size() < 3) return;
  if (layers_.empty() || layers_.back().width != 0 || layers_.back().colour != colour)
    layers_.push_back({{}, 0, std::string(colour)});
  layers_.back().paths.push_back(corners);
}

std::string SvgPage::text(double width, std::string_view title) const {
  Bounds bounds;
  for (const Layer& l : layers_)
    for (const PaperPath& path : l.paths)
      for (const PaperPoint& p : path) bounds.add(p);
  if (layers_.empty()) bounds = {{0, 0}, {1, 1}};
  const double margin = .03 * width;
  const double wide = bounds.upper[0] - bounds.lower[0], high = bounds.upper[1] - bounds.lower[1];
  const double scale = (width - 2 * margin) / std::max({wide, high, 1e-300});
  const Fit fit{bounds.lower, scale, margin};
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.7g} {1:.7g}\" width=\"{0:.7g}\" "
      "height=\"{1:.7g}\">\n"
      "<title>{2}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      wide * scale + 2 * margin, high * scale + 2 * margin, escaped(title));
  for (const Layer& l : layers_) {
    out += l.width > 0
               ? fmt::format(
                     "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{:.3g}\" stroke-linecap=\"round\" "
                     "stroke-linejoin=\"round\" d=\"",
                     l.colour, l.width)
               : fmt::format("<path fill=\"{0}\" stroke=\"{0}\" stroke-width=\".3\" stroke-linejoin=\"round\" d=\"",
                             l.colour);
    for (const PaperPath& path : l.paths) print_path(out, path, l.width == 0, fit);
    out += "\"/>\n";
  }
  return out + "</svg>\n";
}
