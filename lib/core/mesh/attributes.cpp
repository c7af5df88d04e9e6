#include "strata/attributes.h"

#include <algorithm>

namespace strata {

bool Attributes::empty() const {
  return channels.empty() && materials.empty() && images.empty() && objects.empty() && groups.empty();
}

const Channel* Attributes::find(std::string_view name) const {
  const auto found = std::find_if(channels.begin(), channels.end(), [&](const Channel& c) { return c.name == name; });
  return found == channels.end() ? nullptr : &*found;
}

}  // namespace strata
