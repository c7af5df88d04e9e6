"""What Strata is to reach, held against what was measured."""

import dataclasses
from collections.abc import Callable

import comparison


@dataclasses.dataclass(frozen=True)
class Target:
    what: str
    bound: float
    at_least: bool  # else at most
    unit: str
    concerns: Callable[[dict], bool]
    value: Callable[[dict, int], float | None]
    only_threads: int | None = None

    def met(self, value: float) -> bool:
        return value >= self.bound if self.at_least else value <= self.bound

    def words(self) -> str:
        return f"{'at least' if self.at_least else 'at most'} {self.bound:g}{self.unit}"


def in_group(*groups):
    return lambda case: case["group"] in groups


def named(*names):
    return lambda case: case["name"] in names


def large_pair(case):
    return case["group"] in ("pair", "largest") and case["triangles"] >= 600_000


def microseconds(case, threads):
    seconds = comparison.our_time(case, threads)
    return 1e6 * seconds if seconds else None


def all_targets(cases: list[dict]) -> list[Target]:
    small = next((c for c in cases if c["name"] == "a20k"), None)

    def growth(case, threads):
        return comparison.growth(small, case, threads) if small else None

    ratio, floor = comparison.ratio, comparison.floor_ratio
    to_manifold = comparison.ratio_to("manifold")
    return [
        Target("largest pair of spheres: best peer / Strata", 4, True, "x", in_group("largest"), ratio),
        Target("largest pair of spheres: Strata / copy floor", 3, False, "x", in_group("largest"), floor),
        Target("every other pair from 20k triangles: best peer / Strata", 3, True, "x", in_group("pair"), ratio),
        Target("two icosahedra: time", 20, False, " us", in_group("tiny"), microseconds),
        Target("crossings or contact everywhere: best peer / Strata", 3, True, "x", in_group("dense"), ratio),
        Target("hundreds of operands in one call: best peer / Strata", 5, True, "x", in_group("many"), ratio),
        Target("small drill: Strata / copy floor", 2.5, False, "x", in_group("drill"), floor),
        Target("nine cuts in one call: Manifold / Strata", 13, True, "x", named("k_nine"), to_manifold),
        Target("terrain, 223 cuts in one call: Manifold / Strata", 10, True, "x", named("k_terrain223"), to_manifold),
        Target("dome, cut by cut: Manifold / Strata", 30, True, "x", named("k_dome100_steps"), to_manifold),
        Target(
            "largest pair of spheres: memory beside input and output, per input triangle",
            100, False, " bytes", in_group("largest"), comparison.bytes_per_triangle,
        ),
        Target("spheres from 20k to 1.3M triangles: exponent of growth", 1.05, False, "", named("a1310k"), growth),
        Target("pairs from 327k triangles: two threads over one", 1.8, True, "x", large_pair, comparison.speedup, 2),
    ]  # fmt: skip


def hold(target: Target, cases: list[dict], threads: int) -> dict:
    """The worst case of those concerned, how many meet the target, and where Strata has no right result."""
    concerned = [c for c in cases if target.concerns(c)]
    wrong = [c["name"] for c in concerned if comparison.our_time(c, threads) is None]
    found = [(target.value(c, threads), c["name"]) for c in concerned]
    found = [(value, name) for value, name in found if value is not None]
    worst = (min if target.at_least else max)(found, default=(None, None))
    return {"worst": worst, "met": sum(target.met(v) for v, _ in found), "of": len(concerned), "wrong": wrong}


def table(cases: list[dict], thread_counts: list[int]) -> list[dict]:
    rows = []
    for target in all_targets(cases):
        held = {}
        for threads in thread_counts:
            if target.only_threads in (None, threads):
                held[threads] = hold(target, cases, threads)
        rows.append({"what": target.what, "bound": target.words(), "unit": target.unit, "threads": held})
    return rows
