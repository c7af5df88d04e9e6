"""The union of a thousand pairs of meshes, by Ray on a local cluster of two workers.

    pip install strata-csg ray
    python batch_ray.py

Jobs are sent by the fifties: a task of Ray costs more than a small union. What is in flight is bounded, so that there
may be more jobs than fit into memory.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy
import ray
import strata_csg

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


@ray.remote(num_cpus=1, max_retries=1)
def unions(numbers: list[int]) -> list[Arrays | str]:
    return [union(job_of(number)) for number in numbers]


def in_order(chunks: Iterable[list[int]], most_in_flight: int = 8) -> Iterator[Arrays | str]:
    """Results in the order of the jobs."""
    waiting = []
    for chunk in chunks:
        waiting.append(unions.remote(chunk))
        if len(waiting) == most_in_flight:
            yield from ray.get(waiting.pop(0))
    for task in waiting:
        yield from ray.get(task)


def main(count: int = 1000, size: int = 50) -> list[Arrays | str]:
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        chunks = (list(range(first, min(first + size, count))) for first in range(0, count, size))
        results = list(in_order(chunks))
    finally:
        ray.shutdown()
    done = [result for result in results if not isinstance(result, str)]
    print(f"{len(done)} of {count} unions, {sum(len(triangles) for _, triangles in done)} triangles")
    return results


if __name__ == "__main__":
    main()
