#include "common/description.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

namespace {

/// `NAME:{a,b}` and `NAME:value in {a->0,b->1} OR {0,1}` begin their choices here; npos: there are none.
std::size_t begin_of_choices(const std::string& type) { return std::min(type.find(":{"), type.find(":value in {")); }

Json describe(const CLI::Option& option) {
  const bool flag = option.get_items_expected_max() == 0;
  Json names = Json::array();
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return {{"names", names},
          {"about", option.get_description()},
          {"value", flag ? Json(nullptr) : Json(value_name(option))},
          {"choices", choices(option)},
          {"default", option.get_default_str().empty() ? Json(nullptr) : Json(option.get_default_str())},
          {"required", option.get_required()},
          {"flag", flag}};
}

Json describe_operand(const CLI::Option& option) {
  const int most = option.get_items_expected_max();
  return {{"name", option.get_name(true, false)},
          {"about", option.get_description()},
          {"least", option.get_required() ? std::max(1, option.get_items_expected_min()) : 0},
          {"most", most >= CLI::detail::expected_max_vector_size ? Json(nullptr) : Json(most)}};
}

/// The footer without examples and exit codes, which all verbs have in common.
std::string explanation(const CLI::App& app) {
  std::string footer = app.get_footer();
  footer.resize(std::min(footer.size(), footer.find("Exit codes:")));
  if (const std::size_t begin = footer.find("Example"); begin != std::string::npos) {
    const std::size_t end = footer.find("\n\n", begin);
    footer.erase(begin, end == std::string::npos ? std::string::npos : end - begin);
  }
  while (!footer.empty() && footer.back() == '\n') footer.pop_back();
  return footer.substr(std::min(footer.size(), footer.find_first_not_of('\n')));
}

}  // namespace

std::vector<std::string> choices(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = begin_of_choices(type);
  if (begin == std::string::npos) return {};
  const std::size_t open = type.find('{', begin);
  std::istringstream words(type.substr(open + 1, type.find('}', open) - open - 1));
  std::vector<std::string> found;
  for (std::string word; std::getline(words, word, ',');) found.push_back(word.substr(0, word.find("->")));
  return found;
}

std::string value_name(const CLI::Option& option) {
  std::string type = option.get_type_name();
  type.resize(std::min(type.size(), begin_of_choices(type)));
  for (const std::string check : {":POSITIVE", ":NONNEGATIVE"})
    if (type.ends_with(check)) type.resize(type.size() - check.size());
  return type;
}

std::vector<std::string> examples(const CLI::App& app) {
  const std::string footer = app.get_footer();
  std::vector<std::string> found;
  const std::size_t begin = footer.find("Example");
  if (begin == std::string::npos) return found;
  std::istringstream lines(footer.substr(begin));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line.starts_with("  ")) found.push_back(line.substr(2));
  return found;
}

Json describe(const CLI::App& app) {
  Json operands = Json::array();
  Json options = Json::array();
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    if (option->get_positional())
      operands.push_back(describe_operand(*option));
    else
      options.push_back(describe(*option));
  }
  Json verbs = Json::array();
  for (const CLI::App* verb : app.get_subcommands({}))
    if (!verb->get_group().empty()) verbs.push_back(describe(*verb));
  return {{"name", app.get_name()},       {"about", app.get_description()},
          {"aliases", app.get_aliases()}, {"operands", operands},
          {"options", options},           {"examples", examples(app)},
          {"more", explanation(app)},     {"verbs", verbs}};
}
