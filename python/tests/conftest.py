"""Small meshes, and what the tests share."""

from __future__ import annotations

import signal

import numpy as np
import pytest
import strata_csg as st

#: Jobs in the background ignore Ctrl-C, and what they start does, too.
signal.signal(signal.SIGINT, signal.default_int_handler)

#: A tetrahedron with corners on the axes.
CORNER_VERTICES = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]
CORNER_TRIANGLES = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]


@pytest.fixture
def corner() -> tuple[np.ndarray, np.ndarray]:
    return np.array(CORNER_VERTICES, dtype=np.float64), np.array(CORNER_TRIANGLES, dtype=np.uint32)


@pytest.fixture(scope="session")
def slow_solids() -> list[st.Solid]:
    """Solids whose union takes some seconds."""
    base = st.torus(3, 1, 300, 200)
    return [base.rotated((1, 2, 3), 7.0 * i) for i in range(30)]
