#!/usr/bin/env python3
"""The software bill of materials of a build on this system: CycloneDX 1.5, in JSON, to standard output.

Versions are those of Debian's packages. `scope` is optional for what a build can do without. Deterministic: no date, no random number.
"""
import argparse
import hashlib
import json
import pathlib
import re
import subprocess
import sys
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[1]


class Part(NamedTuple):
    """A library: its package in Debian, an SPDX expression, what it is for, and the builds that have it."""
    name: str
    package: str
    licence: str
    what: str
    scope: str
    builds: tuple[str, ...] = ("system", "portable")


PARTS = [
    Part("oneTBB", "libtbb-dev", "Apache-2.0", "threads", "required", ("system",)),
    Part("oneTBB", "onetbb", "Apache-2.0", "threads; built by tools/static_tbb", "required", ("portable",)),
    Part("Boost", "libboost-dev", "BSL-1.0", "headers: Container, Multiprecision", "required"),
    Part("zlib", "zlib1g-dev", "Zlib", "archives of 3MF", "required"),
    Part("GMP", "libgmp-dev", "LGPL-3.0-or-later", "big integers; left out by STRATA_WITH_GMP=OFF", "optional", ("system",)),
    Part("assimp", "libassimp-dev", "BSD-3-Clause", "readers of more formats; left out by STRATA_WITH_ASSIMP=OFF", "optional", ("system",)),
    Part("libdeflate", "libdeflate-dev", "MIT", "unpacks archives of 3MF; zlib does with STRATA_WITH_LIBDEFLATE=OFF", "optional", ("system",)),
    Part("libpng", "libpng-dev", "libpng-2.0", "PNG textures in drawings, surfaces of pictures; left out by STRATA_WITH_PNG=OFF",
         "optional", ("system",)),
    Part("libjpeg-turbo", "libjpeg62-turbo-dev", "IJG AND BSD-3-Clause", "JPEG textures in drawings; left out by STRATA_WITH_JPEG=OFF",
         "optional", ("system",)),
    Part("FreeType", "libfreetype-dev", "FTL", "outlines of texts in models of OpenSCAD; left out by STRATA_WITH_FONTS=OFF", "optional", ("system",)),
    Part("HarfBuzz", "libharfbuzz-dev", "MIT-Modern-Variant", "glyphs of these texts; left out with FreeType", "optional", ("system",)),
    Part("Fontconfig", "libfontconfig-dev", "HPND-sell-variant", "fonts by name; left out with FreeType", "optional", ("system",)),
    Part("pugixml", "libpugixml-dev", "MIT", "SVG files; of the extension planar", "optional"),
    Part("nlohmann-json", "nlohmann-json3-dev", "MIT", "headers: glTF and GeoJSON files, reports", "required"),
    Part("CLI11", "libcli11-dev", "BSD-3-Clause", "headers: the command line", "optional"),
    Part("fmt", "libfmt-dev", "MIT", "messages of the command line", "optional"),
    Part("glibc", "libc6-dev", "LGPL-2.1-or-later", "the C library", "required", ("portable",)),
    Part("libstdc++", "libstdc++6", "GPL-3.0-or-later WITH GCC-exception-3.1", "the C++ library", "required", ("portable",)),
]


def version_in(path, pattern):
    return re.search(pattern, (ROOT / path).read_text(encoding="utf-8"), re.MULTILINE)[1]


def version_of(package):
    if package == "onetbb":
        return version_in("tools/static_tbb", r"^version=([0-9.]+)")
    done = subprocess.run(["dpkg-query", "--show", "--showformat=${Version}", package], capture_output=True, text=True, check=False)
    return done.stdout if done.returncode == 0 and done.stdout else None


def component(part):
    licence = {"expression": part.licence} if " " in part.licence else {"license": {"id": part.licence}}
    entry = {"type": "library", "bom-ref": part.package, "name": part.name, "scope": part.scope, "description": part.what, "licenses": [licence]}
    if found := version_of(part.package):
        entry |= {"version": found, "purl": f"pkg:deb/debian/{part.package}@{found}"}
    return entry


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--portable", action="store_true", help="of programs with everything inside (the preset portable)")
    build = "portable" if parser.parse_args().portable else "system"
    linked = "statically" if build == "portable" else "dynamically, headers apart"
    version = version_in("CMakeLists.txt", r"project\(strata VERSION ([0-9.]+)")
    parts = [part for part in PARTS if build in part.builds]
    licence = hashlib.sha256((ROOT / "LICENSE").read_bytes()).hexdigest()
    json.dump({
        "bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
        "metadata": {"component": {"type": "application", "bom-ref": "strata", "name": "strata", "version": version,
                                   "licenses": [{"license": {"id": "Apache-2.0"}}],
                                   "properties": [{"name": "sha256 of LICENSE", "value": licence}, {"name": "linked", "value": linked}]}},
        "components": [component(part) for part in parts],
        "dependencies": [{"ref": "strata", "dependsOn": [part.package for part in parts]}],
    }, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
