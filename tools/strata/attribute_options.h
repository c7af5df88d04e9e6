#pragma once
#include <optional>
#include <string>
#include <vector>

#include "strata/attributes.h"

/// What --attributes and --cut-material ask for.
struct AttributeSettings {
  std::vector<std::string> names{"all"};  ///< of channels, or one of all and none
  std::string cut_material;               ///< a name, or a color as #rrggbb; empty: none

  /// What is wanted of what an operand has.
  [[nodiscard]] strata::Attributes chosen(strata::Attributes attributes) const;
  /// The material for cut faces: the first of that name in the lists, or one that has nothing but the name or the
  /// color. Throws UsageError for what begins as a color and is none.
  [[nodiscard]] std::optional<strata::Material> material_among(
      const std::vector<const strata::Attributes*>& lists) const;
};

struct Settings;
namespace strata {
struct Engine;
}

/// False where there is nothing to carry, and where an engine carries no attributes, which a note says.
[[nodiscard]] bool carries_attributes(const strata::Engine* engine, const std::vector<const strata::Attributes*>& lists,
                                      const std::optional<strata::Material>& cut_material, const Settings& settings);
