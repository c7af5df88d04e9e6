#include "core/io/ply_channels.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "core/io/ply_names.h"

namespace strata::io {
namespace {

/// Keeps what is spent on a file in proportion to its size.
constexpr std::size_t most_channels = 1024;

ChannelValues values_of(PlyScalar type) {
  switch (type) {
    case PlyScalar::uint8:
      return std::vector<std::uint8_t>();
    case PlyScalar::int8:
    case PlyScalar::int16:
    case PlyScalar::uint16:
    case PlyScalar::int32:
      return std::vector<std::int32_t>();
    case PlyScalar::float32:
      return std::vector<float>();
    case PlyScalar::uint32:
    case PlyScalar::float64:
      return std::vector<double>();
  }
  return {};
}

/// As check_attributes wants it.
bool can_be(Interpolation how, PlyScalar type) {
  if (!is_integer(type)) return true;
  return how == Interpolation::nearest || (how == Interpolation::linear && type == PlyScalar::uint8);
}

}  // namespace

/// The channels of one element, in the order of their first properties.
class PlyChannels::OfElement {
 public:
  OfElement(PlyChannels& all, const PlyElement& element, Element kind, std::vector<PlyUse>& uses)
      : all_(all), element_(element), kind_(kind), uses_(uses), is_done_(uses.size()) {
    for (std::size_t i = 0; i < uses.size(); ++i) {
      is_done_[i] = uses[i].kind != PlyUse::Kind::none;
      first_of_name_.try_emplace(property(i).name, i);
    }
  }

  void add() {
    add_announced();
    for (std::size_t i = 0; i < uses_.size(); ++i)
      if (!is_done_[i]) add_unannounced(i);
  }

 private:
  using Properties = std::vector<std::size_t>;

  [[nodiscard]] const PlyProperty& property(std::size_t i) const { return element_.properties[i]; }
  [[nodiscard]] bool is_free(std::size_t i) const { return i < uses_.size() && !is_done_[i]; }

  /// True for properties that can be the components of one channel: numbers of one type, or one list.
  [[nodiscard]] bool fit(const Properties& properties) const {
    return std::all_of(properties.begin(), properties.end(), [&](std::size_t i) {
      return is_free(i) && property(i).type == property(properties[0]).type &&
             (!property(i).list_count || (properties.size() == 1 && kind_ == Element::face));
    });
  }

  void add_announced() {
    for (const PlyAnnouncement& a : element_.announcements) {
      const bool is_list = is_free(a.property) && property(a.property).list_count;
      Properties properties;
      for (std::size_t k = 0; k < (is_list ? 1 : a.components); ++k) properties.push_back(a.property + k);
      if (fit(properties) && can_be(a.interpolation, property(a.property).type))
        make(a.name, a.interpolation, a.components, properties);
    }
  }

  /// The name of a channel that nothing announces: its own, or with its element before it, if that is a name in another
  /// element.
  [[nodiscard]] std::string name_here(std::string_view own) const {
    std::string name(own);
    const auto other = all_.names_.find(name);
    return other == all_.names_.end() || other->second == kind_ ? name : std::string(ply_prefix(kind_)) + name;
  }

  void add_unannounced(std::size_t i) {
    const PlyProperty& p = property(i);
    if (p.list_count) return add_list(i);
    for (const PlyKnownNames& known : ply_known_names)
      if (const Properties properties = components_of(known, i); !properties.empty())
        return make(name_here(known.channel), known.interpolation, properties.size(), properties);
    make(name_here(p.name), is_integer(p.type) ? Interpolation::nearest : Interpolation::linear, 1, {i});
  }

  void add_list(std::size_t i) {
    const bool is_texcoord =
        kind_ == Element::face && property(i).name == ply_texcoord_list && !is_integer(property(i).type);
    if (is_texcoord) return make(name_here(channel_names::texcoord), Interpolation::linear, 2, {i});
    all_.lists_.add(property(i).name);
    is_done_[i] = true;
  }

  /// The properties of a known channel of which one is given; none if it is none of them, or some are missing.
  [[nodiscard]] Properties components_of(const PlyKnownNames& known, std::size_t one) const {
    const auto names = known.names(known.properties.size());
    if (std::find(names.begin(), names.end(), property(one).name) == names.end()) return {};
    Properties found;
    for (const std::string_view name : names) {
      const auto place = first_of_name_.find(name);
      if (place == first_of_name_.end()) break;
      const std::size_t i = place->second;
      if (!is_free(i) || property(i).type != property(one).type || property(i).list_count) break;
      found.push_back(i);
    }
    const PlyScalar type = property(one).type;
    const bool is_type = !is_integer(type) || (type == PlyScalar::uint8 && known.channel == channel_names::color);
    const bool has_one = std::find(found.begin(), found.end(), one) != found.end();
    return is_type && has_one && found.size() >= known.least ? found : Properties();
  }

  void make(const std::string& name, Interpolation how, std::size_t components, const Properties& properties) {
    for (const std::size_t i : properties) is_done_[i] = true;
    if (all_.channels_.size() == most_channels) return all_.beyond_.add(name);
    if (!all_.names_.emplace(name, kind_).second) return all_.twice_.add(name);
    const PlyProperty& first = property(properties[0]);
    const bool is_list = first.list_count.has_value();
    for (std::size_t k = 0; k < properties.size(); ++k) {
      PlyUse& use = uses_[properties[k]];
      use.kind = is_list ? PlyUse::Kind::corner_values : PlyUse::Kind::value;
      use.channel = all_.channels_.size();
      use.components = components;
      use.component = k;
    }
    all_.channels_.push_back(
        {{name, is_list ? Element::corner : kind_, how, static_cast<std::uint32_t>(components), values_of(first.type)},
         first.type == PlyScalar::uint32});
  }

  PlyChannels& all_;
  const PlyElement& element_;
  Element kind_;
  std::vector<PlyUse>& uses_;
  std::vector<bool> is_done_;
  std::map<std::string_view, std::size_t> first_of_name_;
};

void PlyChannels::add(const PlyElement& element, Element kind, std::vector<PlyUse>& uses) {
  OfElement(*this, element, kind, uses).add();
}

void PlyChannels::leave_out_properties(const PlyElement& element, const std::vector<PlyUse>& uses) {
  for (std::size_t i = 0; i < uses.size(); ++i)
    if (uses[i].kind == PlyUse::Kind::none) apart_.add(element.properties[i].name);
}

std::vector<std::string> PlyChannels::notes() const {
  std::vector<std::string> notes;
  const auto note = [&](const LeftOut& left_out, const char* one, const char* many, const char* why) {
    if (left_out.count == 0) return;
    notes.push_back(std::to_string(left_out.count) + " " + (left_out.count == 1 ? one : many) + " left out (" + why +
                    "); the first is " + io::quoted(left_out.first));
  };
  note(elements_, "element", "elements", "neither vertices nor faces");
  note(lists_, "list", "lists", "neither of vertices nor of a channel on corners");
  note(twice_, "channel", "channels", "another one has the name");
  note(apart_, "property of faces", "properties of faces", "several elements of the file have faces");
  note(beyond_, "channel", "channels", "there are more than 1024");
  return notes;
}

}  // namespace strata::io
