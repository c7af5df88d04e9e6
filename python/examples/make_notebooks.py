"""Makes the notebooks beside the scripts of this folder that have parts: the scripts are the source.

    python make_notebooks.py            writes NAME.ipynb for every such NAME.py
    python make_notebooks.py --check    writes nothing; fails where a notebook is not what its script makes

The docstring of a script becomes the first cell. A line `# %% Title` begins a part: the title and the comment right
after it become a cell of text, the rest a cell of code. No outputs are stored.
"""

from __future__ import annotations

import ast
import json
import sys
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
MARKER = "# %%"

Cell = dict[str, Any]


def scripts() -> list[Path]:
    """The scripts of this folder that have parts."""
    return sorted(path for path in HERE.glob("*.py") if f"\n{MARKER} " in path.read_text(encoding="utf-8"))


def notebook_of(script: Path) -> str:
    """The notebook that a script makes, as JSON."""
    source = script.read_text(encoding="utf-8")
    head, *parts = source.split(f"\n{MARKER} ")
    tree = ast.parse(head)
    docstring = ast.get_docstring(tree)
    if docstring is None or len(tree.body) > 1 or not parts:
        raise ValueError(f"{script.name}: expected a docstring, then parts that begin with {MARKER!r}")
    title, _, text = docstring.partition("\n")
    cells = [text_cell(f"# {title}\n{text}")]
    for part in parts:
        cells += cells_of(part)
    for number, cell in enumerate(cells, 1):
        cell["id"] = f"{script.stem.replace('_', '-')}-{number}"
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    metadata = {"kernelspec": kernel, "language_info": {"name": "python"}}
    notebook = {"cells": cells, "metadata": metadata, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(notebook, indent=1, sort_keys=True, ensure_ascii=False) + "\n"


def cells_of(part: str) -> list[Cell]:
    """The text and the code of a part, which begins with its title."""
    title, *lines = part.split("\n")
    comments = 0
    while comments < len(lines) and lines[comments].startswith("#"):
        comments += 1
    text = "\n".join(line.removeprefix("#").removeprefix(" ") for line in lines[:comments])
    code = "\n".join(lines[comments:]).strip("\n")
    return [text_cell(f"## {title}\n\n{text}"), *([code_cell(code)] if code else [])]


def text_cell(text: str) -> Cell:
    return {"cell_type": "markdown", "metadata": {}, "source": text.strip().splitlines(keepends=True)}


def code_cell(code: str) -> Cell:
    return {
        "cell_type": "code",
        "execution_count": None,
        "metadata": {},
        "outputs": [],
        "source": code.splitlines(keepends=True),
    }


def main() -> None:
    check = sys.argv[1:] == ["--check"]
    outdated = []
    for script in scripts():
        notebook, text = script.with_suffix(".ipynb"), notebook_of(script)
        if notebook.exists() and notebook.read_text(encoding="utf-8") == text:
            continue
        outdated.append(notebook.name)
        if not check:
            notebook.write_text(text, encoding="utf-8")
    for name in outdated:
        print(f"{name}: {'not up to date' if check else 'written'}")
    if check and outdated:
        sys.exit(1)


if __name__ == "__main__":
    main()
