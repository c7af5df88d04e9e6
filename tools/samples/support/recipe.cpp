#include "support/recipe.h"

#include <algorithm>
#include <map>
#include <sstream>

namespace strata::test {
namespace {

using Kind = Recipe::Kind;

bool is_bounded(Kind kind, bool a, bool b) {
  switch (kind) {
    case Kind::union_:
      return a && b;
    case Kind::intersection:
      return a || b;
    case Kind::difference:
      return a || !b;
    case Kind::symmetric_difference:
      return a == b;
    case Kind::solid:
    case Kind::complement:
    case Kind::map:
      break;
  }
  return a;
}

const char* sign_of(Kind kind) {
  switch (kind) {
    case Kind::union_:
      return " | ";
    case Kind::intersection:
      return " & ";
    case Kind::difference:
      return " - ";
    case Kind::symmetric_difference:
      return " ^ ";
    case Kind::solid:
    case Kind::complement:
    case Kind::map:
      break;
  }
  return "";
}

void append(std::ostream& text, const RationalPoint& p) { text << p[0] << ' ' << p[1] << ' ' << p[2]; }

/// Steps with the maps above them: places of a recipe that is written anew.
class MapsPushedDown {
 public:
  explicit MapsPushedDown(const Recipe& old) : old_(old) {}

  [[nodiscard]] Recipe run() {
    place(static_cast<std::uint32_t>(old_.steps.size() - 1), {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}}});
    return std::move(result_);
  }

 private:
  std::uint32_t place(std::uint32_t number, const Affine& above) {
    Recipe::Step step = old_.steps[number];
    if (step.kind == Kind::map) return place(step.first, product(above, old_.maps[step.second]));
    const auto key = std::pair(number, above.columns);
    if (const auto known = placed_.find(key); known != placed_.end()) return known->second;
    if (step.kind == Kind::solid) {
      result_.solids.push_back(mapped(old_.solids[step.first], above));
      step.first = static_cast<std::uint32_t>(result_.solids.size() - 1);
    } else {
      step.first = place(step.first, above);
      if (joins_two(step.kind)) step.second = place(step.second, above);
    }
    result_.steps.push_back(step);
    return placed_[key] = static_cast<std::uint32_t>(result_.steps.size() - 1);
  }

  const Recipe& old_;
  Recipe result_;
  std::map<std::pair<std::uint32_t, decltype(Affine::columns)>, std::uint32_t> placed_;
};

}  // namespace

bool is_bounded(const Recipe& recipe) {
  return value_of<char>(
             recipe, [](std::uint32_t) { return char{1}; },
             [](Kind kind, char a, char b) { return static_cast<char>(is_bounded(kind, a != 0, b != 0)); },
             [](char a) { return static_cast<char>(a == 0); }, [](char a, const Affine&) { return a; }) != 0;
}

std::size_t solid_count(const Recipe& recipe) {
  return value_of<std::size_t>(
      recipe, [](std::uint32_t) { return std::size_t{1}; }, [](Kind, std::size_t a, std::size_t b) { return a + b; },
      [](std::size_t a) { return a; }, [](std::size_t a, const Affine&) { return a; });
}

std::size_t depth(const Recipe& recipe) {
  return value_of<std::size_t>(
      recipe, [](std::uint32_t) { return std::size_t{0}; },
      [](Kind, std::size_t a, std::size_t b) { return std::max(a, b) + 1; }, [](std::size_t a) { return a + 1; },
      [](std::size_t a, const Affine&) { return a + 1; });
}

std::string text(const Recipe& recipe) {
  return value_of<std::string>(
      recipe, [](std::uint32_t n) { return std::string("s").append(std::to_string(n)); },
      [](Kind kind, const std::string& a, const std::string& b) { return "(" + a + sign_of(kind) + b + ")"; },
      [](const std::string& a) { return "~" + a; },
      [&](const std::string& a, const Affine& map) {
        return std::string("m").append(std::to_string(&map - recipe.maps.data())) + "(" + a + ")";
      });
}

std::string full_text(const Recipe& recipe) {
  std::ostringstream all;
  all << text(recipe) << '\n';
  for (std::size_t n = 0; n < recipe.solids.size(); ++n) {
    const ExactMesh& solid = recipe.solids[n];
    all << "s" << n << ":";
    for (std::uint32_t v = 0; v < solid.mesh.vertices.size(); ++v) append(all << " v ", solid.position(v));
    for (const auto& [a, b, c] : solid.mesh.triangles) all << " f " << a << ' ' << b << ' ' << c;
    all << '\n';
  }
  for (std::size_t n = 0; n < recipe.maps.size(); ++n) {
    all << "m" << n << ": columns";
    for (const auto& column : recipe.maps[n].columns) append(all << "  ", column);
    all << '\n';
  }
  return all.str();
}

Recipe without_maps(const Recipe& recipe) { return MapsPushedDown(recipe).run(); }

}  // namespace strata::test
