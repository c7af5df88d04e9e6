#!/usr/bin/env python3
"""Checks a built site: every link within it leads to a file and an anchor, and no page asks another server for anything.

Usage: check_links.py FOLDER. Exit code 1: something is wrong; each fault is a line.
"""
import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """Links, anchors and assets of a page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.assets, self.anchors = [], [], {""}
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        for key in ("id", "name"):
            if values.get(key):
                self.anchors.add(values[key])
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        if tag == "link" and values.get("href") and values.get("rel") != "canonical":
            self.assets.append(values["href"])
        if tag in ("img", "script", "iframe", "source", "object") and (values.get("src") or values.get("data")):
            self.assets.append(values.get("src") or values.get("data"))


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    files = {path: Page(path) for path in sorted(root.rglob("*.html"))}
    faults = []
    for path, page in files.items():
        place = path.relative_to(root)
        for asset in page.assets:
            if urllib.parse.urlparse(asset).scheme not in ("", "data"):
                faults.append(f"{place}: asks another server for {asset}")
        for link in page.links + page.assets:
            parts = urllib.parse.urlparse(link)
            if parts.scheme or parts.netloc or place.name == "404.html":
                continue
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if target.is_dir():
                target /= "index.html"
            if not target.exists():
                faults.append(f"{place}: there is no {link}")
            elif parts.fragment and target in files and urllib.parse.unquote(parts.fragment) not in files[target].anchors | {"__search"}:
                faults.append(f"{place}: {link}: there is no such place in the page")
    for sheet in root.rglob("*.css"):
        text = sheet.read_text(encoding="utf-8")
        faults += [f"{sheet.relative_to(root)}: asks another server" for mark in ("url(http", 'url("http', "@import url(//") if mark in text]
    print("\n".join(faults) if faults else f"{len(files)} pages, {sum(len(p.links) for p in files.values())} links: no fault")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
