"""The bar that ``progress=True`` shows."""

from __future__ import annotations

from collections.abc import Callable


def bar() -> Callable[[float], None]:
    """A callable that shows the fraction done, by tqdm; without tqdm, one that shows nothing."""
    try:
        from tqdm.auto import tqdm  # type: ignore[import-untyped, unused-ignore]
    except ImportError:
        return lambda fraction: None
    shown = tqdm(total=1.0, bar_format="{percentage:3.0f}%|{bar}| {elapsed}", leave=False)

    def show(fraction: float) -> None:
        shown.update(fraction - shown.n)
        if fraction >= 1:
            shown.close()

    return show
