# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sphinx: the documents of the repository as pages. build.py calls it on a folder that holds them."""
import os
import pathlib
import re

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
CONTENTS = pathlib.Path(os.environ["CHAINDRIVE_CONTENTS"])  # the lists of pages, for the start page

project = "chaindrive"
copyright = "the chaindrive developers, LGPL 2.1 or later"  # the name that Sphinx asks for
version = release = (REPOSITORY / "VERSION").read_text().strip()
language = "en"

extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath", "tasklist"]
myst_heading_anchors = 4
myst_disable_syntax = ["myst_line_comment", "myst_block_break", "myst_target"]  # documents are plain Markdown: % begins no comment
myst_update_mathjax = False
root_doc = "index"
include_patterns = ["*.md", "doc/*.md", "doc/plugin-example/*.md", "doc/validation/*.md", "prm/**.md", "python/*.md", "scripts/*.md", "gallery/*.md"]
exclude_patterns = ["README.md"]  # the start page has its text
suppress_warnings = ["myst.header"]  # a document may begin a list of questions below a smaller heading
highlight_language = "none"

# Formulas are drawn by the MathJax that Debian has, which build.py copies beside the pages: as pictures
# without fonts, so that they are right where there is no network and no server.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {"messageStyle": "none", "showMathMenu": False, "SVG": {"font": "TeX", "linebreaks": {"automatic": True}},
                   "tex2jax": {"inlineMath": [["\\(", "\\)"]], "displayMath": [["\\[", "\\]"]], "processClass": "math", "ignoreClass": "document"}}

html_theme = "furo"
html_title = f"chaindrive {version}"
html_static_path = [str(pathlib.Path(__file__).parent / "static")]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
html_last_updated_fmt = None
html_theme_options = {"navigation_with_keys": True}


def read(app, docname, source):
    """The start page is the README with the lists of pages; who links to the README means that page."""
    if docname == app.config.root_doc:
        source[0] = (REPOSITORY / "README.md").read_text() + "\n" + CONTENTS.read_text()
        return
    up = "../" * docname.count("/")
    source[0] = source[0].replace(f"]({up}README.md", f"]({up}index.md")


def keep_together(app, pagename, templatename, context, doctree):
    """No line begins with the comma behind a formula, nor ends with the bracket before it."""
    if "body" in context:
        context["body"] = re.sub(r'(\(?)(<span class="math notranslate nohighlight">[^<]*</span>)([-,.;:)\]\u2019]*)',
                                 lambda m: f'<span class="together">{m[0]}</span>' if m[1] or m[3] else m[0], context["body"])


def setup(app):
    app.connect("html-page-context", keep_together)
    app.connect("source-read", read)
