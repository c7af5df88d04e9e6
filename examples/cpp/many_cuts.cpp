// A hundred cuts in a workpiece: each costs about what it cuts, and all versions stay valid.
#include <strata/incremental.h>
#include <strata/strata.h>

#include <cstdlib>
#include <iostream>

int main() {
  strata::IncrementalSolid piece(strata::make_box({0, 0, 0}, {100, 10, 1}));
  const strata::IncrementalSolid before = piece;
  const strata::Solid drill = strata::make_cylinder(0.3, 3, 12);
  for (int k = 0; k < 100; ++k)
    piece = piece.with(strata::Operation::difference, drill.translated({k + strata::Rational(1, 3), 5, -1}));
  std::cout << before.triangle_count() << " triangles before, " << piece.triangle_count() << " after, volume "
            << piece.volume() << '\n';
  return before.triangle_count() == 12 && piece.volume() < before.volume() ? EXIT_SUCCESS : EXIT_FAILURE;
}
