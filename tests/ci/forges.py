# SPDX-License-Identifier: LGPL-2.1-or-later
"""What GitHub and GitLab are told to do, as lists of jobs: one for each entry of a matrix."""
import dataclasses
import itertools
import os
import pathlib
import re
import subprocess
import tempfile

import yaml

GITHUB = (".github/workflows/check.yml", ".github/workflows/nightly.yml")
GITLAB = ".gitlab-ci.yml"


@dataclasses.dataclass
class Job:
    name: str
    image: str
    environment: dict
    script: str  # of all steps
    artifacts: list
    junit: str
    nightly: bool


def products(matrix):
    """Every choice of one value for each name."""
    lists = [value if isinstance(value, list) else [value] for value in matrix.values()]
    return [dict(zip(matrix, choice)) for choice in itertools.product(*lists)]


def filled(text, choice):
    """${{ matrix.NAME }} replaced."""
    text = re.sub(r"\$\{\{ *matrix\.(\w+) *\}\}", lambda m: str(choice[m[1]]), str(text))
    if re.search(r"\$\{\{", text):
        raise ValueError(f"what is '{text}' to be?")
    return text


def github_jobs(texts):
    """Of {path: text}. Jobs that only publish, and so have no script, are left out."""
    for text in texts.values():
        workflow = yaml.safe_load(text)
        when = workflow.get("on", workflow.get(True))  # YAML reads `on` as a truth value
        for name, job in workflow["jobs"].items():
            runs = [step["run"] for step in job["steps"] if "run" in step]
            for step in job["steps"]:
                if not ({"run", "uses"} & set(step)):
                    raise ValueError(f"{name}: a step without run or uses")
            if not runs:
                continue
            for choice in products(job.get("strategy", {}).get("matrix", {})):
                environment = {key: filled(value, choice) for key, value in job.get("env", {}).items()}
                artifacts = [filled(step["with"]["path"], choice) for step in job["steps"] if step.get("uses", "").startswith("actions/upload-")]
                yield Job(name, filled(job["container"], choice), environment, "\n".join(filled(run, choice) for run in runs), artifacts,
                          next((path for path in artifacts if path.endswith(".xml")), ""), "schedule" in when)


def gitlab_jobs(text):
    """Of the text of .gitlab-ci.yml."""
    document = yaml.safe_load(text)

    def whole(name):
        job, merged = document[name], {}
        parents = job.get("extends", [])
        for parent in [parents] if isinstance(parents, str) else parents:
            merged.update(whole(parent))
        return {**merged, **job}

    for name in document:
        if name.startswith(".") or not isinstance(document[name], dict) or "script" not in document[name]:
            continue
        job = whole(name)
        stages = document["stages"]
        if job["stage"] not in stages:
            raise ValueError(f"{name}: no stage {job['stage']}")
        rows = job.get("parallel", {}).get("matrix", [{}])
        for choice in (choice for row in rows for choice in products(row)):
            image = re.sub(r"\$(\w+)", lambda m: choice[m[1]], job.get("image", document["default"]["image"]))
            nightly = all("schedule" in rule["if"] and "!=" not in rule["if"] or rule.get("when") == "manual" for rule in job["rules"])
            artifacts = job.get("artifacts", {})
            yield Job(name, image, {key: str(value) for key, value in choice.items()}, "\n".join([*job.get("before_script", []), *job["script"]]),
                      artifacts.get("paths", []), artifacts.get("reports", {}).get("junit", ""), nightly)


RECORDER = """#!/bin/bash
{ printf '%s\\x1f' "${0##*/}" "$@"; echo; } >>"$RECORD"
"""
_started = {}


def started(job, scripts=(".ci/run", "site", "check", "run", "study")):
    """The words with which a job starts apt-get and the scripts of the repository, from running its lines where these only say so."""
    key = (job.script, *sorted(job.environment.items()))
    if key in _started:
        return _started[key]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "bin").mkdir()
        (folder / "results/site").mkdir(parents=True)
        record = folder / "record"
        record.touch()
        for script in [*scripts, "bin/apt-get"]:
            (folder / script).parent.mkdir(exist_ok=True)
            (folder / script).write_text(RECORDER)
            (folder / script).chmod(0o755)
        environment = {**os.environ, **job.environment, "PATH": f"{folder}/bin:{os.environ['PATH']}", "RECORD": str(record), "LC_ALL": "C.UTF-8"}
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", job.script], cwd=folder, env=environment, capture_output=True, text=True)
        if done.returncode:
            raise ValueError(f"{job.name}: its lines end with {done.returncode}: {done.stderr}")
        lines = record.read_text().replace(f"{folder}/", "").split("\x1f\n")[:-1]
        _started[key] = [line.split("\x1f") for line in lines]
        return _started[key]
