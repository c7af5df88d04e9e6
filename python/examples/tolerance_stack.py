"""An assembly checked for gaps of a micrometre: press fits, contacts and interference

A shaft with washers runs in a housing. The parts are modelled at their real sizes within their tolerances, so a press
fit is an interference of some micrometres and a running fit a gap of as many. Programs with a tolerance of their own
take both for contact. Here every relation is decided exactly.

The unit is the micrometre: sizes are integers, so the models are the drawing.
"""

# %% The parts
# The bore and the shaft are prisms of 48 sides. Their corners are rounded to doubles once, when they are made; from
# then on they are exact. Both have the same directions, so that gap and interference are the same all around.

from __future__ import annotations

from fractions import Fraction
from itertools import combinations

import strata_csg as st

SIDES = 48
MILLIMETRE = 1000


def ring(inner: float, outer: float, thickness: float) -> st.Solid:
    """A washer from z = 0."""
    hole = st.cylinder(inner, 3 * thickness, SIDES).translated((0, 0, -thickness))
    return st.cylinder(outer, thickness, SIDES) - hole


BORE = 10 * MILLIMETRE
THICKNESSES = [2003, 1998, 2001]
CAVITY = 6004

housing = (
    st.box((-20_000, -20_000, -5_000), (20_000, 20_000, CAVITY + 5_000))
    - st.cylinder(BORE, 30_000, SIDES).translated((0, 0, -10_000))
    - st.cylinder(16_000, CAVITY, SIDES)
)
shaft = st.cylinder(BORE + 12, 30_000, SIDES).translated((0, 0, -10_000))
parts = {"housing": housing, "shaft": shaft}
height = 0
for number, thickness in enumerate(THICKNESSES, 1):
    parts[f"washer {number}"] = ring(BORE + 13, 15_000, thickness).translated((0, 0, height))
    height += thickness

# %% All relations
# `contacts` lists the pairs that touch or interfere, and `distance` tells how far the others are apart: the square of
# the distance is a fraction.

names, solids = list(parts), list(parts.values())
near = {(pair["a"], pair["b"]): pair for pair in st.contacts(solids)}
relations: dict[tuple[str, str], tuple[str, Fraction]] = {}
for a, b in combinations(range(len(solids)), 2):
    pair = near.get((a, b))
    if pair is None:
        squared = st.distance(solids[a], solids[b])["squared"]
        relations[names[a], names[b]] = "apart", squared
    elif pair["relation"] == "interfering":
        relations[names[a], names[b]] = "interfering", pair["overlap"].volume
    else:
        relations[names[a], names[b]] = "contact", Fraction(pair["area"])

print(f"{'pair':<22} {'relation':<12} {'how much':>24}")
for (first, second), (relation, value) in relations.items():
    if relation == "apart":
        text = f"gap {float(value) ** 0.5:.3f} um"
    elif relation == "interfering":
        text = f"volume {float(value) / 1e9:.6f} mm3"
    else:
        text = f"area {float(value) / 1e6:.3f} mm2"
    print(f"{first + ' - ' + second:<22} {relation:<12} {text:>24}")

# %% What it shows
# The shaft is pressed into the housing, and the interference is that of two prisms and a wall: the ring between the
# bore and the shaft, as long as the bore. Washers touch each other and the floor of the cavity. Between the last one
# and the ceiling is a gap of 2 micrometres, and between shaft and washers one of 1 micrometre, measured across the
# flats.

assert relations["housing", "shaft"][0] == "interfering"
ring_area = st.cylinder(BORE + 12, 1, SIDES).volume - st.cylinder(BORE, 1, SIDES).volume
assert relations["housing", "shaft"][1] == ring_area * 10_000
assert relations["housing", "washer 1"][0] == "contact"
assert relations["washer 1", "washer 2"][0] == "contact"
assert relations["housing", "washer 3"] == ("apart", Fraction((CAVITY - sum(THICKNESSES)) ** 2))
assert relations["washer 1", "washer 3"] == ("apart", Fraction(THICKNESSES[1] ** 2))
gap = float(relations["shaft", "washer 2"][1]) ** 0.5
assert relations["shaft", "washer 2"][0] == "apart" and 0.99 < gap < 1

# %% The stack at its limits
# Each washer may be 3 micrometres thicker or thinner. In the worst case the stack is higher than the cavity.

for name, deviation in (("least", -3), ("nominal", 0), ("greatest", 3)):
    top = sum(THICKNESSES) + 3 * deviation
    stack = ring(BORE + 13, 15_000, top)
    found = st.contacts([housing, stack])
    overlap = next((pair["overlap"].volume for pair in found if pair["relation"] == "interfering"), Fraction(0))
    print(f"{name:>9}: the stack is {top} um of {CAVITY} um, interference {float(overlap) / 1e9:.6f} mm3")
    assert (overlap > 0) == (top > CAVITY)
