# SPDX-License-Identifier: LGPL-2.1-or-later
"""install.py CASE BUILD: what is installed works without the sources, in an empty folder.

  prefix   cmake --install, after a build of the program alone, into a folder that is moved afterwards: plan, template, a
           short run, a study with the installed scripts, a report, manual page and completion; what is missing is named
  package  cpack -G DEB after the same: the packages name their libraries, what report and study need, and who made them,
           have a changelog, and unpacked they plan and write templates; where lintian is installed it finds nothing

`package` without dpkg-shlibdeps, and the study without Snakemake, are left out (77)."""
import json
import os
import pathlib
import re
import shutil
import sys

from program import REPOSITORY, check, start

CASE, BUILD = sys.argv[1], pathlib.Path(sys.argv[2])
os.environ.pop("PYTHONPATH", None)  # what is started finds its modules by itself
DESIGN = ("--chain", "10B", "--teeth", "21/63", "--centre", "500", "--rpm", "1450", "--kW", "3")
SHORT = ("--set", "Time/End time in ms=1", "--set", "Output/Window start in ms=0", "--set", "Output/Field interval in ms=0")


def done(*words, status=0):
    """What `words` say on standard output; the status must be `status`."""
    said = start(list(map(str, words)))
    check(said.returncode == status, f"{words}: {said}")
    return said.stdout


def packages(use):
    """Those of packaging/packages.txt."""
    rows = [line.split() for line in (REPOSITORY / "packaging/packages.txt").read_text().splitlines()]
    return [row[1] for row in rows if row and row[0] == use]


def forget_texts():
    """As after a build of the program alone, which is what ./run builds."""
    for text in ("chaindrive.1.gz", "chaindrive", "changelog.gz", "changelog.Debian.gz"):
        (BUILD / "packaging" / text).unlink(missing_ok=True)


def refuses(words, status, sentence, **environment):
    """The command says `sentence` and nothing of the sources: neither their scripts nor where they are."""
    said = start(list(map(str, words)), environment)
    check(said.returncode == status, f"{words}: {said}")
    check(sentence in said.stderr.splitlines(), f"{words}: {said.stderr}")
    for strange in ("./run", "./study", str(BUILD), str(REPOSITORY), "Traceback"):
        check(strange not in said.stdout + said.stderr, f"{words}: {strange}: {said}")


def names_packages(program):
    """Who lacks packages is told which."""
    install = "apt install --no-install-recommends "
    two = pathlib.Path("two.prm")
    two.write_text("include made.prm\nsubsection Contact\n set Friction coefficient = {0|0.1}\nend\n")
    nothing, hide = empty("nothing"), empty("hide")
    (hide / "sitecustomize.py").write_text(
        "import importlib.machinery, os\n"
        "hidden, find = os.environ['HIDDEN'].split(), importlib.machinery.PathFinder.find_spec\n"
        "importlib.machinery.PathFinder.find_spec = lambda name, *rest: None if name in hidden else find(name, *rest)\n")

    shutil.rmtree("study", ignore_errors=True)
    study = [program, "study", "two.prm", *SHORT, "--output", "study"]
    refuses(study, 3, "chaindrive: Snakemake, which runs the variants, is not installed. A study needs packages of Debian: "
            + install + " ".join(packages("study")), PATH=str(nothing))
    check(not pathlib.Path("study").exists(), "a study that cannot run has begun")
    said = start([*map(str, study), "--dry-run"], {"PATH": str(nothing)})
    check(said.returncode == 0, f"--dry-run needs no Snakemake: {said}")
    if shutil.which("/usr/bin/python3"):
        names = [name for name in packages("report") if name != "python3-plotly"]  # without which figures are still pictures
        lacks = {"PYTHONPATH": str(hide), "HIDDEN": " ".join(names).replace("python3-", "")}
        sentence = f"chaindrive: A report needs packages of Debian that are not installed: {install}{' '.join(names)}"
        refuses([program, "report", "run"], 2, sentence, **lacks)
        shutil.rmtree("reported", ignore_errors=True)
        refuses([program, "made.prm", *SHORT, "--report", "--output", "reported"], 0, sentence, **lacks)
    if shutil.which("snakemake"):
        names = [name for name in packages("study") if name not in ("snakemake", "python3-jinja2")]  # which Snakemake needs, too
        refuses(study, 3, f"chaindrive: A study needs packages of Debian that are not installed: {install}{' '.join(names)}",
                PYTHONPATH=str(hide), HIDDEN=" ".join(names).replace("python3-", ""))
        check(not list(pathlib.Path("study").glob("*/*/summary.json")), "a study that cannot end has run")


def empty(name):
    """A folder of that name with nothing in it."""
    shutil.rmtree(name, ignore_errors=True)
    folder = pathlib.Path(name).resolve()
    folder.mkdir()
    return folder


def plans_and_writes_templates(root):
    """The program below `root` with the files that came with it; returns its path."""
    program, drives = root / "bin/chaindrive", root / "share/chaindrive/prm"
    check("Drive\n" in done(program, "plan", drives / "paper/simple.prm"), "a plan without the drive")
    done(program, "plan", drives / "paper/imported-sprocket.prm")  # finds its mesh
    made = pathlib.Path("made.prm")
    made.write_text(done(program, "template", *DESIGN))
    done(program, "plan", made)
    for file in ("README.md", "copyright", "CITATION.cff", "doc/theory.md", "doc/pictures/drive.png", "prm/paper/simple.prm"):
        check((root / "share/doc/chaindrive" / file).is_file(), f"share/doc/chaindrive/{file} is not there")
    version = done(program, "--version").split()[1]
    cited = (root / "share/doc/chaindrive/CITATION.cff").read_text()
    check(f"\nversion: {version}\n" in cited, f"CITATION.cff is not that of {version}")
    return program


def completions(root, *words):
    """What bash offers for the last of `words`."""
    script = (f"source {root}/share/bash-completion/completions/chaindrive; compopt() {{ :; }}; "
              'COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _chaindrive; printf "%s\\n" "${COMPREPLY[@]}"')
    return done("bash", "-c", script, "bash", "chaindrive", *words).split()


def helps(root, program):
    """Manual page and completion have all commands and options of --help."""
    help_text = done(program, "--help")
    page = done("gzip", "-dc", root / "share/man/man1/chaindrive.1.gz")
    commands = [line.split()[0] for line in help_text.split("Commands:")[1].split("Options:")[0].splitlines() if line.strip()]
    options = [line.split()[0] for line in help_text.splitlines() if line.startswith("  --")]
    check(len(commands) >= 6 and len(options) >= 15, f"{commands} {options}")
    for word in commands + options:
        check(f"\\fB{word}\\fR".replace("-", "\\-") in page, f"the manual page lacks {word}")
    if shutil.which("groff"):
        pathlib.Path("page.1").write_text(page)
        said = start(["groff", "-man", "-ww", "-z", "-Tutf8", "page.1"])
        check(said.returncode == 0 and not said.stderr, f"groff: {said.stderr}")

    drive = pathlib.Path("a drive.prm")
    drive.write_text("")
    check(set(commands) <= set(completions(root, "")), f"commands: {completions(root, '')}")
    of_study, of_run = completions(root, "study", "--"), completions(root, "run", "--")
    check(set(of_study + of_run + sum((completions(root, c, "--") for c in commands), [])) == set(options), "not all options")
    check("--quick" in of_study and "--quick" not in of_run, "--quick belongs to studies")
    check(completions(root, "plan", "--str") == ["--strict"] and completions(root, "--completion", "") == ["bash"], "values")
    check(completions(root, "plan", "a ") == ["a", "drive.prm"], "files with blanks")
    check(completions(root, "report", "made", "mo") == ["moved"], "folders of runs")
    check("made.prm" in completions(root, "ma") and "page.1" not in completions(root, ""), "parameter files only")


def prefix():
    empty("first")
    shutil.rmtree("moved", ignore_errors=True)
    forget_texts()
    done("cmake", "--install", BUILD, "--prefix", pathlib.Path("first").resolve())
    root = pathlib.Path("first").rename("moved").resolve()
    program = plans_and_writes_templates(root)
    helps(root, program)
    done(program, "made.prm", *SHORT, "--output", "run")
    check(json.loads(pathlib.Path("run/summary.json").read_text())["steps"] > 0, "no steps")
    names_packages(program)
    if shutil.which("/usr/bin/python3") and start(["/usr/bin/python3", "-c", "import h5py, pandas"]).returncode == 0:
        style = root / "share/chaindrive/python/chaindrive/report/page.css"
        style.write_text(style.read_text() + "/* installed */")
        done(program, "report", "run")
        check("/* installed */" in pathlib.Path("run/report.html").read_text(), "a report by another package than the installed one")

    if not shutil.which("snakemake"):
        sys.exit(77)
    # scripts that are installed leave a mark: those of the sources would do, too
    snakefile = root / "share/chaindrive/scripts/study/Snakefile"
    snakefile.write_text(snakefile.read_text() + "\npathlib.Path('installed').touch()\n")
    shutil.rmtree("study", ignore_errors=True)
    done(program, "study", "two.prm", *SHORT, "--output", "study")
    check(pathlib.Path("study/installed").exists(), "the study was run by other scripts than those installed")
    check(pathlib.Path("study/study.html").exists(), "no page")


def package():
    if not shutil.which("dpkg-shlibdeps"):
        sys.exit(77)
    for old in pathlib.Path(".").glob("*.deb"):
        old.unlink()
    forget_texts()
    done("cpack", "-G", "DEB", "--config", BUILD / "CPackConfig.cmake", "-B", pathlib.Path(".").resolve())
    files = {file.name.split("_")[0]: file for file in pathlib.Path(".").glob("*.deb")}
    check(sorted(files) == ["chaindrive", "chaindrive-dev", "chaindrive-report", "chaindrive-study"], f"packages: {files}")
    file = files["chaindrive"]

    def names(name, field):
        """Packages without their versions."""
        return [word.split()[0] for word in done("dpkg-deb", "--field", files[name], field).split(",") if word.strip()]

    full_version = done("dpkg-deb", "--field", file, "Version").strip()
    depends = names("chaindrive", "Depends")
    check(any(name.startswith("libdeal.ii") for name in depends), f"Depends: {depends}")
    check(set(packages("program")) <= set(depends), f"Depends: {depends}")
    # nodes of a cluster run the program alone
    others = set(packages("report") + packages("study") + packages("check") + packages("build")) - set(packages("program"))
    check(not others & set(depends) and not names("chaindrive", "Recommends"), f"more than the program needs: {depends}")
    for use in ("dev", "report", "study"):
        name = f"chaindrive-{use}"
        check(names(name, "Depends") == ["chaindrive", *packages(use)], f"{name}: {names(name, 'Depends')}")
        check(f"chaindrive (= {full_version})" in done("dpkg-deb", "--field", files[name], "Depends"), f"{name} goes with any version")
        check(name in names("chaindrive", "Suggests"), "not suggested")
    maintainer = done("dpkg-deb", "--field", file, "Maintainer").strip()
    check(re.fullmatch(r"[^<>]+ <[^<>@ ]+@[^<>@ ]+>", maintainer), f"Maintainer: {maintainer}")
    root = empty("root")
    done("dpkg-deb", "--extract", file, root)
    documents = root / "usr/share/doc/chaindrive"
    changes = done("gzip", "-dc", documents / "changelog.Debian.gz").splitlines()
    check(changes[0] == f"chaindrive ({full_version}) unstable; urgency=medium", f"changelog: {changes[0]}")
    check(changes[-1].startswith(f" -- {maintainer}  ") and changes[-1].endswith("00:00:00 +0000"), f"changelog: {changes[-1]}")
    check(re.search(r"^Copyright: \d{4} ", (documents / "copyright").read_text(), re.MULTILINE), "no year in copyright")
    check(done("gzip", "-dc", documents / "changelog.gz") == (documents / "CHANGELOG.md").read_text(), "another changelog")
    if shutil.which("lintian"):
        said = done("lintian", "--fail-on", "none", *files.values()).splitlines()
        check(not [line for line in said if line[:2] in ("E:", "W:")], "\n".join(said))
    program = plans_and_writes_templates(root / "usr")
    version = done(program, "--version").split()[1]
    check(file.name.startswith(f"chaindrive_{version}"), f"{file.name} has the program {version}")


{"prefix": prefix, "package": package}[CASE]()
