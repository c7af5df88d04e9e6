"""The union of a thousand pairs of meshes, by dask.bag on a local cluster of two workers.

    pip install strata-csg "dask[distributed]"
    python batch_dask.py

A job and its result are plain arrays, which dask moves between machines as well. Jobs that raise are results here, as
records of `strata_csg.batch` are; a worker that crashes is started again by dask, and its jobs are repeated.
"""

from __future__ import annotations

import numpy
import strata_csg
from dask import bag
from distributed import Client, LocalCluster

Arrays = tuple[numpy.ndarray, numpy.ndarray]


def job_of(number: int) -> list[Arrays]:
    """Two boxes, as arrays of vertices and triangles. A real job reads them, from files or from a database."""
    a = strata_csg.box((0, 0, 0), (1, 1, 1))
    b = strata_csg.box((0.5, 0.5, number / 1000), (1.5, 1.5, 2))
    return [(solid.vertices, solid.triangles) for solid in (a, b)]


def union(job: list[Arrays]) -> Arrays | str:
    """The function that all pools of processes are given. One thread: the cluster has a worker for each core."""
    try:
        mesh = strata_csg.boolean("union", job, threads=1)
    except (strata_csg.InputError, MemoryError) as error:
        return f"{type(error).__name__}: {error}"
    return numpy.asarray(mesh.vertices), numpy.asarray(mesh.triangles)


def main(count: int = 1000) -> list[Arrays | str]:
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster):
        jobs = bag.from_sequence(range(count), npartitions=20).map(job_of)
        results: list[Arrays | str] = jobs.map(union).compute()
    done = [result for result in results if not isinstance(result, str)]
    print(f"{len(done)} of {count} unions, {sum(len(triangles) for _, triangles in done)} triangles")
    return results


if __name__ == "__main__":
    main()
