#!/usr/bin/env python3
"""Gathers the pages of the site in a folder, for MkDocs: those of docs/, those that lie beside the code, those that programs write.

Usage: stage.py --tool STRATA --out FOLDER. Links between pages are kept. A link to a file of the repository that is no page becomes plain
text. Python's standard library is enough.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

import api
import verbs

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Pages that lie elsewhere in the repository: where they are, and where they go.
ELSEWHERE = {
    "CHANGELOG.md": "project/changes.md",
    "examples/README.md": "tutorials/examples.md",
    "CODE_OF_CONDUCT.md": "project/conduct.md",
    "CONTRIBUTING.md": "project/contributing.md",
    "SECURITY.md": "project/security.md",
    "data/README.md": "project/data.md",
    "docs/versions.md": "project/versions.md",
    "lib/ARCHITECTURE.md": "explanation/architecture.md",
    "lib/core/io/xoff.md": "reference/formats/xoff.md",
    "lib/extensions/complex/sgc.md": "reference/formats/sgc.md",
    "lib/extensions/openscad/semantics.md": "reference/formats/csg.md",
    "lib/extensions/scene/rays.md": "explanation/theory/rays.md",
    "python/MIGRATION.md": "reference/python-migration.md",
    "python/README.md": "reference/python.md",
    "schemas/README.md": "reference/schemas/about.md",
    "tests/README.md": "project/tests.md",
    "tools/bench/RESULTS.md": "comparison/speed.md",
    "tools/strata/batch.md": "reference/formats/batch.md",
    "tools/strata/chain.md": "reference/formats/chain.md",
    "tools/verify/generators.md": "project/generators.md",
    "web/package/README.md": "reference/javascript.md",
}


def pages():
    """{file in the repository: file in the site} of everything that is copied."""
    found = {pathlib.Path(a): pathlib.Path(b) for a, b in ELSEWHERE.items() if (ROOT / a).exists()}
    for path in sorted((ROOT / "docs").rglob("*")):
        name = path.relative_to(ROOT)
        if path.is_file() and name not in found and path.suffix in (".md", ".svg", ".png", ".css"):
            found[name] = name.relative_to("docs")
    for path in sorted((ROOT / "lib").rglob("*.md")):
        name = path.relative_to(ROOT)
        if name.name == "theory.md":
            found[name] = pathlib.Path("explanation/theory", path.parent.name + ".md")
        elif name not in found:
            found[name] = pathlib.Path("explanation/theory", path.name)
    for path in sorted((ROOT / "lib").rglob("*.png")) + sorted((ROOT / "lib").rglob("*.svg")):
        found[path.relative_to(ROOT)] = pathlib.Path("explanation/theory", path.name)
    for path in sorted((ROOT / "examples/pictures").glob("*.svg")):
        found[path.relative_to(ROOT)] = pathlib.Path("tutorials/pictures", path.name)
    for path in sorted((ROOT / "include/strata").glob("*.h")):
        found[path.relative_to(ROOT)] = pathlib.Path("reference/api", path.stem + ".md")
    found[pathlib.Path("README.md")] = pathlib.Path("index.md")
    found[pathlib.Path("include/strata")] = pathlib.Path("reference/api/index.md")
    for folder in ("docs/decisions", "docs/gallery"):
        found[pathlib.Path(folder)] = pathlib.Path(folder).relative_to("docs") / "README.md"
    return found


def relink(text, source, target, found):
    """Links of a page that moves from `source` to `target`, both relative."""
    def link(match):
        mark, label, place, rest = match.groups()
        if re.match(r"[a-z]+:|#", place):
            return match[0]
        path, _, anchor = place.partition("#")
        wanted = pathlib.Path(os.path.normpath(source.parent / path))
        if wanted in found:
            new = os.path.relpath(found[wanted], target.parent)
            return f"{mark}[{label}]({new}{'#' + anchor if anchor else ''}{rest})"
        generated = pathlib.Path(os.path.normpath(source.parent / path))
        if source.parts[0] == "docs" and generated.parts[:2] in (("docs", "reference"), ("docs", "figures")):
            return match[0]  # made below
        if not (ROOT / wanted).exists():
            sys.exit(f"{source}: there is no {wanted}, to which it links")
        if label.startswith("`") or wanted.as_posix().endswith(label):
            return label
        return f"{label} (`{wanted}`)"
    return re.sub(r"(!?)\[([^\]]*)\]\(([^)\s]+)((?:\s+\"[^\"]*\")?)\)", link, text)


def with_programs(text):
    """Blocks such as ```cpp title="examples/cpp/x.cpp" that are empty get the file's text."""
    return re.sub(r'^(```\w+ title="(examples/[^"]+)"\n)```$',
                  lambda match: match[1] + (ROOT / match[2]).read_text(encoding="utf-8") + "```", text, flags=re.MULTILINE)


def copy(found, out):
    for source, target in found.items():
        place = out / target
        if (ROOT / source).is_dir() or source == pathlib.Path("README.md"):
            continue
        place.parent.mkdir(parents=True, exist_ok=True)
        if source.suffix == ".md":
            text = with_programs((ROOT / source).read_text(encoding="utf-8"))
            text = re.sub(r"(?m)^<!-- exit (\d+) -->$", r"*Exit code \1:*\n", text)
            place.write_text(relink(text, source, target, found), encoding="utf-8")
        elif source.suffix == ".h":
            place.write_text(api.page(ROOT / source), encoding="utf-8")
        else:
            shutil.copy(ROOT / source, place)


def write(folder, made):
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in made:
        (folder / name).write_text(text, encoding="utf-8")


def api_index():
    rows = [f"| [{path.name}]({path.stem}.md) | {api.summary(path)} |" for path in sorted((ROOT / "include/strata").glob("*.h"))]
    return "\n".join(["# Library", "", "Every public header. `<strata/strata.h>` has the core; extensions have headers of their own.",
                      "", "| header | |", "|---|---|", *rows, ""])


def figures(tool, folder):
    """Pictures that Strata draws, for pages of explanation; commands in docs/figures.txt, one a line, made in turn."""
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copytree(ROOT / "data", folder / "data", ignore=shutil.ignore_patterns("cases"), dirs_exist_ok=True)
    for line in (ROOT / "docs/figures.txt").read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            done = subprocess.run(["bash", "-c", line.replace("strata ", f"'{tool}' ", 1)], cwd=folder, capture_output=True, text=True, check=False)
            if done.returncode:
                sys.exit(f"docs/figures.txt: {line}: {done.stderr}")
    shutil.rmtree(folder / "data")
    for path in folder.iterdir():
        if path.is_dir():
            shutil.rmtree(path)
        elif path.suffix != ".svg":
            path.unlink()


def title(path):
    """The first heading of a page."""
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("# "):
            return line[2:].replace("`", "").strip().replace('"', "'")
    return path.stem


def configuration(out):
    """docs/mkdocs.yml with a list of pages in place of each folder in its `nav`."""
    lines = []
    for line in (ROOT / "docs/mkdocs.yml").read_text(encoding="utf-8").splitlines():
        match = re.match(r"(\s*)- (.+): (\S+)/$", line)
        if not match:
            lines.append(line.replace("../build/site/", f"{out.parent.resolve()}/"))
            continue
        indent, name, folder = match.groups()
        lines.append(f"{indent}- {name}:")
        index = [path for name in ("index.md", "README.md") if (path := out / folder / name).exists()]
        lines += [f"{indent}    - {path.relative_to(out)}" for path in index]
        lines += [f'{indent}    - "{title(path)}": {path.relative_to(out)}' for path in sorted((out / folder).glob("*.md")) if path not in index]
    (out.parent / "mkdocs.yml").write_text("\n".join(lines) + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tool", required=True)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    arguments = parser.parse_args()
    tool = str(pathlib.Path(arguments.tool).resolve())
    shutil.rmtree(arguments.out, ignore_errors=True)
    found = pages()
    copy(found, arguments.out)
    reference = arguments.out / "reference"
    write(reference / "api", [("index.md", api_index())])
    write(reference / "verbs", verbs.pages(tool))
    write(reference / "schemas", verbs.schema_pages(tool))
    table = verbs.run(tool, "formats")
    write(reference / "formats", [("index.md", "# File formats\n\nWhat `strata formats` prints:\n\n```text\n" + table + "```\n\nGrammars and documents: "
                                   "[XOFF](xoff.md), [SGC](sgc.md), [.csg](csg.md), [steps of chain](chain.md), [jobs of batch](batch.md).\n")])
    figures(tool, arguments.out / "figures")
    configuration(arguments.out)


if __name__ == "__main__":
    main()
