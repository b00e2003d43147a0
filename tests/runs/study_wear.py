# SPDX-License-Identifier: LGPL-2.1-or-later
"""study_wear.py PROGRAM REPOSITORY: a study of wear, in an empty folder: hours are the integral of the rates of its runs, with
intervals over phases; its page has them and the chart.

Without Snakemake, h5py, matplotlib or pandas it ends with 77: left out."""
import csv
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys

from program import check
from small_drives import STUDY_OF_RIGID

if shutil.which("snakemake") is None:
    sys.exit(77)
try:
    import numpy as np
    import report
    import sweep
    import wear
except ModuleNotFoundError as error:
    if error.name not in ("h5py", "jinja2", "matplotlib", "numpy", "pandas", "PIL"):
        raise
    sys.exit(77)

PROGRAM, REPOSITORY = sys.argv[1], pathlib.Path(sys.argv[2])
os.environ.pop("PYTHONPATH", None)  # what is started finds its modules by itself

STUDY = STUDY_OF_RIGID + """
subsection Study
  set Outputs = wear_rate, plate_safety, roller_life
  set Against = Drive/Chain/Elongation in percent
  set Phases  = 4
end
subsection Drive
  subsection Chain
    set Elongation in percent = {0 | 1 | 2}
  end
end
subsection Contact
  set Friction coefficient = 0.1
end
"""


def close(a, b, tolerance, what):
    check(abs(a - b) <= tolerance, f"{what}: {a}, not {b}")


# rates that are straight lines, by quadrature with many strips; and the elongation is that of the new chain
elongations, rates = [0., 0.01, 0.03], [1e-9, 2e-9, 2e-9]
fine = (np.arange(300000) + 0.5) * 1e-7
growing = np.interp(fine, elongations, np.multiply(rates, [1., 1.01, 1.03]))
close(wear.hours(elongations, rates)[-1] / (np.sum(1e-7 / growing) / 3600.), 1., 1e-6, "hours of straight lines")
close(wear.hours([0., 0.03], [1e-9, 1e-9 / 1.03])[-1], 0.03e9 / 3600., 1e-6, "hours of one rate")
gone = wear.hours([0., 0.01, 0.02, 0.03], [1e-9, 1e-9, 0., 1e-9])
check(np.isfinite(gone).tolist() == [True, True, False, False], f"hours of a chain that does not wear: {gone}")

shutil.rmtree("there", ignore_errors=True)
pathlib.Path("small.prm").write_text(STUDY)
done = subprocess.run([PROGRAM, "study", "small.prm", "--cores", "2", "--output", "there", "--quiet"], stdout=subprocess.PIPE,
                      stderr=subprocess.STDOUT, text=True)
check(done.returncode == 0, done.stdout)
with open("there/table.csv", encoding="utf-8") as file:
    rows = sorted((float(row["variant"].split("=")[-1]), row) for row in csv.DictReader(file))
done = report.Study("there")
curve, = wear.curves(sweep.Sweep(done))
check(np.allclose(curve.elongations, [0., 0.01, 0.02]), f"states {curve.elongations}")
for (_, row), variant in zip(rows, sweep.Sweep(done).curves[""]):
    found = [json.loads(pathlib.Path("there", run["folder"], "summary.json").read_text())["life"] for run in variant["runs"]]
    for name, member in (("wear_rate", "simulated_wear_rate"), ("plate_safety", "simulated_plate_safety")):
        values = [one.get(member, math.nan) for one in found]
        check(np.isclose(float(row[name] or "nan"), np.mean(values), equal_nan=True), f"{name} = {row[name]}, not {values}")
rates = [variant["row"]["wear_rate"] for variant in sweep.Sweep(done).curves[""]]
fine = fine[:200000]
growing = np.interp(fine, [0., 0.01, 0.02], np.multiply(rates, [1., 1.01, 1.02]))
close(curve.hours[-1] / (np.sum(1e-7 / growing) / 3600.), 1., 1e-5, "hours of the runs")
check(np.all(curve.low[1:] < curve.hours[1:]) and np.all(curve.hours[1:] < curve.high[1:]), f"intervals {curve.low} {curve.high}")
page = pathlib.Path("there/study.md").read_text()
check(all(wear.rounded(value) in page for value in curve.hours) and "| replaced" not in page, f"the page:\n{page}")
check(curve.limit == found[0]["elongation"] == 0.03 and math.isnan(curve.life()), f"life without a state of 3 %: {curve.life()}")
curve.limit = 0.015
growing = growing[:150000]
close(curve.life() / (np.sum(1e-7 / growing) / 3600.), 1., 1e-4, "hours until it is replaced")
check(any(row[0] == "replaced at 1.5" and row[2] == wear.rounded(curve.life()) for row in wear.tables([curve])[0][1]), "no row of life")
check(pathlib.Path("there/chart-wear.svg").stat().st_size > 500, "no chart of wear")
