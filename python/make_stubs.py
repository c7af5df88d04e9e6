#!/usr/bin/env python3
"""Writes strata_csg/_native.pyi, the types of the extension module, from the module that is found.

Usage: PYTHONPATH=build/python python3 python/make_stubs.py [OUTPUT]
"""

import pathlib
import runpy
import sys

here = pathlib.Path(__file__).resolve().parent
output = sys.argv[1] if len(sys.argv) > 1 else str(here / "strata_csg" / "_native.pyi")
# Not the source tree, which has no extension module.
sys.path = [path for path in sys.path if pathlib.Path(path or ".").resolve() != here]
sys.argv = ["stubgen", "--quiet", "--include-private", "-m", "strata_csg._native", "-p", str(here / "stubs.nanobind"), "-o", output]
runpy.run_module("nanobind.stubgen", run_name="__main__")
