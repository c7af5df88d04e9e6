"""Volumes that add up: inclusion and exclusion, and thousands of operations

The volume of a solid with vertices that are doubles is a rational number, and so it is for every Boolean of such
solids. Strata computes it as a `Fraction`. Laws of volumes hold exactly then, not up to a tolerance, and a program
can test whether two ways to make a part make the same part.
"""

# %% Inclusion and exclusion
# |a u b u c| = |a| + |b| + |c| - |a n b| - |a n c| - |b n c| + |a n b n c|, for a sphere, a torus and a box that is
# turned by 20 degrees, exactly: it stays congruent, with coordinates that are fractions.

from __future__ import annotations

from fractions import Fraction
from itertools import combinations
from time import perf_counter

import strata_csg as st

solids = [
    st.sphere(1, 32),
    st.torus(1, 0.25, 32, 16),
    st.box((-1, -1, -0.25), (1, 1, 0.25)).rotated((1, 1, 1), 20, exact=True),
]
total = Fraction(0)
for size in (1, 2, 3):
    for chosen in combinations(solids, size):
        total -= (-1) ** size * st.intersection(chosen).volume
union = st.union(solids)
bits = union.volume.denominator.bit_length()
print(f"volume of the union {float(union.volume):.15f}, a fraction with a denominator of {bits:,} bits")
assert union.volume == total
assert solids[2].volume == 2

# %% Two thousand steps
# A plate in which a tool mills pockets of thirds and sevenths, one after the other. Every step is a solid;
# coordinates do not grow, since a `Workpiece` knows the planes that they come from.

tool = st.box((0, 0, 0), (2, 2, 3)).scaled((Fraction(1, 3), Fraction(2, 7), 1))
begin = perf_counter()
work = st.Workpiece(st.box((0, 0, 0), (50, 40, 2)))
for i in range(50):
    for j in range(40):
        work = work.cut(tool.translated((i + Fraction(1, 6), j + Fraction(3, 14), 1)))
plate = work.solid
print(f"{50 * 40} pockets in {perf_counter() - begin:.1f} s: {plate}, volume {plate.volume}")
assert plate.volume == 50 * 40 * 2 - 50 * 40 * Fraction(2, 3) * Fraction(4, 7)

# %% The same in one arrangement
# An `Expression` computes nothing before it is evaluated, and then all at once. Both ways give the same set of
# points.

pockets = [
    st.Expression(tool.translated((i + Fraction(1, 6), j + Fraction(3, 14), 1))) for i in range(50) for j in range(40)
]
begin = perf_counter()
at_once = (st.Expression(st.box((0, 0, 0), (50, 40, 2))) - st.Expression.any(pockets)).evaluate()
print(f"at once: {perf_counter() - begin:.1f} s")
assert at_once == plate
assert at_once.canonical_text() == plate.canonical_text()

# %% Four hundred spheres that overlap
# Every chain of operations obeys the laws of sets. Here: what is in an odd number of spheres, and what is in an even
# number but in one at least, make up the union.

spheres = [
    st.Expression(st.sphere(1, 8).translated((Fraction(9 * i, 7), Fraction(3 * j, 2), 0)))
    for i in range(20)
    for j in range(20)
]
begin = perf_counter()
union_of_all = st.Expression.any(spheres)
odd = st.Expression.odd(spheres)
everything, alternating, rest = (e.evaluate() for e in (union_of_all, odd, union_of_all - odd))
print(f"three times {len(spheres)} spheres: {perf_counter() - begin:.1f} s, {everything}")
assert alternating.volume + rest.volume == everything.volume
