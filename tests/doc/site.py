# SPDX-License-Identifier: LGPL-2.1-or-later
"""site.py CASE PROGRAM: the pages that ./site writes.

  pages  manual and code reference are built without a warning or a dead link
  site   all pages are there: documents, search, a page per room with pictures of its seams, a drive with its report; headless Chromium draws
         formulas and pictures, and no page is wider than a wide or a narrow window
  wrong  what is wrong in a document, a comment, the list of rooms or a picture of a seam stops the build with a sentence that names it
  links  links that lead nowhere and what would be loaded from the network are found

Without Sphinx, MyST, furo, MathJax or Doxygen all but the last end with 77, without Chromium nothing is drawn: left out."""
import html
import pathlib
import re
import shutil
import subprocess
import sys

import links
from program import check

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]

CASE, PROGRAM = sys.argv[1:3]
CHROMIUM = shutil.which("chromium")

# Says of a page, when its formulas are drawn, how wide it is and what is missing in it.
LOOK = """<script>
addEventListener("load", () => {
  const look = () => {
    const root = document.documentElement;
    root.dataset.look = [root.scrollWidth <= innerWidth + 1 ? "fits" : root.scrollWidth + " of " + innerWidth,
      [...document.images].filter(i => i.complete && !i.naturalWidth && i.loading != "lazy").map(i => i.src),
      document.querySelectorAll(".math").length, document.querySelectorAll(".math svg").length,
      document.querySelectorAll(".math .noError, .math [data-mml-node=merror], .MathJax_Error, .merror").length].join("|");
  };
  if (window.MathJax) MathJax.Hub.Queue(look); else look();
});
</script></body>"""


def build(*words, repository=REPOSITORY):
    return subprocess.run([sys.executable, "-B", repository / "doc/site/build.py", "--program", PROGRAM, *words], capture_output=True, text=True)


def needs():
    """Ends with 77 where what the pages are made with is missing."""
    done = subprocess.run([sys.executable, "-c", "import sphinx, myst_parser, furo, h5py, pandas"], capture_output=True)
    if done.returncode or not shutil.which("doxygen") or not shutil.which("dot") or not pathlib.Path("/usr/share/javascript/mathjax/MathJax.js").is_file():
        sys.exit(77)


def looked_at(page, size):
    """What LOOK says of a page in a window of this size."""
    copy = page.with_name("looked_at.html")
    text = page.read_text()
    check("</body>" in text, f"{page} has no end")
    copy.write_text(text.replace("</body>", LOOK))
    done = subprocess.run([CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=60000", f"--window-size={size}", "--dump-dom",
                           copy.resolve().as_uri()], capture_output=True, text=True, timeout=300)
    copy.unlink()
    found = re.search(r'data-look="([^"]*)"', done.stdout)
    check(found, f"{page} in {size}: Chromium says nothing of it: {done.stderr[-500:]}")
    return found[1].split("|")


def plain(text):
    """Text without elements, on one line, with straight quotes and simple dashes."""
    text = html.unescape(re.sub(r"<[^>]*>", "", re.sub(r"<(script|style)\b.*?</\1>", "", text, flags=re.DOTALL)))
    for other, usual in (("\u2018", "'"), ("\u2019", "'"), ("\u201c", '"'), ("\u201d", '"'), ("\u2013", "--"), ("\u2026", "...")):
        text = text.replace(other, usual)
    return " ".join(text.split())


def prose(text):
    """Lines of a document that are words alone: no table, no code, no formula, no mark of Markdown."""
    fenced = False
    for line in text.splitlines():
        fenced ^= line.startswith("```")
        if not fenced and len(line.split()) > 4 and not line.startswith(("    ", "|", "#")) and not re.search(r"[`*_\[\]$\\<>&]|^ *(-|\d+\.) ", line):
            yield line


def pages():
    needs()
    done = build("--output", "pages", "--drives")
    check(done.returncode == 0, f"{done.stdout}{done.stderr}")
    folder = pathlib.Path("pages")
    for page in ("index.html", "doc/theory.html", "prm/README.html", "api/group__contact.html"):
        check((folder / page).is_file(), f"there is no page {page}")
    check(links.broken(folder.resolve()) == [], "links")


def site():
    needs()
    pages = pathlib.Path("site").resolve()
    pages.mkdir(exist_ok=True)
    (pages / "old.html").write_text("")
    done = build("--output", "site", "--drives", "simple")
    check(done.returncode == 0, f"{done.stdout}{done.stderr}")
    check(not (pages / "old.html").exists(), "a page of before is left")
    check(f"Pages: {pages}/index.html" in done.stdout, done.stdout)
    for document in [*(REPOSITORY / "doc").glob("*.md"), *(REPOSITORY / "doc/validation").glob("*.md"), REPOSITORY / "CONTRIBUTING.md", REPOSITORY / "prm/README.md"]:
        page = pages / document.relative_to(REPOSITORY).with_suffix(".html")
        title = re.search(r"^# (.*)$", document.read_text(), re.MULTILINE)[1]
        check(page.is_file() and title in page.read_text(), f"{document} has no page with its title")
        check(page.relative_to(pages).as_posix() in (pages / "index.html").read_text(), f"{page} is not in the list of pages")
        shown = plain(page.read_text())
        lost = [line for line in prose(document.read_text()) if plain(line) not in shown]
        check(not lost, f"{document} has lines that its page lacks: {lost[:3]}")
    search = (pages / "searchindex.js").read_text()
    check(all(word in search for word in ("hourglass", "checkpoint", "clearanc")), "words are missing in the search")
    check(list((pages / "api/search").glob("all_*.js")), "the reference has no search")
    version = (REPOSITORY / "VERSION").read_text().strip()
    check(f"chaindrive {version}" in (pages / "index.html").read_text() and version in (pages / "api/index.html").read_text(), "the version is missing")

    import api
    import seams
    drawn = 0
    for room in api.rooms():
        text = (pages / f"api/group__{room}.html").read_text()
        expected = [name for name, seam in seams.SEAMS.items() if seam.room == room]
        check(all(f"The seam: {name}" in text for name in expected), f"{room}: a seam is missing")
        pictures = re.findall(r'(?:src|data)="(dot_inline_[^"]*\.svg)"', text)
        check(len(pictures) == len(expected), f"{room}: {len(pictures)} pictures of {len(expected)} seams")
        for name, seam, picture in ((name, seams.SEAMS[name], picture) for name, picture in zip(expected, pictures)):
            told = (pages / "api" / picture).read_text()
            for item in (item for stage in seam.stages for item in stage if isinstance(item, seams.Implementations)):
                missing = [cls for _, cls, _ in seams.derived(item.of) if f">{cls}<" not in told]
                check(not missing, f"{name}: {missing} are not in its picture")
            drawn += 1
        headers = list((REPOSITORY / "include/chaindrive" / room).rglob("*.h"))
        check(not headers or "memItemRight" in text, f"the page of the room {room} lists nothing")
    check(drawn == len(seams.SEAMS) >= 11, f"{drawn} pictures of seams")
    check("class=\"memItemLeft\"" in (pages / "api/group__bodies.html").read_text() and "BodyGroup" in (pages / "api/group__bodies.html").read_text(), "bodies")
    check("../index.html" in (pages / "api/index.html").read_text() or "../index.html" in (pages / "api/menudata.js").read_text(), "no way back to the manual")
    check("api/group__contact.html" in (pages / "reference.html").read_text(), "no way to the reference")
    check((pages / "gallery/simple/report.html").is_file() and "simple.prm" in (pages / "gallery/simple.html").read_text(), "the drive")
    check(links.broken(pages) == [], "links")

    import gallery
    report = pathlib.Path("site.work/runs/simple/report.html")
    before = report.stat().st_mtime_ns
    gallery.run("simple", PROGRAM, report.parent)
    check(report.stat().st_mtime_ns == before, "a drive was run again of which nothing has changed")

    if CHROMIUM is None:
        print("no Chromium: the pages were not looked at")
        return
    words = subprocess.run([CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=20000", "--dump-dom",
                            (pages / "search.html").as_uri() + "?q=hourglass"], capture_output=True, text=True, timeout=300)
    check(re.search(r'<a href="doc/theory.html[^"]*"[^>]*>Theory</a>', words.stdout), "a search for hourglass does not find the theory")
    for name, formulas in (("index", 0), ("doc/theory", 300), ("doc/tutorial", 0), ("prm/README", 0), ("gallery/index", 0), ("gallery/simple", 0),
                           ("reference", 0), ("api/group__contact", 0), ("api/classchaindrive_1_1BodyGroup", 0)):
        for size in ("1400,1000", "420,900"):
            fits, missing, written, shown, wrong = looked_at(pages / f"{name}.html", size)
            check(fits == "fits", f"{name} in {size}: wider than the window, {fits}")
            check(not missing, f"{name}: pictures are missing: {missing}")
            check(int(written) >= formulas and int(shown) >= int(written) and wrong == "0", f"{name}: {shown} of {written} formulas are drawn, {wrong} wrong")


def wrong():
    needs()
    copy = pathlib.Path("copy")
    shutil.rmtree(copy, ignore_errors=True)
    left_out = re.compile(r"\.git|build.*|results")
    shutil.copytree(REPOSITORY, copy, symlinks=True, ignore=lambda folder, names: [
        name for name in names if name == "__pycache__" or pathlib.Path(folder) == REPOSITORY and left_out.fullmatch(name)])

    def refused(file, old, new, words, by):
        text = (copy / file).read_text()
        check(old in text, f"{file} has no '{old}'")
        (copy / file).write_text(text.replace(old, new, 1))
        done = by()
        (copy / file).write_text(text)
        said = done.stdout + done.stderr
        check(done.returncode == 1 and "Traceback" not in said and all(word in said for word in words), f"{file}: status {done.returncode}: {said}")

    def pages():
        return build("--output", "pages", "--drives", repository=copy.resolve())

    def reference():
        code = ("import pathlib, sys, api; work = pathlib.Path('reference'); import shutil; shutil.rmtree(work, ignore_errors=True); (work / 'out').mkdir(parents=True); "
                "sys.exit(api.build(work, work / 'out', '0') or 0)")
        return subprocess.run([sys.executable, "-B", "-c", code], env={"PYTHONPATH": str(copy.resolve() / "doc/site"), "PATH": "/usr/bin:/bin"},
                              capture_output=True, text=True)

    done = reference()
    check(done.returncode == 0, f"the copy as it is: {done.stdout}{done.stderr}")
    refused("include/chaindrive/contact/family.h", "All contacts of one kind", "@nosuchcommand All contacts", ("contact/family.h", "nosuchcommand"), reference)
    refused("include/chaindrive/path/span.h", "///", "/// see @ref nowhere_at_all\n///", ("path/span.h", "nowhere_at_all"), reference)
    refused("doc/architecture.md", "| `mesh` |", "| `meshes` |", ("doc/architecture.md", "mesh", "rooms.txt"), reference)
    refused("doc/architecture.md", "| observer |", "| watcher |", ("observer", "watcher", "seams.py"), reference)
    refused("source/dynamics/newmark.cc", "void second_half", "void other_half", ("source/dynamics/newmark.cc", "second_half"), reference)
    refused("doc/theory.md", "[Geometry](#1-geometry)", "[Geometry](#no-such-place)", ("theory.md", "no-such-place"), pages)
    refused("doc/site/contents.md", "doc/cluster\n", "", ("cluster.md", "toctree"), pages)
    done = build("--drives", "nonsense")
    check(done.returncode and "nonsense" in done.stderr and "simple" in done.stderr, done.stderr)
    for words, named in ((["--quicker"], "--quicker"), (["--output"], "--output")):
        done = subprocess.run([REPOSITORY / "site", *words], capture_output=True, text=True)
        check(done.returncode == 2 and named in done.stderr and not done.stdout, f"./site {words}: {done.returncode} {done.stderr}")
    check(not pathlib.Path("pages").exists(), "pages of a build that failed are left behind")


def of_links():
    folder = pathlib.Path("pages")
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "a").mkdir(parents=True)
    (folder / "b.html").write_text('<p id="here">')
    good = '<a href="../b.html#here">b</a><a href="#top" id="top">top</a><img src="c.svg"><a href="https://www.debian.org">Debian</a><a href="mailto:a@b">post</a>'
    (folder / "a/c.svg").write_text("<svg></svg>")
    (folder / "a/a.html").write_text(good)
    check(links.broken(folder) == [], f"good links: {links.broken(folder)}")
    for bad, word in (('<a href="b.html">', "leads nowhere"), ('<a href="../b.html#there">', "there"), ('<img src="d.png">', "d.png"), ('<a href="#nowhere">', "nowhere"),
                      ('<script src="https://www.debian.org/a.js"></script>', "network"), ('<a href="../../outside.html">', "leads nowhere"),
                      ('<link rel="stylesheet" href="//www.debian.org/a.css">', "network")):
        (folder / "a/a.html").write_text(good + bad)
        links.read.cache_clear()
        found = links.broken(folder)
        check(len(found) == 1 and "a/a.html" in found[0] and word in found[0], f"{bad}: {found}")


{"pages": pages, "site": site, "wrong": wrong, "links": of_links}[CASE]()
