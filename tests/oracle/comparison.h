#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "strata/combine.h"
#include "support/touching.h"

namespace strata::oracle {

/// Seeds first .. last-1.
struct SeedRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};

/// The range "first-last" (or one seed) in the environment variable STRATA_SEEDS, which replays a case; else `usual`.
[[nodiscard]] SeedRange seeds(SeedRange usual);

/// What became of all operations. Nothing is skipped: the three numbers add up to all that were asked for.
struct Tally {
  std::uint64_t equal = 0;
  std::uint64_t different = 0;      ///< the engine threw, or its result is another point set
  std::uint64_t oracle_failed = 0;  ///< CGAL has no answer, or several that differ
};

/// An engine that is compared, and what became of its operations.
struct Compared {
  std::string name;
  const Engine* engine = nullptr;  ///< none: the arrangement
  Tally tally;
};

/// All engines of the library, with nothing counted: the arrangement, layers, and binary space partitions.
[[nodiscard]] std::vector<Compared> all_engines();

/// Runs the four operations on the operands, by every engine and in CGAL, which is asked once for all; every difference
/// is a failed check that carries the seed, the engine, the operation and the operands, which are also written as OFF
/// files.
void compare_with_nef(const test::Operands& operands, std::uint64_t seed, std::vector<Compared>& engines);

/// One line on stdout.
void print(const std::string& title, const Tally& tally);

}  // namespace strata::oracle
