"""Checks the built site: every link, anchor and picture leads somewhere, and no page needs a network.

Usage: check.py FOLDER. Links to other sites are checked for their form only.
"""

import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.parts = {""}, [], []
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.update(value for key, value in attributes if key in ("id", "name") and value)
        if tag == "a" and "href" in values:
            self.links.append(values["href"])
        elif tag == "link" and values.get("rel") in ("stylesheet", "icon", "shortcut icon"):
            self.parts.append(values["href"])
        elif "src" in values:
            self.parts.append(values["src"])


def problems(folder):
    pages = {path.resolve(): Page(path) for path in folder.rglob("*.html")}
    for path, page in pages.items():
        for link in page.links + page.parts:
            at = urlsplit(link)
            if at.scheme or at.netloc:
                if link in page.parts:
                    yield path, link, "needs a network"
                elif at.scheme not in ("https", "http") or "." not in at.netloc or " " in link:
                    yield path, link, "is not an address"
                continue
            target = (path.parent / unquote(at.path)).resolve() if at.path else path
            if not target.is_file():
                yield path, link, "leads nowhere"
            elif target in pages and unquote(at.fragment) not in pages[target].anchors:
                yield path, link, "has an anchor that is not there"
    for path in folder.rglob("*.css"):
        for link in re.findall(r"url\(['\"]?([^'\")]*)", path.read_text()):
            if not link.startswith(("data:", "#")) and not (path.parent / link).resolve().is_file():
                yield path, link, "leads nowhere"
    if len(pages) < 30:
        yield folder, len(pages), "are too few pages"


folder = Path(sys.argv[1])
found = [f"{path}: {link} {problem}" for path, link, problem in problems(folder)]
print("\n".join(found) if found else f"{folder}/index.html: all links and anchors are valid")
sys.exit(1 if found else 0)
