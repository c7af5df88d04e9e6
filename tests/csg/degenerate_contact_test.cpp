#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "strata/check.h"
#include "strata/combine.h"
#include "strata/measure.h"
#include "support/contact_rows.h"
#include "support/planes.h"

namespace strata {
namespace {

using test::ContactFacts;
using test::ContactQuestion;
using test::ContactRow;

/// Twice the oriented area of a triangle.
RationalPoint area_vector(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  RationalPoint n;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    n[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
  }
  return n;
}

RationalPoint area_vector(const ExactMesh& mesh, const Triangle& t) {
  return area_vector(mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2]));
}

/// Letter, or minus and letter, of the operand that each part of the surface is from, with its area.
std::map<std::string, Rational> areas_by_source(const ExactMesh& result, const std::vector<Source>& sources,
                                                const ContactRow& row, ContactQuestion question) {
  const std::vector<Mesh> operands = operands_of(row, question);
  std::map<std::string, Rational> areas;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto [operand, face] = sources[i];
    const Mesh& from = operands[operand];
    const RationalPoint n = area_vector(result, result.mesh.triangles[i]);
    const RationalPoint m = area_vector(ExactMesh{from, {}}, from.triangles[face]);
    const std::size_t place =
        question == ContactQuestion::reversed_difference ? operands.size() - 1 - operand : operand;
    const bool is_turned = n[0] * m[0] + n[1] * m[1] + n[2] * m[2] < 0;
    Rational& area = areas[(is_turned ? "-" : "") + std::string(1, static_cast<char>('a' + place))];
    for (const Rational& x : n) area += (x < 0 ? -x : x) / 2;
  }
  return areas;
}

/// Each word expected has a part of the surface, of that area if one is told, and there are no other parts.
void check_sources(const std::map<std::string, Rational>& found, const std::string& expected) {
  std::istringstream words(expected);
  std::size_t count = 0;
  for (std::string word; words >> word; ++count) {
    const std::size_t equals = word.find('=');
    const auto place = found.find(word.substr(0, equals));
    CAPTURE(word);
    REQUIRE(place != found.end());
    if (equals != std::string::npos) CHECK(place->second == Rational(word.substr(equals + 1)));
  }
  CHECK(found.size() == count);
}

BooleanResult result_of(const ContactRow& row, ContactQuestion question, InputClass input) {
  const std::vector<Mesh> operands = operands_of(row, question);
  const std::vector<MeshView> views(operands.begin(), operands.end());
  return combine(operation_of(question), std::span<const MeshView>(views), {.input = input, .exact_vertices = true});
}

/// A boundary as it should be written: closed, embedded, and this many places listed twice.
void check_written(const ExactMesh& mesh, std::size_t copies) {
  CHECK(topology(mesh).open_edges == 0);
  if (!mesh.mesh.triangles.empty()) CHECK(check(mesh).empty());
  const std::set<Vertex> places(mesh.mesh.vertices.begin(), mesh.mesh.vertices.end());
  CHECK(places.size() + copies == mesh.mesh.vertices.size());
}

void check_row(const ContactRow& row, ContactQuestion question) {
  const ContactFacts& expected = row.result(question);
  const BooleanResult result = result_of(row, question, row.input);
  const ExactMesh mesh{result.mesh, result.exact};
  const CanonicalForm form = canonical_form(mesh);
  const Topology t = topology(mesh);
  CHECK(volume(mesh) == expected.volume);
  CHECK(form.facet_count() == expected.facets);
  CHECK(t.non_manifold_edges == expected.edges);
  CHECK(t.non_manifold_vertices == expected.vertices);
  check_sources(areas_by_source(mesh, result.sources, row, question), expected.sources);
  CHECK(test::wrong_sources(mesh, result.sources, operands_of(row, question)) == "");
  check_written(mesh, expected.sources.find('a') == std::string::npos ? 0 : row.copies);
  const BooleanResult searched = result_of(row, question, InputClass::overlapping);
  CHECK(canonical_form({searched.mesh, searched.exact}) == form);
}

/// A line of the table in the header: the name of a contact and its cells.
using Line = std::vector<std::string>;

Line cells_of(const std::string& line) {
  Line cells;
  std::istringstream parts(line.substr(line.find('|') + 1));
  for (std::string cell; std::getline(parts, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' ');
    if (first != std::string::npos) cells.push_back(cell.substr(first, cell.find_last_not_of(' ') + 1 - first));
  }
  return cells;
}

/// The table of contacts without its head.
std::vector<Line> table_of_header() {
  std::ifstream header(STRATA_DATA_DIR "/../include/strata/degenerate_contact.h");
  REQUIRE(header);
  std::vector<Line> table;
  bool is_in_table = false;
  for (std::string line; std::getline(header, line);) {
    if (line.rfind("/// |", 0) != 0) {
      is_in_table = false;
    } else if (line.rfind("/// | contact ", 0) == 0) {
      is_in_table = true;
    } else if (is_in_table && line.rfind("/// |-", 0) != 0) {
      table.push_back(cells_of(line));
    }
  }
  return table;
}

CanonicalForm form_of(const Mesh& mesh) { return canonical_form(ExactMesh{mesh, {}}); }

/// Does one word of a cell hold for a result?
bool holds(const std::string& word, const ContactRow& row, const ExactMesh& result, const std::string& sources) {
  const Topology t = topology(result);
  const bool is_manifold = t.non_manifold_edges == 0 && t.non_manifold_vertices == 0;
  const auto is_from = [&](char operand) { return sources.find(operand) != std::string::npos; };
  const char last = static_cast<char>('a' + row.operands.size() - 1);
  if (word == "0") return result.mesh.vertices.empty() && result.mesh.triangles.empty();
  if (word == "A") return canonical_form(result) == form_of(row.operands.front());
  if (word == "B") return canonical_form(result) == form_of(row.operands.back());
  if (word == "AB") return is_manifold && t.components == 2 && is_from('a') && is_from(last);
  if (word == "a") return is_from('a');
  if (word == "b") return is_from(last);
  if (word == ".") return is_manifold && !result.mesh.triangles.empty();
  if (word == "m") return is_manifold && is_from('a') && is_from(last);
  if (word == "v") return t.non_manifold_edges == 0 && t.non_manifold_vertices == 1;
  if (word == "e") return t.non_manifold_edges > 0;
  return false;
}

}  // namespace

// Catches: another face than the lowest that counts, walls between opposite faces that stay, pieces on the wrong side,
// places written twice.
TEST_CASE("degenerate contacts give what the table in degenerate_contact.h says", "[csg][degenerate]") {
  for (const ContactRow& row : test::contact_rows()) {
    DYNAMIC_SECTION(row.name) {
      for (const ContactQuestion question : test::all_contact_questions) {
        CAPTURE(name(question));
        check_row(row, question);
      }
    }
  }
}

// Catches: faces that stay divided after what divided them is gone.
TEST_CASE("contact inside faces leaves no divided faces where it leaves no trace", "[csg][degenerate]") {
  const std::set<std::string> inside_faces{"vertex on face, outside",
                                           "vertex on face, inside",
                                           "edge in face, outside",
                                           "edge in face, inside",
                                           "coplanar faces, same side, equal",
                                           "coplanar faces, same side, contained",
                                           "identical operands",
                                           "coplanar faces, opposite sides, contained"};
  std::size_t compared = 0;
  for (const ContactRow& row : test::contact_rows()) {
    if (!inside_faces.contains(row.name)) continue;
    CAPTURE(row.name);
    for (const ContactQuestion question : test::all_contact_questions) {
      const BooleanResult result = result_of(row, question, row.input);
      const CanonicalForm form = canonical_form(ExactMesh{result.mesh, result.exact});
      for (const Mesh& operand : row.operands) {
        if (form != form_of(operand)) continue;
        ++compared;
        CHECK(result.mesh.triangles.size() == operand.triangles.size());
        CHECK(result.mesh.vertices.size() == operand.vertices.size());
      }
    }
  }
  CHECK(compared == 18);
}

TEST_CASE("every row of the table of degenerate contacts has a test, and every test a row", "[csg][degenerate]") {
  std::vector<std::string> in_header, tested;
  for (const Line& line : table_of_header()) in_header.push_back(line.front());
  for (const ContactRow& row : test::contact_rows()) tested.push_back(row.name);
  CHECK(in_header == tested);
}

TEST_CASE("every cell of the table of degenerate contacts holds", "[csg][degenerate]") {
  const std::vector<Line> table = table_of_header();
  const std::vector<ContactRow>& rows = test::contact_rows();
  REQUIRE(table.size() == rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CAPTURE(rows[i].name);
    REQUIRE(table[i].size() == 1 + test::all_contact_questions.size());
    for (const ContactQuestion question : test::all_contact_questions) {
      const BooleanResult result = result_of(rows[i], question, rows[i].input);
      std::istringstream words(table[i][1 + static_cast<std::size_t>(question)]);
      for (std::string word; words >> word;) {
        CAPTURE(name(question), word);
        CHECK(holds(word, rows[i], {result.mesh, result.exact}, rows[i].result(question).sources));
      }
    }
  }
}

}  // namespace strata
