#include "attribute_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "common/tell.h"
#include "common/usage_error.h"
#include "settings.h"
#include "strata/carry_attributes.h"
#include "strata/combine.h"
#include "strata/srgb.h"

namespace {

/// Of #rrggbb or #rrggbbaa.
std::array<double, 4> color_of(const std::string& text) {
  std::array<double, 4> color{0, 0, 0, 1};
  const std::size_t parts = (text.size() - 1) / 2;
  bool is_color = text.size() % 2 == 1 && (parts == 3 || parts == 4);
  for (std::size_t i = 0; is_color && i < parts; ++i) {
    unsigned byte = 0;
    const char* const first = text.data() + 1 + 2 * i;
    is_color = std::from_chars(first, first + 2, byte, 16).ptr == first + 2;
    color[i] = i < 3 ? strata::light_of_srgb(byte / 255.0) : byte / 255.0;
  }
  if (!is_color) throw UsageError("--cut-material " + text + ": a color is #rrggbb or #rrggbbaa");
  return color;
}

}  // namespace

strata::Attributes AttributeSettings::chosen(strata::Attributes attributes) const {
  if (names.size() == 1 && names.front() == "all") return attributes;
  if (names.size() == 1 && names.front() == "none") return {};
  return strata::only(attributes, names);
}

std::optional<strata::Material> AttributeSettings::material_among(
    const std::vector<const strata::Attributes*>& lists) const {
  if (cut_material.empty()) return std::nullopt;
  strata::Material material;
  material.name = cut_material;
  if (cut_material.front() == '#') {
    material.color = color_of(cut_material);
    return material;
  }
  for (const strata::Attributes* list : lists) {
    const auto found = std::find_if(list->materials.begin(), list->materials.end(),
                                    [&](const strata::Material& m) { return m.name == cut_material && !m.image; });
    if (found != list->materials.end()) return *found;
  }
  return material;
}

bool carries_attributes(const strata::Engine* engine, const std::vector<const strata::Attributes*>& lists,
                        const std::optional<strata::Material>& cut_material, const Settings& settings) {
  if (!cut_material && std::all_of(lists.begin(), lists.end(), [](const auto* list) { return list->empty(); }))
    return false;
  if (engine == nullptr || engine->keeps_faces) return true;
  if (!settings.quiet) tell("strata: note: the engine {} carries no attributes\n", engine->name);
  return false;
}

void add_attributes_option(CLI::App& verb, Settings& settings) {
  verb.add_option("--attributes", settings.attributes.names,
                  "What the result carries on from the operands: all, none, or channels by their names, as color, "
                  "normal, texcoord, material")
      ->type_name("all|none|NAME,...")
      ->delimiter(',')
      ->expected(1)
      ->default_str("all");
}

void add_attribute_options(CLI::App& verb, Settings& settings) {
  add_attributes_option(verb, settings);
  verb.add_option("--cut-material", settings.attributes.cut_material,
                  "What cut faces are made of where what cuts has no material: the name of a material, one of the "
                  "operands' or a new one, or a color as #rrggbb")
      ->type_name("NAME");
}
