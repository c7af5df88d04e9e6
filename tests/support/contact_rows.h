#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "strata/mesh.h"
#include "strata/options.h"
#include "strata/rational.h"

/// The rows of the table in strata/degenerate_contact.h, each with the smallest solids that meet so and with what the
/// operations give.
namespace strata::test {

/// What is known about a result, whatever its triangles.
struct ContactFacts {
  Rational volume = 0;
  std::size_t facets = 0;    ///< of the canonical form
  std::size_t edges = 0;     ///< non-manifold
  std::size_t vertices = 0;  ///< non-manifold
  /// Where the surface comes from: a letter per operand, with a minus if turned over, and optionally how much: "a=4
  /// -b=8". Area is measured as the sum of those of the projections along the three axes; that is a rational number.
  std::string sources = {};
};

/// What is asked about a row. The reversed difference is the last operand without all others.
enum class ContactQuestion { union_, intersection, difference, reversed_difference, symmetric_difference };

inline constexpr std::array all_contact_questions{ContactQuestion::union_, ContactQuestion::intersection,
                                                  ContactQuestion::difference, ContactQuestion::reversed_difference,
                                                  ContactQuestion::symmetric_difference};

struct ContactRow {
  std::string name;
  std::vector<Mesh> operands;
  std::array<ContactFacts, all_contact_questions.size()> results;
  std::size_t copies = 0;  ///< vertices that the first operand lists twice and that stay two
  InputClass input = InputClass::solid;

  [[nodiscard]] const ContactFacts& result(ContactQuestion question) const {
    return results[static_cast<std::size_t>(question)];
  }
};

/// In the order of the table.
[[nodiscard]] const std::vector<ContactRow>& contact_rows();

[[nodiscard]] Operation operation_of(ContactQuestion question);
/// In the order in which the operation takes them.
[[nodiscard]] std::vector<Mesh> operands_of(const ContactRow& row, ContactQuestion question);
[[nodiscard]] const char* name(ContactQuestion question);

}  // namespace strata::test
