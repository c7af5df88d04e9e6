#!/usr/bin/env python3
"""The software bill of materials of a build on this system: CycloneDX 1.5, in JSON, to standard output.

Versions are those of Debian's packages. `scope` is optional for what a build can do without. Deterministic: no date, no random number.
"""
import hashlib
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]

# name, Debian's package, licence, what it is for, scope
PARTS = [
    ("oneTBB", "libtbb-dev", "Apache-2.0", "threads; linked dynamically", "required"),
    ("Boost", "libboost-dev", "BSL-1.0", "headers: Container, Multiprecision", "required"),
    ("GMP", "libgmp-dev", "LGPL-3.0-or-later", "big integers; linked dynamically, left out by STRATA_WITH_GMP=OFF", "optional"),
    ("assimp", "libassimp-dev", "BSD-3-Clause", "readers of more formats; left out by STRATA_WITH_ASSIMP=OFF", "optional"),
    ("pugixml", "libpugixml-dev", "MIT", "SVG files; of the extension planar", "optional"),
    ("nlohmann-json", "nlohmann-json3-dev", "MIT", "headers: GeoJSON files, reports", "optional"),
    ("CLI11", "libcli11-dev", "BSD-3-Clause", "headers: the command line", "optional"),
    ("fmt", "libfmt-dev", "MIT", "messages of the command line", "optional"),
]


def version_of(package):
    done = subprocess.run(["dpkg-query", "--show", "--showformat=${Version}", package], capture_output=True, text=True, check=False)
    return done.stdout if done.returncode == 0 and done.stdout else None


def main():
    version = re.search(r"project\(strata VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    components = []
    for name, package, licence, what, scope in PARTS:
        component = {"type": "library", "bom-ref": package, "name": name, "scope": scope, "description": what,
                     "licenses": [{"license": {"id": licence}}]}
        if found := version_of(package):
            component |= {"version": found, "purl": f"pkg:deb/debian/{package}@{found}"}
        components.append(component)
    licence = hashlib.sha256((ROOT / "LICENSE").read_bytes()).hexdigest()
    json.dump({
        "bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
        "metadata": {"component": {"type": "application", "bom-ref": "strata", "name": "strata", "version": version,
                                   "licenses": [{"license": {"id": "Apache-2.0"}}],
                                   "properties": [{"name": "sha256 of LICENSE", "value": licence}]}},
        "components": components,
        "dependencies": [{"ref": "strata", "dependsOn": [package for _, package, *_ in PARTS]}],
    }, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
