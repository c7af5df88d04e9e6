"""Many independent jobs, by a pool of processes with limits of time and memory."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import pickle
import signal
import time
from collections import deque
from collections.abc import Callable, Iterable
from multiprocessing.connection import Connection, wait
from multiprocessing.context import BaseContext
from typing import Any, TypeVar

from strata_csg._batch_records import Record, RecordFile, digest
from strata_csg._batch_worker import BROKEN, DONE, HEADER, INDEX, JOB, OUT_OF_MEMORY, READY, RECALL, STATUSES, work
from strata_csg._progress import bar

__all__ = ["Record", "batch"]

J = TypeVar("J")
R = TypeVar("R")


def batch(
    function: Callable[[J], R],
    jobs: Iterable[J],
    *,
    workers: int | None = None,
    timeout: float | None = None,
    memory: int | None = None,
    records: str | os.PathLike[str] | None = None,
    resume: bool = False,
    progress: Callable[[float], None] | bool | None = None,
) -> list[Record[R]]:
    """Calls a function with each of many jobs, in other processes. A job that crashes or hangs costs this one job.

    Parameters
    ----------
    function : callable
        Takes a job. It is pickled, so it is a function of a module, or an object of a class of a module. It should use
        one thread: there are as many processes as cores.
    jobs : iterable
        Objects that can be pickled.
    workers : int, optional
        Jobs at a time. As many as there are cores, if not given.
    timeout : float, optional
        Seconds by the clock after which a job is stopped. Its process is killed and replaced.
    memory : int, optional
        Bytes of address space that a job may take beside what its process has when it starts. What asks for more gets
        a ``MemoryError``; builds with GMP, which ends the process then, have the status "crashed" for large fractions.
        Every thread that a job starts takes some 70 MB.
    records : path, optional
        A file that gets a JSON line for each job, as soon as the job has ended. Results are pickled into a file beside
        it, with ``.results`` at the end of its name.
    resume : bool
        Jobs that have a record in this file are not run again: same index, same pickled job, same name of the function.
        Their records, with results, are read from the files, which must come from a source that you trust, as all
        pickles. A last line that was cut short is dropped.
    progress : callable, True or None
        Is called with the fraction of the jobs that have ended, from 0 to 1; True shows a bar.

    Returns
    -------
    list of Record
        In the order of the jobs.

    Raises
    ------
    RuntimeError
        If workers cannot start, such as when the function cannot be imported.
    ValueError
        If the file of records is none.

    Notes
    -----
    Processes are started with ``forkserver``, or ``spawn`` where there is none: scripts need
    ``if __name__ == "__main__":``. Ctrl-C stops all of them; with `records`, nothing is lost that was done. Processes
    that jobs start are killed with their worker. Jobs that were sent ahead to a worker that is killed are executed by
    another one; it may happen that such a job had begun.

    Examples
    --------
    >>> import math
    >>> from strata_csg._batch import batch
    >>> [(r.status, r.result) for r in batch(math.sqrt, [4.0, -1.0, 9.0], workers=2, timeout=60)]
    [('ok', 2.0), ('failed', None), ('ok', 3.0)]
    """
    call = pickle.dumps(function, protocol=5)
    pickled = [pickle.dumps(job, protocol=5) for job in jobs]
    if resume and records is None:
        raise ValueError("resume needs the file of the records")
    if workers is not None and workers < 1:
        raise ValueError("workers: expected a positive number, or None")
    if timeout is not None and not timeout > 0:
        raise ValueError("timeout: expected a positive number of seconds, or None")
    if memory is not None and memory <= 0:
        raise ValueError("memory: expected a positive number of bytes, or None")
    if not (progress is None or isinstance(progress, bool) or callable(progress)):
        raise TypeError("progress: expected None, True, or a callable that takes the fraction done")
    show = bar() if progress is True else progress or None
    with contextlib.ExitStack() as stack:
        file = None if records is None else stack.enter_context(RecordFile(records, resume))
        digests = [] if file is None else [digest(call, job) for job in pickled]
        done: dict[int, Record[Any]] = {} if file is None else file.kept(digests)

        def keep(record: Record[Any], result: bytes | None) -> None:
            if file is not None:
                file.add(record, digests[record.index], result)
            done[record.index] = record
            if show is not None:
                show(len(done) / len(pickled))

        left = [index for index in range(len(pickled)) if index not in done]
        count = min(workers or os.cpu_count() or 1, len(left))
        if count:
            pool = _Pool(call, pickled, left, timeout, memory, keep)
            stack.callback(pool.kill)
            pool.run(count)
    return [done[index] for index in range(len(pickled))]


def _signal_name(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:  # those of real time have no names
        return str(number)


class _Worker:
    """A process as its parent sees it."""

    def __init__(self, context: BaseContext, call: bytes, memory: int | None) -> None:
        jobs, self.jobs = context.Pipe(duplex=False)
        self.replies, replies = context.Pipe(duplex=False)
        arguments = (jobs, replies, call, memory)
        self.process = context.Process(target=work, args=arguments, daemon=False)  # type: ignore[attr-defined]
        self.process.start()
        jobs.close()
        replies.close()
        self.ready = False
        self.recalled = False
        self.leaving = False  #: it ends by itself, and executes no other job
        self.given: deque[int] = deque()  #: jobs that were sent; the first one is executed
        self.bytes = 0  #: of these
        self.since = 0.0  #: when that began, or a moment later

    def give(self, index: int, job: bytes) -> None:
        if not self.given:
            self.since = time.monotonic()
        self.given.append(index)
        self.bytes += len(job)
        with contextlib.suppress(OSError):  # it has ended, which its other pipe will tell
            self.jobs.send_bytes(JOB + INDEX.pack(index) + job)

    def recall(self) -> None:
        self.recalled = True
        with contextlib.suppress(OSError):
            self.jobs.send_bytes(RECALL)

    def kill(self) -> None:
        """Ends the process and all that it has started."""
        for kill in (os.killpg, os.kill):
            with contextlib.suppress(OSError):
                kill(self.process.pid, signal.SIGKILL)
        self.process.join()
        self.jobs.close()


class _Pool:
    """Processes that execute jobs. Small jobs are sent ahead, and called back where another process has none."""

    _tick = 0.05  #: seconds of work that are sent ahead
    _most_ahead = 64
    _most_bytes = 1 << 15  #: larger jobs are not sent ahead

    def __init__(
        self,
        call: bytes,
        jobs: list[bytes],
        left: list[int],
        timeout: float | None,
        memory: int | None,
        keep: Callable[[Record[Any], bytes | None], None],
    ) -> None:
        methods = multiprocessing.get_all_start_methods()
        self._context = multiprocessing.get_context("forkserver" if "forkserver" in methods else "spawn")
        self._call, self._jobs, self._timeout, self._memory, self._keep = call, jobs, timeout, memory, keep
        self._left = deque(left)  #: jobs that nobody has
        self._missing = len(left)  #: jobs without a record
        self._workers: list[_Worker] = []
        self._failed_starts = 0
        self._mean = 1.0  #: seconds of a job, of the last ones above all

    def run(self, count: int) -> None:
        for _ in range(count):
            self._start()
        while self._missing:
            by_pipe = {worker.replies: worker for worker in self._workers}
            for pipe in wait(list(by_pipe), self._time_to_wait()):
                assert isinstance(pipe, Connection)
                if not self._receive(by_pipe[pipe]):
                    self._bury(by_pipe[pipe], None)
            self._expire()
            self._share_out()

    def kill(self) -> None:
        for worker in self._workers:
            worker.kill()

    def _start(self) -> None:
        self._workers.append(_Worker(self._context, self._call, self._memory))

    def _time_to_wait(self) -> float | None:
        if self._timeout is None:
            return None
        ends = [worker.since + self._timeout for worker in self._workers if worker.given]
        return max(0.0, min(ends) - time.monotonic()) if ends else None

    def _receive(self, worker: _Worker) -> bool:
        """Takes all messages that are there; false if the process has ended."""
        try:
            while worker.replies.poll():
                self._take(worker, worker.replies.recv_bytes())
        except (EOFError, OSError):
            return False
        return True

    def _take(self, worker: _Worker, message: bytes) -> None:
        kind, content = message[:1], message[1:]
        if kind == READY:
            worker.ready = True
            self._failed_starts = 0
        elif kind == DONE:
            self._end_job(worker, content)
        elif kind == BROKEN:
            raise RuntimeError(f"the function cannot be loaded in another process: {content.decode()}")
        else:  # RETURNED
            worker.recalled = False
            returned = pickle.loads(content)
            worker.given = deque(index for index in worker.given if index not in set(returned))
            worker.bytes = sum(len(self._jobs[index]) for index in worker.given)
            self._left.extendleft(reversed(returned))

    def _end_job(self, worker: _Worker, content: bytes) -> None:
        index, number, seconds, peak = HEADER.unpack_from(content)
        status, answer = STATUSES[number], content[HEADER.size :]
        worker.bytes -= len(self._jobs[worker.given.popleft()])
        worker.since = time.monotonic()
        worker.leaving = status == "memory"
        self._mean += (seconds - self._mean) / 8
        if status != "ok":
            self._record(Record(index, status, None, answer.decode(), seconds, peak), None)
            return
        try:
            result = pickle.loads(answer)
        except Exception as error:
            text = f"the result cannot be read: {type(error).__qualname__}: {error}"
            self._record(Record(index, "failed", None, text, seconds, peak), None)
        else:
            self._record(Record(index, status, result, None, seconds, peak), None if result is None else answer)

    def _record(self, record: Record[Any], result: bytes | None) -> None:
        self._missing -= 1
        self._keep(record, result)

    def _expire(self) -> None:
        for worker in list(self._workers):
            if self._timeout is not None and worker.given and time.monotonic() >= worker.since + self._timeout:
                self._bury(worker, worker.given[0])

    def _bury(self, worker: _Worker, expired: int | None) -> None:
        """A process has ended, or ends because a job took too long. Only the job that it executes is lost."""
        seconds = time.monotonic() - worker.since
        self._workers.remove(worker)
        if expired is None:
            worker.process.join()
        worker.kill()
        self._receive(worker)  # all that it has sent
        worker.replies.close()
        if worker.given and expired in (None, worker.given[0]) and not worker.leaving:
            self._record(self._death(worker, worker.given.popleft(), expired, seconds), None)
        self._left.extendleft(reversed(worker.given))
        if not worker.ready and expired is None:
            self._failed_starts += 1
            if self._failed_starts > 3:
                raise RuntimeError(
                    f"a worker ended while it started, with exit code {worker.process.exitcode}; "
                    'a script needs if __name__ == "__main__":'
                )
        if self._left:
            self._start()

    def _death(self, worker: _Worker, index: int, expired: int | None, seconds: float) -> Record[Any]:
        code = worker.process.exitcode or 0
        if expired is not None:
            return Record(index, "timeout", None, f"took longer than {self._timeout:g} s", seconds, 0)
        if code == OUT_OF_MEMORY:
            return Record(index, "memory", None, "out of memory", seconds, 0)
        how = f"by signal {_signal_name(-code)}" if code < 0 else f"with exit code {code}"
        return Record(index, "crashed", None, f"the process ended {how}", seconds, 0)

    def _share_out(self) -> None:
        """Gives jobs to those that have the fewest; calls back what was sent ahead where another process has none."""
        ready = [worker for worker in self._workers if worker.ready and not worker.leaving]
        while self._left:
            job = self._jobs[self._left[0]]
            worker = min(ready, key=lambda worker: len(worker.given), default=None)
            if worker is None or not self._has_room(worker, len(job)):
                return
            worker.give(self._left.popleft(), job)
        if any(not worker.given for worker in ready):
            longest = max(self._workers, key=lambda worker: len(worker.given))
            if len(longest.given) > 1 and not longest.recalled:
                longest.recall()

    def _has_room(self, worker: _Worker, size: int) -> bool:
        if not worker.given:
            return True
        ahead = max(1, min(self._most_ahead, int(self._tick / max(self._mean, 1e-6))))
        return len(worker.given) <= ahead and worker.bytes + size <= self._most_bytes
