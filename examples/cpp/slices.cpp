// The areas of a ball's slices: exact polygons, also in planes that contain vertices.
#include <strata/planar.h>
#include <strata/section.h>
#include <strata/strata.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <vector>

int main() {
  const strata::Solid ball = strata::make_sphere(1, 24);
  std::vector<double> heights;
  for (int k = -4; k <= 4; ++k) heights.push_back(k / 4.0);
  double largest = 0;
  strata::slice(ball, 2, heights, [&](std::size_t k, const strata::planar::Region& region) {
    const double area = strata::to_nearest_double(strata::planar::area(region));
    largest = std::max(largest, area);
    std::cout << heights[k] << ' ' << area << '\n';
  });
  return largest > 3 && largest < 3.1416 ? EXIT_SUCCESS : EXIT_FAILURE;  // the polyhedron is within the ball
}
