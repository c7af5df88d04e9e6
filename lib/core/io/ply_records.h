#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/io/ply_numbers.h"
#include "core/io/ply_store.h"

namespace strata::io {

/// Reads records of PLY elements, one after the other.
template <class Numbers>
class PlyRecords {
 public:
  PlyRecords(const PlyPlan& plan, PlyStore& store, Numbers numbers)
      : plan_(plan), store_(store), numbers_(numbers), piece_(plan) {}

  /// Reads the next records of an element, from number `first` on.
  void read(const PlyElementPlan& plan, std::uint64_t first, std::uint64_t count) {
    switch (plan.role) {
      case PlyRole::points:
        return read_points(plan, first, count);
      case PlyRole::faces:
        return read_faces(plan, first, count);
      case PlyRole::strips:
        return repeat(first, count, [&](std::uint64_t number) {
          read_record(plan, number);
          add_strip();
        });
      case PlyRole::none:
        return skip(*plan.element, count);
    }
  }
  void skip(const PlyElement& element, std::uint64_t count) {
    repeat(0, count, [&](std::uint64_t) {
      for (const PlyProperty& p : element.properties) skip(p);
    });
  }

  [[nodiscard]] Numbers& numbers() { return numbers_; }
  [[nodiscard]] PlyPiece take() { return std::move(piece_); }

 private:
  static constexpr bool is_binary = std::same_as<Numbers, BinaryNumbers>;
  static constexpr std::uint32_t restart = 0xffff'ffff;

  template <class Read>
  void repeat(std::uint64_t first, std::uint64_t count, const Read& read) {
    for (std::uint64_t i = 0; i < count; ++i) {
      read(first + i);
      numbers_.end_record();
    }
  }

  void read_points(const PlyElementPlan& plan, std::uint64_t first, std::uint64_t count) {
    constexpr std::uint64_t block = 1024;  // stays in the cache while its properties are read
    for (const std::uint64_t last = first + count; first < last; first += block) {
      const std::uint64_t some = std::min(block, last - first);
      if constexpr (is_binary) {
        if (numbers_.take_points(plan, store_, first, some)) continue;
      }
      repeat(first, some, [&](std::uint64_t number) { read_record(plan, number); });
    }
  }

  void read_faces(const PlyElementPlan& plan, std::uint64_t first, std::uint64_t count) {
    piece_.faces.reserve(count);
    for (const std::uint64_t last = first + count; first < last; ++first) {
      if constexpr (is_binary) {
        first += numbers_.take_triangles(plan, plan_.vertex_count, last - first, piece_.faces);
        if (first == last) return;
      }
      read_record(plan, first);
      piece_.faces.add(list_);
      if (plan_.has_corners) keep_corners();
      numbers_.end_record();
    }
  }

  void keep_corners() {
    piece_.corners.insert(piece_.corners.end(), list_.begin(), list_.end());
    piece_.ends.push_back(piece_.corners.size());
  }

  /// Its list of vertices is stored in list_.
  void read_record(const PlyElementPlan& plan, std::uint64_t number) {
    for (std::size_t i = 0; i < plan.uses.size(); ++i) {
      const PlyProperty& property = plan.element->properties[i];
      const PlyUse& use = plan.uses[i];
      switch (use.kind) {
        case PlyUse::Kind::none:
          skip(property);
          break;
        case PlyUse::Kind::coordinate:
          store_.vertices[number][use.component] = read_coordinate(property.type, number);
          break;
        case PlyUse::Kind::indices:
          read_indices(property, plan.role == PlyRole::strips);
          break;
        case PlyUse::Kind::value:
          std::visit([&](auto& values) { values[use.place(number)] = read_value(values, property.type); },
                     store_.values[use.channel]);
          break;
        case PlyUse::Kind::corner_values:
          read_corner_values(property, piece_.values[use.channel]);
          break;
      }
    }
  }

  /// 0 for what is no number. `values` tell its type.
  template <class T>
  T read_value(const std::vector<T>& /*values*/, PlyScalar type) {
    const std::optional<T> value = numbers_.template value<T>(type);
    piece_.no_numbers += !value;
    return value.value_or(T{0});
  }

  void read_corner_values(const PlyProperty& property, PlyCornerValues& corners) {
    const std::uint64_t count = list_size(property);
    std::visit(
        [&](auto& values) {
          for (std::uint64_t i = 0; i < count; ++i) values.push_back(read_value(values, property.type));
          corners.ends.push_back(values.size());
        },
        corners.values);
  }

  double read_coordinate(PlyScalar type, std::uint64_t number) {
    const std::size_t place = numbers_.offset();
    const double x = numbers_.next(type, "a number for a coordinate");
    if (!std::isfinite(x)) numbers_.fail_at(place, "expected a finite coordinate of vertex " + std::to_string(number));
    return x;
  }

  void read_indices(const PlyProperty& property, bool is_strip) {
    const std::uint64_t count = list_size(property);
    list_.clear();
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::size_t place = numbers_.offset();
      const double value = numbers_.next(property.type, "a vertex index");
      if (is_strip && value == -1)
        list_.push_back(restart);
      else if (!(value >= 0 && value < static_cast<double>(plan_.vertex_count)) || value != std::floor(value))
        numbers_.fail_at(place, "vertex index " + shown(value) + " is out of range: the file has " +
                                    std::to_string(plan_.vertex_count) + " vertices, counted from 0");
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
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) piece_.faces.add(t);
    }
  }

  static std::string shown(double value) {
    return value == std::floor(value) && std::abs(value) < 1e15 ? std::to_string(static_cast<std::int64_t>(value))
                                                                : std::to_string(value);
  }

  const PlyPlan& plan_;
  PlyStore& store_;
  Numbers numbers_;
  PlyPiece piece_;
  std::vector<std::uint32_t> list_;
};

}  // namespace strata::io
