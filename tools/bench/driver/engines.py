"""Who is measured, and how to call them."""

import dataclasses
import pathlib


@dataclasses.dataclass(frozen=True)
class Engine:
    name: str
    label: str  # in the table
    family: str  # engines of one family share their mistakes: together they have one vote
    command: tuple  # what comes before the case file
    sequential: bool = False  # one thread whatever it is given
    most_triangles: int = 10**9  # above it the engine is hopeless and not tried


def ours(build: pathlib.Path) -> Engine:
    return Engine("strata", "Strata", "strata", (str(build / "tools/bench/strata-bench"), "run"))


PYPI = (
    ("manifold", "Manifold", "manifold", "manifold3d"),
    ("trueform_f64", "trueform f64", "trueform", "trueform"),
    ("trueform_f32", "trueform f32", "trueform", "trueform"),
    ("meshlib", "MeshLib", "meshlib", "meshlib"),
)
CGAL = (
    ("corefine_epick", "CGAL corefine EPICK", 10**9),
    ("corefine_epeck", "CGAL corefine EPECK", 10**6),
    ("nef", "CGAL Nef", 50_000),
)
PEER_NAMES = tuple(name for name, *_ in PYPI + CGAL)


def find_peers(build: pathlib.Path, python: pathlib.Path, runs) -> tuple[list[Engine], dict[str, str]]:
    """The peers this machine has, and why the others are missing. `runs(command)` tells whether a command succeeds."""
    found, missing = [], {}
    script = pathlib.Path(__file__).parent.parent / "peers/peer.py"
    for name, label, family, package in PYPI:
        if not python.exists():
            missing[name] = "no Python environment was made"
        elif not runs([python, "-c", f"import numpy, {package}"]):
            missing[name] = f"{package} is not in the Python environment"
        else:
            found.append(Engine(name, label, family, (str(python), str(script), name)))
    program = build / "tests/oracle/cgal_bench"
    for name, label, most in CGAL:
        if not program.exists():
            missing[name] = "cgal_bench was not built (is CGAL there?)"
        else:
            found.append(Engine(name, label, "cgal", (str(program), name), sequential=True, most_triangles=most))
    return found, missing
