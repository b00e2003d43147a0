# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.py DIRECTORY [--pictures FOLDER]: writes the results of a study: table.csv and table.h5, chart.png and .svg,
study.md and study.html. Unfinished runs are rows without values, and so are variants whose chain jumped, or whose
window means are meaningless for another reason: the first line of output says how many. Needs
python3-h5py, python3-matplotlib, python3-pandas and python3-jinja2.

--pictures FOLDER also writes a small chart of DIRECTORY there, and prints the table in Markdown for a document."""
import argparse
import csv
import json
import pathlib
import sys

import h5py
import numpy as np

import outputs
import page
import stats
import sweep

FIGURES = {"steps": "steps", "memory": "memory_peak", "wall": "wall_seconds"}  # of summary.json


UNREADABLE = (outputs.chaindrive.RunError, ValueError, TypeError, LookupError, ArithmeticError, AttributeError, RuntimeError, OSError)


def number(value):
    """A figure of a summary; nan for none."""
    return np.nan if value is None else float(value)


def read_run(folder, names):
    """{"status", "error", "invalid", "figures": {column: value}, "cpu": {phase: s}, "values": {output: value}} of a run.
    Status is none while it has not ended, or when its files cannot be read; invalid: it has ended, and means over its
    window tell nothing, for which `error` has the reasons: then there are no figures and values."""
    run = {**outputs.end_of_run(folder), "invalid": False}
    if run["status"] == 0:
        try:
            opened = outputs.chaindrive.open(folder)
            run["cpu"] = {outputs.sentence(phase): number(seconds) for phase, seconds in opened.summary["cpu_seconds"].items()}
            if opened.window_is_valid is False:
                faults = outputs.sentence(" ".join(opened.window_faults))
                return {**run, "invalid": True, "error": faults or "Its window is not valid."}
            run["figures"] = {column: number(opened.summary.get(name)) for column, name in FIGURES.items()}
            run["values"] = outputs.of_run(folder, names)
        except UNREADABLE as error:
            return {"status": None, "error": outputs.sentence(f"its results cannot be read: {error}"), "invalid": False}
    return run


def mean(dictionaries):
    """Means of members over dictionaries that have them."""
    names = dict.fromkeys(name for dictionary in dictionaries for name in dictionary)
    return {name: float(np.mean([d[name] for d in dictionaries if name in d])) for name in names}


class Study:
    """Everything known of a study: `variants`, each with its runs and the row of the table."""

    def __init__(self, directory):
        self.directory = pathlib.Path(directory)
        self.about = json.loads((self.directory / "study.json").read_text())
        self.variants = self.about["variants"]
        for variant in self.variants:
            variant["results"] = {run["phase"]: read_run(self.directory / run["folder"], self.about["outputs"])
                                  for run in variant["runs"]}
        found = (run["values"] for v in self.variants for run in v["results"].values() if "values" in run)
        self.columns = self._in_order(dict.fromkeys(name for values in found for name in values))
        for variant in self.variants:
            variant["row"] = self._row(variant)
        for column in self.columns:
            front = stats.efficient([(v["row"]["cpu"], abs(v["row"][f"{column} error"])) for v in self.variants])
            for variant, on_front in zip(self.variants, front):
                variant["row"][f"{column} efficient"] = on_front

    def _in_order(self, columns):
        """Bands of a spectrum behind each other."""
        return [column for name in self.about["outputs"]
                for column in columns if column == name or column.startswith(name + " ")]

    @property
    def reference(self):
        return next(v for v in self.variants if v["name"] == self.about["reference"])

    @staticmethod
    def done(variant):
        """{phase: run} of the runs that the figures of a variant are made of. None of a variant with a run whose window is
        not valid: a chain that jumps from some start phases jumps, and means over the others would hide it."""
        if any(run["invalid"] for run in variant["results"].values()):
            return {}
        return {phase: run for phase, run in variant["results"].items() if "values" in run}

    @property
    def invalid(self):
        """The variants with a run whose window is not valid."""
        return [v for v in self.variants if v["row"]["not valid"]]

    def shortfall(self):
        """How many variants have no figures, or not all, in a sentence; empty if there are none."""
        failed = [v for v in self.variants if v["row"]["failed"] and not v["row"]["not valid"]]
        parts = [f"{len(self.invalid)} of {len(self.variants)} variants {'has' if len(self.invalid) == 1 else 'have'} no figures: means over their "
                 "window are not valid"] if self.invalid else []
        parts += [f"{len(failed)} of {len(self.variants)} variants {'has' if len(failed) == 1 else 'have'} runs that failed or are not finished"] if failed else []
        return "; ".join(parts) + "." if parts else ""

    def _row(self, variant):
        done, all_done = self.done(variant), self.done(self.reference)
        runs = list(variant["results"].values())
        row = {"variant": variant["name"], "ranks": variant["ranks"], "runs": len(done), "failed": sum(run["status"] != 0 for run in runs),
               "not valid": sum(run["invalid"] for run in runs), "message": self._message(runs),
               "cpu": np.nan, **dict.fromkeys(FIGURES, np.nan)}
        cpu = mean([run["cpu"] for run in done.values()])
        row["cpu"] = cpu.pop("total", np.nan)
        row.update(mean([run["figures"] for run in done.values()]))
        row.update({f"cpu {phase}": seconds for phase, seconds in cpu.items()})
        for column in self.columns:
            values = {phase: run["values"].get(column, np.nan) for phase, run in done.items()}
            row[column], row[f"{column} low"], row[f"{column} high"] = stats.mean_interval(list(values.values()))
            both = [phase for phase in values if phase in all_done]
            row[f"{column} error"], row[f"{column} error low"], row[f"{column} error high"] = stats.error_interval(
                [values[phase] for phase in both], [all_done[phase]["values"].get(column, np.nan) for phase in both])
        return row

    @staticmethod
    def _message(runs):
        """What is wrong with runs; a window that is not valid first."""
        faults = [run["error"] for run in runs if run["invalid"]]
        where = f" (not valid in {len(faults)} of {len(runs)} runs)" if len(runs) > 1 else ""
        texts = [f"{faults[0]}{where}"] if faults else []
        return "; ".join(dict.fromkeys([*texts, *(run["error"] for run in runs if run["status"] != 0)]))

    def fields(self):
        """Names of all columns of the table, those of any row."""
        names = dict.fromkeys(name for variant in self.variants for name in variant["row"])
        phases = [name for name in names if name.startswith("cpu ")]
        first = list(dict.fromkeys(["variant", "ranks", "runs", "failed", "not valid", "message", "cpu", *phases]))
        return first + [name for name in names if name not in first]

    def value(self, name, variant):
        """In a column of the table; what a variant has not computed has cost it nothing."""
        return variant["row"].get(name, 0. if name.startswith("cpu ") and variant["row"]["runs"] else np.nan)

    def write_csv(self, file):
        with open(file, "w", newline="", encoding="utf-8") as out:
            writer = csv.writer(out, lineterminator="\n")
            writer.writerow(self.fields())
            writer.writerows([self.value(name, variant) for name in self.fields()] for variant in self.variants)

    def write_hdf5(self, file):
        """A dataset per column of the table; group `by_phase` has the outputs of single runs."""
        with h5py.File(file, "w") as out:
            out.attrs.update({key: self.about[key] for key in ("title", "file", "reference", "version", "quick")})
            for name in self.fields():
                values = [self.value(name, variant) for variant in self.variants]
                text = any(isinstance(value, str) for value in values)
                out.create_dataset(name, data=values, dtype=h5py.string_dtype() if text else None)
            for variant in self.variants:
                group = out.create_group("by_phase/" + variant["name"])
                group["phase"] = list(variant["results"])
                for column in self.columns:
                    group[column] = [run.get("values", {}).get(column, np.nan) for run in variant["results"].values()]
                group["cpu"] = [run.get("cpu", {}).get("total", np.nan) for run in variant["results"].values()]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--pictures", type=pathlib.Path, metavar="FOLDER")
    words = parser.parse_args()
    study = Study(words.directory)
    if study.shortfall():
        print(study.shortfall(), file=sys.stderr if words.pictures else sys.stdout, flush=True)
    if words.pictures:
        name = words.directory.resolve().name
        page.draw_all(study, words.pictures, f"study-{name}", "png", dpi=72)
        tables = sweep.tables(sweep.Sweep(study), page.heading, page.number) if study.about.get("against") else []
        print("\n\n".join(page.markdown(*table) for table in tables) or page.table(study))
        return
    study.write_csv(words.directory / "table.csv")
    study.write_hdf5(words.directory / "table.h5")
    page.draw_all(study, words.directory, kind="png", dpi=110)
    page.write(study, words.directory)


if __name__ == "__main__":
    main()
