#include "location_table.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <string_view>

#include "common/binary_records.h"
#include "common/csv.h"

using strata::Contact;
using strata::Location;
using strata::Vertex;
using strata::Where;

namespace {

constexpr std::array<std::string_view, 3> words{"out", "on", "in"};
constexpr std::size_t longest_integer = 10;  ///< of 32 bits

char* append(char* at, std::string_view text) { return std::copy(text.begin(), text.end(), at); }
char* append(char* at, std::uint32_t value) { return std::to_chars(at, at + longest_integer, value).ptr; }

void append(std::string& text, std::uint32_t value) { text.append(std::to_string(value)); }

}  // namespace

std::string LocationTable::header(std::uint64_t count) const {
  if (form_ != Form::ply)
    return nearest_ ? "x,y,z,where,solid,face,distance,nearest_x,nearest_y,nearest_z\n" : "x,y,z,where,solid,face\n";
  return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(count) +
         "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar where\nproperty int solid\n"
         "property int face\nend_header\n";
}

void LocationTable::append_rows(std::span<const double> coordinates, std::string& rows, WhereCounts& counts) const {
  for (std::size_t i = 0; i < coordinates.size(); i += 3) {
    const Vertex q{coordinates[i], coordinates[i + 1], coordinates[i + 2]};
    const Location location = locate_(q);
    ++counts[static_cast<std::size_t>(location.where())];
    if (form_ == Form::ply)
      append_ply(q, location, rows);
    else
      append_csv(q, location, rows);
  }
}

void LocationTable::append_csv(const Vertex& q, const Location& location, std::string& rows) const {
  std::array<char, 3 * (longest_number + 1) + 3 + 2 * (longest_integer + 1) + 1> row;
  char* at = row.data();
  for (const double x : q) {
    at = append_number(at, x);
    *at++ = ',';
  }
  const Where w = location.where();
  at = append(at, words[static_cast<std::size_t>(w)]);
  *at++ = ',';
  if (form_ == Form::csv) {
    if (w == Where::in) at = append(at, location.windings.begin()->first);
    if (w == Where::on) at = append(at, location.contacts.front().solid);
    *at++ = ',';
    if (w == Where::on) at = append(at, input_.file_face(location.contacts.front().face));
  }
  rows.append(row.data(), at);
  if (form_ == Form::csv_all) append_all(location, rows);
  if (nearest_) append_nearest(q, rows);
  rows += '\n';
}

void LocationTable::append_nearest(const Vertex& q, std::string& rows) const {
  const std::optional<Nearest> found = nearest_(q);
  if (!found) {
    rows += ",,,,";
    return;
  }
  std::array<char, 4 * (longest_number + 1)> row;
  char* at = row.data();
  for (const double x : {found->distance, found->point[0], found->point[1], found->point[2]}) {
    *at++ = ',';
    at = append_number(at, x);
  }
  rows.append(row.data(), at);
}

void LocationTable::append_all(const Location& location, std::string& rows) const {
  struct Entry {
    std::uint32_t solid;
    const Contact* contact;
  };
  std::vector<Entry> entries;
  for (const Contact& c : location.contacts) entries.push_back({c.solid, &c});
  for (const auto& [solid, winding] : location.windings) entries.push_back({solid, nullptr});
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.solid < b.solid; });
  for (const Entry& e : entries) {
    if (&e != entries.data()) rows += ';';
    append(rows, e.solid);
  }
  rows += ',';
  for (const Entry& e : entries) {
    if (&e != entries.data()) rows += ';';
    if (e.contact != nullptr) append(rows, input_.file_face(e.contact->face));
  }
}

void LocationTable::append_ply(const Vertex& q, const Location& location, std::string& rows) const {
  const Where w = location.where();
  std::int32_t solid = -1, face = -1;
  if (w == Where::in) solid = static_cast<std::int32_t>(location.windings.begin()->first);
  if (w == Where::on) {
    solid = static_cast<std::int32_t>(location.contacts.front().solid);
    face = static_cast<std::int32_t>(input_.file_face(location.contacts.front().face));
  }
  std::array<char, 3 * 8 + 1 + 2 * 4> row;
  char* at = row.data();
  for (const double x : q) at = store(at, x);
  at = store(at, static_cast<std::uint8_t>(w));
  at = store(at, solid);
  at = store(at, face);
  rows.append(row.data(), at);
}
