#include "extensions/scene/location.h"

#include <algorithm>

namespace strata {

std::int32_t WindingNumbers::operator[](std::uint32_t solid) const {
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), solid,
                                   [](const Entry& e, std::uint32_t s) { return e.first < s; });
  return at != entries_.end() && at->first == solid ? at->second : 0;
}

WindingNumbers numbers_of(const Windings& windings) {
  return WindingNumbers(std::vector<WindingNumbers::Entry>(windings.begin(), windings.end()));
}

Location location_of(Windings windings, std::vector<Contact> faces) {
  std::sort(faces.begin(), faces.end(), [](const Contact& a, const Contact& b) { return a.face < b.face; });
  const auto same = [](const Contact& a, const Contact& b) { return a.solid == b.solid; };
  faces.erase(std::unique(faces.begin(), faces.end(), same), faces.end());
  for (const Contact& c : faces) windings.set(c.solid, 0);
  return {numbers_of(windings), std::move(faces)};
}

}  // namespace strata
