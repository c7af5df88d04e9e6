"""Which results are right: closed, and with the volume that is known or that independent engines agree on."""

TOLERANCE = 1e-6  # of the volume: doubles and floats round, and so do engines that are not exact


def agree(a: float, b: float) -> bool:
    return abs(a - b) <= TOLERANCE * max(abs(a), abs(b))


def solid(m: dict) -> bool:
    return m["status"] == "done" and m["judged"]["well_formed"] and m["judged"]["closed"]


def consensus(measurements: list[dict]) -> tuple[float | None, list[str]]:
    """The volume on which most families of engines agree, and who they are. None unless two families do, and more
    than on any other volume."""
    camps = []
    for m in filter(solid, measurements):
        volume = m["judged"]["volume"]
        camp = next((c for c in camps if agree(c["volume"], volume)), None)
        if camp is None:
            camp = {"volume": volume, "families": set()}
            camps.append(camp)
        camp["families"].add(m["family"])
    camps.sort(key=lambda c: len(c["families"]), reverse=True)
    if not camps or len(camps[0]["families"]) < 2:
        return None, []
    if len(camps) > 1 and len(camps[1]["families"]) == len(camps[0]["families"]):
        return None, []
    return camps[0]["volume"], sorted(camps[0]["families"])


def fault(m: dict, volume: float | None) -> str | None:
    """What is wrong with a result; None if nothing is known to be."""
    judged = m["judged"]
    if not judged["well_formed"]:
        return "indices out of range or coordinates not finite"
    if not judged["closed"]:
        return "not closed"
    if volume == 0 and judged["triangles"] > 0:
        return f"{judged['triangles']:,} triangles, should be empty"
    if volume is not None and not agree(judged["volume"], volume):
        return f"volume {judged['volume']:.9g} instead of {volume:.9g}"
    return None


def settle(case: dict) -> None:
    """Turns the status `done` of a case's measurements into `right`, `wrong` or `unconfirmed`, and says by what."""
    measurements = case["measurements"]
    known = case["volume"]
    if known is not None:
        case["right_volume"], case["right_by"] = known, "construction"
    else:
        case["right_volume"], families = consensus(measurements)
        case["right_by"] = ", ".join(families) or None
    for m in measurements:
        if m["status"] != "done":
            continue
        why = fault(m, case["right_volume"])
        if why is not None:
            m["status"], m["why"] = "wrong", why
        else:
            m["status"] = "unconfirmed" if case["right_by"] is None else "right"
