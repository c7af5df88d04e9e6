#include "hit_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <vector>

#include "common/csv.h"

using strata::Ray;
using strata::RayHit;
using strata::RoundedHit;

namespace {

constexpr std::array<std::string_view, 4> words{"entering", "leaving", "touching", "along"};
constexpr std::size_t longest_integer = 20;  ///< of 64 bits

void append(std::string& text, std::uint64_t value) {
  std::array<char, longest_integer> digits;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + longest_integer, value).ptr);
}

void append(std::string& text, double value) {
  std::array<char, longest_number> digits;
  text.append(digits.data(), append_number(digits.data(), value));
}

}  // namespace

std::string HitTable::header() const {
  return form_.exact ? "ray,hit,x,y,z,t,solid,face,passage,exact_x,exact_y,exact_z,exact_t\n"
                     : "ray,hit,x,y,z,t,solid,face,passage\n";
}

void HitTable::append_rows(std::uint64_t number, const Ray& ray, std::string& rows, RayCounts& counts) const {
  const std::uint64_t before = counts.hits;
  ++counts.rays;
  if (form_.exact) {
    append_exact(number, ray, rows, counts);
  } else if (form_.all) {
    for (const RoundedHit& h : caster_.all_rounded(ray)) {
      append_row(number, counts.hits++ - before, h, rows);
      rows += '\n';
    }
  } else if (const auto h = caster_.first_rounded(ray)) {
    append_row(number, counts.hits++ - before, *h, rows);
    rows += '\n';
  }
  if (counts.hits != before) {
    ++counts.meeting;
    return;
  }
  append(rows, number);
  rows += form_.exact ? ",,,,,,,,,,,,\n" : ",,,,,,,,\n";
}

void HitTable::append_row(std::uint64_t number, std::uint64_t hit, const RoundedHit& h, std::string& rows) const {
  append(rows, number);
  rows += ',';
  append(rows, hit);
  for (const double x : {h.place[0], h.place[1], h.place[2], h.t}) {
    rows += ',';
    append(rows, x);
  }
  for (const std::uint32_t id : {h.solid, input_.file_face(h.face)}) {
    rows += ',';
    append(rows, std::uint64_t{id});
  }
  rows += ',';
  rows += words[static_cast<std::size_t>(h.passage)];
}

void HitTable::append_exact(std::uint64_t number, const Ray& ray, std::string& rows, RayCounts& counts) const {
  std::vector<RayHit> hits;
  if (form_.all) {
    hits = caster_.all(ray);
  } else if (auto h = caster_.first(ray)) {
    hits.push_back(std::move(*h));
  }
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const RayHit& h = hits[i];
    append_row(number, i, {strata::to_nearest_double(h.t), h.rounded, h.face, h.solid, h.passage}, rows);
    for (const strata::Rational& x : {h.place[0], h.place[1], h.place[2], h.t}) {
      rows += ',';
      rows += x.str();
    }
    rows += '\n';
  }
  counts.hits += hits.size();
}
