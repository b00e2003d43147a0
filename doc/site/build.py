# SPDX-License-Identifier: LGPL-2.1-or-later
"""Builds the manual, the reference of the code and the gallery as pages: ./site calls it."""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import api
import gallery
import links

HERE = pathlib.Path(__file__).resolve().parent
REPOSITORY = HERE.parents[1]
MATHJAX = pathlib.Path("/usr/share/javascript/mathjax")
NOT_STAGED = re.compile(r"\.git|build.*|results")  # what building and running leave behind, and history


def say(text):
    print(f"== {text}", flush=True)


def fail(text):
    sys.exit(f"site: {text}")


def formulas(static):
    """What MathJax needs to draw formulas as pictures."""
    if not (MATHJAX / "MathJax.js").is_file():
        fail(f"formulas need {MATHJAX}/MathJax.js; Debian's libjs-mathjax has it")
    target = static / "mathjax"
    for name in ("MathJax.js", "config/TeX-AMS_SVG.js", "extensions", "jax/element", "jax/input/TeX", "jax/output/SVG/fonts/TeX", "jax/output/SVG/autoload",
                 "jax/output/SVG/config.js", "jax/output/SVG/jax.js"):
        source = MATHJAX / name
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        (shutil.copytree if source.is_dir() else shutil.copy)(source, target / name)


def manual(work, pages, output, extra, with_gallery):
    """Sphinx: warnings are errors."""
    contents = (HERE / "contents.md").read_text()
    if not with_gallery:
        contents = contents.replace("gallery/index\n", "")
    (work / "contents.md").write_text(contents)
    command = [sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-b", "html", "-c", str(HERE), "-d", str(work / "doctrees"),
               "-D", f"html_extra_path={extra}", str(pages), str(output)]
    done = subprocess.run(command, env={**os.environ, "CHAINDRIVE_CONTENTS": str(work / "contents.md")}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True)
    if done.returncode:
        said = done.stdout.replace(f"{pages}/index.md", "README.md").replace(f"{pages}/", "")
        fail(f"Sphinx found something wrong:\n{said}")
    formulas(output / "_static")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=pathlib.Path, default=REPOSITORY / "build/site")
    parser.add_argument("--program", type=pathlib.Path, default=REPOSITORY / "build/source/chaindrive")
    parser.add_argument("--drives", nargs="*", default=list(gallery.DRIVES), help="of the gallery; none: without a gallery")
    arguments = parser.parse_args()
    for name in arguments.drives:
        if name not in gallery.DRIVES:
            fail(f"--drives: '{name}' is none of {', '.join(gallery.DRIVES)}")
    version = (REPOSITORY / "VERSION").read_text().strip()
    began, output = time.monotonic(), arguments.output.resolve()
    work = output.with_name(output.name + ".work")
    for name in ("pages", "api", "extra", "doctrees", "new"):
        shutil.rmtree(work / name, ignore_errors=True)
    pages, extra, new = work / "pages", work / "extra", work / "new"
    for folder in (pages, extra, new):
        folder.mkdir(parents=True)

    # Sphinx reads a folder that has all where it is in the repository, and the pages that are made here.
    for entry in REPOSITORY.iterdir():
        if not NOT_STAGED.fullmatch(entry.name):
            (pages / entry.name).symlink_to(entry)
    (pages / "index.md").write_text("")  # conf.py reads the README in its place
    (pages / "reference.md").write_text(api.reference())

    if arguments.drives:
        gallery.build(arguments.drives, arguments.program, work / "runs", pages / "gallery", extra, say)
    say("the manual, by Sphinx")
    manual(work, pages, new, extra, bool(arguments.drives))
    say("the reference of the code, by Doxygen")
    complaints = api.build(work, new, version)
    if complaints:
        fail(f"Doxygen found something wrong:\n{complaints}")
    say("links")
    found = links.broken(new)
    if found:
        fail("\n".join(["these links lead nowhere:", *found[:40]]))
    shutil.rmtree(output, ignore_errors=True)
    new.rename(output)
    print(f"Pages: {output}/index.html")
    print(f"{sum(1 for _ in output.rglob('*.html'))} pages, {sum(f.stat().st_size for f in output.rglob('*') if f.is_file()) / 1e6:.0f} MB, "
          f"{time.monotonic() - began:.0f} s")


if __name__ == "__main__":
    main()
