"""The command line ``strata``: the extension module contains it, too, so that a wheel has the library once."""

from __future__ import annotations

import sys

from strata_csg import _native


def main() -> int:
    """Run ``strata`` with the arguments of this process; its exit code."""
    return _native._run_command_line(["strata", *sys.argv[1:]])
