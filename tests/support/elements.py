# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a browser would make of a page."""
import html.parser


class Elements(html.parser.HTMLParser):
    """`found`: all elements of a page, as (tag, attributes)."""

    def __init__(self, page):
        super().__init__()
        self.found = []
        self.feed(page)

    def handle_starttag(self, tag, attributes):
        self.found.append((tag, attributes))
