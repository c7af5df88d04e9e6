#include "core/winding/location.h"

#include <algorithm>

namespace strata {

Location Location::of(Windings windings, std::vector<Contact> faces) {
  std::sort(faces.begin(), faces.end(), [](const Contact& a, const Contact& b) { return a.face < b.face; });
  const auto same = [](const Contact& a, const Contact& b) { return a.solid == b.solid; };
  faces.erase(std::unique(faces.begin(), faces.end(), same), faces.end());
  for (const Contact& c : faces) windings.set(c.solid, 0);
  return {std::move(windings), std::move(faces)};
}

}  // namespace strata
