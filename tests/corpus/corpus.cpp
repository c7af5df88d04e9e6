#include "corpus/corpus.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "strata/io.h"
#include "support/transform.h"

namespace strata::test {
namespace {

/// digits[.digits][e[sign]digits]
Rational decimal(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  std::string digits(text.substr(0, e));
  int exponent = e == std::string_view::npos ? 0 : std::stoi(std::string(text.substr(e + 1)));
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<int>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  const bool negative = !digits.empty() && digits[0] == '-';
  digits.erase(0, std::min(digits.find_first_not_of("+-0"), digits.size()));  // a leading 0 would mean octal
  const Rational mantissa(Integer(digits.empty() ? "0" : digits));
  const Rational power(pow(Integer(10), static_cast<unsigned>(std::abs(exponent))));
  const Rational value = exponent < 0 ? Rational(mantissa / power) : Rational(mantissa * power);
  return negative ? Rational(-value) : value;
}

/// The number rounded to 15 digits, as an exact rational.
Rational short_decimal(const std::string& text) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.15g", std::stod(text));
  return decimal(digits);
}

std::size_t root(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

std::optional<std::filesystem::path> corpus_or_skip() {
  const char* root = std::getenv("STRATA_CORPUS");
  if (root == nullptr) {
    WARN("skipped: STRATA_CORPUS does not name the directory of the corpus");
    return std::nullopt;
  }
  return root;
}

Mesh load(const std::filesystem::path& root, const std::string& path) { return read_mesh(root / path).mesh; }

ExactMesh load_decimals(const std::filesystem::path& root, const std::string& path) {
  std::ifstream file(root / path);
  std::string word;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  if (!(file >> word >> vertices >> triangles >> word)) throw std::runtime_error("no OFF header: " + path);
  std::vector<RationalPoint> points(vertices);
  for (RationalPoint& p : points) {
    for (Rational& x : p) {
      if (!(file >> word)) throw std::runtime_error("vertices are missing: " + path);
      x = short_decimal(word);
    }
  }
  std::vector<Triangle> faces(triangles);
  for (auto& [a, b, c] : faces) {
    if (!(file >> word >> a >> b >> c) || word != "3") throw std::runtime_error("not all faces are triangles: " + path);
  }
  return exact_mesh(points, faces);
}

std::optional<Rational> exact_number(std::string_view text) {
  text = text.substr(0, text.find(' '));
  if (text.empty()) return std::nullopt;
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return decimal(text);
  return Rational(decimal(text.substr(0, slash)) / decimal(text.substr(slash + 1)));
}

NamedOperation operation_named(std::string_view name) {
  if (name == "union") return {Operation::union_};
  if (name == "intersection") return {Operation::intersection};
  if (name == "A-B") return {Operation::difference};
  if (name == "B-A") return {Operation::difference, true};
  if (name == "xor") return {Operation::symmetric_difference};
  throw std::invalid_argument("no operation: " + std::string(name));
}

Solid evaluate(std::string_view name, const Solid& a, const Solid& b) {
  const auto [operation, swapped] = operation_named(name);
  return combine_solids(operation, swapped ? std::array{b, a} : std::array{a, b});
}

bool within(const Rational& x, const Rational& expected, const Rational& bound) {
  return abs(Rational(x - expected)) <= bound * abs(expected);
}

std::size_t surface_parts(const Mesh& mesh) {
  struct Side {
    std::uint32_t low, high;
    std::size_t face;
  };
  std::vector<Side> sides;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(mesh.triangles[f][i], mesh.triangles[f][(i + 1) % 3]);
      sides.push_back({low, high, f});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return std::tie(a.low, a.high) < std::tie(b.low, b.high); });
  std::vector<std::size_t> parent(mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  std::size_t parts = parent.size();
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    if (end - i == 2 && root(parent, sides[i].face) != root(parent, sides[i + 1].face)) {
      parent[root(parent, sides[i].face)] = root(parent, sides[i + 1].face);
      --parts;
    }
    i = end;
  }
  return parts;
}

std::string short_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace strata::test
