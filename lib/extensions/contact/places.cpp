#include "extensions/contact/places.h"

namespace strata::contact {

std::uint32_t Places::number(const SymbolicPoint& name) {
  const auto [named, is_new] = by_name_.try_emplace(name, static_cast<std::uint32_t>(size()));
  if (!is_new) return named->second;
  const Point point = make_point(input_, name);
  InputComplex::Coordinates nearest = nearest_doubles(input_, point);
  for (double& x : nearest) x += 0.0;  // one zero
  const RationalPoint position = exact_position(input_, point);
  for (auto [at, end] = by_nearest_.equal_range(nearest); at != end; ++at)
    if (positions_[at->second] == position) return named->second = at->second;
  by_nearest_.emplace(nearest, named->second);
  points_.push_back(point);
  positions_.push_back(position);
  nearest_.push_back(nearest);
  return named->second;
}

}  // namespace strata::contact
