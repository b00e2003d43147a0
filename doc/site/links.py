# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every link and picture of the pages below a folder leads to a file there, and to a place in it that exists."""
import functools
import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.names, self.links = set(), []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.names |= {attributes[key] for key in ("id", "name") if attributes.get(key)}
        for key in ("href", "src", "data", "xlink:href"):
            if attributes.get(key) and tag not in ("base",):
                self.links.append((tag, attributes[key]))


@functools.cache
def read(file):
    return Page(file.read_text(encoding="utf-8", errors="replace"))


def broken(folder):
    """One line for each link that leads nowhere, or to another host than a reader asks for by following it."""
    folder, out = pathlib.Path(folder).resolve(), []
    for file in sorted(folder.rglob("*")):
        if file.suffix not in (".html", ".svg") or "_static" in file.parts:
            continue
        for tag, link in read(file).links:
            parts = urllib.parse.urlsplit(link)
            here = file.relative_to(folder)
            if parts.scheme in ("http", "https") or parts.netloc:
                if tag not in ("a", "area"):
                    out.append(f"{here}: <{tag}> loads {link} from the network")
                continue
            if parts.scheme in ("data", "mailto", "javascript"):
                continue
            target = (file.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else file
            if not target.is_relative_to(folder) or not target.exists() or (target.is_dir() and not (target / "index.html").exists()):
                out.append(f"{here}: the link to {link} leads nowhere")
            elif parts.fragment and target.suffix == ".html" and "report.html" != target.name and urllib.parse.unquote(parts.fragment) not in read(target).names:
                out.append(f"{here}: {target.relative_to(folder)} has no place called {parts.fragment}")
    return out


if __name__ == "__main__":
    found = broken(sys.argv[1])
    print(*found, sep="\n")
    sys.exit(bool(found))
