#include "common/misuse.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "common/description.h"
#include "common/nearest.h"

namespace {

using Words = std::vector<std::string>;

/// What other programs call our verbs.
constexpr std::array<std::pair<std::string_view, std::string_view>, 20> other_names{
    {{"add", "union"},         {"common", "intersection"}, {"cut", "difference"}, {"diff", "difference"},
     {"distance", "contacts"}, {"erode", "erosion"},       {"fix", "resolve"},    {"fuse", "union"},
     {"heal", "resolve"},      {"join", "union"},          {"measure", "info"},   {"merge", "union"},
     {"minus", "difference"},  {"render", "draw"},         {"repair", "resolve"}, {"stat", "info"},
     {"stats", "info"},        {"subtract", "difference"}, {"validate", "check"}, {"volume", "info"}}};

/// The verb that was parsed last, which the error is about; the program itself where none was.
const CLI::App& innermost(const CLI::App& app) {
  const CLI::App* verb = &app;
  while (!verb->get_subcommands().empty()) verb = verb->get_subcommands().back();
  return *verb;
}

/// "strata planar union".
std::string full_name(const CLI::App& verb) {
  return (verb.get_parent() == nullptr ? "" : full_name(*verb.get_parent()) + " ") + verb.get_name();
}

/// Verbs with their aliases.
Words verb_names(const CLI::App& app) {
  Words names;
  for (const CLI::App* verb : app.get_subcommands({})) {
    if (verb->get_group().empty()) continue;
    names.push_back(verb->get_name());
    for (const std::string& alias : verb->get_aliases()) names.push_back(alias);
  }
  return names;
}

Words option_names(const CLI::App& app) {
  Words names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string meant(const std::string& word) { return word.empty() ? "" : fmt::format("; did you mean '{}'?", word); }

std::string meant_verb(const CLI::App& app, const std::string& word) {
  const Words names = verb_names(app);
  const auto* other = std::ranges::find(other_names, word, [](const auto& entry) { return std::string(entry.first); });
  if (other != other_names.end() && std::ranges::count(names, std::string(other->second)) > 0)
    return std::string(other->second);
  return nearest(word, names);
}

const CLI::App* find_verb(const CLI::App& app, const std::string& name) {
  for (const CLI::App* verb : app.get_subcommands({}))
    if (verb->check_name(name)) return verb;
  return nullptr;
}

/// MESH... -o OUT: what has to be there.
std::string usage(const CLI::App& verb) {
  std::string text = full_name(verb);
  for (const CLI::Option* option : verb.get_options()) {
    if (!option->get_positional()) continue;
    const std::string name = option->get_name(true, false);
    const int least = std::max(1, option->get_items_expected_min());
    std::string operand = name;
    for (int k = 1; k < least; ++k) operand += " " + name;
    if (option->get_items_expected_max() > least) operand += "...";
    text += option->get_required() ? " " + operand : " [" + operand + "]";
  }
  for (const CLI::Option* option : verb.get_options())
    if (option->get_required() && option->nonpositional())
      text += fmt::format(" {} {}",
                          option->get_snames().empty() ? "--" + option->get_lnames()[0] : "-" + option->get_snames()[0],
                          value_name(*option));
  if (!verb.get_subcommands({}).empty()) text += " VERB";
  return text + " [OPTIONS]";
}

std::string what_to_type(const CLI::App& verb) {
  const Words shown = examples(verb);
  return fmt::format("Type:    {}\n{}Help:    {} --help\n", usage(verb),
                     shown.empty() ? "" : fmt::format("Example: {}\n", shown[0]), full_name(verb));
}

/// Operands as they were given.
Words given_operands(const CLI::App& verb) {
  Words given;
  for (const CLI::Option* option : verb.get_options())
    if (option->get_positional()) given.insert(given.end(), option->results().begin(), option->results().end());
  return given;
}

const CLI::Option* find_option(const CLI::App& verb, const std::string& name) {
  for (const CLI::Option* option : verb.get_options())
    if (option->check_name(name) || option->get_name() == name || option->get_name(true, true) == name) return option;
  return nullptr;
}

/// A word that nobody asked for: an option that there is not, a verb that there is not, an operand too many.
std::string explain_extra(const CLI::App& verb, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  if (name.size() > 1 && name.starts_with('-')) {
    std::string wanted = nearest(name.starts_with("--") ? name : "-" + name, option_names(verb));
    if (wanted.empty()) wanted = meant_verb(verb, name.substr(name.find_first_not_of('-')));
    return fmt::format("{}: there is no option {}{}\n{}", full_name(verb), name, meant(wanted), what_to_type(verb));
  }
  if (!verb.get_subcommands({}).empty()) {
    if (std::filesystem::exists(word))
      return fmt::format(
          "{}: a verb is missing before {}\nExample: {} union A.stl B.stl -o OUT.stl\nHelp:    {} --help\n",
          full_name(verb), word, full_name(verb), full_name(verb));
    const std::string wanted = meant_verb(verb, word);
    const CLI::App* found = find_verb(verb, wanted);
    return fmt::format("{}: there is no verb '{}'{}\n{}", full_name(verb), word, meant(wanted),
                       what_to_type(found == nullptr ? verb : *found));
  }
  return fmt::format("{}: '{}' is one operand too many\n{}", full_name(verb), word, what_to_type(verb));
}

std::string explain_missing(const CLI::App& verb, const std::string& name) {
  if (!verb.get_subcommands({}).empty() && verb.get_subcommands().empty())
    return fmt::format("{}: a verb is missing\n{}Verbs:   {}\n", full_name(verb), what_to_type(verb),
                       fmt::join(verb_names(verb), ", "));
  const CLI::Option* option = find_option(verb, name);
  if (option == nullptr || option->get_positional())
    return fmt::format("{}: {} is missing\n{}", full_name(verb), name, what_to_type(verb));
  std::string text = fmt::format("{}: {} {} is missing\n", full_name(verb), name, value_name(*option));
  const Words operands = given_operands(verb);
  if (option->check_name("-o") && operands.size() > 1 && !std::filesystem::exists(operands.back())) {
    const Words inputs(operands.begin(), operands.end() - 1);
    text += fmt::format("Meant?   {} {} -o {}\n", full_name(verb), fmt::join(inputs, " "), operands.back());
  }
  return text + what_to_type(verb);
}

/// A value that an option does not take.
std::string explain_value(const CLI::App& verb, const std::string& name, const std::string& otherwise) {
  const CLI::Option* option = find_option(verb, name);
  if (option == nullptr || option->results().empty())
    return fmt::format("{}: {}\n{}", full_name(verb), otherwise, what_to_type(verb));
  const std::string value = option->results().back();
  const Words words = choices(*option);
  if (words.empty())
    return fmt::format("{}: {}: '{}' is no {}\n{}", full_name(verb), name, value,
                       value_name(*option).empty() ? "value for it" : value_name(*option), what_to_type(verb));
  return fmt::format("{}: {}: '{}' is none of {}{}\n{}", full_name(verb), name, value, fmt::join(words, ", "),
                     meant(nearest(value, words)), what_to_type(verb));
}

std::string explain_number(const CLI::App& verb, const std::string& name, const std::string& otherwise) {
  const CLI::Option* option = find_option(verb, name);
  if (option == nullptr) return fmt::format("{}: {}\n{}", full_name(verb), otherwise, what_to_type(verb));
  const std::size_t given = option->results().size();
  if (option->get_positional() && given > static_cast<std::size_t>(option->get_items_expected_max()))
    return explain_extra(verb, option->results().back());
  if (option->get_positional())
    return fmt::format("{}: {} {} needed, {} given\n{}", full_name(verb), std::max(1, option->get_items_expected_min()),
                       name, given, what_to_type(verb));
  return fmt::format("{}: {} needs a value, {}\n{}", full_name(verb), name, value_name(*option), what_to_type(verb));
}

}  // namespace

std::string explain_misuse(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& verb = innermost(app);
  const std::string text = error.what();
  // An option that there is not may be the cause of everything else.
  const Words extras = app.remaining(true);
  const bool lacks_verb = !verb.get_subcommands({}).empty() && verb.get_subcommands().empty();
  if (lacks_verb && !extras.empty()) return explain_extra(verb, extras.front());
  const auto strange = std::ranges::find_if(extras, [](const std::string& w) { return w.size() > 1 && w[0] == '-'; });
  if (strange != extras.end()) return explain_extra(verb, *strange);
  if (!extras.empty()) return explain_extra(verb, extras.front());
  const std::string name = text.substr(0, text.find(": "));
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)
    return explain_missing(verb, text.substr(0, text.find(" is required")));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) return explain_number(verb, name, text);
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {
    const std::size_t begin = text.find(": ");
    return explain_value(verb, begin == std::string::npos ? text : text.substr(begin + 2, text.find(" = ") - begin - 2),
                         text);
  }
  const CLI::Option* option = find_option(verb, name);
  if (option != nullptr && (!choices(*option).empty() || option->get_type_name().ends_with(":POSITIVE")))
    return explain_value(verb, name, text);
  return fmt::format("{}: {}\n{}", full_name(verb), text, what_to_type(verb));
}

std::string explain_misuse(const CLI::App& app, const UsageError& error) {
  const CLI::App& verb = innermost(app);
  return fmt::format("{}: {}\n{}", full_name(verb), error.what(), what_to_type(verb));
}
