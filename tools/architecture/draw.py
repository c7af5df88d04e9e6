#!/usr/bin/env python3
"""The drawing of the house in lib/ARCHITECTURE.md, made from the includes.

draw.py           prints the drawing
draw.py --write   puts it into lib/ARCHITECTURE.md, between its markers
draw.py --check   fails where an include goes against the order, or the drawing is not that of the tree

The order is that of lib/CMakeLists.txt: a module may include what its link line names, and what that links in turn. A public
header may include public headers and the standard library. Of the programs, the command line includes public headers and
core/system only; what it shares with others (tools/common) may use the readers and writers of the core besides.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "lib/ARCHITECTURE.md"
BEGIN, END = "<!-- drawing: tools/architecture/draw.py --write -->", "<!-- end of drawing -->"

PROGRAMS = {"tools/strata": ("core/system/",), "tools/common": ("core/io/", "core/system/"), "tools/verify": ("core/",)}  # and what each may include of lib


def linked():
    """Per module, in the order of the file: its level and all that it sees."""
    modules = {}
    text = (ROOT / "lib/CMakeLists.txt").read_text()
    for kind, name, uses in re.findall(r"^strata_(core_module|extension)\((\w+)\s*([^)]*)\)", text, re.M):
        direct = [u for u in re.findall(r"strata::(\w+)", uses)]
        sees = set(direct)
        for u in direct:
            sees |= modules[u][1]
        modules[name] = ("core" if kind == "core_module" else "extensions", sees)
    return modules


def includes(path):
    return re.findall(r'^#include "([^"]+)"', path.read_text(), re.M)


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in (".h", ".cpp"))


def arrows_and_faults(modules):
    arrows, faults = {}, []
    for name, (level, sees) in modules.items():
        arrows[name] = set()
        for path in sources(ROOT / "lib" / level / name):
            for include in includes(path):
                if include.startswith("strata/"):
                    if not (ROOT / "include" / include).exists():
                        faults.append(f"{path.relative_to(ROOT)}: no public header {include}")
                    continue
                other = include.split("/")[1]
                if other == name:
                    continue
                arrows[name].add(other)
                if other not in sees:
                    faults.append(f"{path.relative_to(ROOT)}: {include} is not below {name}")
    for path in sorted((ROOT / "include/strata").glob("*.h")):
        faults += [f"{path.relative_to(ROOT)}: {i} is not public" for i in includes(path) if not i.startswith("strata/")]
    for folder, allowed in PROGRAMS.items():
        for path in sources(ROOT / folder):
            if folder == "tools/strata" and (ROOT / "include/strata" / path.name).exists():
                faults.append(f"{path.relative_to(ROOT)}: has the name of a public header, which it would hide")
            faults += [f"{path.relative_to(ROOT)}: {i} is not for {folder}" for i in includes(path)
                       if i.startswith(("core/", "extensions/")) and not i.startswith(allowed)]
    for level in ("core", "extensions"):
        for folder in (ROOT / "lib" / level).iterdir():
            if folder.is_dir() and folder.name not in modules:
                faults.append(f"lib/{level}/{folder.name}: no such module in lib/CMakeLists.txt")
    return arrows, faults


def drawing(modules, arrows):
    """Each module below those that it includes; of these only the ones that no other of them includes."""
    closure = {}
    for name in modules:
        closure[name] = set(arrows[name]).union(*(closure[a] for a in arrows[name]))
    lines = []
    for level, title in (("core", "lib/core"), ("extensions", "lib/extensions")):
        lines.append(title)
        for name, (of_level, _) in modules.items():
            if of_level != level:
                continue
            near = sorted(a for a in arrows[name] if not any(a in closure[b] for b in arrows[name]))
            lines.append(f"  {name:<12}" + ("-> " + ", ".join(near) if near else "").rstrip())
    public = sorted(p.name for p in (ROOT / "include/strata").glob("*.h"))
    lines.append("include/strata")
    row = " "
    for header in public:
        if len(row) + len(header) > 110:
            lines.append(row)
            row = " "
        row += " " + header
    lines.append(row)
    return "```\n" + "\n".join(line.rstrip() for line in lines) + "\n```"


def main():
    modules = linked()
    arrows, faults = arrows_and_faults(modules)
    picture = drawing(modules, arrows)
    page = PAGE.read_text()
    before, _, rest = page.partition(BEGIN)
    now, _, after = rest.partition(END)
    if "--write" in sys.argv:
        PAGE.write_text(f"{before}{BEGIN}\n{picture}\n{END}{after}")
    elif "--check" in sys.argv:
        if now.strip() != picture:
            faults.append("lib/ARCHITECTURE.md: the drawing is not that of the tree; run tools/architecture/draw.py --write")
        print(*faults, sep="\n")
        return 1 if faults else 0
    else:
        print(picture)
    return 0


if __name__ == "__main__":
    sys.exit(main())
