"""Numbers of one case that compare engines. Of several runs they are the medians of what each run gives: engines are
compared within a run, close together in time."""

import math
import statistics
from collections.abc import Callable


def in_runs(case: dict) -> list[dict]:
    """The case as each run measured it."""
    return case.get("runs", [case])


def over_runs(case: dict, value: Callable[[dict], float | None]) -> list[float]:
    """What the runs give, those that give nothing left out."""
    return [v for v in map(value, in_runs(case)) if v is not None]


def middle(values: list[float]) -> float | None:
    return statistics.median(values) if values else None


def of(case: dict, engine: str, threads: int) -> dict | None:
    """The measurement of an engine; that of a sequential one holds for any number of threads."""
    for m in case["measurements"]:
        if m["engine"] == engine and (m["threads"] == threads or m["sequential"]):
            return m
    return None


def counts(m: dict | None) -> bool:
    return m is not None and m["status"] in ("right", "unconfirmed")


def our_time(case: dict, threads: int) -> float | None:
    m = of(case, "strata", threads)
    return m["median"] if counts(m) else None


def peers(case: dict, threads: int) -> list[dict]:
    others = [m for m in case["measurements"] if m["engine"] != "strata"]
    return [m for m in others if m["threads"] == threads or m["sequential"]]


def best_peer(case: dict, threads: int) -> dict | None:
    """The fastest peer that gets it right."""
    return min(filter(counts, peers(case, threads)), key=lambda m: m["median"], default=None)


def time_to_beat(case: dict, threads: int) -> tuple[float | None, bool]:
    """Seconds of the fastest right peer, and whether that is only a lower bound: none was right, some were stopped."""
    best = best_peer(case, threads)
    if best:
        return best["median"], False
    stopped = [m["timeout"] for m in peers(case, threads) if m["status"] == "timeout"]
    return (max(stopped), True) if stopped else (None, False)


def ratios(case: dict, threads: int) -> list[float]:
    """The ratio of each run."""
    return over_runs(case, lambda one: ratio_of_run(one, threads))


def ratio(case: dict, threads: int) -> float | None:
    """Time of the fastest right peer / ours: above 1, Strata is faster. Infinite when all peers get it wrong."""
    return middle(ratios(case, threads))


def ratio_of_run(case: dict, threads: int) -> float | None:
    ours, beaten = our_time(case, threads), time_to_beat(case, threads)[0]
    if ours is None or all(m["status"] == "not tried" for m in peers(case, threads)):
        return None
    return beaten / ours if beaten else math.inf


def ratio_to(engine: str) -> Callable[[dict, int], float | None]:
    """Time of this engine / ours; a lower bound if it was stopped."""

    def of_run(case: dict, threads: int) -> float | None:
        ours, theirs = our_time(case, threads), of(case, engine, threads)
        if ours is None or theirs is None:
            return None
        if theirs["status"] == "timeout":
            return theirs["timeout"] / ours
        return theirs["median"] / ours if counts(theirs) else None

    return lambda case, threads: middle(over_runs(case, lambda one: of_run(one, threads)))


def floor_ratio(case: dict, threads: int) -> float | None:
    """Our time / copy floor."""

    def of_run(one: dict) -> float | None:
        ours = our_time(one, threads)
        return ours / of(one, "strata", threads)["copy_floor"] if ours else None

    return middle(over_runs(case, of_run))


def speedup(case: dict, threads: int) -> float | None:
    """Our time on one thread / on several."""

    def of_run(one: dict) -> float | None:
        alone, together = our_time(one, 1), our_time(one, threads)
        return alone / together if alone and together else None

    return middle(over_runs(case, of_run))


def bytes_per_triangle(case: dict, threads: int) -> float | None:
    """Our memory beside input and output, per input triangle."""
    m = of(case, "strata", threads)
    if not counts(m):
        return None
    return max(0, m["memory_above_input"] - m["output_bytes"]) / case["triangles"]


def growth(small: dict, large: dict, threads: int) -> float | None:
    """The exponent e in time ~ triangles^e."""
    a, b = our_time(small, threads), our_time(large, threads)
    if not a or not b:
        return None
    return math.log(b / a) / math.log(large["triangles"] / small["triangles"])
