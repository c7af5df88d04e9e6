#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "strata/errors.h"
#include "verify/decimal.h"
#include "verify/reports.h"
#include "verify/sketch.h"
#include "verify/workbench_link.h"

namespace verify {
namespace {

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Exactness scoreboard</title><style>
body{font:14px/1.4 system-ui,sans-serif;margin:2em auto;max-width:1200px;padding:0 1em;color:#222}
table{border-collapse:collapse}td,th{padding:.25em .6em;border:1px solid #ccc;text-align:left;vertical-align:top}
td.n{text-align:right;white-space:nowrap}th{background:#f4f4f4}a{color:inherit}code{background:#f4f4f4}
.exact,.rounded{background:#d9f0d9}.rounded,.collapsed{background:#eef6d6}.wrong,.invalid{background:#f8d0d0}
.refused,.not{background:#eee}.crashed,.timed,.oracle{background:#f6dcb8}
section{border-top:1px solid #ccc;margin-top:1.2em}figure{display:inline-block;margin:.3em .8em .3em 0}
figcaption{font-size:12px;color:#555}.list{display:none}.list:target{display:block;border:2px solid #888;padding:.5em 1em}
</style></head><body>
<h1>Exactness scoreboard</h1>
)";

/// The first word of an outcome is its class.
std::string css_class(Outcome outcome) {
  const std::string_view text = name(outcome);
  return std::string(text.substr(0, text.find(' ')));
}

bool is_right(Outcome outcome) {
  return outcome == Outcome::exact || outcome == Outcome::rounded || outcome == Outcome::collapsed;
}

const Finding& finding(const Run& run, std::size_t of_case, std::size_t of_engine) {
  return run.findings[of_case * run.engines.size() + of_engine];
}

/// Calls visit with the numbers of the cases that have a tag; of all cases for the tag "all".
template <class Visit>
void for_each_tagged(const Run& run, const std::string& tag, const Visit& visit) {
  for (std::size_t k = 0; k < run.cases.size(); ++k)
    if (tag == "all" || run.cases[k].has_tag(tag)) visit(k);
}

std::string totals(const Run& run) {
  std::string html = "<table><tr><th>engine</th>";
  for (const Outcome o : all_outcomes) html += fmt::format("<th>{}</th>", name(o));
  html += "</tr>\n";
  for (std::size_t e = 0; e < run.engines.size(); ++e) {
    html += fmt::format("<tr><th>{}</th>", escaped(run.engines[e]));
    for (const Outcome o : all_outcomes) {
      const std::size_t n = count(run, e, o);
      html += fmt::format("<td class=\"n {}\">{}</td>", n == 0 ? "" : css_class(o), n);
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

/// Right results of how many; which outcomes the others have.
std::string cell(const Run& run, const std::string& tag, std::size_t engine) {
  std::size_t all = 0, right = 0, exact = 0;
  for_each_tagged(run, tag, [&](std::size_t k) {
    const Outcome o = finding(run, k, engine).verdict.outcome;
    all += o != Outcome::not_applicable;
    right += is_right(o);
    exact += o == Outcome::exact;
  });
  const char* look = all == 0           ? "not"
                     : all == exact     ? "exact"
                     : all == right     ? "rounded"
                     : 2 * right >= all ? "crashed"
                                        : "wrong";
  return fmt::format("<td class=\"n {}\"><a href=\"#list-{}-{}\">{} of {}</a></td>", look, engine, tag, right, all);
}

std::string board(const Run& run, const std::vector<std::string>& tags) {
  std::string html = "<table><tr><th>tag</th>";
  for (const std::string& engine : run.engines) html += fmt::format("<th>{}</th>", escaped(engine));
  html += "</tr>\n";
  for (const std::string& tag : tags) {
    html += fmt::format("<tr><th>{}</th>", escaped(tag));
    for (std::size_t e = 0; e < run.engines.size(); ++e) html += cell(run, tag, e);
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

/// What a cell of the board links to: its cases by outcome. Shown when it is the target.
std::string list(const Run& run, const std::string& tag, std::size_t engine) {
  std::string html = fmt::format("<div class=\"list\" id=\"list-{}-{}\"><b>{}, {}</b>", engine, tag,
                                 escaped(run.engines[engine]), tag);
  for (const Outcome o : all_outcomes) {
    std::string cases;
    for_each_tagged(run, tag, [&](std::size_t k) {
      if (finding(run, k, engine).verdict.outcome == o)
        cases += fmt::format(" <a href=\"#{0}\">{0}</a>", run.cases[k].slug);
    });
    if (!cases.empty()) html += fmt::format("<p><span class=\"{}\">{}</span>:{}</p>", css_class(o), name(o), cases);
  }
  return html + "</div>\n";
}

std::string figure(const std::string& picture, const std::string& caption) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>", picture, escaped(caption));
}

std::string expected_text(const Expectation& e) {
  std::string origin;
  for (const std::string& who : e.origin) origin += (origin.empty() ? "" : ", ") + who;
  return fmt::format(
      "volume {}, area {}, {} facets, {} edges, {} vertices, {} components, Euler characteristic {}, "
      "{} non-manifold edges, {} non-manifold vertices (by {})",
      decimal(e.volume_near), decimal(e.area), e.form.facets, e.form.edges, e.form.vertices, e.components, e.euler,
      e.touching.edges, e.touching.vertices, origin);
}

/// A link that asks the workbench the case's question, where it is not too long.
std::string link_to(const std::string& workbench, const Case& c) {
  const std::string fragment = workbench.empty() ? std::string() : workbench_fragment(c);
  if (fragment.empty()) return {};
  return fmt::format("<p><a href=\"{}#{}\">in the workbench</a></p>\n", escaped(workbench), escaped(fragment));
}

std::string case_section(const Run& run, std::size_t k, const std::string& workbench) {
  const Case& c = run.cases[k];
  std::string html = fmt::format("<section id=\"{0}\"><h3>{0}</h3><p>{1}</p><p><code>{2}</code></p>\n", c.slug,
                                 escaped(c.why), escaped(c.expression));
  constexpr std::size_t most_operands = 4;
  for (std::size_t i = 0; i < std::min(c.operands.size(), most_operands); ++i)
    html += figure(sketch(c.operands[i].mesh.mesh), c.operands[i].name);
  if (c.operands.size() > most_operands) html += fmt::format("and {} more ", c.operands.size() - most_operands);
  if (!run.expected_pictures.at(k).empty()) html += figure(run.expected_pictures[k], "expected");
  for (std::size_t e = 0; e < run.engines.size(); ++e)
    if (const Finding& f = finding(run, k, e); !f.picture.empty())
      html += figure(f.picture, run.engines[e] + ": " + std::string(name(f.verdict.outcome)));
  if (c.expected) html += fmt::format("<p>{}</p>", escaped(expected_text(*c.expected)));
  html += "<table>";
  for (std::size_t e = 0; e < run.engines.size(); ++e) {
    const Finding& f = finding(run, k, e);
    html += fmt::format("<tr><th>{}</th><td class=\"{}\">{}</td><td>{}</td><td class=\"n\">{:.2f} s</td></tr>\n",
                        escaped(run.engines[e]), css_class(f.verdict.outcome), name(f.verdict.outcome),
                        escaped(f.verdict.reason), f.seconds);
  }
  return html + "</table>" + link_to(workbench, c) + "</section>\n";
}

}  // namespace

std::string scoreboard(const Run& run, const std::string& workbench) {
  std::vector<std::string> tags = {"all"};
  std::ranges::copy(tags_of(run), std::back_inserter(tags));
  std::string html = head + fmt::format("<style>{}</style>\n", sketch_style());
  html += fmt::format(
      "<p>{} cases, {:.0f} s, strata {}. Exact: the same point set, as a valid mesh. Rounded: volume, area and "
      "topology "
      "right within rounding. Cells count results that are one or the other; they link to their cases.</p>\n",
      run.cases.size(), run.seconds, STRATA_VERSION);
  html += totals(run) + "<h2>By tag</h2>\n" + board(run, tags);
  for (const std::string& tag : tags)
    for (std::size_t e = 0; e < run.engines.size(); ++e) html += list(run, tag, e);
  html += "<h2>Cases</h2>\n";
  for (std::size_t k = 0; k < run.cases.size(); ++k) html += case_section(run, k, workbench);
  return html + "</body></html>\n";
}

}  // namespace verify
