"""Shows viewers in Chromium, turns them, and looks for errors and for requests to a network.

Run it by hand; it is not one of the tests of pytest::

    python python/tests/browser_notebook.py [FOLDER FOR PICTURES]

It needs the package playwright, and Chromium: its own (`playwright install chromium`) or one on the path. Without them
it says so and does nothing.
"""

from __future__ import annotations

import base64
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import strata_csg as st
from strata_csg._notebook import Viewer, show

try:
    from playwright.sync_api import sync_playwright
except ImportError:
    print("SKIPPED: playwright is not installed")
    sys.exit(0)

DATA = Path(__file__).resolve().parents[2] / "data"
OPTIONS = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"]

#: Pictures of the same differ by less than SAME: two buffers in turn may smooth lines differently. Others differ by
#: more than CHANGED.
SAME, CHANGED = 0.3, 0.12

DIFFERENCE = """async (urls) => {
  const pixels = await Promise.all(urls.map(async (url) => {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, image.width, image.height).data;
  }));
  return pixels[0].reduce((sum, value, i) => sum + Math.abs(value - pixels[1][i]), 0) / pixels[0].length;
}"""


def viewers() -> dict[str, Viewer]:
    notched = st.box((0, 0, 0), (2, 2, 1)) - st.box((1, 1, 0), (2, 2, 1)) - st.box((0.5, 0.5, 0.5), (0.75, 0.75, 2))
    spot = st.Solid(st.read(DATA / "spot.obj"))
    gear = st.Solid(st.read(DATA / "gear.off"))
    return {
        "cube": show(st.box((0, 0, 0), (1, 1, 1))),
        "far": show(st.box((0, 0, 0), (1, 2, 1)).translated((2**40, 2**40, 2**40)), colors="#80c080"),
        "decomposition": show(st.decompose(notched)),
        "layers": show(st.layers([notched], direction=(1, 2, 3))),
        "spot": show(spot - gear),
        "box": show(st.sphere(1, 600)),
        "surface": show(st.clip(st.Surface.of_plane(((1, 1, 1), 0), (-1, -1, -1), (1, 1, 1)), spot)),
    }


def check(condition: bool, message: str) -> None:
    if not condition:
        raise AssertionError(message)


class Window:
    """A page of a browser, with what it asked for and what went wrong."""

    def __init__(self, browser: Any, file: Path, width: int, height: int) -> None:
        self.requests: list[str] = []
        self.errors: list[str] = []
        self.page = browser.new_page(viewport={"width": width, "height": height}, device_scale_factor=1)
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.on("pageerror", lambda error: self.errors.append(str(error)))
        self.page.on("console", self._heard)
        self.page.goto(file.as_uri())
        self.frame = self.page.frame_locator("iframe").first
        self.page.wait_for_timeout(300)

    def _heard(self, message: Any) -> None:
        if message.type in ("error", "warning"):
            self.errors.append(message.text)

    def picture(self) -> bytes:
        self.page.wait_for_timeout(150)
        picture: bytes = self.page.locator("iframe").first.screenshot()
        return picture

    def changes(self, what: str, action: Callable[[], object]) -> None:
        before = self.picture()
        action()
        difference = self.difference(before, self.picture())
        check(difference > CHANGED, f"{what} changes nothing: {difference}")

    def difference(self, a: bytes, b: bytes) -> float:
        """The mean difference of two pictures, per pixel and colour, where 255 is that of black and white."""
        urls = ["data:image/png;base64," + base64.b64encode(picture).decode() for picture in (a, b)]
        result: float = self.page.evaluate(DIFFERENCE, urls)
        return result

    def close(self, file: Path) -> None:
        strangers = [url for url in self.requests if url != file.as_uri() and not url.startswith(("about:", "data:"))]
        check(not strangers, f"requests: {strangers}")
        ours = [error for error in self.errors if "GPU stall" not in error]
        check(not ours, f"errors: {ours}")
        self.page.close()


def drag(window: Window, dx: float, dy: float) -> None:
    box = window.page.locator("iframe").first.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    window.page.mouse.move(x, y)
    window.page.mouse.down()
    window.page.mouse.move(x + dx, y + dy, steps=4)
    window.page.mouse.up()


def exercise(window: Window, name: str) -> None:
    """Every way to change the picture changes it, and reset restores it."""
    stage, keyboard = window.frame.locator("#stage"), window.page.keyboard
    at_home = window.picture()
    window.changes("dragging", lambda: drag(window, 60, 30))
    window.changes("the wheel", lambda: window.page.mouse.wheel(0, -300))
    keyboard.down("Shift")
    window.changes("dragging with shift", lambda: drag(window, 40, -20))
    keyboard.up("Shift")
    stage.focus()
    for key in ("ArrowLeft", "ArrowUp", "Shift+ArrowRight", "+", "-"):
        window.changes(key, lambda: keyboard.press(key))
    keyboard.press("Home")
    window.page.mouse.move(0, 0)
    stage.blur()
    difference = window.difference(at_home, window.picture())
    check(difference < SAME, f"Home does not restore the picture: {difference}")
    if name == "decomposition":
        window.changes("the slider", lambda: window.frame.locator("#slider").fill("70"))
    if name == "layers":
        window.changes("the slider", lambda: window.frame.locator("#slider").fill("1"))
        check("1 of" in window.frame.locator("#label").inner_text(), "the label does not count layers")
        window.frame.locator("#slider").fill("2")
    if name != "box":
        window.changes("the check box", lambda: window.frame.locator("#lines").uncheck())
        window.frame.locator("#lines").check()


def lost(window: Window) -> None:
    """A picture that the browser takes back can be had again."""
    canvas = window.frame.locator("canvas")
    canvas.evaluate("canvas => canvas.getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()")
    message = window.frame.locator("#message")
    message.wait_for(state="visible")
    message.click()
    message.wait_for(state="hidden")


def look_at(browser: Any, name: str, viewer: Viewer, folder: Path) -> None:
    file = folder / f"{name}.html"
    viewer.save(file)
    window = Window(browser, file, 900, 560)
    check(window.frame.locator("#message").is_hidden(), f"{name}: {window.frame.locator('#message').inner_text()}")
    exercise(window, name)
    window.page.screenshot(path=folder / f"{name}.png")
    window.page.set_viewport_size({"width": 420, "height": 560})
    window.page.screenshot(path=folder / f"{name}-narrow.png")
    lost(window)
    window.close(file)


def many(browser: Any, folder: Path) -> None:
    """Several viewers in one page do not disturb one another."""
    file = folder / "several.html"
    all_viewers = viewers()
    shown = [all_viewers[name] for name in ("cube", "decomposition", "layers")]
    file.write_text("<!DOCTYPE html><meta charset='utf-8'>" + "".join(v._repr_html_() for v in shown), "utf-8")
    window = Window(browser, file, 700, 1400)
    window.changes("dragging", lambda: drag(window, 60, 30))
    window.page.screenshot(path=folder / "several.png")
    window.close(file)


def without_webgl(playwright: Any, options: dict[str, Any], folder: Path) -> None:
    browser = playwright.chromium.launch(**{**options, "args": ["--disable-gpu", "--disable-3d-apis", "--no-sandbox"]})
    window = Window(browser, folder / "cube.html", 900, 560)
    check("no WebGL" in window.frame.locator("#message").inner_text(), "no sentence without WebGL")
    window.page.screenshot(path=folder / "without.png")
    browser.close()


def main() -> None:
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp())
    folder.mkdir(parents=True, exist_ok=True)
    with sync_playwright() as playwright:
        installed = Path(playwright.chromium.executable_path).exists()
        path = None if installed else shutil.which("chromium") or shutil.which("google-chrome")
        if not installed and not path:
            print("SKIPPED: there is no Chromium")
            return
        options: dict[str, Any] = {"args": OPTIONS, "executable_path": path}
        browser = playwright.chromium.launch(**options)
        for name, viewer in viewers().items():
            look_at(browser, name, viewer, folder)
            print(f"{name}: {viewer.facts}")
        many(browser, folder)
        browser.close()
        without_webgl(playwright, options, folder)
    print(f"no errors, no requests; pictures are in {folder}")


if __name__ == "__main__":
    main()
