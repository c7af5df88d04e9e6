#include "extensions/openscad/report.h"

#include "strata/openscad.h"

namespace strata {
namespace openscad {

void Report::fail(const Place& place, const std::string& reason) const {
  throw CsgError(file_, place.line, place.column, reason);
}

void Report::note(const Place& place, const std::string& what) { note(what, place.line, 1); }

void Report::note(const std::string& what, std::size_t line, std::size_t count) {
  constexpr std::size_t most = 100;
  if (const auto known = number_of_.find(what); known != number_of_.end()) {
    notes_[known->second].count += count;
  } else if (notes_.size() == most) {
    left_out_ += count;
  } else {
    number_of_.emplace(what, notes_.size());
    notes_.push_back({what, line, count});
  }
}

void Report::absorb(const Report& other) {
  for (const Note& n : other.notes_) note(n.what, n.line, n.count);
  left_out_ += other.left_out_;
}

std::vector<std::string> Report::notes() const {
  std::vector<std::string> sentences;
  for (const Note& n : notes_) {
    const std::string line = "line " + std::to_string(n.line);
    const std::string where = n.count == 1 ? line : std::to_string(n.count) + " times, first in " + line;
    sentences.push_back(n.what + " (" + where + ")");
  }
  if (left_out_ > 0) sentences.push_back(std::to_string(left_out_) + " more notes are left out");
  return sentences;
}

}  // namespace openscad

CsgError::CsgError(std::string file, std::size_t line, std::size_t column, std::string reason)
    : std::runtime_error(file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + reason),
      file_(std::move(file)),
      line_(line),
      column_(column),
      reason_(std::move(reason)) {}

}  // namespace strata
