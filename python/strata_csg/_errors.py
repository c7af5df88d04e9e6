"""What can go wrong, and how it is reported."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Defect:
    """One kind of defect of a mesh: where it is, and what would repair it.

    Attributes
    ----------
    kind : str
        ``"open edge"``, ``"self-intersection"``, ``"degenerate triangle"`` and so on.
    severity : str
        ``"error"``: the mesh is no solid. ``"note"``: it is one, and this was resolved exactly on the way in.
    where : tuple of float or None
        A point at the defect, in model units.
    faces : tuple of int
        Numbers of the triangles concerned, from 0.
    count : int
        How many of this kind there are; only the first few are listed.
    message, remedy : str
        A sentence each.
    """

    kind: str
    severity: str
    where: tuple[float, float, float] | None
    faces: tuple[int, ...]
    count: int
    message: str
    remedy: str
    text: str = ""

    def __str__(self) -> str:
        return self.text or f"{self.kind}: {self.message}"


class InputError(ValueError):
    """A mesh is not what it was declared to be.

    Attributes
    ----------
    defects : tuple of Defect
        Every kind of defect that was found.
    operand : int
        The operand that has them, from 0.
    """

    defects: tuple[Defect, ...]
    operand: int

    def __init__(self, message: str, defects: tuple[Defect, ...] = (), operand: int = 0) -> None:
        super().__init__(message)
        self.defects = tuple(defects)
        self.operand = operand

    def __reduce__(self) -> tuple[type[InputError], tuple[str, tuple[Defect, ...], int]]:
        return type(self), (str(self), self.defects, self.operand)


class FileError(OSError):
    """A file cannot be read or written, or does not hold what its format demands.

    Attributes
    ----------
    path : str
        The file.
    line, byte : int or None
        Where in the file: a line of a text, from 1, or a byte, from 0.
    reason : str
        What was expected, and what was found.
    """

    path: str
    line: int | None
    byte: int | None
    reason: str

    def __init__(
        self, message: str, path: str = "", line: int | None = None, byte: int | None = None, reason: str = ""
    ) -> None:
        super().__init__(message)
        self.path = path
        self.line = line
        self.byte = byte
        self.reason = reason

    def __reduce__(self) -> tuple[type[FileError], tuple[str, str, int | None, int | None, str]]:
        return type(self), (str(self), self.path, self.line, self.byte, self.reason)


class ParseError(ValueError):
    """A text, such as an expression, does not follow its grammar.

    Attributes
    ----------
    position : int
        Where in the text, in bytes from 0.
    """

    position: int

    def __init__(self, message: str, position: int = 0) -> None:
        super().__init__(message)
        self.position = position

    def __reduce__(self) -> tuple[type[ParseError], tuple[str, int]]:
        return type(self), (str(self), self.position)


class InternalError(RuntimeError):
    """An invariant of the library does not hold: a fault of Strata. Please report it with the input."""
