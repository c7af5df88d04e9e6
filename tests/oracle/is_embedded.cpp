// strata_is_embedded MESH: exit code 0 if no triangles of a mesh cross, touch or overlap other than along common edges
// and vertices, by CGAL; else 1. What tools/bench/rounded.py asks.
#include <exception>
#include <iostream>

#include "oracle/embedding.h"
#include "strata/io.h"

int main(int count, char** arguments) {
  constexpr int failed = 2;
  try {
    if (count != 2) throw std::invalid_argument("one file is expected");
    return strata::oracle::is_embedded(strata::read_mesh(arguments[1]).mesh) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return failed;
  }
}
