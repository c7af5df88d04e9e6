#include "random.h"

namespace bench {

double Random::uniform(double low, double high) {
  state_ += 0x9e3779b97f4a7c15u;
  std::uint64_t bits = state_;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  bits ^= bits >> 31;
  return low + (high - low) * (static_cast<double>(bits >> 11) * 0x1p-53);
}

strata::Vertex Random::in_box(double low, double high) {
  const double x = uniform(low, high);
  const double y = uniform(low, high);
  return {x, y, uniform(low, high)};
}

}  // namespace bench
