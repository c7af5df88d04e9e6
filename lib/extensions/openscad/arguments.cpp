#include "extensions/openscad/arguments.h"

#include <algorithm>
#include <cmath>

namespace strata::openscad {

Arguments::Arguments(const SyntaxNode& node, std::initializer_list<std::string_view> parameters, Report& report)
    : node_(node), report_(report) {
  const auto* position = parameters.begin();
  for (const Argument& a : node.arguments) {
    if (!a.name.empty()) {
      const bool is_known = std::find(parameters.begin(), parameters.end(), a.name) != parameters.end();
      if (is_known || a.name[0] == '$') {
        given_.push_back({a.name, &a});
      } else {
        report.note(a.place, std::string(node.name) + " has no '" + std::string(a.name.substr(0, 32)) +
                                 "', which is passed over");
      }
      continue;
    }
    while (position != parameters.end() && given(*position) != nullptr) ++position;
    if (position != parameters.end()) {
      given_.push_back({*position++, &a});
    } else {
      report.note(a.place, std::string(node.name) + " has too many arguments, which are passed over");
    }
  }
}

const Arguments::Given* Arguments::given(std::string_view parameter) const {
  const auto found =
      std::find_if(given_.rbegin(), given_.rend(), [&](const Given& g) { return g.parameter == parameter; });
  return found == given_.rend() ? nullptr : &*found;
}

const Value* Arguments::find(std::string_view parameter) const {
  const Given* const g = given(parameter);
  return g == nullptr || g->argument->value.kind == Value::Kind::undefined ? nullptr : &g->argument->value;
}

double Arguments::number(std::string_view parameter, double otherwise) const {
  const Value* const value = find(parameter);
  if (value == nullptr) return otherwise;
  if (value->kind != Value::Kind::number) fail(parameter, "is no number");
  return value->number;
}

bool Arguments::truth(std::string_view parameter, bool otherwise) const {
  const Value* const value = find(parameter);
  if (value == nullptr) return otherwise;
  if (value->kind != Value::Kind::boolean) fail(parameter, "is neither true nor false");
  return value->truth;
}

std::string Arguments::text(std::string_view parameter, const std::string& otherwise) const {
  const Value* const value = find(parameter);
  if (value == nullptr) return otherwise;
  if (value->kind != Value::Kind::string) fail(parameter, "is no string");
  return text_of(*value);
}

std::vector<double> Arguments::numbers(std::string_view parameter, std::vector<double> otherwise) const {
  const Value* const value = find(parameter);
  if (value == nullptr) return otherwise;
  if (value->kind == Value::Kind::number) return std::vector<double>(otherwise.size(), value->number);
  if (value->kind != Value::Kind::vector) fail(parameter, "is neither a number nor a vector");
  for (std::size_t i = 0; i < std::min(otherwise.size(), value->items.size()); ++i) {
    const Value& item = value->items[i];
    if (item.kind != Value::Kind::number) fail(parameter, "has a component that is no number");
    otherwise[i] = item.number;
  }
  return otherwise;
}

std::vector<std::vector<double>> Arguments::points(std::string_view parameter, std::size_t dimension) const {
  std::vector<std::vector<double>> points;
  const Value* const value = find(parameter);
  if (value == nullptr) return points;
  if (value->kind != Value::Kind::vector) fail(parameter, "are no vector");
  const auto is_coordinate = [](const Value& v) { return v.kind == Value::Kind::number && std::isfinite(v.number); };
  for (const Value& item : value->items) {
    if (item.kind != Value::Kind::vector || item.items.size() != dimension ||
        !std::all_of(item.items.begin(), item.items.end(), is_coordinate))
      fail(parameter, std::string("have no ") + (dimension == 2 ? "two" : "three") + " finite numbers at number " +
                          std::to_string(points.size()));
    auto& point = points.emplace_back();
    for (const Value& v : item.items) point.push_back(v.number);
  }
  return points;
}

void Arguments::note(const std::string& what) const { report_.note(node_.place, std::string(node_.name) + " " + what); }

void Arguments::fail(std::string_view parameter, const std::string& reason) const {
  const Given* const g = given(parameter);
  report_.fail(g == nullptr ? node_.place : g->argument->place,
               "the " + std::string(parameter) + " of " + std::string(node_.name) + " " + reason);
}

}  // namespace strata::openscad
