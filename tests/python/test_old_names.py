# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of earlier versions by the names of this one, and entries and members by their old names."""
import json
import shutil

import pytest

import chaindrive
from chaindrive import schema


@pytest.fixture
def older(simple, tmp_path):
    """The same run as an earlier version would have written it."""
    folder = tmp_path / "older"
    shutil.copytree(simple.folder, folder)
    summary = json.loads((folder / "summary.json").read_text())
    old = {now: name for name, now in schema.OLD_NAMES["summary"].items()}
    (folder / "summary.json").write_text(json.dumps({old.get(name, name): value for name, value in summary.items()}))
    lines, section = [], ""
    for line in (folder / "parameters.prm").read_text().splitlines():
        if line.strip().startswith("subsection "):
            section = line.strip().removeprefix("subsection ")
        for name, now in schema.OLD_NAMES["entries"].items():
            if now.startswith(section + "/"):
                line = line.replace(f"set {now.rpartition('/')[2]} =", f"set {name.rpartition('/')[2]} =")
        lines.append(line)
    (folder / "parameters.prm").write_text("\n".join(lines) + "\n")
    return chaindrive.open(folder)


def test_there_are_old_names():
    assert schema.OLD_NAMES["entries"] and schema.OLD_NAMES["values"] and schema.OLD_NAMES["summary"]
    for now in schema.OLD_NAMES["summary"].values():
        assert any(path == now or path.startswith(now + "/") for path in schema.SUMMARY)


def test_the_older_run_is_older(simple, older):
    for name, now in schema.OLD_NAMES["summary"].items():
        assert f'"{name}"' in (older.folder / "summary.json").read_text()
        assert f'"{now}"' in (simple.folder / "summary.json").read_text()
    for name in schema.OLD_NAMES["entries"]:
        assert f"set {name.rpartition('/')[2]} =" in (older.folder / "parameters.prm").read_text()


def test_members_have_both_names(simple, older):
    assert dict(older.summary) == dict(simple.summary)
    for run in (simple, older):
        for name, now in schema.OLD_NAMES["summary"].items():
            assert name in run.summary and now in run.summary and name not in list(run.summary)
            assert run.summary[name] == run.summary[now] == run.summary.get(name) == run.summary.get(now)
    assert simple.summary.get("nothing", 7) == 7 and "nothing" not in simple.summary
    with pytest.raises(KeyError):
        simple.summary["nothing"]


def test_entries_have_both_names(simple, older):
    assert dict(older.parameters) == dict(simple.parameters)
    for run in (simple, older):
        for name, now in schema.OLD_NAMES["entries"].items():
            assert name in run.parameters and name not in list(run.parameters)
            assert run.parameters[name] == run.parameters[now] == run.parameters.get(name) == run.parameters[name.rpartition("/")[2]]


def test_values_are_those_of_now():
    for entry, values in schema.OLD_NAMES["values"].items():
        section, _, name = entry.rpartition("/")
        for old, now in values.items():
            read = chaindrive.Parameters(f"subsection {section}\n  set {name} = {old}\nend\n")
            assert read[entry] == now
