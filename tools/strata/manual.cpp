#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "about.h"
#include "common/text_file.h"
#include "common/usage_error.h"

namespace {

using Words = std::vector<std::string>;

/// Text for roff: backslashes, hyphens and lines that begin with a command character are protected.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if ((out.empty() || out.back() == '\n') && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

std::string joined(const Words& words, const char* between) { return fmt::format("{}", fmt::join(words, between)); }

/// "MESH MESH...", in italics.
std::string operand_text(const Json& operand) {
  const int least = operand["least"];
  std::string text;
  for (int k = 0; k < std::max(least, 1); ++k) text += (k == 0 ? "\\fI" : " \\fI") + escaped(operand["name"]) + "\\fR";
  if (operand["most"].is_null() || operand["most"].get<int>() > std::max(least, 1)) text += "...";
  return least == 0 ? "[" + text + "]" : text;
}

std::string synopsis(const Json& verb, const std::string& name) {
  std::string text = ".SH SYNOPSIS\n\\fB" + escaped(name) + "\\fR";
  for (const Json& operand : verb["operands"]) text += " " + operand_text(operand);
  for (const Json& option : verb["options"])
    if (option["required"])
      text += fmt::format(" \\fB{}\\fR \\fI{}\\fR", escaped(option["names"][0]), escaped(option["value"]));
  if (!verb["verbs"].empty()) text += " \\fIverb\\fR";
  return text + " [\\fIoptions\\fR]\n";
}

std::string option_text(const Json& option) {
  Words names;
  for (const std::string name : option["names"]) names.push_back("\\fB" + escaped(name) + "\\fR");
  std::string text = ".TP\n" + joined(names, ", ");
  if (!option["flag"]) text += " \\fI" + escaped(option["value"]) + "\\fR";
  text += "\n" + escaped(option["about"]) + ".\n";
  if (!option["choices"].empty()) text += "One of " + escaped(joined(option["choices"].get<Words>(), ", ")) + ".\n";
  if (!option["default"].is_null()) text += "Unless given: " + escaped(option["default"]) + ".\n";
  return text;
}

std::string examples_text(const Json& verb) {
  if (verb["examples"].empty()) return {};
  std::string text = ".SH EXAMPLES\n";
  for (const std::string line : verb["examples"]) text += ".PP\n.nf\n" + escaped(line) + "\n.fi\n";
  return text;
}

std::string verbs_text(const Json& verb, const std::string& name) {
  if (verb["verbs"].empty()) return {};
  std::string text = ".SH VERBS\n";
  std::string page = name;
  std::ranges::replace(page, ' ', '-');
  for (const Json& each : verb["verbs"])
    text += fmt::format(".TP\n\\fB{}\\fR(1)\n{}.\n", escaped(page + "-" + each["name"].get<std::string>()),
                        escaped(each["about"]));
  return text;
}

constexpr const char* exit_status = R"(.SH EXIT STATUS
.TP
.B 0
ok
.TP
.B 1
the answer is no: different, not a solid, not all jobs ok
.TP
.B 2
usage
.TP
.B 3
a file cannot be read or written
.TP
.B 4
invalid input
.TP
.B 5
the result is not certified
.TP
.B 6
cancelled, out of time or out of memory
.TP
.B 70
an error of the program itself
)";

const Json& find(const Json& program, const Words& path) {
  const Json* verb = &program;
  for (const std::string& word : path) {
    const auto& verbs = (*verb)["verbs"];
    const auto found = std::ranges::find_if(verbs, [&](const Json& each) { return each["name"] == word; });
    if (found == verbs.end())
      throw UsageError("there is no verb '" + joined(path, " ") + "'; `strata --help` lists them");
    verb = &*found;
  }
  return *verb;
}

void write_pages(const Json& program, const Words& path, const std::filesystem::path& folder) {
  const std::string name = "strata" + (path.empty() ? "" : "-" + joined(path, "-")) + ".1";
  write_text((folder / name).string(), manual_page(program, path));
  for (const Json& verb : find(program, path)["verbs"]) {
    Words longer = path;
    longer.push_back(verb["name"]);
    write_pages(program, longer, folder);
  }
}

}  // namespace

std::string manual_page(const Json& program, const Words& path) {
  const Json& verb = find(program, path);
  const std::string name = path.empty() ? "strata" : "strata " + joined(path, " ");
  std::string page = name;
  std::ranges::replace(page, ' ', '-');
  std::string upper = page;
  std::ranges::transform(upper, upper.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  std::string text = fmt::format(".TH {} 1 \"\" \"strata {}\" \"Strata\"\n.SH NAME\n{} \\- {}\n", upper, STRATA_VERSION,
                                 escaped(page), escaped(verb["about"]));
  text += synopsis(verb, name);
  if (const std::string more = verb["more"]; !more.empty()) text += ".SH DESCRIPTION\n" + escaped(more) + "\n";
  if (!verb["operands"].empty()) text += ".SH OPERANDS\n";
  for (const Json& operand : verb["operands"])
    text += ".TP\n" + operand_text(operand) + "\n" + escaped(operand["about"]) + ".\n";
  if (!verb["options"].empty()) text += ".SH OPTIONS\n";
  for (const Json& option : verb["options"]) text += option_text(option);
  text += verbs_text(verb, name) + examples_text(verb) + exit_status;
  return path.empty() ? text : text + ".SH SEE ALSO\n.BR strata (1)\n";
}

void write_manual(const Json& program, const std::string& folder) {
  std::filesystem::create_directories(folder);
  write_pages(program, {}, folder);
}
