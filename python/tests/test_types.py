"""The stubs are those of the extension module, and type checkers find nothing."""

from __future__ import annotations

import os
import pathlib
import subprocess
import sys

import pytest
import strata_csg as st

SOURCE = pathlib.Path(__file__).resolve().parent.parent
PACKAGE = pathlib.Path(st.__file__).resolve().parent
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(pathlib.Path(st.__file__).parent.parent)}


def run(*command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True, cwd="/", check=False)


def test_stubs_are_up_to_date(tmp_path):
    pytest.importorskip("nanobind")
    output = tmp_path / "_native.pyi"
    made = run(sys.executable, str(SOURCE / "make_stubs.py"), str(output))
    assert made.returncode == 0, made.stderr
    assert output.read_text() == (SOURCE / "strata_csg" / "_native.pyi").read_text(), "run python/make_stubs.py"


def test_mypy(tmp_path):
    pytest.importorskip("mypy")
    checked = run(sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path), "-p", "strata_csg")
    assert checked.returncode == 0, checked.stdout


def test_a_program_that_uses_it_wrongly_is_found(tmp_path):
    pytest.importorskip("mypy")
    program = tmp_path / "program.py"
    program.write_text("import strata_csg as st\nst.box((0, 0, 0), (1, 1, 1)).volume.nothing\nst.boolean('unite', [])\n")
    checked = run(sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), str(program))
    assert checked.returncode == 1 and checked.stdout.count("error:") == 2, checked.stdout


def test_versions_agree():
    project = (SOURCE.parent / "pyproject.toml").read_text()
    assert f'\nversion = "{st.__version__}"\n' in project
