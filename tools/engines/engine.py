"""What the engines' scripts share: `SCRIPT OPERATION A.off B.off OUT.off`, or `SCRIPT --check`.

Exit status: 0 done; 3 refused, 4 not installed, 5 no such operation, each with a sentence on standard error. `--check`
exits with 0 where coordinates are doubles and with 24 where they are floats, whose unit roundoff is 2^-24.
"""
import os
import sys

REFUSED, NOT_INSTALLED, NO_OPERATION, FLOATS = 3, 4, 5, 24


class Refused(Exception):
    """The engine says that it has no result."""


def read_off(path):
    """Vertices and triangles of an OFF file as strata writes it."""
    import numpy
    with open(path) as file:
        words = file.read().split()
    if words[0] != "OFF":
        raise ValueError(f"{path} is no OFF file")
    vertices, faces = int(words[1]), int(words[2])
    points = numpy.array(words[4:4 + 3 * vertices], dtype=numpy.float64).reshape(-1, 3)
    corners = numpy.array(words[4 + 3 * vertices:], dtype=numpy.int64).reshape(faces, 4)
    return points, corners[:, 1:]


def write_off(path, vertices, triangles):
    lines = ["OFF", f"{len(vertices)} {len(triangles)} 0"]
    lines += [" ".join(repr(float(x)) for x in v) for v in vertices]
    lines += [f"3 {int(a)} {int(b)} {int(c)}" for a, b, c in triangles]
    with open(path, "w") as file:
        file.write("\n".join(lines) + "\n")


def with_empty_operands(operation, a, b):
    """The result where an operand is empty, which engines are not asked; else None."""
    if len(a[1]) and len(b[1]):
        return None
    nothing = (a[0][:0], a[1][:0])
    if operation == "intersection":
        return nothing
    return a if len(a[1]) else nothing if operation == "difference" else b


def main(package, run, floats=False):
    """`run(operation, (vertices, triangles), (vertices, triangles))` returns vertices and triangles; it imports the
    engine."""
    if sys.argv[1:] == ["--check"]:
        try:
            for name in ("numpy", *package.split()[1:]):
                __import__(name)
        except ImportError as error:
            print(f"{error}; pip install {package.split()[0]} numpy", file=sys.stderr)
            sys.exit(NOT_INSTALLED)
        sys.exit(FLOATS if floats else 0)
    operation, first, second, out = sys.argv[1:]
    a, b = read_off(first), read_off(second)
    try:
        result = with_empty_operands(operation, a, b)
        write_off(out, *(result if result is not None else run(operation, a, b)))
    except Refused as error:
        print(error, file=sys.stderr)
        sys.stderr.flush()
        os._exit(REFUSED)
    os._exit(0)  # some engines crash when the interpreter takes them down


def xor_by_differences(pair, a, b):
    """For engines without a symmetric difference: the union of both differences."""
    one, two = pair("difference", a, b), pair("difference", b, a)
    result = with_empty_operands("union", one, two)
    return result if result is not None else pair("union", one, two)
