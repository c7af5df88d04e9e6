// A plate with holes as an expression: nothing is computed before it is evaluated, and then all at once, exactly.
#include <strata/strata.h>

#include <cstdlib>
#include <iostream>

int main() {
  using strata::Expression;
  using strata::Rational;
  const Expression drill(strata::make_cylinder(0.4, 3, 32), "drill");
  Expression part(strata::make_box({0, 0, 0}, {9, 3, 1}), "plate");
  for (int k = 0; k < 3; ++k)  // at thirds of the length, which no double is
    part = part - drill.transformed(strata::Transform::translation({Rational(3 * k) + Rational(4, 3), 1.5, -1}));
  const strata::Solid solid = part.evaluate();
  std::cout << part.text() << '\n' << "holes remove " << Rational(27) - solid.volume() << '\n';
  strata::write_mesh("plate.off", solid.exact_mesh());
  return solid.components().size() == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
