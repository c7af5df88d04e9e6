#include "extensions/openscad/arguments.h"

#include <algorithm>

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

void Arguments::fail(std::string_view parameter, const std::string& reason) const {
  const Given* const g = given(parameter);
  report_.fail(g == nullptr ? node_.place : g->argument->place,
               "the " + std::string(parameter) + " of " + std::string(node_.name) + " " + reason);
}

}  // namespace strata::openscad
