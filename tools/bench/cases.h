#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "corpus.h"
#include "strata/mesh.h"
#include "strata/options.h"

namespace bench {

/// What a case is for; results are held against a target per group.
enum class Group {
  largest,     ///< the largest pair of smooth meshes
  pair,        ///< two meshes of 20,000 triangles or more
  tiny,        ///< two icosahedra: what a call costs
  small,       ///< a few triangles, degenerate
  dense,       ///< contact or crossings everywhere, or one face with thousands of them
  many,        ///< hundreds of operands in one call
  one_by_one,  ///< hundreds of operands, each joined to the result so far
  chain,       ///< many differences one after the other, in one call
  drill,       ///< a small operand in a large one
  slow,        ///< as one_by_one, but some engines take an hour; not part of the table
  smoke,       ///< for counting instructions; not part of the table
};

struct Case {
  std::string name;
  std::string about;  ///< one line for the table
  Group group = Group::pair;
  strata::Operation operation = strata::Operation::union_;
  bool from_corpus = false;
  std::optional<double> volume = {};                             ///< of the result, where it is known by construction
  std::function<std::vector<strata::Mesh>(const Corpus&)> make;  ///< throws MissingMesh
};

[[nodiscard]] std::span<const Case> all_cases();
[[nodiscard]] const Case& case_named(const std::string& name);  ///< throws std::invalid_argument
[[nodiscard]] std::string name(Group group);

}  // namespace bench
