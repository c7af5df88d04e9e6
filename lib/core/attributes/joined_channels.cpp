#include "core/attributes/joined_channels.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace strata {
namespace {

using Floats = std::vector<float>;
using Doubles = std::vector<double>;
using Bytes = std::vector<std::uint8_t>;
using Integers = std::vector<std::int32_t>;

bool are_floating(const ChannelValues& v) {
  return std::holds_alternative<Floats>(v) || std::holds_alternative<Doubles>(v);
}

/// No values of the smallest type that holds those of both.
ChannelValues common_type(const ChannelValues& a, const ChannelValues& b) {
  if (a.index() == b.index()) return a;
  const auto is_any = [&]<class T>(const T&) { return std::holds_alternative<T>(a) || std::holds_alternative<T>(b); };
  if (is_any(Doubles{}) || (is_any(Floats{}) && is_any(Integers{}))) return Doubles{};
  return is_any(Floats{}) ? ChannelValues(Floats{}) : ChannelValues(Integers{});
}

ChannelValues without_values(const ChannelValues& v) {
  return std::visit([](const auto& values) -> ChannelValues { return std::remove_cvref_t<decltype(values)>{}; }, v);
}

/// The finer of two: values on it can say what those on the other do.
Element common_element(Element a, Element b) { return a == b ? a : Element::corner; }

/// The form of a channel of one operand, and that of more.
Channel form_of(const Channel& channel) {
  return {channel.name, channel.element, channel.interpolation, channel.components, without_values(channel.values)};
}
void join(Channel& form, const Channel& other) {
  form.element = common_element(form.element, other.element);
  form.components = std::max(form.components, other.components);
  form.values = common_type(form.values, without_values(other.values));
  if (other.interpolation == Interpolation::nearest) form.interpolation = Interpolation::nearest;
  if (std::holds_alternative<Integers>(form.values)) form.interpolation = Interpolation::nearest;
}

bool is_color(const Channel& form) { return form.name == channel_names::color; }

/// What an operand without the channel has.
double missing_value(const Channel& form) {
  if (is_color(form)) return are_floating(form.values) ? 1 : 255;
  return std::holds_alternative<Integers>(form.values) ? -1 : 0;
}

/// Of a channel of fewer components, as those that are missing.
double missing_component(const Channel& form) { return is_color(form) ? missing_value(form) : 0; }

/// Where the values of a corner are.
std::size_t element_at(Element element, const MeshView& mesh, std::size_t corner) {
  switch (element) {
    case Element::vertex:
      return mesh.triangles[corner / 3][corner % 3];
    case Element::corner:
      return corner;
    case Element::face:
      return corner / 3;
  }
  return 0;
}

template <class To, class From>
void convert(const Channel& channel, const std::vector<From>& from, const Channel& form, const MeshView& mesh,
             std::vector<To>& to) {
  const bool is_finer = channel.element != form.element;  // it is on corners then
  const std::size_t elements = is_finer ? 3 * mesh.triangles.size() : from.size() / channel.components;
  const bool are_parts_of_255 = is_color(form) && std::is_integral_v<From> && std::is_floating_point_v<To>;
  to.reserve(elements * form.components);
  for (std::size_t e = 0; e < elements; ++e) {
    const std::size_t at = is_finer ? element_at(channel.element, mesh, e) : e;
    if ((at + 1) * channel.components > from.size()) {  // a vertex that there is not: no result has the face
      to.resize(to.size() + form.components);
      continue;
    }
    for (std::size_t c = 0; c < channel.components; ++c) {
      const From x = from[at * channel.components + c];
      if constexpr (std::is_same_v<To, From>)
        to.push_back(x);  // bit by bit
      else
        to.push_back(static_cast<To>(are_parts_of_255 ? static_cast<double>(x) / 255 : static_cast<double>(x)));
    }
    for (std::size_t c = channel.components; c < form.components; ++c)
      to.push_back(static_cast<To>(missing_component(form)));
  }
}

Channel converted(const Channel& channel, const Channel& form, const MeshView& mesh) {
  Channel result = form;
  std::visit(
      [&](auto& to) { std::visit([&](const auto& from) { convert(channel, from, form, mesh, to); }, channel.values); },
      result.values);
  return result;
}

bool has_form(const Channel& channel, const Channel& form) {
  return channel.element == form.element && channel.components == form.components &&
         channel.values.index() == form.values.index();
}

}  // namespace

JoinedChannels::JoinedChannels(std::span<const AttributedMesh> operands, JoinedLists& lists)
    : operands_(operands.size()) {
  for (std::size_t n = 0; n < operands.size(); ++n) {
    if (operands[n].attributes == nullptr) continue;
    for (const Channel& channel : operands[n].attributes->channels) {
      auto known = std::find_if(channels_.begin(), channels_.end(),
                                [&](const JoinedChannel& j) { return j.form.name == channel.name; });
      if (known == channels_.end()) {
        add(form_of(channel));
        known = channels_.end() - 1;
      } else {
        join(known->form, channel);
      }
      known->of_operand[n] = &channel;
    }
  }
  for (JoinedChannel& joined : channels_) {
    const std::optional<IndexList> list = list_of(joined.form);
    joined.missing.assign(joined.form.components, missing_value(joined.form));
    joined.missing_is_normal = joined.form.interpolation == Interpolation::spherical && joined.form.components == 3;
    for (std::size_t n = 0; n < operands.size(); ++n) {
      const Channel*& channel = joined.of_operand[n];
      if (channel == nullptr) continue;
      const bool is_renumbered = list && list_of(*channel) && !lists.are_kept(n, *list);
      if (has_form(*channel, joined.form) && !is_renumbered) continue;
      converted_.push_back(converted(*channel, joined.form, operands[n].mesh.mesh));
      channel = &converted_.back();
      if (is_renumbered)
        for (std::int32_t& i : std::get<Integers>(converted_.back().values)) i = lists.index(n, *list, i);
    }
  }
}

void JoinedChannels::add(Channel form) {
  JoinedChannel joined;
  joined.missing.assign(form.components, missing_value(form));
  joined.form = std::move(form);
  joined.of_operand.assign(operands_, nullptr);
  channels_.push_back(std::move(joined));
}

const JoinedChannel* JoinedChannels::find(std::string_view name) const {
  const auto found =
      std::find_if(channels_.begin(), channels_.end(), [&](const JoinedChannel& j) { return j.form.name == name; });
  return found == channels_.end() ? nullptr : &*found;
}

}  // namespace strata
