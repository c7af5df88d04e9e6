#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/io/face_list.h"
#include "core/io/ply_numbers.h"

namespace strata::io {

/// Reads records of PLY elements, one after the other.
template <class Numbers>
class PlyRecords {
 public:
  PlyRecords(const PlyPlan& plan, Numbers numbers) : vertex_count_(plan.vertex_count), numbers_(numbers) {}

  /// Reads the next records of an element. Points are stored in `vertices`, from `first` on.
  void read(const PlyElementPlan& plan, std::uint64_t first, std::uint64_t count, std::span<Vertex> vertices) {
    switch (plan.role) {
      case PlyRole::points:
        return read_points(plan, first, vertices.subspan(first, count));
      case PlyRole::faces:
        return read_faces(plan, count);
      case PlyRole::strips:
        return repeat(count, [&] {
          read_list(plan, true);
          add_strip();
        });
      case PlyRole::none:
        return skip(*plan.element, count);
    }
  }
  void skip(const PlyElement& element, std::uint64_t count) {
    repeat(count, [&] {
      for (const PlyProperty& p : element.properties) skip(p);
    });
  }

  [[nodiscard]] Numbers& numbers() { return numbers_; }
  [[nodiscard]] FaceList take_faces() { return std::move(faces_); }

 private:
  static constexpr bool is_binary = std::same_as<Numbers, BinaryNumbers>;
  static constexpr std::uint32_t restart = 0xffff'ffff;

  template <class Read>
  void repeat(std::uint64_t count, const Read& read) {
    for (std::uint64_t i = 0; i < count; ++i) {
      read();
      numbers_.end_record();
    }
  }

  void read_points(const PlyElementPlan& plan, std::uint64_t first, std::span<Vertex> points) {
    constexpr std::size_t block = 1024;  // stays in the cache while its coordinates are read
    for (std::size_t i = 0; i < points.size(); i += block) {
      const auto some = points.subspan(i, std::min(block, points.size() - i));
      if constexpr (is_binary) {
        if (numbers_.take_points(plan, some)) continue;
      }
      std::uint64_t number = first + i;
      auto point = some.begin();
      repeat(some.size(), [&] { *point++ = read_point(plan, number++); });
    }
  }

  Vertex read_point(const PlyElementPlan& plan, std::uint64_t number) {
    Vertex p{};
    const auto& properties = plan.element->properties;
    for (std::size_t i = 0; i < properties.size(); ++i) {
      const auto axis = std::find(plan.axes.begin(), plan.axes.end(), i);
      if (axis == plan.axes.end())
        skip(properties[i]);
      else
        p[static_cast<std::size_t>(axis - plan.axes.begin())] = read_coordinate(properties[i].type, number);
    }
    return p;
  }

  double read_coordinate(PlyScalar type, std::uint64_t number) {
    const std::size_t place = numbers_.offset();
    const double x = numbers_.next(type, "a number for a coordinate");
    if (!std::isfinite(x)) numbers_.fail_at(place, "expected a finite coordinate of vertex " + std::to_string(number));
    return x;
  }

  void read_faces(const PlyElementPlan& plan, std::uint64_t count) {
    faces_.reserve(count);
    while (count > 0) {
      if constexpr (is_binary) {
        count -= numbers_.take_triangles(plan, vertex_count_, count, faces_);
        if (count == 0) return;
      }
      read_list(plan, false);
      faces_.add(list_);
      numbers_.end_record();
      --count;
    }
  }

  /// Reads a record; its list of vertices is stored in list_.
  void read_list(const PlyElementPlan& plan, bool is_strip) {
    const auto& properties = plan.element->properties;
    for (std::size_t i = 0; i < properties.size(); ++i)
      if (i == plan.list)
        read_indices(properties[i], is_strip);
      else
        skip(properties[i]);
  }

  void read_indices(const PlyProperty& property, bool is_strip) {
    const std::uint64_t count = list_size(property);
    list_.clear();
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::size_t place = numbers_.offset();
      const double value = numbers_.next(property.type, "a vertex index");
      if (is_strip && value == -1)
        list_.push_back(restart);
      else if (!(value >= 0 && value < static_cast<double>(vertex_count_)) || value != std::floor(value))
        numbers_.fail_at(place, "vertex index " + shown(value) + " is out of range: the file has " +
                                    std::to_string(vertex_count_) + " vertices, counted from 0");
      else
        list_.push_back(static_cast<std::uint32_t>(value));
    }
  }

  std::uint64_t list_size(const PlyProperty& property) {
    const std::size_t place = numbers_.offset();
    const double count = numbers_.next(*property.list_count, "the length of a list");
    const std::uint64_t room = numbers_.room(property.type);
    if (!(count >= 0 && count <= static_cast<double>(room)) || count != std::floor(count))
      numbers_.fail_at(place, "the length of a list is " + shown(count) + ", but the rest of the file has room for " +
                                  std::to_string(room) + " at most");
    return static_cast<std::uint64_t>(count);
  }

  void skip(const PlyProperty& property) {
    numbers_.skip(property.type, property.list_count ? list_size(property) : 1);
  }

  /// Every vertex forms a triangle with the two before it, in alternating order; -1 starts a new strip.
  void add_strip() {
    std::size_t start = 0;
    for (std::size_t i = 0; i < list_.size(); ++i) {
      if (list_[i] == restart) start = i + 1;
      if (i < start + 2) continue;
      const bool odd = (i - start) % 2 != 0;
      const Triangle t{list_[i - 2 + odd], list_[i - 1 - odd], list_[i]};
      // Strips repeat vertices on purpose, to change direction.
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) faces_.add(t);
    }
  }

  static std::string shown(double value) {
    return value == std::floor(value) && std::abs(value) < 1e15 ? std::to_string(static_cast<std::int64_t>(value))
                                                                : std::to_string(value);
  }

  std::uint64_t vertex_count_;
  Numbers numbers_;
  FaceList faces_;
  std::vector<std::uint32_t> list_;
};

}  // namespace strata::io
