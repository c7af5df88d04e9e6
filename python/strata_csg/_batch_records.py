"""The records of a batch, and the file that keeps them."""

from __future__ import annotations

import hashlib
import json
import os
import pickle
from collections.abc import Sequence
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Generic, TypeVar

R = TypeVar("R")


@dataclass(frozen=True)
class Record(Generic[R]):
    """How one job ended.

    Attributes
    ----------
    index : int
        Of the job, from 0.
    status : str
        ``"ok"``; ``"failed"``: the function raised; ``"timeout"``: it took too long, and its process was killed;
        ``"memory"``: it needed more memory than it may have; ``"crashed"``: its process ended.
    result : object or None
        What the function returned.
    error : str or None
        What went wrong; where, in further lines.
    seconds : float
        By the clock.
    peak_memory : int
        The most resident memory of the process while the job ran, the interpreter included. Bytes; 0 if unknown.
    """

    index: int
    status: str
    result: R | None
    error: str | None
    seconds: float
    peak_memory: int


def digest(function: bytes, job: bytes) -> str:
    """Two jobs with one digest are the same call."""
    return hashlib.sha256(hashlib.sha256(function).digest() + job).hexdigest()


class RecordFile:
    """A JSON line for every job that has ended, in the order in which they end; results are in another file.

    The line has the members of `Record`, and ``"job"``, a digest of the call. ``"result"`` is null, or ``[offset,
    size]`` of the pickled result in the file of the same name with ``.results`` at its end. The result is written
    first, so that a line stands for a whole result.
    """

    def __init__(self, path: str | os.PathLike[str], resume: bool) -> None:
        self._path = os.fspath(path)
        self._kept: dict[int, dict[str, Any]] = {}
        flags = os.O_RDWR | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC | (0 if resume else os.O_TRUNC)
        self._lines = os.open(self._path, flags, 0o666)
        self._results = os.open(self._path + ".results", flags, 0o666)
        try:
            if resume:
                self._keep_whole_lines()
        except BaseException:
            self.close()
            raise

    def __enter__(self) -> RecordFile:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        os.close(self._lines)
        os.close(self._results)

    def kept(self, digests: Sequence[str]) -> dict[int, Record[Any]]:
        """The records of these calls that the file has already, by index."""
        records = {}
        for index, line in self._kept.items():
            if index < len(digests) and line["job"] == digests[index]:
                result = None if line["result"] is None else pickle.loads(self._result(*line["result"]))
                records[index] = Record(
                    index, line["status"], result, line["error"], line["seconds"], line["peak_memory"]
                )
        return records

    def add(self, record: Record[Any], job: str, result: bytes | None) -> None:
        """Writes the record of a call with this digest and with this pickled result."""
        place = None
        if result is not None:
            place = [os.fstat(self._results).st_size, len(result)]
            _write(self._results, result)
        line = {
            "index": record.index,
            "job": job,
            "status": record.status,
            "result": place,
            "error": record.error,
            "seconds": record.seconds,
            "peak_memory": record.peak_memory,
        }
        _write(self._lines, json.dumps(line).encode() + b"\n")

    def _keep_whole_lines(self) -> None:
        size = os.fstat(self._lines).st_size
        text = os.pread(self._lines, size, 0) if size else b""
        whole = text.rfind(b"\n") + 1
        for number, line in enumerate(text[:whole].splitlines(), 1):
            try:
                entry = json.loads(line)
                self._kept[entry["index"]] = entry  # the last one counts
            except (ValueError, KeyError, TypeError):
                raise ValueError(f"{self._path}:{number}: is no record of a batch") from None
        os.ftruncate(self._lines, whole)

    def _result(self, offset: int, size: int) -> bytes:
        result = os.pread(self._results, size, offset)
        if len(result) < size:
            raise ValueError(f"{self._path}.results does not belong to {self._path}: it is too short")
        return result


def _write(descriptor: int, data: bytes) -> None:
    left = memoryview(data)
    while left:
        left = left[os.write(descriptor, left) :]
