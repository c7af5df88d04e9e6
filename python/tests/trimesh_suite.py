"""Runs trimesh's own tests of Booleans, those of the installed version, on the engine that ``register`` adds.

    python trimesh_suite.py [--checkout FOLDER]

Without a checkout, tests/test_boolean.py is taken from the source distribution, which pip fetches into a temporary
folder. It comes without trimesh's meshes and helpers: two cubes with known volumes stand in for the two balls. Exit
codes: 0 passed, 1 failed, 77 skipped, because the source cannot be fetched.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tarfile
import tempfile
from importlib.metadata import version
from pathlib import Path
from xml.etree import ElementTree

SKIPPED = 77

#: The only test that names its engine, and it names another.
OF_ANOTHER_ENGINE = "test_boolean_manifold"

#: What test_boolean.py uses of trimesh's tests/generic.py, which is not in the source distribution.
GENERIC = """
import logging, time
import numpy as np
import pytest
import trimesh

trimesh.util._STRICT = True
trimesh.constants.tol.strict = True
all_dependencies = False
log = logging.getLogger("trimesh")
data = {"boolean": {"difference": 7.0, "intersection": 1.0, "union": 15.0}}


def get_mesh(name):
    lower = {"ballA.off": 0, "ballB.off": 1}[name]
    return trimesh.creation.box(bounds=[[lower] * 3, [lower + 2] * 3])
"""


def pytest_configure() -> None:
    """As a plug-in of pytest: Strata is the default engine and the only one under test."""
    import trimesh

    from strata_csg.trimesh import register

    register(default=True)
    trimesh.boolean.engines_available = {"strata"}


def fetch(folder: Path) -> Path | None:
    """The unpacked source distribution of the installed version, with helpers; None if there is none to be had."""
    requirement = f"trimesh=={version('trimesh')}"
    command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--no-binary", ":all:", requirement]
    fetched = subprocess.run([*command, "--dest", str(folder)], capture_output=True, text=True)
    if fetched.returncode != 0:
        print(f"skipped: pip cannot fetch the source of {requirement}\n{fetched.stderr.strip()}")
        return None
    archive = next(folder.glob("trimesh-*.tar.gz"))
    with tarfile.open(archive) as packed:
        packed.extractall(folder, filter="data")
    source = folder / archive.name.removesuffix(".tar.gz")
    (source / "tests" / "generic.py").write_text(GENERIC)
    return source


def run(source: Path, folder: Path) -> ElementTree.Element:
    """Runs the tests of a source folder; the testsuite element of the report in JUnit's format."""
    report = folder / "report.xml"
    paths = [str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths)), "PYTHONDONTWRITEBYTECODE": "1"}
    options = ["-p", "trimesh_suite", "-p", "no:cacheprovider", "--quiet", f"--junitxml={report}"]
    options += [f"-k=not {OF_ANOTHER_ENGINE}", f"--rootdir={source}"]
    command = [sys.executable, "-m", "pytest", *options, str(source / "tests" / "test_boolean.py")]
    subprocess.run(command, cwd=folder, env=environment, check=False)
    suite = ElementTree.parse(report).getroot().find("testsuite") if report.exists() else None
    if suite is None:
        raise SystemExit("pytest ended without a report")
    return suite


def main() -> int:
    parser = argparse.ArgumentParser(description="Runs trimesh's tests of Booleans on Strata.")
    parser.add_argument("--checkout", type=Path, help="a checkout of trimesh's repository, with its meshes")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        source = arguments.checkout.resolve() if arguments.checkout else fetch(folder)
        if source is None:
            return SKIPPED
        counts = {key: int(value) for key, value in run(source, folder).items() if value.isdigit()}
    failed = counts["failures"] + counts["errors"]
    passed = counts["tests"] - failed - counts["skipped"]
    print(
        f"trimesh {version('trimesh')}, tests/test_boolean.py, engine strata, "
        f"{'meshes of trimesh' if arguments.checkout else 'cubes in place of meshes'}: "
        f"{passed} passed, {failed} failed, {counts['skipped']} skipped; without {OF_ANOTHER_ENGINE}"
    )
    return 0 if failed == 0 and passed > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
