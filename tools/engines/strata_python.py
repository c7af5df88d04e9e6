#!/usr/bin/env python3
"""The Python package of Strata as an engine of `strata verify`, called as `strata eval` is; results are exact.

`strata verify --engine strata-python` asks for it; `--python` or $STRATA_PYTHON names an interpreter that has the
package. Exit status: 0 done; 4 refused; 6 out of memory. `--check`: whether the package is there.
"""
import argparse
import sys

REFUSED, STOPPED = 4, 6


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("verb", choices=["eval"])
    parser.add_argument("expression")
    parser.add_argument("operands", nargs="+", metavar="NAME=FILE")
    parser.add_argument("-o", dest="output", required=True)
    parser.add_argument("--input", default="automatic")
    parser.add_argument("-j", dest="threads", type=int, default=0)
    return parser.parse_known_args()[0]  # reports and the like are for the command line


def main():
    import strata_csg
    asked = arguments()
    try:
        solids = {}
        for binding in asked.operands:
            name, path = binding.split("=", 1)
            solids[name] = strata_csg.Solid(strata_csg.read(path), input=asked.input, threads=asked.threads)
        result = strata_csg.Expression.parse(asked.expression, solids).evaluate(threads=asked.threads)
    except strata_csg.InputError as error:
        print(error, file=sys.stderr)
        return REFUSED
    except MemoryError:
        print("out of memory", file=sys.stderr)
        return STOPPED
    strata_csg.write(asked.output, result)
    return 0


if __name__ == "__main__":
    if sys.argv[1:] == ["--check"]:
        try:
            import strata_csg  # noqa: F401
        except ImportError as error:
            sys.exit(f"{error}; pip install strata-csg")
        sys.exit(0)
    sys.exit(main())
