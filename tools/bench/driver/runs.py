"""Several runs of the benchmark as one: every time is the median of the medians of the runs."""

import statistics

import comparison

ALIKE = ("commit", "processor", "cpus", "system", "compiler", "flags")  # of the machine's facts


def difference(runs: list[dict]) -> str | None:
    """Why these runs are not of the same thing; None if they are."""
    first = runs[0]
    for other in runs[1:]:
        for what in ALIKE:
            one, two = first["machine"][what], other["machine"][what]
            if one != two:
                return f"{what}: {one} and {two}"
        if first["settings"] != other["settings"]:
            return f"settings: {first['settings']} and {other['settings']}"
        if names(first) != names(other):
            return "they have not the same cases"
    return None


def names(run: dict) -> list[str]:
    return [case["name"] for case in run["cases"]]


def merged(runs: list[dict]) -> dict:
    """One set of results. Its cases keep those of the runs under `runs`."""
    if len(runs) == 1:
        return runs[0]
    whole = dict(runs[0])
    whole["runs"] = [run["machine"] for run in runs]
    for what in ("peers", "versions"):
        whole[what] = {name: value for run in reversed(runs) for name, value in run[what].items()}
    here = {name: sum(name in run["peers"] for run in runs) for name in whole["peers"]}
    whole["partial_peers"] = {whole["peers"][name]: n for name, n in here.items() if n < len(runs)}
    whole["missing_peers"] = {n: why for n, why in runs[0]["missing_peers"].items() if n not in whole["peers"]}
    whole["cases"] = [merged_case(list(one)) for one in zip(*(run["cases"] for run in runs))]
    return whole


def merged_case(cases: list[dict]) -> dict:
    found = {}
    for case in cases:
        for m in case["measurements"]:
            found.setdefault((m["engine"], m["threads"]), []).append(m)
    whole = dict(cases[0])
    whole["runs"] = cases
    whole["measurements"] = [merged_measurement(same) for same in found.values()]
    whole["right_by"] = next((case["right_by"] for case in cases if case["right_by"] is not None), None)
    return whole


def merged_measurement(found: list[dict]) -> dict:
    """Of one engine with one number of threads. What goes wrong once is wrong; what is stopped in half of the runs has
    no time."""
    for m in found:
        if m["status"] in ("wrong", "failed"):
            return m
    timed = [m for m in found if comparison.counts(m)]
    if 2 * len(timed) <= len(found):
        return next(m for m in found if not comparison.counts(m))
    whole = dict(timed[0])
    whole["warm_up_only"] = any(m["warm_up_only"] for m in timed)
    for what in ("median", "memory_above_input", "copy_floor"):
        if what in whole:
            whole[what] = statistics.median(m[what] for m in timed)
    return whole
