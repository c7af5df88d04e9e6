#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "strata/errors.h"

namespace strata {

/// Collects defects of one kind: keeps the first few, counts all.
class DefectList {
 public:
  DefectList(DefectKind kind, Severity severity, std::string remedy, std::size_t listed = few_defects)
      : kind_(kind), severity_(severity), remedy_(std::move(remedy)), listed_(listed) {}

  /// `message` is called only for the defects that are kept.
  template <class Message>
  void add(std::optional<Vertex> where, std::vector<std::uint32_t> faces, Message message) {
    if (++count_ > listed_) return;
    defects_.push_back({kind_, severity_, where, std::move(faces), 1, message(), remedy_});
  }

  /// Moves the kept defects to the end of a list, each with the total count.
  void append_to(std::vector<Defect>& list) {
    for (Defect& defect : defects_) {
      defect.count = count_;
      list.push_back(std::move(defect));
    }
    defects_.clear();
  }

  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  DefectKind kind_;
  Severity severity_;
  std::string remedy_;
  std::size_t listed_;
  std::uint64_t count_ = 0;
  std::vector<Defect> defects_;
};

}  // namespace strata
