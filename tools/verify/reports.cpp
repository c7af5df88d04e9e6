#include "verify/reports.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace verify {
namespace {

Json outcomes_of(const Run& run, std::size_t engine) {
  Json outcomes = Json::object();
  for (const Outcome outcome : all_outcomes)
    if (const std::size_t n = count(run, engine, outcome); n != 0) outcomes[std::string(name(outcome))] = n;
  return outcomes;
}

/// The element inside <testcase>, if there is one.
std::string junit_element(const Verdict& v) {
  const auto element = [&](const char* tag) {
    return fmt::format("<{0} type=\"{1}\" message=\"{2}\"/>", tag, name(v.outcome), escaped(v.reason));
  };
  switch (v.outcome) {
    case Outcome::exact:
    case Outcome::rounded:
    case Outcome::collapsed:
      return {};
    case Outcome::wrong:
    case Outcome::invalid:
      return element("failure");
    case Outcome::refused:
    case Outcome::crashed:
    case Outcome::timed_out:
    case Outcome::oracle_failed:
      return element("error");
    case Outcome::not_applicable:
      return "<skipped/>";
  }
  return {};
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += static_cast<unsigned char>(c) < 0x20 && c != '\t' ? ' ' : c;
    }
  }
  return out;
}

std::vector<std::string> tags_of(const Run& run) {
  std::map<std::string, std::size_t> counts;
  for (const Case& c : run.cases)
    for (const std::string& tag : c.tags) ++counts[tag];
  std::vector<std::pair<std::string, std::size_t>> list(counts.begin(), counts.end());
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<std::string> tags;
  for (const auto& entry : list) tags.push_back(entry.first);
  return tags;
}

Json json_report(const Run& run) {
  Json engines = Json::array(), tags = Json::object(), findings = Json::array();
  for (std::size_t e = 0; e < run.engines.size(); ++e)
    engines.push_back({{"name", run.engines[e]}, {"outcomes", outcomes_of(run, e)}});
  for (const Case& c : run.cases)
    for (const std::string& tag : c.tags) tags[tag] = tags.value(tag, 0) + 1;
  for (const Finding& f : run.findings)
    findings.push_back({{"case", run.cases[f.of_case].slug},
                        {"engine", run.engines[f.of_engine]},
                        {"outcome", name(f.verdict.outcome)},
                        {"reason", f.verdict.reason},
                        {"seconds", f.seconds},
                        {"peak_bytes", f.peak_bytes}});
  return {{"operation", "verify"}, {"cases", run.cases.size()}, {"seconds", run.seconds}, {"engines", engines},
          {"tags", tags},          {"findings", findings}};
}

std::string junit_report(const Run& run) {
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"strata verify\">\n";
  for (std::size_t e = 0; e < run.engines.size(); ++e) {
    const auto n = [&](std::initializer_list<Outcome> list) {
      std::size_t sum = 0;
      for (const Outcome o : list) sum += count(run, e, o);
      return sum;
    };
    xml += fmt::format("<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n",
                       escaped(run.engines[e]), run.cases.size(), n({Outcome::wrong, Outcome::invalid}),
                       n({Outcome::refused, Outcome::crashed, Outcome::timed_out, Outcome::oracle_failed}),
                       n({Outcome::not_applicable}));
    for (const Finding& f : run.findings)
      if (f.of_engine == e)
        xml += fmt::format("<testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">{}</testcase>\n",
                           escaped(run.engines[e]), escaped(run.cases[f.of_case].slug), f.seconds,
                           junit_element(f.verdict));
    xml += "</testsuite>\n";
  }
  return xml + "</testsuites>\n";
}

std::string summary(const Run& run) {
  std::string text;
  for (std::size_t e = 0; e < run.engines.size(); ++e) {
    text += run.engines[e] + ":";
    for (const Outcome outcome : all_outcomes)
      if (const std::size_t n = count(run, e, outcome); n != 0) text += fmt::format(" {} {}", n, name(outcome));
    text += "\n";
    for (const Finding& f : run.findings) {
      const Outcome o = f.verdict.outcome;
      if (f.of_engine != e || o == Outcome::exact || o == Outcome::rounded || o == Outcome::collapsed ||
          o == Outcome::not_applicable)
        continue;
      constexpr std::size_t longest = 160;
      text += fmt::format("  {}: {}: {}\n", run.cases[f.of_case].slug, name(o), f.verdict.reason.substr(0, longest));
    }
  }
  return text + fmt::format("{} cases in {:.1f} s\n", run.cases.size(), run.seconds);
}

}  // namespace verify
