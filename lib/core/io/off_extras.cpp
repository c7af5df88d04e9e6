#include "core/io/off_extras.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/io/face_values.h"
#include "core/io/number_in.h"

namespace strata::io {
namespace {

using Words = std::span<const std::string_view>;

bool is_byte(std::string_view word) {
  const auto number = number_in<std::int32_t>(word);
  return number && *number >= 0 && *number <= 255;
}

}  // namespace

bool OffColors::add(std::uint64_t element, Words words) {
  if (words.size() != 3 && words.size() != 4) return false;
  Color color{element, {}, words.size()};
  for (std::size_t k = 0; k < words.size(); ++k) {
    const auto number = number_in<float>(words[k]);
    if (!number) return false;
    color.numbers[k] = *number;
  }
  are_bytes_ = are_bytes_ && std::all_of(words.begin(), words.end(), is_byte);
  components_ = std::max(components_, words.size());
  colors_.push_back(color);
  return true;
}

void OffColors::add(const OffColors& later) {
  colors_.insert(colors_.end(), later.colors_.begin(), later.colors_.end());
  are_bytes_ = are_bytes_ && later.are_bytes_;
  components_ = std::max(components_, later.components_);
}

template <class T>
std::vector<T> OffColors::values(std::uint64_t count, T opaque) const {
  std::vector<T> values(count * components_, opaque);
  for (const Color& c : colors_)
    for (std::size_t k = 0; k < c.count; ++k) values[c.element * components_ + k] = static_cast<T>(c.numbers[k]);
  return values;
}

Channel OffColors::channel(Element element, std::uint64_t count) const {
  Channel channel{
      std::string(channel_names::color), element, Interpolation::linear, static_cast<std::uint32_t>(components_), {}};
  if (are_bytes_)
    channel.values = values<std::uint8_t>(count, 255);
  else
    channel.values = values<float>(count, 1);
  return channel;
}

void OffExtras::add_vertex(std::uint64_t number, Words words) {
  if (add_values(number, words)) return;
  other_vertices_.add(number);
  if (letters_.normals) normals_.resize(normals_.size() + 3);
  if (letters_.texcoords) texcoords_.resize(texcoords_.size() + 2);
}

/// Returns false, and adds nothing, if the words are not what the letters say.
bool OffExtras::add_values(std::uint64_t number, Words words) {
  if (words.empty()) return !letters_.any();
  const std::size_t normal = letters_.normals ? 3 : 0, texcoord = letters_.texcoords ? 2 : 0;
  if (words.size() < normal + texcoord) return false;
  const Words color = words.subspan(normal, words.size() - normal - texcoord);
  if (!letters_.colors && !color.empty()) return false;
  std::vector<double> numbers;
  for (const std::string_view word : words) {
    const auto x = number_in<double>(word);
    if (!x) return false;
    numbers.push_back(*x);
  }
  if (letters_.colors && !of_vertices_.add(number, color)) return false;
  const auto begin = numbers.begin(), end = numbers.end();
  normals_.insert(normals_.end(), begin, begin + static_cast<std::ptrdiff_t>(normal));
  texcoords_.insert(texcoords_.end(), end - static_cast<std::ptrdiff_t>(texcoord), end);
  has_values_ = true;
  return true;
}

void OffExtras::add_face(std::uint64_t number, Words words) {
  if (words.empty() || of_faces_.add(number, words)) return;
  (words.size() == 1 ? indexed_faces_ : other_faces_).add(number);
}

void OffExtras::add(const OffExtras& later) {
  normals_.insert(normals_.end(), later.normals_.begin(), later.normals_.end());
  texcoords_.insert(texcoords_.end(), later.texcoords_.begin(), later.texcoords_.end());
  has_values_ = has_values_ || later.has_values_;
  of_vertices_.add(later.of_vertices_);
  of_faces_.add(later.of_faces_);
  other_vertices_.add(later.other_vertices_);
  indexed_faces_.add(later.indexed_faces_);
  other_faces_.add(later.other_faces_);
}

void OffExtras::move_to(MeshFile& file, std::uint64_t face_count) && {
  std::vector<Channel>& channels = file.attributes.channels;
  const auto add_channel = [&](std::string_view name, Interpolation how, std::uint32_t components,
                               std::vector<double>& values) {
    channels.push_back({std::string(name), Element::vertex, how, components, std::move(values)});
  };
  if (letters_.normals && has_values_) add_channel(channel_names::normal, Interpolation::spherical, 3, normals_);
  if (letters_.texcoords && has_values_) add_channel(channel_names::texcoord, Interpolation::linear, 2, texcoords_);
  if (!of_vertices_.empty()) {
    channels.push_back(of_vertices_.channel(Element::vertex, file.mesh.vertices.size()));
  } else if (!of_faces_.empty()) {
    channels.push_back(of_faces_.channel(Element::face, face_count));
    repeat_on_triangles(channels.back(), file);
  }
  if (!of_vertices_.empty() && !of_faces_.empty())
    file.notes.emplace_back("colours of faces left out: vertices have some");
  other_vertices_.note(file, "vertex", "vertices",
                       "with other numbers behind coordinates than the header says, left out", "vertex");
  indexed_faces_.note(file, "face", "faces", "with an index into a map of colours, which is left out");
  other_faces_.note(file, "face", "faces", "with other numbers behind corners than a colour, left out");
}

}  // namespace strata::io
