#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>

#include "about.h"
#include "common/usage_error.h"

namespace {

using Words = std::vector<std::string>;

/// Calls visit(path, verb) for every verb, and for the verbs of verbs. "planar", "planar union".
void for_each_verb(const Json& parent, const std::string& prefix,
                   const std::function<void(const std::string&, const Json&)>& visit) {
  for (const Json& verb : parent["verbs"]) {
    const std::string path = prefix + verb["name"].get<std::string>();
    visit(path, verb);
    for_each_verb(verb, path + " ", visit);
  }
}

Words names_of(const Json& list) {
  Words names;
  for (const Json& each : list) {
    names.push_back(each["name"]);
    for (const std::string alias : each["aliases"]) names.push_back(alias);
  }
  return names;
}

Words option_names(const Json& verb) {
  Words names;
  for (const Json& option : verb["options"])
    for (const std::string name : option["names"]) names.push_back(name);
  return names;
}

/// In single quotes, for any of the shells.
std::string quoted(const std::string& text, const char* quote) {
  std::string out;
  for (const char c : text)
    if (c == '\'')
      out += quote;
    else
      out += c;
  return "'" + out + "'";
}

/// The paths of a verb and of its aliases, as alternatives of a `case`.
std::string alternatives(const std::string& path, const Json& verb) {
  const std::string parent = path.substr(0, path.size() - verb["name"].get<std::string>().size());
  std::string text = "'" + path + "'";
  for (const std::string alias : verb["aliases"]) text += "|'" + parent + alias + "'";
  return text;
}

std::string bash(const Json& program) {
  std::string parents;
  std::string verbs;
  std::string values;
  for_each_verb(program, "", [&](const std::string& path, const Json& verb) {
    const std::string key = alternatives(path, verb);
    if (!verb["verbs"].empty())
      parents += fmt::format("    {}) words='{}' ;;\n", key, fmt::join(names_of(verb["verbs"]), " "));
    verbs += fmt::format("    {}) words='{}' ;;\n", key, fmt::join(option_names(verb), " "));
    for (const Json& option : verb["options"])
      if (!option["choices"].empty())
        for (const std::string name : option["names"])
          values +=
              fmt::format("    '{} {}') words='{}' ;;\n", path, name, fmt::join(option["choices"].get<Words>(), " "));
  });
  return fmt::format(R"(# Completion of strata for bash; made by `strata completion bash`.
_strata() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} path=${{COMP_WORDS[1]}} words=''
  COMPREPLY=()
  if [[ $COMP_CWORD -eq 1 ]]; then
    mapfile -t COMPREPLY < <(compgen -W '{}' -- "$word")
    return
  fi
  case $path in
{}  esac
  if [[ -n $words ]]; then
    if [[ $COMP_CWORD -eq 2 ]]; then
      mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
      return
    fi
    path="$path ${{COMP_WORDS[2]}}"
  fi
  words=''
  case "$path $previous" in
{}  esac
  if [[ -z $words && $word == -* ]]; then
    case $path in
{}    esac
  fi
  if [[ -n $words ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  else
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}}
complete -F _strata strata
)",
                     fmt::join(names_of(program["verbs"]), " "), parents, values, verbs);
}

/// Text within a specification of zsh's _arguments.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_arguments(const Json& verb) {
  std::string text = "_arguments -s";
  for (const Json& option : verb["options"]) {
    const Words names = option["names"];
    std::string rest = "[" + zsh_text(option["about"]) + "]";
    if (!option["flag"]) {
      rest += ":" + zsh_text(option["value"]) + ":";
      rest +=
          option["choices"].empty() ? "_files" : fmt::format("({})", fmt::join(option["choices"].get<Words>(), " "));
    }
    for (const std::string& name : names)
      text += " \\\n        " + quoted(fmt::format("({}){}{}", fmt::join(names, " "), name, rest), "'\\''");
  }
  return text + " \\\n        '*:file:_files'";
}

/// The part of the function that completes after the words of `parent`, which are shifted away.
std::string zsh_verbs(const Json& parent, const std::string& indent) {
  std::string list;
  std::string cases;
  for (const Json& verb : parent["verbs"]) {
    Words names = {verb["name"]};
    for (const std::string alias : verb["aliases"]) names.push_back(alias);
    for (const std::string& name : names)
      list += indent + "  " + quoted(name + ":" + zsh_text(verb["about"]), "'\\''") + "\n";
    cases += fmt::format("{}  {})\n{}    {}\n{}    ;;\n", indent, fmt::join(names, "|"), indent,
                         verb["verbs"].empty() ? zsh_arguments(verb) : "\n" + zsh_verbs(verb, indent + "    "), indent);
  }
  return fmt::format(R"({0}verbs=(
{1}{0})
{0}if (( CURRENT == 2 )); then _describe verb verbs; return; fi
{0}shift words; (( CURRENT-- ))
{0}case $words[1] in
{2}{0}esac)",
                     indent, list, cases);
}

std::string zsh(const Json& program) {
  return fmt::format(R"(#compdef strata
# Completion of strata for zsh; made by `strata completion zsh`.
_strata() {{
  local -a verbs
{}
}}
if [[ $funcstack[1] == _strata ]]; then _strata "$@"; else compdef _strata strata; fi
)",
                     zsh_verbs(program, "  "));
}

std::string fish(const Json& program) {
  std::string text =
      "# Completion of strata for fish; made by `strata completion fish`.\n"
      "function __strata_path\n  set -l words (commandline -opc)\n  test \"$words[2..]\" = \"$argv\"\nend\n"
      "function __strata_after\n  set -l words (commandline -opc)\n"
      "  string match -q -- \"$argv *\" \"$words[2..] \"\nend\n";
  const auto add_verbs = [&](const Json& parent, const std::string& path) {
    for (const Json& verb : parent["verbs"]) {
      Words names = {verb["name"]};
      for (const std::string alias : verb["aliases"]) names.push_back(alias);
      for (const std::string& name : names)
        text += fmt::format("complete -c strata -f -n '__strata_path {}' -a {} -d {}\n", path, name,
                            quoted(verb["about"], "\\'"));
    }
  };
  add_verbs(program, "");
  for_each_verb(program, "", [&](const std::string& path, const Json& verb) {
    add_verbs(verb, path);
    const std::string parent = path.substr(0, path.size() - verb["name"].get<std::string>().size());
    Words paths = {path};
    for (const std::string alias : verb["aliases"]) paths.push_back(parent + alias);
    for (const std::string& each : paths)
      for (const Json& option : verb["options"]) {
        std::string line = fmt::format("complete -c strata -n '__strata_after {}'", each);
        for (const std::string name : option["names"])
          line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
        if (!option["flag"]) line += " -r";
        if (!option["choices"].empty())
          line += fmt::format(" -f -a '{}'", fmt::join(option["choices"].get<Words>(), " "));
        text += line + " -d " + quoted(option["about"], "\\'") + "\n";
      }
  });
  return text;
}

}  // namespace

std::string completion(const Json& program, const std::string& shell) {
  if (shell == "bash") return bash(program);
  if (shell == "zsh") return zsh(program);
  if (shell == "fish") return fish(program);
  throw UsageError("completions are for bash, zsh and fish, not for " + shell);
}
