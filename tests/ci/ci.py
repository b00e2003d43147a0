# SPDX-License-Identifier: LGPL-2.1-or-later
"""ci.py CASE CTEST: what forges are told to do, and what is done before a commit.

  forges  both forges do the same: the tests on Debian 12 and 13 with both compilers, a Debug build, at night all tests and sanitizers, the pages;
          every script and option that they call exists, and what they keep is what was written
  wrong   changes of these files that would leave something out, or call what is not there, are found
  typed   what is mistyped after ./run, ./study and ./check is refused before anything is installed or built
  printed ./run and ./study print what they install and build on standard error, and nothing when there is nothing to do
  habits  presets, hooks before a commit, templates and the development container name what exists

Without PyYAML all end with 77."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

try:
    import yaml
except ModuleNotFoundError:
    sys.exit(77)
import forges
import style

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
CASE, CTEST = sys.argv[1:3]


def check(condition, message):
    if not condition:
        sys.exit(message)


def read(*names):
    return {name: (REPOSITORY / name).read_text() for name in names}


def options_of(script, known={}):
    """What SCRIPT --help tells of; ./check also takes those of ctest, of which one is of use here."""
    if script not in known:
        path = REPOSITORY / script
        if not path.is_file() or not os.access(path, os.X_OK):
            raise ValueError(f"there is no script {script}")
        known[script] = set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", subprocess.run([path, "--help"], capture_output=True, text=True, check=True).stdout))
        if script in (".ci/run", "check"):
            known[script] |= {"--output-junit"} & set(subprocess.run([CTEST, "--help"], capture_output=True, text=True, check=True).stdout.split())
    return known[script]


def faults(jobs):
    """What is wrong with the jobs of one forge, one line each."""
    out, tests, debug, night, pages = [], set(), False, {"--sanitize": set(), "--all": set()}, False
    for job in jobs:
        if job.image not in ("debian:12", "debian:13"):
            out.append(f"{job.name}: the image {job.image}")
        try:
            calls = forges.started(job)
        except ValueError as error:
            out.append(str(error))
            continue
        for script, *words in calls:
            if script == "apt-get":
                out += [f"{job.name}: apt-get of {word}" for word in words if not word.startswith("-") and word not in
                        ("update", "install", "git", "ca-certificates", "g++", "clang")]
                continue
            path = ".ci/run" if script == "run" else script
            try:
                out += [f"{job.name}: {path} has no option {word}" for word in words if word.startswith("--") and word not in options_of(path)]
            except ValueError as error:
                out.append(f"{job.name}: {error}")
            if script == "site":
                pages = True
                if words[1:] != job.artifacts:
                    out.append(f"{job.name}: pages go to {words[1:]}, and {job.artifacts} are kept")
                continue
            if words[-2:] != ["--output-junit", job.junit] or job.junit not in job.artifacts:
                out.append(f"{job.name}: the results are in {words[-1:]}, and {job.artifacts} are kept")
            for option in night.keys() & set(words):
                if not job.nightly:
                    out.append(f"{job.name}: {option} is for the night")
                night[option].add(job.image)
            if night.keys() & set(words) or job.nightly:
                continue
            elif "--debug" in words:
                debug = True
            elif "--quick" not in words:
                tests.add((job.image, job.environment.get("CXX")))
    for image in ("debian:12", "debian:13"):
        out += [f"no tests on {image} with {compiler}" for compiler in ("g++", "clang++") if (image, compiler) not in tests]
        out += [f"no {option} on {image}" for option, images in night.items() if image not in images]
    return out + ([] if debug else ["no Debug build"]) + ([] if pages else ["no pages"])


def all_faults(texts):
    """Of both forges."""
    github = list(forges.github_jobs({name: texts[name] for name in forges.GITHUB}))
    gitlab = [job for job in forges.gitlab_jobs(texts[forges.GITLAB]) if job.name != "pages"]
    return [f"GitHub: {fault}" for fault in faults(github)] + [f"GitLab: {fault}" for fault in faults(gitlab)]


def of_forges():
    found = all_faults(read(*forges.GITHUB, forges.GITLAB))
    check(not found, "\n".join(found))
    pages = next(job for job in forges.gitlab_jobs((REPOSITORY / forges.GITLAB).read_text()) if job.name == "pages")
    check(pages.script == "mv results/site public" and pages.artifacts == ["public"], "GitLab publishes the folder `public` of a job `pages`")


def wrong():
    texts = read(*forges.GITHUB, forges.GITLAB)
    night = forges.GITHUB[1]
    for name, old, new, word in (
            (forges.GITHUB[0], "debian: [12, 13]", "debian: [12]", "debian:13 with g++"), (forges.GITHUB[0], "[g++, clang++]", "[g++]", "with clang++"),
            (forges.GITHUB[0], "--debug --quick", "--quick", "no Debug"), (forges.GITHUB[0], ".ci/run --output", ".ci/runs --output", "runs"),
            (forges.GITHUB[0], "--debug", "--debugging", "--debugging"), (forges.GITHUB[0], "path: results/ctest.xml", "path: results/tests.xml", "are kept"),
            (forges.GITHUB[0], "./site --output results/site", "./site --output results/pages", "are kept"),
            (forges.GITHUB[0], "mkdir -p results\n", "if true\n", "syntax error"), (forges.GITHUB[0], "git ca-certificates", "git ca-certificate", "ca-certificate"),
            (night, "debian: [12, 13]", "debian: [13]", "no --sanitize on debian:12"), (night, "schedule:\n    - cron: \"17 2 * * *\"\n", "push:\n", "night"),
            (night, "--sanitize", "", "no --sanitize"), (night, "--all", "", "no --all"),
            (forges.GITLAB, 'DEBIAN: ["12", "13"]\n        CXX', 'DEBIAN: ["13"]\n        CXX', "debian:12 with"),
            (forges.GITLAB, "--output-junit", "--junit", "--junit"), (forges.GITLAB, "junit: results/ctest.xml", "junit: results/a.xml", "are kept"),
            (forges.GITLAB, "--debug", "", "no Debug"), (forges.GITLAB, "./site --output results/site", "echo none", "no pages")):
        check(old in texts[name], f"{name} has no '{old}'")
        found = all_faults({**texts, name: texts[name].replace(old, new)})
        check(any(word in fault for fault in found), f"{name} with '{new}' instead of '{old}': {found}")


def habits():
    presets = json.loads((REPOSITORY / "CMakePresets.json").read_text())
    options = set(re.findall(r"option\((\w+)", (REPOSITORY / "CMakeLists.txt").read_text()))
    for preset in presets["configurePresets"]:
        unknown = [name for name in preset.get("cacheVariables", {}) if name.startswith("CHAINDRIVE_") and name not in options]
        check(not unknown, f"CMakePresets.json: {preset['name']} sets {unknown}")
        check(preset.get("hidden") or re.fullmatch(r"\$\{sourceDir\}/build(-\w+)?", preset["binaryDir"]), f"CMakePresets.json: {preset['name']} builds elsewhere")
    listed = subprocess.run([CTEST.replace("ctest", "cmake"), "--list-presets"], cwd=REPOSITORY, capture_output=True, text=True)
    check(listed.returncode == 0, listed.stderr)
    for name in ("release", "debug", "sanitize", "clang"):
        check(f'"{name}"' in listed.stdout, f"CMake knows no preset {name}: {listed.stdout}")

    hooks = yaml.safe_load((REPOSITORY / ".pre-commit-config.yaml").read_text())
    for repo in hooks["repos"]:
        check(repo["repo"] == "local", f".pre-commit-config.yaml fetches {repo['repo']}")
        for hook in repo["hooks"]:
            check(hook["language"] == "system", f"{hook['id']} would be installed from elsewhere")
            for word in (word for word in hook["entry"].split() if "/" in word and not word.startswith(("-", "/"))):
                check((REPOSITORY / word).is_file(), f"{hook['id']}: there is no {word}")
    rules = [hook["args"][0] for hook in hooks["repos"][0]["hooks"] if "tests/style/style.py" in hook["entry"]]
    check(set(rules) == set(style.rules.RULES), f"before a commit {sorted(set(style.rules.RULES) ^ set(rules))} are checked here or there alone")

    for folder in (".github/ISSUE_TEMPLATE", ".gitlab/issue_templates"):
        for file in (REPOSITORY / folder).iterdir():
            if file.suffix == ".yml":
                yaml.safe_load(file.read_text())
        wrong_result = next((REPOSITORY / folder).glob("[Bb]ug.*")).read_text()
        check(all(word in wrong_result for word in (".prm", "log.txt", "--version")), f"{folder} does not ask for .prm, log.txt and --version")
    container = json.loads((REPOSITORY / ".devcontainer/devcontainer.json").read_text())
    build = container["build"]
    file = (REPOSITORY / ".devcontainer" / build["dockerfile"]).resolve()
    check(file.is_file(), f"the development container is built from {build['dockerfile']}, which is not there")
    check(re.search(rf"^FROM \S+ AS {build['target']}$", file.read_text(), re.MULTILINE), f"{file.name} has no stage {build['target']}")
    lines = container["postCreateCommand"]
    check(subprocess.run(["bash", "-n", "-c", lines]).returncode == 0, "postCreateCommand of the development container is no shell script")
    used = set(re.findall(r"\$\{(\w+)_packages\[@\]\}", lines))
    uses = {line.split()[0] for line in (REPOSITORY / "packaging/packages.txt").read_text().splitlines() if line and not line.startswith("#")}
    check(used and used <= uses, f"the development container asks for packages of {sorted(used - uses)}")
    version = (REPOSITORY / "VERSION").read_text().strip()
    check(f"\nversion: {version}\n" in (REPOSITORY / "CITATION.cff").read_text(), f"CITATION.cff is not of version {version}")
    check("\n## [Unreleased]\n" in (REPOSITORY / "CHANGELOG.md").read_text(), "CHANGELOG.md has no [Unreleased]")


def typed():
    with tempfile.TemporaryDirectory() as folder:  # without .ci/setup.sh, which is the first thing that scripts ask for
        for script in ("run", "study", "check"):
            shutil.copy(REPOSITORY / script, folder)
        pathlib.Path(folder, "my.prm").touch()
        path = os.pathsep.join((str(pathlib.Path(CTEST).parent), os.environ["PATH"]))
        for line, said in (
                ("./run mine.prm", "no parameter file 'mine.prm'"), ("./run plan mine.prm --set Time/a=b", "no parameter file 'mine.prm'"),
                ("./run -n 2 my.prm mine.prm", "no parameter file 'mine.prm'"), ("./run my.prm", "setup.sh"), ("./run -n 100000 my.prm", "at most"), ("./run -n 18446744073709551617 my.prm", "at most"),
                ("./run -n 0 my.prm", "a number of processes"), ("./run -n 3 my.prm", "setup.sh"), ("./run plan my.prm --picture new.prm", "setup.sh"),
                ("./study mine.prm --quick", "no parameter file 'mine.prm'"), ("./study -j 2 my.prm", "setup.sh"),
                ("./check contact", "-R '^contact'"), ("./check --quick contact", "-R '^contact'"), ("./check -R files contact", "-R '^contact'"),
                ("./check --fast", "option --fast"), ("./check -R files -j 2 --timeout=3 --output-junit file", "setup.sh"), ("./check --debug --quick", "setup.sh")):
            done = subprocess.run(line.split(), cwd=folder, capture_output=True, text=True, env={**os.environ, "PATH": path})
            check(said in done.stderr and done.returncode == (1 if said == "setup.sh" else 2), f"{line} ends with {done.returncode} and says: {done.stderr}")


def printed():
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)

        def tool(name, text):
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f"#!/bin/sh\n{text}\n")
            path.chmod(0o755)

        for name in ("run", "study", ".ci/setup.sh", "packaging/packages.txt"):
            (folder / name).parent.mkdir(exist_ok=True)
            shutil.copy(REPOSITORY / name, folder / name)
        tool("build/source/chaindrive", 'echo "the program $@"')
        (folder / "build/build.ninja").touch()
        tool("bin/dpkg-query", 'printf "installed %s\\n" "$@"')
        tool("bin/sudo", 'shift; exec "$@"')
        tool("bin/apt-get", "echo apt-get")
        globs = "echo \"ninja: Entering directory 'build'\"; echo '[0/2] Re-checking globbed directories...'"

        def call(*words, status=0):
            done = subprocess.run(words, cwd=folder, text=True, capture_output=True, env={**os.environ, "PATH": f"{folder}/bin:{os.environ['PATH']}"})
            check(done.returncode == status, f"{words} ends with {done.returncode}: {done.stderr}")
            check(done.stdout == ("" if status else f"the program {' '.join(word for word in words if word != './run').replace('./study', 'study')}\n"), f"{words} prints {done.stdout}")
            return done.stderr

        for words in (("./run", "template"), ("./run", "report", "results"), ("./study", "--help-of-it")):
            tool("bin/ninja", f"{globs}; echo 'ninja: no work to do.'")
            said = call(*words)
            check(said == "", f"nothing is to do, but {words} says: {said}")
            tool("bin/ninja", f"{globs}; echo '[1/2] compile'; echo '[2/2] link'")
            said = call(*words)
            check(said == "== building\n[1/2] compile\n[2/2] link\n", f"{words} says of a build: {said}")
            tool("bin/ninja", f"{globs}; echo 'FAILED: an object'; exit 1")
            check("FAILED: an object" in call(*words, status=1), f"{words} does not say what fails")
        tool("bin/ninja", f"{globs}; echo 'ninja: no work to do.'")
        tool("bin/dpkg-query", "true")
        said = call("./run", "template")
        check("== installing" in said and "apt-get" in said, f"./run does not say that it installs packages: {said}")


{"forges": of_forges, "wrong": wrong, "habits": habits, "typed": typed, "printed": printed}[CASE]()
