// Queries of a canonical form: equality, counts, text.
#include <algorithm>
#include <utility>

#include "strata/measure.h"

namespace strata {
namespace {

/// Orientation of a, b, c as seen from outside the plane.
int orientation(const CanonicalPlane& plane, const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  int dropped = 0;
  while (dropped < 3 && plane.coefficients[dropped] == 0) ++dropped;
  const int i = (dropped + 1) % 3, j = (dropped + 2) % 3;
  const Rational determinant = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
  return plane.coefficients[dropped].sign() * determinant.sign();
}

/// A loop is an outer one when it is counter-clockwise at its smallest vertex, which is extreme.
bool is_outer(const CanonicalForm& form, const CanonicalPlane& plane, const std::vector<std::uint32_t>& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop[i] != loop.front()) continue;
    const RationalPoint& before = form.vertices[loop[i == 0 ? loop.size() - 1 : i - 1]];
    const RationalPoint& after = form.vertices[loop[i + 1 == loop.size() ? 0 : i + 1]];
    if (orientation(plane, before, form.vertices[loop[i]], after) < 0) return false;
  }
  return true;
}

/// Calls `write` with each line of the text.
template <class Write>
void write_lines(const CanonicalForm& form, const Write& write) {
  write(std::to_string(form.vertices.size()) + " vertices\n");
  for (std::size_t i = 0; i < form.vertices.size(); ++i) {
    std::string line = std::to_string(i) + ":";
    for (const Rational& x : form.vertices[i]) line.append(" ").append(x.str());
    write(line + "\n");
  }
  write(std::to_string(form.planes.size()) + " planes\n");
  for (const CanonicalFacets& facets : form.planes) {
    const auto& [a, b, c, d] = facets.plane.coefficients;
    write(a.str() + " x + " + b.str() + " y + " + c.str() + " z = " + d.str() + "\n");
    for (const auto& loop : facets.loops) {
      std::string line = " ";
      for (const std::uint32_t v : loop) line.append(" ").append(std::to_string(v));
      write(line + "\n");
    }
  }
}

}  // namespace

std::size_t CanonicalForm::facet_count() const {
  std::size_t count = 0;
  for (const CanonicalFacets& facets : planes) {
    for (const auto& loop : facets.loops) count += is_outer(*this, facets.plane, loop);
  }
  return count;
}

std::size_t CanonicalForm::edge_count() const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const CanonicalFacets& facets : planes) {
    for (const auto& loop : facets.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t next = loop[i + 1 == loop.size() ? 0 : i + 1];
        sides.emplace_back(std::min(loop[i], next), std::max(loop[i], next));
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  return static_cast<std::size_t>(std::unique(sides.begin(), sides.end()) - sides.begin());
}

std::string CanonicalForm::text() const {
  std::string all;
  write_lines(*this, [&](const std::string& line) { all += line; });
  return all;
}

/// FNV-1a over the text, which determines the form.
std::uint64_t CanonicalForm::hash(const Monitor& monitor) const {
  std::uint64_t h = 0xCBF29CE484222325U;
  write_lines(*this, [&](const std::string& line) {
    monitor.check();
    for (const char c : line) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  });
  return h;
}

bool operator==(const CanonicalForm& a, const CanonicalForm& b) {
  const auto same = [](const CanonicalFacets& f, const CanonicalFacets& g) {
    return f.plane == g.plane && f.loops == g.loops;
  };
  return a.vertices == b.vertices &&
         std::equal(a.planes.begin(), a.planes.end(), b.planes.begin(), b.planes.end(), same);
}

}  // namespace strata
