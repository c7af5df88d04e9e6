#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "about.h"
#include "common/nearest.h"
#include "common/usage_error.h"
#include "schema_texts.h"  // made by the build from schemas/*.json

namespace {

constexpr const char* prefix = "#/$defs/";

/// Names of definitions that a part of a schema refers to.
void collect(const Json& part, std::set<std::string>& names) {
  if (part.is_object())
    for (const auto& [key, value] : part.items()) {
      if (key == "$ref" && value.is_string() && value.get<std::string>().starts_with(prefix))
        names.insert(value.get<std::string>().substr(std::string_view(prefix).size()));
      collect(value, names);
    }
  if (part.is_array())
    for (const Json& value : part) collect(value, names);
}

const std::string_view* text_of(std::string_view name) {
  const auto found = std::ranges::find(schema_texts, name, &SchemaText::name);
  return found == schema_texts.end() ? nullptr : &found->text;
}

/// "planar union" is described in planar-union.json.
std::string file_of(std::string verb) {
  std::ranges::replace(verb, ' ', '-');
  return verb;
}

}  // namespace

std::vector<std::string> verbs_with_schema() {
  std::vector<std::string> verbs;
  for (const SchemaText& each : schema_texts) {
    if (each.name == "common") continue;
    const Json schema = Json::parse(each.text);
    for (const std::string verb : schema["verbs"]) verbs.push_back(verb);
  }
  std::ranges::sort(verbs);
  return verbs;
}

Json report_schema(const std::string& verb) {
  for (const SchemaText& each : schema_texts) {
    if (each.name == "common") continue;
    Json schema = Json::parse(each.text);
    const auto& verbs = schema["verbs"];
    if (std::ranges::find(verbs, Json(verb)) == verbs.end()) continue;
    schema.erase("verbs");
    const Json common = Json::parse(*text_of("common"));
    std::set<std::string> names;
    std::set<std::string> reached;
    collect(schema, names);
    while (names != reached) {
      reached = names;
      for (const std::string& name : reached)
        if (common["$defs"].contains(name)) collect(common["$defs"][name], names);
    }
    for (const std::string& name : reached) schema["$defs"][name] = common["$defs"].at(name);
    Json whole = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                  {"$id", fmt::format("urn:strata:{}:report:{}", STRATA_VERSION, file_of(verb))},
                  {"title", fmt::format("The report of strata {}", verb)}};
    whole.update(schema);
    return whole;
  }
  const std::vector<std::string> known = verbs_with_schema();
  const std::string meant = nearest(verb, known);
  throw UsageError(fmt::format("no report has a schema for '{}'; {}", verb,
                               meant.empty() ? fmt::format("schemas are there for {}", fmt::join(known, ", "))
                                             : fmt::format("did you mean '{}'?", meant)));
}
