#include "extensions/openscad/svg_path.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "core/system/decimal.h"
#include "strata/errors.h"

namespace strata::openscad {
namespace {

using planar::PlanePoint;

PlanePoint operator+(const PlanePoint& a, const PlanePoint& b) { return {a[0] + b[0], a[1] + b[1]}; }
PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) { return {a[0] - b[0], a[1] - b[1]}; }
PlanePoint operator*(double f, const PlanePoint& a) { return {f * a[0], f * a[1]}; }

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) { skip(); }

  [[nodiscard]] bool at_end() const { return at_ == text_.size(); }
  [[nodiscard]] bool at_number() const {
    return !at_end() && std::string_view("+-.0123456789").find(text_[at_]) != std::string_view::npos;
  }
  char take() {
    const char c = text_[at_++];
    skip();
    return c;
  }
  double number() {
    const std::size_t start = at_;
    if (!at_end() && text_[at_] == '+') ++at_;
    double x = 0;
    const auto [end, error] = system::from_chars(text_.data() + at_, text_.data() + text_.size(), x);
    if (error != std::errc{} || !std::isfinite(x)) fail(start, "expected a number");
    at_ = static_cast<std::size_t>(end - text_.data());
    skip();
    return x;
  }
  /// 0 or 1, which need not be separated from what follows.
  bool flag() {
    if (at_end() || (text_[at_] != '0' && text_[at_] != '1')) fail(at_, "expected a flag 0 or 1");
    return take() == '1';
  }
  [[noreturn]] void fail(std::size_t at, const std::string& reason) const {
    throw IoError("SVG", {}, "path data at byte " + std::to_string(at) + ": " + reason);
  }
  [[nodiscard]] std::size_t at() const { return at_; }

 private:
  void skip() {
    while (!at_end() && std::string_view(" \t\r\n\f,").find(text_[at_]) != std::string_view::npos) ++at_;
  }
  std::string_view text_;
  std::size_t at_ = 0;
};

class PathReader {
 public:
  PathReader(std::string_view data, const CurveParts& parts) : scanner_(data), parts_(parts) {}

  std::vector<std::vector<PlanePoint>> read() {
    while (!scanner_.at_end()) {
      const std::size_t at = scanner_.at();
      const char c = scanner_.take();
      if (paths_.empty() && c != 'M' && c != 'm') scanner_.fail(at, "expected M");
      command(c, at);
    }
    return std::move(paths_);
  }

 private:
  void command(char c, std::size_t at) {
    is_relative_ = c >= 'a';
    const char kind = is_relative_ ? static_cast<char>(c - 'a' + 'A') : c;
    if (kind == 'Z') {
      here_ = start_;
      is_closed_ = true;
      return last(kind, here_);
    }
    bool is_first = true;
    do {
      one(kind == 'M' && !is_first ? 'L' : kind, at);
      is_first = false;
    } while (scanner_.at_number());
  }

  void one(char kind, std::size_t at) {
    if (kind == 'M') {
      here_ = start_ = point();
      paths_.push_back({here_});
      is_closed_ = false;
      return last(kind, here_);
    }
    if (is_closed_) paths_.push_back({here_});  // goes on from the start of the last subpath
    is_closed_ = false;
    switch (kind) {
      case 'L':
        return line(point());
      case 'H':
        return line({scanner_.number() + (is_relative_ ? here_[0] : 0), here_[1]});
      case 'V':
        return line({here_[0], scanner_.number() + (is_relative_ ? here_[1] : 0)});
      case 'C': {
        const PlanePoint a = point(), b = point();
        return cubic(a, b, point());
      }
      case 'S': {
        const PlanePoint a = last_ == 'C' ? here_ + (here_ - control_) : here_, b = point();
        return cubic(a, b, point());
      }
      case 'Q': {
        const PlanePoint a = point();
        return quadratic(a, point());
      }
      case 'T':
        return quadratic(last_ == 'Q' ? here_ + (here_ - control_) : here_, point());
      case 'A':
        return arc();
      default:
        scanner_.fail(at, std::string("'") + kind + "' is no command");
    }
  }

  PlanePoint point() {
    const double x = scanner_.number(), y = scanner_.number();
    return is_relative_ ? here_ + PlanePoint{x, y} : PlanePoint{x, y};
  }
  void last(char kind, const PlanePoint& control) {
    last_ = kind;
    control_ = control;
  }
  void emit(const PlanePoint& p) { paths_.back().push_back(p); }
  void line(const PlanePoint& to) {
    emit(to);
    here_ = to;
    last('L', to);
  }
  void cubic(const PlanePoint& a, const PlanePoint& b, const PlanePoint& to) {
    for (double k = 1; k < parts_.of_bezier; ++k) {
      const double t = k / parts_.of_bezier, s = 1 - t;
      emit(s * s * s * here_ + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * to);
    }
    line(to);
    last('C', b);
  }
  void quadratic(const PlanePoint& a, const PlanePoint& to) {
    for (double k = 1; k < parts_.of_bezier; ++k) {
      const double t = k / parts_.of_bezier, s = 1 - t;
      emit(s * s * here_ + 2 * s * t * a + t * t * to);
    }
    line(to);
    last('Q', a);
  }
  /// SVG 1.1, F.6: from end points to the centre.
  void arc() {
    double rx = std::abs(scanner_.number()), ry = std::abs(scanner_.number());
    const double tilt = scanner_.number() * std::numbers::pi / 180, c = std::cos(tilt), s = std::sin(tilt);
    const bool is_large = scanner_.flag(), is_positive = scanner_.flag();
    const PlanePoint to = point();
    if (rx == 0 || ry == 0 || to == here_) return line(to);
    const PlanePoint half = 0.5 * (here_ - to);
    const double x = c * half[0] + s * half[1], y = c * half[1] - s * half[0];
    const double excess = x * x / (rx * rx) + y * y / (ry * ry);
    if (excess > 1) {
      rx *= std::sqrt(excess);
      ry *= std::sqrt(excess);
    }
    const double across = rx * rx * y * y + ry * ry * x * x;
    const double root = std::sqrt(std::max(rx * rx * ry * ry / across - 1, 0.0)) * (is_large == is_positive ? -1 : 1);
    const double cx = root * rx * y / ry, cy = -root * ry * x / rx;
    const PlanePoint middle = 0.5 * (here_ + to), centre{c * cx - s * cy + middle[0], s * cx + c * cy + middle[1]};
    const double start = std::atan2((y - cy) / ry, (x - cx) / rx);
    double turn = std::atan2((-y - cy) / ry, (-x - cx) / rx) - start;
    if (is_positive && turn < 0) turn += 2 * std::numbers::pi;
    if (!is_positive && turn > 0) turn -= 2 * std::numbers::pi;
    const double steps = std::max(std::ceil(parts_.of_turn * std::abs(turn) / (2 * std::numbers::pi)), 1.0);
    for (double k = 1; k < steps; ++k) {
      const double angle = start + turn * k / steps, u = rx * std::cos(angle), v = ry * std::sin(angle);
      emit({c * u - s * v + centre[0], s * u + c * v + centre[1]});
    }
    line(to);
  }

  Scanner scanner_;
  const CurveParts& parts_;
  std::vector<std::vector<PlanePoint>> paths_;
  PlanePoint here_{}, start_{}, control_{};
  char last_ = 'M';
  bool is_relative_ = false, is_closed_ = false;
};

}  // namespace

std::vector<std::vector<PlanePoint>> svg_subpaths(std::string_view data, const CurveParts& parts) {
  return PathReader(data, parts).read();
}

std::vector<double> svg_numbers(std::string_view list) {
  std::vector<double> numbers;
  Scanner scanner(list);
  while (scanner.at_number()) numbers.push_back(scanner.number());
  return numbers;
}

}  // namespace strata::openscad
