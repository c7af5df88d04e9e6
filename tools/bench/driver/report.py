"""The results as Markdown."""

import math

import comparison
import targets

STAGES = ("prepare", "find_candidates", "intersect", "subdivide", "label", "extract", "round")  # as the library says


def markdown(results: dict) -> str:
    parts = [
        "# Speed",
        heading(results),
        "## Targets",
        target_table(results),
    ]
    for threads in results["settings"]["threads"]:
        parts += [f"## Time, {count(threads, 'thread')}", time_table(results, threads)]
    parts += ["## Memory", memory_table(results), "## Where the time goes", stage_table(results)]
    parts += ["## What went wrong", faults(results), "## Skipped", skipped(results)]
    parts += ["## Cases", case_table(results)]
    return "\n\n".join(parts) + "\n"


def heading(results: dict) -> str:
    machine, settings = results["machine"], results["settings"]
    runs = results.get("runs", [machine])
    processor = f"{machine['processor']}, {machine['cpus']} CPUs, {machine['memory_gb']} GB"
    versions = ", ".join(f"{family} {version}" for family, version in sorted(results["versions"].items()))
    facts = [
        ["date", ", ".join(run["date"] for run in runs)],
        ["commit", machine["commit"]],
        ["machine", f"{processor}; load at start {', '.join(str(run['load_at_start']) for run in runs)}"],
        ["system", machine["system"]],
        ["compiler", f"{machine['compiler']}, `{machine['flags']}`"],
        ["peers", versions or "none"],
    ]
    return f"""Written by `tools/bench/run`; every repetition is in `results.json`.

{table(["", ""], facts)}

- **Times** are from vertex and index arrays to vertex and index arrays, with every structure built inside: medians of
  up to {settings["repetitions"]} repetitions after a warm-up, in processes of their own, pinned. Strata is measured
  before and after its peers. No repetition begins after {settings["budget"]:g} s; `*` marks what was then run once,
  not warmed up. Engines are stopped after {settings["timeout"]:g} s. Very short operations are timed in batches.
{of_several_runs(len(runs), results.get("partial_peers", {}))}- **Ratio** is the time of the fastest peer that gets it right over that of Strata: above 1, Strata is faster.
- **Floor** is the time of Strata over the time one thread takes to copy the vertex and index arrays of input and
  output into fresh memory.
- **Right** is a closed result whose volume is within 1e-6 of the one known by construction, else of the one on which
  most independent engines agree. What is wrong is struck out and does not count.
- CGAL works on one thread: its times stand for any number. trueform f32 gets the coordinates rounded to floats.
  Manifold, trueform and MeshLib are called through their Python bindings: what these take to convert arrays counts."""


def of_several_runs(runs: int, partial_peers: dict[str, int]) -> str:
    if runs == 1:
        return ""
    partly = "".join(f" {label} was in {count(n, 'run')} only." for label, n in partial_peers.items())
    return f"""- **Runs**: all was measured {runs} times. Times are medians of the runs' medians; ratios and floors are medians
  of those within each run, the lowest and the highest ratio in brackets.{partly}
"""


def target_table(results: dict) -> str:
    thread_counts = results["settings"]["threads"]
    rows = []
    for row in targets.table(results["cases"], thread_counts):
        cells = [held_cell(row["threads"].get(t), row["unit"]) for t in thread_counts]
        rows.append([row["what"], row["bound"], *cells])
    heads = [count(t, "thread") for t in thread_counts]
    return table(["target", "bound", *heads], rows) + "\n\nThe worst case of each, and how many of the cases meet it."


def held_cell(held: dict | None, unit: str) -> str:
    if held is None:
        return ""
    value, name = held["worst"]
    if held["wrong"]:
        return f"**missed**, no right result of {', '.join(held['wrong'])}"
    if value is None:
        return "not measured"
    verdict = "met" if held["met"] == held["of"] else "**missed**"
    return f"{verdict}, {digits(value)}{unit} ({name}), {held['met']} of {held['of']}"


def time_table(results: dict, threads: int) -> str:
    peers = results["peers"]
    rows = []
    for case in results["cases"]:
        ours = comparison.of(case, "strata", threads)
        best = comparison.best_peer(case, threads)
        rows.append(
            [
                case["name"],
                f"{case['triangles']:,}",
                f"{ours['triangles']:,}" if ours and "triangles" in ours else "",
                time_cell(ours, False),
                maybe(comparison.floor_ratio(case, threads)),
                ratio_cell(case, threads),
                *[time_cell(comparison.of(case, p, threads), best is not None and best["engine"] == p) for p in peers],
            ]
        )
    heads = ["case", "triangles in", "out", "Strata, ms", "floor", "ratio"]
    return table(heads + [peers[p] for p in peers], rows, numbers_from=1) + "\n\nTimes in milliseconds."


def ratio_cell(case: dict, threads: int) -> str:
    ratio, (_, bound) = comparison.ratio(case, threads), comparison.time_to_beat(case, threads)
    if ratio is None:
        return "-"
    text = f"**{'> ' if bound else ''}{digits(ratio)}**"
    of_runs = comparison.ratios(case, threads)
    return text if len(of_runs) == 1 else f"{text} ({digits(min(of_runs))} to {digits(max(of_runs))})"


def time_cell(m: dict | None, best: bool) -> str:
    if m is None:
        return "-"
    match m["status"]:
        case "timeout":
            return f"> {m['timeout'] * 1000:,.0f}"
        case "failed":
            return "failed"
        case "not tried":
            return "too large"
    text = digits(1000 * m["median"]) + ("*" if m["warm_up_only"] else "")
    if m["status"] == "wrong":
        return f"~~{text}~~ wrong"
    if m["status"] == "unconfirmed":
        text += " ?"
    return f"**{text}**" if best else text


def case_table(results: dict) -> str:
    rows = []
    for case in results["cases"]:
        by = case["right_by"] or "-"
        rows.append([case["name"], case["operation"], case["about"], f"{case['operands']:,}", by])
    heads = ["case", "operation", "what", "operands", "volume known by"]
    return table(heads, rows)


def memory_table(results: dict) -> str:
    threads = results["settings"]["threads"][0]
    peers = results["peers"]
    rows = []
    for case in results["cases"]:
        engines = ["strata", *peers]
        rows.append(
            [
                case["name"],
                maybe(comparison.bytes_per_triangle(case, threads)),
                *[memory_cell(comparison.of(case, e, threads)) for e in engines],
            ]
        )
    heads = ["case", "Strata, bytes per triangle", "Strata", *peers.values()]
    return f"""{table(heads, rows, numbers_from=1)}

Peak of the first operation of a process above the loaded input, in MB, {count(threads, "thread")}. The first column is
beside input and output (with the source of every triangle), per input triangle."""


def memory_cell(m: dict | None) -> str:
    return digits(m["memory_above_input"] / 1e6) if m and "memory_above_input" in m else "-"


def stage_table(results: dict) -> str:
    one, several = results["settings"]["threads"][0], results["settings"]["threads"][-1]
    rows = []
    stages = [*STAGES, "other"]
    for case in results["cases"]:
        alone, together = stages_of(case, one), stages_of(case, several)
        if alone is None or together is None:
            continue
        whole = sum(together.values())
        rows.append([case["name"], *[stage_cell(alone.get(s), together.get(s), whole) for s in stages]])
    if not rows:
        return "Not measured."
    words = f"in brackets how many times as long it takes with {count(one, 'thread')}"
    return f"""{table(["case", *[s.replace("_", " ") for s in stages]], rows, numbers_from=1)}

Of Strata's last repetition with {count(several, "thread")}, the share of each stage; {words}."""


def stages_of(case: dict, threads: int) -> dict[str, float] | None:
    m = comparison.of(case, "strata", threads)
    if m is None or not m.get("stages"):
        return None
    found = {stage: m["stages"].get(stage, 0.0) for stage in STAGES}
    return found | {"other": sum(m["stages"].values()) - sum(found.values())}


def stage_cell(alone: float, together: float, whole: float) -> str:
    share = 100 * together / whole
    return f"{share:.0f} %" + (f" ({alone / together:.1f})" if share >= 5 else "")


def faults(results: dict) -> str:
    rows = []
    for case in results["cases"]:
        for m in case["measurements"]:
            if m["status"] in ("wrong", "failed"):
                who = "Strata" if m["engine"] == "strata" else results["peers"][m["engine"]]
                rows.append([case["name"], who, count(m["threads"], "thread"), m["status"], m["why"]])
        if case["right_by"] is None:
            rows.append([case["name"], "all", "", "unconfirmed", "no two independent engines agree on a volume (?)"])
    return table(["case", "engine", "", "what", "why"], rows) if rows else "Nothing."


def skipped(results: dict) -> str:
    lines = [f"- {name}: {why}" for name, why in sorted(results["missing_peers"].items())]
    lines += [f"- case {name}: {why}" for name, why in results["skipped_cases"].items()]
    return "\n".join(lines) or "Nothing."


def table(heads: list[str], rows: list[list[str]], numbers_from: int | None = None) -> str:
    rule = ["---:" if numbers_from is not None and i >= numbers_from else "---" for i in range(len(heads))]
    lines = [heads, rule, *[[str(cell).replace("|", "/") for cell in row] for row in rows]]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def count(number: int, thing: str) -> str:
    return f"{number} {thing}" + ("" if number == 1 else "s")


def maybe(number: float | None) -> str:
    return "-" if number is None else digits(number)


def digits(number: float) -> str:
    """Three of them, or all before the point."""
    if math.isinf(number):
        return "no peer is right: inf"
    if abs(number) >= 100:
        return f"{number:,.0f}"
    return f"{number:.3g}"
