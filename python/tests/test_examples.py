"""Every example runs, as a script and as a notebook, and the notebooks are those of the scripts."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
import strata_csg as st

FOLDER = Path(__file__).resolve().parents[1] / "examples"
_specification = importlib.util.spec_from_file_location("make_notebooks", FOLDER / "make_notebooks.py")
make_notebooks = importlib.util.module_from_spec(_specification)
_specification.loader.exec_module(make_notebooks)

SCRIPTS = make_notebooks.scripts()
NAMES = [script.stem for script in SCRIPTS]


@pytest.fixture
def environment() -> dict[str, str]:
    """That of a process that finds this package."""
    package = str(Path(st.__file__).parents[1])
    paths = [package, *filter(None, [os.environ.get("PYTHONPATH")])]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(paths)}


@pytest.mark.parametrize("name", ["first_solid", "contacts", "probe", "attributes"])
def test_small_example(name, environment, tmp_path):
    """Those of examples/python, which the site shows."""
    script = FOLDER.parents[1] / "examples/python" / f"{name}.py"
    subprocess.run([sys.executable, "-W", "error", str(script)], cwd=tmp_path, env=environment, check=True, timeout=120)


def test_there_are_examples():
    assert len(SCRIPTS) >= 5


@pytest.mark.parametrize("script", SCRIPTS, ids=NAMES)
def test_script(script, environment, tmp_path):
    result = subprocess.run(
        [sys.executable, "-W", "error", str(script)],
        cwd=tmp_path,
        env={**environment, "TMPDIR": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert result.returncode == 0, result.stdout + result.stderr
    if "SKIPPED" in result.stdout:
        pytest.skip(next(line for line in result.stdout.splitlines() if "SKIPPED" in line))


@pytest.mark.parametrize("script", SCRIPTS, ids=NAMES)
def test_notebook_is_up_to_date(script):
    text = script.with_suffix(".ipynb").read_text(encoding="utf-8")
    assert text == make_notebooks.notebook_of(script), "run python/examples/make_notebooks.py"
    assert all(cell.get("outputs", []) == [] for cell in json.loads(text)["cells"])


def test_no_notebook_without_a_script():
    assert {path.stem for path in FOLDER.glob("*.ipynb")} == set(NAMES)


@pytest.mark.parametrize("script", SCRIPTS, ids=NAMES)
def test_notebook_runs(script, environment, monkeypatch):
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    monkeypatch.setenv("PYTHONPATH", environment["PYTHONPATH"])
    notebook = nbformat.read(script.with_suffix(".ipynb"), as_version=4)
    nbformat.validate(notebook)
    resources = {"metadata": {"path": str(FOLDER)}}
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3", resources=resources).execute()
