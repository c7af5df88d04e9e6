"""Every block of Python in README.md runs, and prints what the page says."""

from __future__ import annotations

import contextlib
import doctest
import io
import re
from pathlib import Path

README = Path(__file__).resolve().parents[1] / "README.md"
BLOCK = re.compile(r"^```python\n(.*?)^```\n(?:\n```text\n(.*?)^```$)?", re.DOTALL | re.MULTILINE)


def test_blocks():
    """One after the other, with the names of those before, as a reader would type them."""
    text = README.read_text(encoding="utf-8")
    blocks = BLOCK.findall(text)
    assert len(blocks) == text.count("```python") >= 5
    names: dict[str, object] = {}
    for number, (code, expected) in enumerate(blocks):
        if ">>>" in code:
            examples = doctest.DocTestParser().get_doctest(code, names, f"block {number}", str(README), 0)
            runner = doctest.DocTestRunner()
            assert runner.run(examples, clear_globs=False).failed == 0
            names.update(examples.globs)
        else:
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                exec(compile(code, f"block {number}", "exec"), names)
            assert printed.getvalue() == expected


def test_the_example_has_an_output():
    """A block without prompts that prints would pass without one."""
    text = README.read_text(encoding="utf-8")
    assert all(expected for code, expected in BLOCK.findall(text) if "print(" in code and ">>>" not in code)
