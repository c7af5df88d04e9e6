"""A hundred thousand points against a torus: how many are inside estimates its volume."""
import numpy as np
import strata_csg as st

torus = st.torus(2, 1, 48, 24)
points = np.random.default_rng(1).uniform((-3, -3, -1), (3, 3, 1), (100_000, 3))
inside = np.count_nonzero(st.Locator([torus]).membership(points) == 1)
estimate = inside / len(points) * 6 * 6 * 2
print("estimated", estimate, "exact", float(torus.volume))
assert abs(estimate - float(torus.volume)) < 0.5
