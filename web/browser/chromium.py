"""Headless Chromium for the tests of pages; they end with exit code 77 where there is none."""
import contextlib
import shutil
import sys

try:
    from playwright.sync_api import sync_playwright
except ImportError:
    sync_playwright = None


@contextlib.contextmanager
def pages(**options):
    """A function that makes a page of a new window, whose errors go to standard error."""
    path = shutil.which("chromium") or shutil.which("google-chrome")
    if path is None or sync_playwright is None:
        print("SKIPPED: there is no Chromium, or no Playwright.", file=sys.stderr)
        sys.exit(77)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=["--no-sandbox", "--enable-unsafe-swiftshader"])

        def make():
            page = browser.new_page(**options)
            page.on("pageerror", lambda error: print(error, file=sys.stderr))
            return page

        yield make
        browser.close()
