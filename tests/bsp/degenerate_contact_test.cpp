#include <catch2/catch.hpp>
#include <span>
#include <utility>
#include <vector>

#include "strata/bsp.h"
#include "strata/combine.h"
#include "strata/measure.h"
#include "strata/query.h"
#include "support/contact_rows.h"

namespace strata {
namespace {

using test::ContactFacts;
using test::ContactQuestion;
using test::ContactRow;

ExactMesh result_of(const ContactRow& row, ContactQuestion question, const Engine* engine) {
  const std::vector<Mesh> operands = operands_of(row, question);
  const std::vector<MeshView> views(operands.begin(), operands.end());
  Options options;
  options.input = row.input;
  options.engine = engine;
  options.exact_vertices = true;
  BooleanResult result = combine(operation_of(question), std::span<const MeshView>(views), options);
  CHECK(result.sources.size() == result.mesh.triangles.size());
  return {std::move(result.mesh), std::move(result.exact)};
}

void check_row(const ContactRow& row, ContactQuestion question, const Engine& engine) {
  CAPTURE(name(question), engine.name);
  const ContactFacts& expected = row.result(question);
  const ExactMesh mesh = result_of(row, question, &engine);
  const CanonicalForm form = canonical_form(mesh);
  CHECK(volume(mesh) == expected.volume);
  CHECK(form.facet_count() == expected.facets);
  CHECK(form == canonical_form(result_of(row, question, nullptr)));
  CHECK(topology(mesh).open_edges == 0);
}

}  // namespace

// Catches: an engine that keeps walls, loses touching parts, or has its own idea of what is regular.
TEST_CASE("degenerate contacts are the same solids by layers and by merged partitions", "[csg][bsp][degenerate]") {
  for (const ContactRow& row : test::contact_rows()) {
    DYNAMIC_SECTION(row.name) {
      for (const ContactQuestion question : test::all_contact_questions) {
        check_row(row, question, layer_engine);
        check_row(row, question, bsp_engine);
      }
    }
  }
}

}  // namespace strata
