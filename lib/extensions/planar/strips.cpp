#include "extensions/planar/strips.h"

#include <cmath>

namespace strata::planar {
namespace {

constexpr double entries_per_segment = 2;  ///< aimed at
constexpr std::uint32_t most_strips = 1u << 22;

}  // namespace

Strips::Strips(std::vector<Box> boxes, std::vector<std::array<PlanePoint, 2>> ends)
    : boxes_(std::move(boxes)), ends_(std::move(ends)) {
  if (boxes_.empty()) return;
  choose_heights();
  fill();
  if (!overlaps_many()) return;
  choose_overlapping();
  fill();
}

void Strips::choose_overlapping() {
  std::vector<double> lows;
  for (const Box& box : boxes_) lows.push_back(box.low);
  std::sort(lows.begin(), lows.end());
  std::size_t step =
      std::max<std::size_t>(8, static_cast<std::size_t>(std::sqrt(static_cast<double>(lows.size()))) / 4);
  for (std::size_t entries = lows.size() * 17; entries > lows.size() * 16; step *= 4) {
    bounds_.clear();
    for (std::size_t i = step; i < lows.size(); i += step)
      if (bounds_.empty() || lows[i] > bounds_.back()) bounds_.push_back(lows[i]);
    entries = 0;
    for (const Box& box : boxes_) entries += strip_of(box.high) - strip_of(box.low) + 1;
  }
  count_ = static_cast<std::uint32_t>(bounds_.size() + 1);
}

void Strips::choose_heights() {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Box& box : boxes_) {
    low = std::min(low, box.low);
    high = std::max(high, box.high);
  }
  half_low_ = low / 2;
  const double height = high / 2 - half_low_;
  double total = 0;  // of the segments' heights, as parts of the whole
  for (const Box& box : boxes_) total += (box.high / 2 - box.low / 2) / height;
  const auto n = static_cast<double>(boxes_.size());
  const double strips = std::min({(entries_per_segment - 1) * n / total, n, static_cast<double>(most_strips)});
  const double scale = strips / height;
  if (!(strips > 1 && height > 0x1p-900 && std::isfinite(scale) && std::isfinite(half_low_)))
    return;  // all in one strip
  count_ = static_cast<std::uint32_t>(strips);
  scale_ = scale;
}

std::uint32_t Strips::strip_of(double y) const {
  if (!bounds_.empty())
    return static_cast<std::uint32_t>(std::upper_bound(bounds_.begin(), bounds_.end(), y) - bounds_.begin());
  const double at = (y / 2 - half_low_) * scale_;
  return at > 0 ? static_cast<std::uint32_t>(std::min(at, static_cast<double>(count_ - 1))) : 0;
}

void Strips::fill() {
  first_.assign(count_ + 1, 0);
  for (const Box& box : boxes_)
    for (std::uint32_t k = strip_of(box.low), last = strip_of(box.high); k <= last; ++k) ++first_[k + 1];
  for (std::uint32_t k = 0; k < count_; ++k) first_[k + 1] += first_[k];
  segment_.resize(first_[count_]);
  for (std::uint32_t s = static_cast<std::uint32_t>(boxes_.size()); s-- > 0;)
    for (std::uint32_t k = strip_of(boxes_[s].low), last = strip_of(boxes_[s].high); k <= last; ++k)
      segment_[--first_[k + 1]] = s;
  // first_[k + 1] is now where strip k starts.
  first_.erase(first_.begin());
  first_.push_back(static_cast<std::uint32_t>(segment_.size()));
}

bool Strips::overlaps_many() const {
  double squares = 0;
  for (std::uint32_t k = 0; k < count_; ++k) {
    const double entries = first_[k + 1] - first_[k];
    squares += entries * entries;
  }
  const auto all = static_cast<double>(segment_.size());
  return boxes_.size() > 64 && squares > 32 * all * (all / count_ + 8);
}

Box Strips::part_in(std::uint32_t segment, double low, double high) const {
  Box box = boxes_[segment];
  if (box.low >= low && box.high <= high) return box;
  const PlanePoint &p = ends_[segment][0], &q = ends_[segment][1];
  const double width = std::abs(q[0] - p[0]), height = std::abs(q[1] - p[1]);
  // The uncertainty of the ends, as given by the box.
  const double unknown_x = (box.right - box.left) - width, unknown_y = (box.high - box.low) - height;
  box.low = std::max(low, box.low);
  box.high = std::min(high, box.high);
  if (height <= 2 * (high - low) || !(unknown_y <= height * 0x1p-20))
    return box;  // or too short to be worth a division
  const double slope = (q[0] - p[0]) / (q[1] - p[1]);
  const double margin =
      2 * (unknown_x + std::abs(slope) * unknown_y) +
      (std::abs(p[0]) + std::abs(q[0]) + std::abs(slope) * (std::abs(p[1]) + std::abs(q[1]))) * 0x1p-48 +
      (1 + height) * 0x1p-1060;  // slopes that underflow
  double left = HUGE_VAL, right = -HUGE_VAL;
  for (const double y : {box.low, box.high}) {
    const double x = p[0] + (y - p[1]) * slope;
    if (!(std::abs(x) + margin < HUGE_VAL)) return box;
    left = std::min(left, x - margin);
    right = std::max(right, x + margin);
  }
  return {std::max(left, box.left), std::min(right, box.right), box.low, box.high};
}

void Strips::load(std::uint32_t strip, std::vector<Entry>& entries) {
  double low = -HUGE_VAL, high = HUGE_VAL;
  if (!bounds_.empty()) {
    if (strip > 0) low = bounds_[strip - 1];
    if (strip + 1 < count_) high = bounds_[strip];
  } else if (count_ > 1) {
    const double height = 2 / scale_, start = 2 * half_low_, margin = height * 0x1p-10 + std::abs(start) * 0x1p-40;
    if (strip > 0) low = start + strip * height - margin;
    if (strip + 1 < count_) high = start + (strip + 1) * height + margin;
  }
  entries.clear();
  for (const std::uint32_t s : segments(strip)) entries.push_back({part_in(s, low, high), s});
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.box.left < b.box.left; });
  for (std::size_t i = 0; i < entries.size(); ++i) {
    segment_[first_[strip] + i] = entries[i].segment;
    left_[first_[strip] + i] = entries[i].box.left;
    widest_[strip] = std::max(widest_[strip], entries[i].box.right - entries[i].box.left);
  }
}

}  // namespace strata::planar
