#include "core/attributes/carried_channel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/attributes/interpolate.h"
#include "core/containers/huge_pages.h"

namespace strata {
namespace {

template <class T>
class TypedChannel final : public CarriedChannel {
 public:
  TypedChannel(const JoinedChannel& joined, const TriangleOrigins& origins)
      : CarriedChannel(joined.form.element), joined_(joined), origins_(origins), size_(joined.form.components) {
    for (const Channel* c : joined.of_operand)
      values_.push_back(c == nullptr ? std::span<const T>() : std::span(std::get<std::vector<T>>(c->values)));
    for (const double x : joined.missing) missing_.push_back(static_cast<T>(x));
    const std::size_t triangles = origins.sources().size();
    resize_fresh(result_, (element_ == Element::face ? triangles : 3 * triangles) * size_);
  }

  void write_triangles(std::size_t first, std::size_t last) override {
    for (std::size_t t = first; t < last;) {
      const std::size_t end = end_of_run(t, last);
      if (end > t) {
        copy_run(t, end);
        t = end;
      } else {
        write_triangle(t++);
      }
    }
  }

  void write_corner(std::size_t corner, std::size_t source_corner, const FaceFrame& frame) override {
    const std::size_t t = corner / 3;
    if (is_missing(t)) return write_missing(corner, &frame);
    copy(value_at(origins_.sources()[t], source_corner), corner);
    if (is_negated(t)) negate(corner);
  }

  void write_corner(std::size_t corner, const FaceFrame::Place& place, const FaceFrame& frame) override {
    const std::size_t t = corner / 3;
    if (is_missing(t)) return write_missing(corner, &frame);
    CornerValues<T> values;
    for (std::size_t k = 0; k < 3; ++k) values[k] = {value_at(origins_.sources()[t], k), size_};
    interpolate<T>(place, joined_.form.interpolation, values, {&result_[corner * size_], size_});
    if (is_negated(t)) negate(corner);
  }

  void copy_corner(std::size_t corner, std::size_t from) override { copy(&result_[from * size_], corner); }

  Channel finish() override {
    Channel channel = joined_.form;
    if (element_ == Element::vertex) {
      const std::vector<std::size_t> corner = first_corners();
      if (do_corners_agree(corner)) {
        result_ = on_vertices(corner);
      } else {
        channel.element = Element::corner;
      }
    }
    channel.values = std::move(result_);
    return channel;
  }

 private:
  [[nodiscard]] bool is_missing(std::size_t triangle) const {
    return joined_.of_operand[origins_.sources()[triangle].operand] == nullptr;
  }
  [[nodiscard]] bool is_negated(std::size_t triangle) const {
    return joined_.form.interpolation == Interpolation::spherical && origins_.is_turned(triangle);
  }
  [[nodiscard]] const T* value_at(const Source& s, std::size_t corner) const {
    const std::size_t element = element_ == Element::vertex ? origins_.source_corners(s)[corner] : 3 * s.face + corner;
    return values_[s.operand].data() + element * size_;
  }
  void copy(const T* from, std::size_t to) { std::copy_n(from, size_, &result_[to * size_]); }
  void negate(std::size_t element) {
    for (std::size_t c = 0; c < size_; ++c)
      result_[element * size_ + c] = static_cast<T>(-result_[element * size_ + c]);
  }

  /// What an operand without the channel has. `frame`: of the source face, if there is one already.
  void write_missing(std::size_t corner, const FaceFrame* frame) {
    if (!joined_.missing_is_normal) return copy(missing_.data(), corner);
    const std::size_t t = element_ == Element::face ? corner : corner / 3;
    const Source& s = origins_.sources()[t];
    const auto normal = frame != nullptr
                            ? frame->unit_normal()
                            : FaceFrame(origins_.points_of(s.operand), origins_.source_corners(s)).unit_normal();
    for (std::size_t c = 0; c < size_; ++c) result_[corner * size_ + c] = static_cast<T>(normal[c]);
    if (is_negated(t)) negate(corner);
  }

  /// The end of the triangles from this one on that are, one after the other, faces of an operand as they are, so that
  /// their values are.
  [[nodiscard]] std::size_t end_of_run(std::size_t first, std::size_t last) const {
    if (element_ == Element::vertex || is_missing(first)) return first;
    const Source& s = origins_.sources()[first];
    std::size_t t = first;
    while (t < last && origins_.sources()[t] == Source{s.operand, s.face + static_cast<std::uint32_t>(t - first)} &&
           (element_ == Element::face || origins_.is_as_it_was(t)) && !is_negated(t))
      ++t;
    return t;
  }
  void copy_run(std::size_t first, std::size_t last) {
    const Source& s = origins_.sources()[first];
    const std::size_t size = element_ == Element::face ? size_ : 3 * size_;
    std::copy_n(values_[s.operand].data() + s.face * size, (last - first) * size, result_.data() + first * size);
  }

  void write_triangle(std::size_t t) {
    if (element_ == Element::face)
      write_face(t);
    else if (origins_.is_whole(t))
      for (std::size_t k = 0; k < 3; ++k) write_corner_of_whole(t, k);
  }
  void write_face(std::size_t t) {
    const Source& s = origins_.sources()[t];
    if (is_missing(t)) return write_missing(t, nullptr);
    copy(values_[s.operand].data() + s.face * size_, t);
    if (is_negated(t)) negate(t);
  }
  void write_corner_of_whole(std::size_t t, std::size_t k) {
    if (is_missing(t)) return write_missing(3 * t + k, nullptr);
    copy(value_at(origins_.sources()[t], origins_.order(t)[k]), 3 * t + k);
    if (is_negated(t)) negate(3 * t + k);
  }

  /// Per vertex the lowest corner of it; none for one that no triangle has.
  [[nodiscard]] std::vector<std::size_t> first_corners() const {
    const auto& triangles = origins_.result().triangles;
    std::vector<std::size_t> corner(origins_.result().vertices.size(), none);
    for (std::size_t c = 3 * triangles.size(); c-- > 0;) corner[triangles[c / 3][c % 3]] = c;
    return corner;
  }
  [[nodiscard]] bool do_corners_agree(const std::vector<std::size_t>& first) const {
    const auto& triangles = origins_.result().triangles;
    std::atomic<bool> agree = true;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles.size(), 1 << 13), [&](const auto& range) {
      for (std::size_t t = range.begin(); t != range.end() && agree.load(std::memory_order_relaxed); ++t)
        for (std::size_t k = 0; k < 3; ++k)
          if (std::memcmp(&result_[(3 * t + k) * size_], &result_[first[triangles[t][k]] * size_], size_ * sizeof(T)) !=
              0)
            agree = false;
    });
    return agree;
  }
  [[nodiscard]] std::vector<T> on_vertices(const std::vector<std::size_t>& corner) const {
    std::vector<T> values;
    values.reserve(corner.size() * size_);
    for (const std::size_t c : corner) {
      const T* from = c == none ? missing_.data() : &result_[c * size_];
      values.insert(values.end(), from, from + size_);
    }
    return values;
  }

  static constexpr std::size_t none = ~std::size_t{0};

  const JoinedChannel& joined_;
  const TriangleOrigins& origins_;
  std::size_t size_;                        ///< components
  std::vector<std::span<const T>> values_;  ///< per operand
  std::vector<T> missing_, result_;
};

}  // namespace

std::unique_ptr<CarriedChannel> CarriedChannel::make(const JoinedChannel& joined, const TriangleOrigins& origins) {
  return std::visit(
      [&](const auto& values) -> std::unique_ptr<CarriedChannel> {
        using T = typename std::remove_cvref_t<decltype(values)>::value_type;
        return std::make_unique<TypedChannel<T>>(joined, origins);
      },
      joined.form.values);
}

}  // namespace strata
