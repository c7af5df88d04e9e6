"""The processes of a batch: each executes one job after another, and tells its parent how they ended."""

from __future__ import annotations

import contextlib
import os
import pickle
import resource
import signal
import struct
import sys
import threading
import time
import traceback
from collections import deque
from collections.abc import Callable, Iterator
from multiprocessing.connection import Connection
from typing import Any

# From the parent: a kind, and after JOB its index and the pickled job.
JOB, RECALL = b"J", b"R"
INDEX = struct.Struct("<q")

# To the parent: a kind, and after DONE this header and the pickled result, or the text of an error.
READY, BROKEN, RETURNED, DONE = b"+", b"!", b"<", b"."
HEADER = struct.Struct("<qBdq")  # index, number of the status, seconds, peak of memory
STATUSES = ("ok", "failed", "timeout", "memory", "crashed")

OUT_OF_MEMORY = 71  # exit code of a worker that cannot even receive jobs any more


class _Inbox:
    """Jobs that the parent sent ahead. A thread receives them, so that the parent never waits for a busy worker."""

    def __init__(self, jobs: Connection, replies: Connection) -> None:
        self._waiting: deque[tuple[int, bytes]] = deque()
        self._changed = threading.Condition()
        self._replies = replies
        self.sending = threading.Lock()
        threading.Thread(target=self._receive, args=(jobs,), daemon=True).start()

    def take(self) -> tuple[int, bytes]:
        with self._changed:
            while not self._waiting:
                self._changed.wait()
            return self._waiting.popleft()

    def _receive(self, jobs: Connection) -> None:
        try:
            while True:
                message = jobs.recv_bytes()
                if message[:1] == RECALL:
                    self._give_back()
                    continue
                (index,) = INDEX.unpack_from(message, 1)
                with self._changed:
                    self._waiting.append((index, message[1 + INDEX.size :]))
                    self._changed.notify()
        except MemoryError:
            os._exit(OUT_OF_MEMORY)
        except (EOFError, OSError):
            os._exit(0)  # there are no more jobs, or there is no parent

    def _give_back(self) -> None:
        with self._changed:
            indices = [index for index, _ in self._waiting]
            self._waiting.clear()
        with self.sending:
            self._replies.send_bytes(RETURNED + pickle.dumps(indices))


class _Memory:
    """The memory of a process: a limit for each job, and how much it took. Only Linux tells it of a single job."""

    def __init__(self) -> None:
        self._size = _open("/proc/self/statm", os.O_RDONLY)
        self._reset = _open("/proc/self/clear_refs", os.O_WRONLY)

    @contextlib.contextmanager
    def limited(self, limit: int | None) -> Iterator[None]:
        """Lets the process have so many bytes of address space beside those that it has."""
        if self._reset is not None:
            os.write(self._reset, b"5")  # the peak is what is resident now: proc(5)
        if limit is None:
            yield
            return
        used = 0
        if self._size is not None:
            used = int(os.pread(self._size, 64, 0).split()[0]) * resource.getpagesize()
        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        most = used + limit if hard == resource.RLIM_INFINITY else min(used + limit, hard)
        resource.setrlimit(resource.RLIMIT_AS, (most, hard))
        try:
            yield
        finally:
            resource.setrlimit(resource.RLIMIT_AS, (soft, hard))

    @staticmethod
    def peak() -> int:
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)


def _open(path: str, flags: int) -> int | None:
    try:
        return os.open(path, flags | os.O_CLOEXEC)
    except OSError:
        return None


def described(error: BaseException) -> str:
    """A line that says what went wrong, and after it where."""
    most = 8000
    name = type(error).__qualname__
    try:
        where = "".join(traceback.format_exception(type(error), error, error.__traceback__))
        return f"{name}: {error}"[:most] + "\n" + where[-most:]
    except Exception:  # of its __str__
        return name


def _execute(function: Callable[[Any], Any], job: bytes, memory: _Memory, limit: int | None) -> tuple[str, bytes]:
    try:
        with memory.limited(limit):
            result = function(pickle.loads(job))
            return "ok", pickle.dumps(result, protocol=5)
    except MemoryError:
        return "memory", b"MemoryError: out of memory"
    except BaseException as error:  # SystemExit is no reason to end the worker
        return "failed", described(error).encode(errors="replace")


def work(jobs: Connection, replies: Connection, function: bytes, limit: int | None) -> None:
    """Executes jobs until the parent closes the pipe, or until one ran out of memory."""
    os.setpgid(0, 0)  # Ctrl-C is for the parent; what jobs start ends with the worker
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        call = pickle.loads(function)
    except BaseException as error:
        replies.send_bytes(BROKEN + described(error).encode(errors="replace"))
        return
    memory = _Memory()
    inbox = _Inbox(jobs, replies)
    replies.send_bytes(READY)
    status = "ok"
    while status != "memory":
        index, job = inbox.take()
        start = time.monotonic()
        status, answer = _execute(call, job, memory, limit)
        seconds = time.monotonic() - start
        header = HEADER.pack(index, STATUSES.index(status), seconds, memory.peak())
        with inbox.sending:
            replies.send_bytes(DONE + header + answer)
