# SPDX-License-Identifier: LGPL-2.1-or-later
"""install.py CASE BUILD: what is installed works without the sources, in an empty folder.

  prefix   cmake --install into a folder that is moved afterwards: plan, template, a short run, a study with the installed
           scripts, a report, manual page and completion
  package  cpack -G DEB: the package names its libraries and who made it, has a changelog, and unpacked it plans and
           writes templates; where lintian is installed it finds no error

`package` without dpkg-shlibdeps, and the study without Snakemake, are left out (77)."""
import json
import os
import pathlib
import re
import shutil
import sys

from program import check, start

CASE, BUILD = sys.argv[1], pathlib.Path(sys.argv[2])
os.environ.pop("PYTHONPATH", None)  # what is started finds its modules by itself
DESIGN = ("--chain", "10B", "--teeth", "21/63", "--centre", "500", "--rpm", "1450", "--kW", "3")
SHORT = ("--set", "Time/End time in ms=1", "--set", "Output/Window start in ms=0", "--set", "Output/Field interval in ms=0")


def done(*words, status=0):
    """What `words` say on standard output; the status must be `status`."""
    said = start(list(map(str, words)))
    check(said.returncode == status, f"{words}: {said}")
    return said.stdout


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
    for text in ("chaindrive.1.gz", "chaindrive"):  # as after a build of the program alone
        (BUILD / "packaging" / text).unlink(missing_ok=True)
    done("cmake", "--install", BUILD, "--prefix", pathlib.Path("first").resolve())
    root = pathlib.Path("first").rename("moved").resolve()
    program = plans_and_writes_templates(root)
    helps(root, program)
    done(program, "made.prm", *SHORT, "--output", "run")
    check(json.loads(pathlib.Path("run/summary.json").read_text())["steps"] > 0, "no steps")
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
    pathlib.Path("two.prm").write_text("include made.prm\nsubsection Contact\n set Friction coefficient = {0|0.1}\nend\n")
    done(program, "study", "two.prm", *SHORT, "--output", "study")
    check(pathlib.Path("study/installed").exists(), "the study was run by other scripts than those installed")
    check(pathlib.Path("study/study.html").exists(), "no page")


def package():
    if not shutil.which("dpkg-shlibdeps"):
        sys.exit(77)
    for old in pathlib.Path(".").glob("*.deb"):
        old.unlink()
    done("cpack", "-G", "DEB", "--config", BUILD / "CPackConfig.cmake", "-B", pathlib.Path(".").resolve())
    file, = pathlib.Path(".").glob("*.deb")
    depends = done("dpkg-deb", "--field", file, "Depends")
    check("libdeal.ii" in depends and "libboost-program-options" in depends, f"Depends: {depends}")
    check("python3" in [word.split()[0] for word in depends.split(",")], f"Depends: {depends}")
    recommends = done("dpkg-deb", "--field", file, "Recommends")
    check("snakemake" in recommends and "openmpi-bin" in recommends, f"Recommends: {recommends}")
    names = [word.strip() for word in recommends.split(",")]
    check(len(set(names)) == len(names), f"Recommends: {recommends}")
    maintainer = done("dpkg-deb", "--field", file, "Maintainer").strip()
    check(re.fullmatch(r"[^<>]+ <[^<>@ ]+@[^<>@ ]+>", maintainer), f"Maintainer: {maintainer}")
    root = empty("root")
    done("dpkg-deb", "--extract", file, root)
    documents = root / "usr/share/doc/chaindrive"
    changes = done("gzip", "-dc", documents / "changelog.Debian.gz").splitlines()
    full_version = done("dpkg-deb", "--field", file, "Version").strip()
    check(changes[0] == f"chaindrive ({full_version}) unstable; urgency=medium", f"changelog: {changes[0]}")
    check(changes[-1].startswith(f" -- {maintainer}  ") and changes[-1].endswith("00:00:00 +0000"), f"changelog: {changes[-1]}")
    check(re.search(r"^Copyright: \d{4} ", (documents / "copyright").read_text(), re.MULTILINE), "no year in copyright")
    if shutil.which("lintian"):
        said = done("lintian", "--fail-on", "none", file).splitlines()
        # whoever publishes the package gives an address that exists: DEBFULLNAME, DEBEMAIL
        wrong = [line for line in said if line.startswith("E:") and "bogus-mail-host" not in line]
        check(not wrong, "\n".join(wrong))
    program = plans_and_writes_templates(root / "usr")
    version = done(program, "--version").split()[1]
    check(file.name.startswith(f"chaindrive_{version}"), f"{file.name} has the program {version}")


{"prefix": prefix, "package": package}[CASE]()
