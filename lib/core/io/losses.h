#pragma once
#include <string>
#include <vector>

#include "strata/attributes.h"
#include "strata/unit.h"

namespace strata::io {

/// What a format keeps of attributes, beside channels.
struct Keeps {
  bool materials = false;
  bool images = false;
  bool objects = false;
  bool groups = false;
  bool unit = false;
};

/// Notes what is lost of attributes and the unit: a sentence per kind. `is_kept` tells of each channel whether the
/// format, which `format` names, has it.
template <class IsKept>
void note_losses(std::vector<std::string>& notes, const Attributes& attributes, Unit unit, const char* format,
                 const Keeps& keeps, const IsKept& is_kept) {
  const std::string end = std::string(" left out: ") + format + " cannot keep ";
  std::string names;
  std::size_t count = 0;
  for (const Channel& c : attributes.channels) {
    if (is_kept(c)) continue;
    names += (count++ > 0 ? ", " : " ") + c.name;
  }
  if (count > 0) notes.push_back((count == 1 ? "channel" : "channels") + names + end + (count == 1 ? "it" : "them"));
  const auto note = [&](std::size_t n, bool kept, const char* what) {
    if (n > 0 && !kept) notes.push_back(what + end + "them");
  };
  note(attributes.materials.size(), keeps.materials, "materials");
  note(attributes.images.size(), keeps.images, "images of textures");
  note(attributes.objects.size(), keeps.objects, "names of objects");
  note(attributes.groups.size(), keeps.groups, "names of groups");
  if (unit != Unit::none && !keeps.unit) notes.push_back("the unit (" + std::string(name(unit)) + ")" + end + "it");
}

/// The same where no channel is kept.
inline void note_losses(std::vector<std::string>& notes, const Attributes& attributes, Unit unit, const char* format) {
  note_losses(notes, attributes, unit, format, {}, [](const Channel&) { return false; });
}

}  // namespace strata::io
