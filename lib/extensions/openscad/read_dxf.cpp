#include "extensions/openscad/read_dxf.h"

#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "core/system/decimal.h"
#include "strata/errors.h"

namespace strata::openscad {
namespace {

using planar::PlanePoint;
using Segment = std::array<PlanePoint, 2>;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(" \t\r"), text.size());
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

/// A line of a code and one of its value.
struct Group {
  int code = 0;
  std::string_view value;
  std::size_t line = 0;
};

class GroupReader {
 public:
  explicit GroupReader(std::string_view text) : text_(text) {}

  std::optional<Group> next() {
    if (trimmed(text_).empty()) return std::nullopt;
    Group group;
    const std::string_view code = line();
    group.line = line_;
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
    if (error != std::errc{} || end != code.data() + code.size())
      throw IoError("DXF", {group.line, {}}, "expected the code of a group");
    group.value = line();
    return group;
  }

 private:
  std::string_view line() {
    const std::string_view all = text_.substr(0, text_.find('\n'));
    text_.remove_prefix(std::min(all.size() + 1, text_.size()));
    ++line_;
    return trimmed(all);
  }
  std::string_view text_;
  std::size_t line_ = 0;
};

/// An entity: its groups by their codes, in order.
struct Entity {
  std::string_view type;
  std::multimap<int, Group> groups;

  [[nodiscard]] double number(int code, double otherwise = 0) const {
    const auto at = groups.find(code);
    return at == groups.end() ? otherwise : value(at->second);
  }
  [[nodiscard]] std::vector<double> numbers(int code) const {
    std::vector<double> list;
    for (auto [at, end] = groups.equal_range(code); at != end; ++at) list.push_back(value(at->second));
    return list;
  }
  [[nodiscard]] std::string_view text(int code) const {
    const auto at = groups.find(code);
    return at == groups.end() ? std::string_view() : at->second.value;
  }

 private:
  static double value(const Group& group) {
    double x = 0;
    std::string_view digits = group.value;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto [end, error] = system::from_chars(digits.data(), digits.data() + digits.size(), x);
    if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(x))
      throw IoError("DXF", {group.line + 1, {}}, "expected a number");
    return x;
  }
};

class DrawingReader {
 public:
  DrawingReader(const DxfPlacement& placement, const Resolution& resolution)
      : placement_(placement), resolution_(resolution) {}

  std::vector<Segment> read(std::string_view text) {
    GroupReader groups(text);
    Entity entity;
    while (const auto group = groups.next()) {
      if (group->code == 0) {
        end(entity);
        entity = {group->value, {}};
      } else {
        entity.groups.emplace(group->code, *group);
      }
    }
    end(entity);
    return std::move(segments_);
  }
  [[nodiscard]] const std::map<std::string, std::size_t>& unread() const { return unread_; }

 private:
  void end(const Entity& e) {
    if (e.type == "SECTION") section_ = e.text(2);
    if (e.type == "ENDSEC") section_ = {};
    if (e.type == "BLOCK") block_ = e.text(2);
    if (e.type == "ENDBLK") block_ = {};
    const bool is_drawn = section_ == "ENTITIES" || (section_ == "BLOCKS" && !block_.empty());
    if (!is_drawn || e.type == "SECTION" || e.type == "BLOCK" || e.type == "ENDBLK") return;
    if (!placement_.layer.empty() && e.text(8) != placement_.layer && block_.empty()) return;
    draw(e);
  }

  void draw(const Entity& e) {
    if (e.type == "LINE") return add({point(e.number(10), e.number(20)), point(e.number(11), e.number(21))});
    if (e.type == "CIRCLE") return arc(e, 0, 360);
    if (e.type == "ARC") return arc(e, e.number(50), e.number(51));
    if (e.type == "LWPOLYLINE") return polyline(e);
    if (e.type == "ELLIPSE") return ellipse(e);
    if (e.type == "INSERT") return insert(e);
    if (e.type == "POLYLINE") return begin_polyline(e);
    if (e.type == "VERTEX") return corners_.push_back(point(e.number(10), e.number(20)));
    if (e.type == "SEQEND") return end_polyline();
    if (e.type != "DIMENSION") ++unread_[std::string(e.type.substr(0, 32))];
  }

  [[nodiscard]] PlanePoint point(double x, double y) const {
    if (!block_.empty()) return {x, y};
    return {(x - placement_.origin[0]) * placement_.scale, (y - placement_.origin[1]) * placement_.scale};
  }
  [[nodiscard]] double length(double x) const { return block_.empty() ? x * placement_.scale : x; }

  void add(const Segment& s) {
    if (!block_.empty()) {
      blocks_[std::string(block_)].push_back(s);
    } else {
      segments_.push_back(s);
    }
  }

  void arc(const Entity& e, double start, double stop) {
    const PlanePoint centre = point(e.number(10), e.number(20));
    const double radius = length(e.number(40));
    while (start > stop) stop += 360;
    const double sides = std::ceil(sides_of_circle(radius, resolution_) * (stop - start) / 360);
    const auto at = [&](double i) -> PlanePoint {
      const double angle = (start + (stop - start) * i / sides) * std::numbers::pi / 180;
      return {centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)};
    };
    for (double i = 0; i < sides; ++i) add({at(i), i + 1 == sides && stop - start == 360 ? at(0) : at(i + 1)});
  }
  void polyline(const Entity& e) {
    begin_polyline(e);
    const std::vector<double> x = e.numbers(10), y = e.numbers(20);
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) corners_.push_back(point(x[i], y[i]));
    end_polyline();
  }
  void begin_polyline(const Entity& e) {
    is_closed_ = std::fmod(std::abs(e.number(70)), 2) == 1;
    corners_.clear();
  }
  void end_polyline() {
    for (std::size_t i = 1; i < corners_.size(); ++i) add({corners_[i - 1], corners_[i]});
    if (is_closed_ && corners_.size() > 2) add({corners_.back(), corners_.front()});
    corners_.clear();
  }
  void ellipse(const Entity& e) {
    const PlanePoint centre = point(e.number(10), e.number(20));
    const double x = length(e.number(11)), y = length(e.number(21)), ratio = e.number(40, 1);
    double start = e.number(41), stop = e.number(42, 2 * std::numbers::pi);
    while (start > stop) stop += 2 * std::numbers::pi;
    const double sides = std::max(
        std::ceil(sides_of_circle(std::hypot(x, y), resolution_) * (stop - start) / (2 * std::numbers::pi)), 1.0);
    const auto at = [&](double i) -> PlanePoint {
      const double angle = start + (stop - start) * i / sides, c = std::cos(angle), s = std::sin(angle) * ratio;
      return {centre[0] + x * c - y * s, centre[1] + y * c + x * s};
    };
    for (double i = 0; i < sides; ++i) add({at(i), at(i + 1)});
  }
  void insert(const Entity& e) {
    const auto block = blocks_.find(std::string(e.text(2)));
    if (block == blocks_.end()) return;
    const double angle = e.number(50) * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    const double sx = e.number(41, 1), sy = e.number(42, 1), dx = e.number(10), dy = e.number(20);
    const auto placed = [&](const PlanePoint& p) {
      const double x = p[0] * sx, y = p[1] * sy;
      return point(x * c - y * s + dx, x * s + y * c + dy);
    };
    for (const Segment& segment : block->second) add({placed(segment[0]), placed(segment[1])});
  }

  const DxfPlacement& placement_;
  const Resolution& resolution_;
  std::string_view section_, block_;
  std::map<std::string, std::vector<Segment>> blocks_;
  std::vector<Segment> segments_;
  std::vector<PlanePoint> corners_;  ///< of the polyline that is being read
  bool is_closed_ = false;
  std::map<std::string, std::size_t> unread_;
};

/// Numbers points, near ones alike.
class PointGrid {
 public:
  std::uint32_t number(const PlanePoint& p) {
    constexpr double cell = 0.001;
    const auto column = static_cast<std::int64_t>(std::floor(p[0] / cell)),
               row = static_cast<std::int64_t>(std::floor(p[1] / cell));
    for (std::int64_t i = -1; i <= 1; ++i)
      for (std::int64_t j = -1; j <= 1; ++j)
        if (const auto at = numbers_.find({column + i, row + j}); at != numbers_.end()) return at->second;
    const auto number = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
    return numbers_[{column, row}] = number;
  }
  [[nodiscard]] const PlanePoint& point(std::uint32_t number) const { return points_[number]; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }

 private:
  std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> numbers_;
  std::vector<PlanePoint> points_;
};

/// Joins segments into closed loops. Returns how many chains a straight line closes.
std::size_t close_loops(const std::vector<Segment>& segments, planar::Loops& loops) {
  PointGrid grid;
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (const Segment& s : segments)
    if (const std::uint32_t a = grid.number(s[0]), b = grid.number(s[1]); a != b) ends.push_back({a, b});
  std::vector<std::vector<std::size_t>> at(grid.size());
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (const std::uint32_t p : ends[i]) at[p].push_back(i);
  std::vector<bool> is_used(ends.size(), false);
  const auto walk = [&](std::uint32_t from) {
    std::vector<std::uint32_t> chain{from};
    while (true) {
      const std::uint32_t last = chain.back();
      std::size_t next = ends.size();
      for (const std::size_t i : at[last])
        if (!is_used[i]) next = std::min(next, i);
      if (next == ends.size()) return chain;
      is_used[next] = true;
      chain.push_back(ends[next][0] == last ? ends[next][1] : ends[next][0]);
      if (chain.back() == from) return chain;
    }
  };
  std::size_t open = 0;
  const auto take = [&](std::uint32_t from) {
    std::vector<std::uint32_t> chain = walk(from);
    if (chain.size() < 2) return;
    if (chain.back() == chain.front()) {
      chain.pop_back();
    } else {
      ++open;
    }
    std::vector<PlanePoint> loop;
    for (const std::uint32_t p : chain) loop.push_back(grid.point(p));
    loops.add(loop);
  };
  for (std::uint32_t p = 0; p < at.size(); ++p)
    if (at[p].size() % 2 == 1) take(p);
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (!is_used[i]) take(ends[i][0]);
  return open;
}

}  // namespace

DxfShapes read_dxf(std::string_view text, const DxfPlacement& placement, const Resolution& resolution) {
  DrawingReader reader(placement, resolution);
  planar::Loops loops;
  DxfShapes shapes;
  const std::size_t open = close_loops(reader.read(text), loops);
  shapes.region = planar::fill({loops, planar::FillRule::even_odd});
  if (open > 0)
    shapes.notes.push_back(std::to_string(open) + " chains of lines do not close, and are closed by straight ones");
  for (const auto& [type, count] : reader.unread())
    shapes.notes.push_back(type + " is left out (" + std::to_string(count) + " of them)");
  return shapes;
}

}  // namespace strata::openscad
