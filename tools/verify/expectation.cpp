#include "verify/expectation.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "common/text_file.h"
#include "verify/decimal.h"
#include "verify/json_number.h"

namespace verify {
namespace {

using strata::Rational;

Rational rational_at(const JsonLocation& root, const char* key) {
  const JsonLocation place = root.at(key);
  const auto value = parse_rational(place.text());
  if (!value) place.fail_expected("a number as a string");
  return *value;
}

std::uint64_t count_at(const JsonLocation& root, const char* key) {
  return static_cast<std::uint64_t>(integer(root.at(key), 0, std::numeric_limits<std::int64_t>::max()));
}

std::uint64_t hash_at(const JsonLocation& root) {
  const JsonLocation place = root.at("hash");
  const std::string text = place.text();
  std::uint64_t hash = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
  if (error != std::errc() || end != text.data() + text.size()) place.fail_expected("a hexadecimal number");
  return hash;
}

}  // namespace

Expectation expectation_of(const Facts& facts) {
  return {volume_text(facts.volume), facts.volume, facts.area,     facts.form,
          facts.components,          facts.euler,  facts.touching, {}};
}

Expectation read_expectation(const std::filesystem::path& path) {
  return parse_expectation(read_file(path.string()), path.string());
}

Expectation parse_expectation(std::string_view text, const std::string& file) {
  const Json json = parse_json(text, file);
  const JsonLocation root(json, file);
  root.expect_keys({"volume", "volume_near", "area", "edge_length", "vertices", "edges", "facets", "components",
                    "euler", "non_manifold_edges", "non_manifold_vertices", "split", "hash", "origin"});
  Expectation e;
  e.volume = root.at("volume").text();
  e.volume_near = rational_at(root, e.volume.starts_with("sha256:") ? "volume_near" : "volume");
  e.area = rational_at(root, "area");
  e.form = {count_at(root, "vertices"), count_at(root, "edges"), count_at(root, "facets"), hash_at(root),
            rational_at(root, "edge_length")};
  e.components = count_at(root, "components");
  e.euler =
      integer(root.at("euler"), std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());
  const JsonLocation split = root.at("split");
  split.expect_keys({"edges", "vertices", "parts"});
  e.touching = {count_at(root, "non_manifold_edges"), count_at(root, "non_manifold_vertices"), count_at(split, "edges"),
                count_at(split, "vertices"), count_at(split, "parts")};
  for (const JsonLocation& who : root.at("origin").items()) e.origin.push_back(who.text());
  return e;
}

Json to_json(const Expectation& e) {
  Json json = {{"volume", e.volume}};
  if (e.volume.starts_with("sha256:")) json["volume_near"] = decimal(e.volume_near);
  json.update(
      {{"area", decimal(e.area)},
       {"edge_length", decimal(e.form.edge_length)},
       {"vertices", e.form.vertices},
       {"edges", e.form.edges},
       {"facets", e.form.facets},
       {"components", e.components},
       {"euler", e.euler},
       {"non_manifold_edges", e.touching.edges},
       {"non_manifold_vertices", e.touching.vertices},
       {"split",
        {{"edges", e.touching.extra_edges}, {"vertices", e.touching.extra_vertices}, {"parts", e.touching.parts}}},
       {"hash", fmt::format("{:016x}", e.form.hash)},
       {"origin", e.origin}});
  return json;
}

std::optional<std::string> difference(const Expectation& found, const Expectation& expected) {
  if (found.volume != expected.volume)
    return fmt::format("volume {} instead of {}", decimal(found.volume_near), decimal(expected.volume_near));
  const auto count = [](const char* what, auto a, auto b) { return fmt::format("{} {} instead of {}", a, what, b); };
  const FormFacts &f = found.form, &g = expected.form;
  if (f.vertices != g.vertices) return count("canonical vertices", f.vertices, g.vertices);
  if (f.edges != g.edges) return count("canonical edges", f.edges, g.edges);
  if (f.facets != g.facets) return count("canonical facets", f.facets, g.facets);
  if (f.hash != g.hash) return "another canonical form with the same counts";
  if (found.components != expected.components) return count("components", found.components, expected.components);
  if (found.euler != expected.euler)
    return fmt::format("Euler characteristic {} instead of {}", found.euler, expected.euler);
  if (!(found.touching == expected.touching)) return "other non-manifold edges or vertices";
  return {};
}

bool add_origin(Expectation& expectation, const std::string& name) {
  auto& list = expectation.origin;
  const auto place = std::lower_bound(list.begin(), list.end(), name);
  if (place != list.end() && *place == name) return false;
  list.insert(place, name);
  return true;
}

}  // namespace verify
