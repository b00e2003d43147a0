# SPDX-License-Identifier: LGPL-2.1-or-later
"""study.py CASE PROGRAM REPOSITORY: studies, in an empty folder.

  statistics  intervals, the efficient front, spectra and variation against closed forms
  refuse      what is wrong is said of every variant before the first begins, and nothing is written
  checks      variants are checked several at a time, with the sentences of one at a time; progress; signals leave nothing behind
  run         a small study from end to end: a variant that fails is a row, the table has the numbers of the runs
  sweep       a study against an entry: curves, orders at each speed, a variant that fails is a gap
  cluster     a study on Slurm, of which a stand-in gives the programs their environment
  kill        kill -9 and once more: what was finished is not repeated, what was not goes on; a changed file runs
              only what has changed

Without Snakemake, h5py, matplotlib or pandas `run`, `sweep`, `cluster` and `kill` end with 77: left out."""
import csv
import fcntl
import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from program import check
from small_drives import STUDY_OF_RIGID

MESH = "sprocket-15.msh"
CASE, PROGRAM, REPOSITORY = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
os.environ.pop("PYTHONPATH", None)  # what is started finds its modules by itself

def write(text, name="small.prm"):
    pathlib.Path(name).write_text(STUDY_OF_RIGID + text)


def words(*options, name="small.prm", cores=2):
    return [PROGRAM, "study", name, "--cores", str(cores), "--output", "there", *options]


def study(*options, status=0, name="small.prm", cores=2):
    done = subprocess.run(words(*options, name=name, cores=cores), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    check(done.returncode == status, f"status {done.returncode} instead of {status}:\n{done.stdout}")
    return done.stdout


def table():
    with open("there/table.csv", encoding="utf-8") as file:
        return {row["variant"]: row for row in csv.DictReader(file)}


def close(a, b, tolerance, what):
    check(abs(a - b) <= tolerance, f"{what}: {a}, not {b}")


def statistics():
    need_snakemake()
    import numpy as np
    import outputs
    import stats
    from chaindrive.schema import SUMMARY

    random = np.random.default_rng(7)
    reference = random.normal(100., 20., 8)
    error, low, high = stats.error_interval(1.03 * reference, reference)
    for value in (error, low, high):  # all phases have the same ratio
        close(value, 3., 1e-9, "error of a constant factor")
    unpaired = stats.error_interval(1.03 * reference[::-1], reference)
    check(unpaired[2] - unpaired[1] > 5., "phases are not paired")

    # 3.1824 with three degrees of freedom
    for got, wanted in zip(stats.mean_interval([0., 0., 1., 1.]), (0.5, 0.5 - 3.1824 / math.sqrt(12.), 0.5 + 3.1824 / math.sqrt(12.))):
        close(got, wanted, 1e-4, "four values")
    few = [*stats.mean_interval([0., 1., 2.])[1:], *stats.error_interval([1., 2., 3.], [1., 1., 1.])[1:]]
    check(np.isnan(few).all(), f"an interval of three values: {few}")
    sample = random.normal(0., 1., 400)
    mean, low, high = stats.mean_interval(sample)
    for end, sign in ((low, -1.), (high, 1.)):  # normal limit
        close((end - mean) * 20., sign * 1.96 * sample.std(), 0.02, "interval of many values")
    check(np.isnan(stats.mean_interval([1.])[1]), "an interval of one value")
    # of four pairs whose errors are known, 95 of 100 intervals hold them
    held = 0
    for _ in range(2000):
        common, own = random.normal(0., 0.2, 4), random.normal(0., 0.1, (2, 4))
        _, low, high = stats.error_interval(1.2 * np.exp(common + own[0]), np.exp(common + own[1]))
        held += low < 20. < high
    check(0.93 < held / 2000 < 0.97, f"{held} of 2000 intervals hold the error")
    _, low, high = stats.error_interval([-3., 1., 2., 1.], [1., 1., 1., 1.])  # 0.25 may have either sign
    close(low + high, -150., 1e-9, "an interval of ratios of both signs")

    points = [(1., 9.), (2., 5.), (2., 6.), (3., 5.), (4., 1.), (5., np.nan), (9., 1.)]
    check(stats.efficient(points) == [True, True, False, False, True, False, False], f"front {stats.efficient(points)}")

    time_ = np.arange(4096) / 50e3
    amplitude, frequency = 0.3, 2000.  # in the middle of a band, and a whole number of periods but for round-off
    wave = amplitude * np.sin(2 * np.pi * frequency * time_) + 4.6 + 100. * time_
    curves = np.stack([np.stack([wave, 0. * wave]), np.stack([0. * wave, wave])])  # two rollers, two directions
    power, frequencies = outputs.power_spectrum(curves, 1. / 50e3)
    bands = outputs.third_octaves(power, frequencies)
    close(bands[2000] / (amplitude / np.sqrt(2)), 1., 5e-3, "a sine is in its band")
    check(max(value for band, value in bands.items() if band != 2000) < 0.05 * bands[2000], f"elsewhere: {bands}")
    noise = random.normal(0., 1., (3, 2, 1001))
    line = np.linspace(noise[..., 0], noise[..., -1], 1001, axis=-1)
    close(outputs.power_spectrum(noise, 1.)[0].sum(), 2 * np.mean((noise - line) ** 2), 1e-12, "Parseval")

    curve = np.array([[1., 2., 3.], [0., 0., 0.]])
    close(outputs.variation(np.stack([curve + 0.5, curve - 0.5])), 0.5 / np.sqrt(14. / 6.), 1e-12, "variation")
    check(outputs.statistics([2.]) == {"mean": 2., "max": 2.} and not outputs.statistics([]),
          "one value has a mean, none has nothing")
    found = outputs.statistics([1., 2., 3.])
    check(found == {"mean": 2., "max": 3., "cv": 0.5, "max_over_min": 3.}, f"statistics {found}")

    import sweep
    beat = np.sort(random.uniform(0., 0.1, 30000))  # seconds; unequal steps
    orders, amplitudes = sweep.order_amplitudes(beat, 5. + 3. * np.sin(2 * np.pi * 200. * beat + 1.) + 0.5 * np.cos(2 * np.pi * 50. * beat),
                                                0.01, 0.005, 0.0888)  # 8 whole periods
    check(len(orders) > 8 * sweep.HIGHEST and orders[1] == 1. / 8, f"orders {orders[:3]}")
    for order, amplitude in ((2., 3.), (0.5, 0.5), (1., 0.), (3., 0.)):
        close(amplitudes[np.argmin(abs(orders - order))], amplitude, 2e-3, f"order {order}")
    check(len(sweep.order_amplitudes(beat, beat, 1., 0., 0.1)[0]) == 0, "less than a period has no orders")

    import needs
    check([needs.memory_mb({"cpu": 1., "memory": memory}, ranks, attempt) for memory, ranks, attempt in (
        (1.9e8, 1, 1), (4e8, 1, 1), (4e8, 3, 1), (4e8, 3, 2))] == [500, 600, 1350, 2700], "memory of a job")
    check([needs.minutes({"cpu": cpu, "memory": 1.}, attempt) for cpu, attempt in ((5., 1), (300., 1), (1800., 1), (1801., 2))] == [10, 10, 60, 122],
          "minutes of a job")
    for nothing in (None, {}, [], {"cpu": None, "memory": "x"}, {"cpu": -1., "memory": float("nan")}, {"cpu": float("inf"), "memory": True}):
        check((needs.memory_mb(nothing, 1), needs.minutes(nothing)) == (500, 10), f"of {nothing}")

    documented = subprocess.run([PROGRAM, "document"], stdout=subprocess.PIPE, text=True).stdout
    of_outputs = documented[documented.index("Outputs of a study:"):].split("\n## ")[0]
    names = [line.split("`")[1] for line in of_outputs.splitlines() if line.startswith("| `")]
    of_summary = {name for name in names if name in SUMMARY}
    check(sorted(set(names) - of_summary) == sorted(outputs.OUTPUTS), f"only in one list: {set(names) ^ set(outputs.OUTPUTS)}")
    units = {line.split("`")[1]: line.split(" | ")[1] for line in of_outputs.splitlines() if line.startswith("| `")}
    wrong = [name for name in of_summary if SUMMARY[name]["unit"] != units[name]]
    check(len(of_summary) == 10 and not wrong, f"outputs of the summary: {sorted(of_summary)}, other units: {wrong}")


LOOP = "subsection Model\n set Fidelity = {simple|layered}\nend\n"


def refuse():
    def said(text, *options, status=2, name="small.prm"):
        shutil.rmtree("there", ignore_errors=True)
        write(text, name)
        out = study(*options, status=status, name=name)
        check(not pathlib.Path("there").exists(), "something was written")
        return out

    for expected, text in (
            ("There is nothing to compare", "set Phases = 2"),
            ("Study/Outputs: there is no output 'tight_tension'. Did you mean one of 'tight_tension_mean', "
             "'tight_tension_max_start', 'tight_tension_ripple'?", LOOP + "set Outputs = tight_tension"),
            ("Study/Outputs: there is no output 'tight_tension_men'. Did you mean 'tight_tension_mean'?", LOOP + "set Outputs = tight_tension_men"),
            ("Study/Reference = full is no variant. There are: fidelity=simple, fidelity=layered.", LOOP + "set Reference = full"),
            ("Study/Names has 3 names for 2 variants", LOOP + "set Names = a, b, c"),
            ("two variants called 'a'", LOOP + "set Names = a, a"),
            ("Study/Phases = 0 is not allowed", LOOP + "set Phases = 0"),
            ("Study/Phases = {1|2} is not allowed: it must be a whole number", LOOP + "set Phases = {1|2}"),
            ("Loads/Drag in 1/s = {{0|1|2}} has 3 values, but there are 2 variants",
             LOOP + "end\nsubsection Loads\n set Drag in 1/s = {{0|1|2}}"),
            ("is no loop: write {a | b}", "end\nsubsection Model\n set Fidelity = {simple|layered"),
            ("Study/Against = Time/Time step in us is no entry with a loop. There are: Model/Fidelity.", LOOP + "set Against = Time/Time step in us"),
            ("Study/Against = Model/Fidelity must have numbers, not 'simple'.", LOOP + "set Against = Model/Fidelity"),
            ("Study/Outputs names 'losses' twice", LOOP + "set Outputs = losses, losses"),
            ("Study/Names = -a, b is not allowed", LOOP + "set Names = -a, b"),
            ("Study/Names = a, .snakemake is not allowed", LOOP + "set Names = a, .snakemake"),
            *((f"No variant can be called '{name}'", LOOP + f"set Names = a, {name}")
              for name in ("study.lock", "study.json", "table.csv", "chart.svg", "chart-orders.svg")),
            ("more than 200 letters", LOOP + "set Names = a, " + 201 * "b"),
            ("'driver_peak_mean' is made of engagements, which Output/Quantities does not keep: add 'engagements' there",
             LOOP + "set Outputs = driver_peak_mean\nend\nsubsection Output\n set Quantities = {speeds | tensions}"),
            ("section Study has no entry 'Phase'. Did you mean 'Phases'?", "set Phase = 3"),
    ):
        loop = LOOP if text.startswith(LOOP) else ""
        out = said(loop + "subsection Study\n" + text.removeprefix(LOOP) + "\nend\n")
        check(expected in " ".join(out.split()), f"'{expected}' is not said:\n{out}")

    # every variant that cannot run, with its sentence, those that can are not mentioned
    out = " ".join(said("subsection Time\n set Time step in us = {0.25 | 50 | 0.1 | nothing}\nend\n").split())
    check("2 of 4 variants cannot run; nothing was started" in out, out)
    check("time-step=50: Time/Time step in us = 50" in out and "time-step=nothing: Time/Time step in us = nothing is not allowed" in out, out)
    check("time-step=0.25:" not in out, out)
    for value in ("/some#where", "/a\nb", "/there\\"):
        out = " ".join(said(LOOP, "--set", f"Drive/Sprockets/Driver mesh={value}").split())
        check(f"Driver mesh = {' '.join(value.split())} is not allowed: in a .prm file" in out, f"{value!r}: {out}")
    os.makedirs("at#home", exist_ok=True)
    shutil.copy(REPOSITORY / "meshes" / MESH, "at#home")
    out = " ".join(said(LOOP + f"subsection Drive\n subsection Sprockets\n set Driver mesh = {MESH}\nend\nend\n", name="at#home/small.prm").split())
    check(f"at#home/{MESH} is not allowed: in a .prm file '#' begins a comment" in out, out)
    check("no quick form" in said(LOOP, "--quick"), "--quick without a quick form")
    write("subsection Study\nend\nsubsection Time\n set Time step in us = {1|2}\nend\n")
    out = subprocess.run([PROGRAM, "small.prm"], stderr=subprocess.PIPE, text=True).stderr
    for sentence in ("Only studies have them", "It belongs to a study", "Loops belong to studies"):
        check(sentence in out, f"a run does not tell a study: {out}")
    check("cannot run" not in said(LOOP, "--dry-run", status=0), "--dry-run")


def checks():
    steps = " | ".join(f"{0.1 + 0.01 * i:.2f}" if i % 2 else str(50 + i) for i in range(24))
    write(f"subsection Time\n set Time step in us = {{{steps}}}\nend\n")
    said = [study("--quiet", status=2, cores=cores) for cores in (1, 5)]
    check(said[0] == said[1] and "12 of 24 variants cannot run" in said[0], f"others with five at a time:\n{said[0]}\n{said[1]}")
    order = [int(line.split(":")[0].removeprefix("time-step=")) for line in said[1].splitlines() if line.startswith("time-step=")]
    check(order == list(range(50, 74, 2)), f"the order of the sentences: {order}")
    listed = [line.split()[0] for line in study("--dry-run", status=2).splitlines() if line.startswith("  time-step=")]
    check(len(listed) == 24 and listed[:2] == ["time-step=50", "time-step=0.11"], f"--dry-run lists {listed}")

    text = "subsection Loads\n set Drag in 1/s = {" + " | ".join(map(str, range(400))) + "}\nend\n"
    write(text)

    def begin(stdout, *options):
        process = subprocess.Popen(words("--dry-run", *options), stdout=stdout, stderr=subprocess.STDOUT, start_new_session=True)
        since = time.time()
        while len(of_group(process.pid)) < 2:
            check(process.poll() is None and time.time() - since < 60, "no process checks a variant")
            time.sleep(0.01)
        return process

    terminal, other = os.openpty()  # a line that is rewritten
    process = begin(other)
    os.close(other)
    shown = b""
    while shown.count(b"of 400 variants checked, left ") < 3:
        shown += os.read(terminal, 1000)
    check(b"\r" in shown and b"\x1b[K" in shown, f"on a terminal: {shown}")
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    os.close(terminal)
    gone(process.pid, "a study that is killed")
    for number in (signal.SIGTERM, signal.SIGINT):
        with open("said.txt", "w+", encoding="utf-8") as file:
            process, since = begin(file), time.time()
            while "of 400 variants checked" not in pathlib.Path("said.txt").read_text():  # a plain line now and then
                check(process.poll() is None and time.time() - since < 120, "no progress in a file")
                time.sleep(0.1)
            process.send_signal(number)
            check(process.wait(30) == 4, f"status {process.returncode} after {number}")
        gone(process.pid, f"a study after {number}")
        said = pathlib.Path("said.txt").read_text()
        check("\r" not in said and "\x1b" not in said and "cannot" not in said, f"in a file: {said}")
    check(not pathlib.Path("there").exists(), "something was written")


def of_group(leader):
    """Processes of a group, without those that have ended."""
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            number, rest = int(stat.parent.name), stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if int(rest[2]) == leader and rest[0] != "Z":
            found.append(number)
    return found


def gone(leader, what):
    since = time.time()
    while of_group(leader):
        check(time.time() - since < 20, f"{what} leaves processes behind")
        time.sleep(0.05)


STUDY = """
subsection Study
  set Title = A small study
  set Outputs = tight_tension_mean, losses
  set Phases = 2
  set Reference = exact
  set Names = coarse, exact, hopeless
  set Ranks = {{ 1 | 2 | 1 }}
end
subsection Time
  set Time step in us = {0.3 | 0.25 | 0.2}
  set Energy limit in percent = {{ 5 | 5 | 1e-9 }}
end
"""


def need_snakemake():
    if shutil.which("snakemake") is None or subprocess.run(
            ["/usr/bin/python3", "-c", "import h5py, jinja2, matplotlib, pandas"], stderr=subprocess.DEVNULL).returncode != 0:
        sys.exit(77)


def run():
    need_snakemake()
    import h5py

    shutil.rmtree("there", ignore_errors=True)
    write(STUDY)
    study("--quiet")
    rows = table()
    check(list(rows) == ["coarse", "exact", "hopeless"], f"rows {list(rows)}")
    check(rows["hopeless"]["failed"] == "2" and "nergy" in rows["hopeless"]["message"], f"the failure: {rows['hopeless']}")
    values = {}
    for name in ("coarse", "exact"):
        summaries = [json.loads(pathlib.Path(f"there/{name}/phase-{p}/summary.json").read_text()) for p in ("0", "0.5")]
        values[name] = [s["tight_tension_mean"] for s in summaries]
        close(float(rows[name]["tight_tension_mean"]), sum(values[name]) / 2, 1e-9, "mean over phases")
        close(float(rows[name]["cpu"]), sum(s["cpu_seconds"]["total"] for s in summaries) / 2, 1e-9, "CPU time")
        check(rows[name]["runs"] == "2" and float(rows[name]["memory"]) > 1e7, f"row {rows[name]}")
        check(values[name][0] != values[name][1], "all phases are the same")
    close(float(rows["coarse"]["tight_tension_mean error"]), 100 * (sum(values["coarse"]) / sum(values["exact"]) - 1), 1e-9, "error")
    with h5py.File("there/table.h5") as file:
        close(file["tight_tension_mean"][0], float(rows["coarse"]["tight_tension_mean"]), 1e-9, "HDF5")
        check(list(file["by_phase/coarse/tight_tension_mean"][:]) == values["coarse"], "HDF5 by phase")

    # a run of its own is the same
    alone = [PROGRAM, "there/coarse/phase-0.5/variant.prm", "--output", "alone", "--quiet"]
    subprocess.run(alone, check=True)
    check(json.loads(pathlib.Path("alone/summary.json").read_text())["tight_tension_mean"] == values["coarse"][1], "variant.prm alone")
    page = pathlib.Path("there/study.html").read_text()
    check("95 %" not in page and "fewer than four start phases" in page, "an interval of two phases")
    check("<svg" in page and "hopeless" in page and "src=" not in page and "<link" not in page, "the page is not complete in itself")
    for file in ("study.md", "chart.png", "chart.svg"):
        check(pathlib.Path("there", file).stat().st_size > 500, file)


SWEEP = """
subsection Study
  set Title   = A sweep
  set Outputs = tight_tension_mean, driver_normal_speed_mean, loss_power_mean, sound_level, roller_velocity_rms
  set Names   = simple-slow, layered-slow, simple-fast, layered-fast, simple-worse, layered-worse
  set Against = Loads/Driver speed in rad/s
  set Phases  = 1
end
subsection Model
  set Fidelity = {simple | layered}
end
subsection Loads
  set Driver speed in rad/s = {300 | 600 | 450}
end
subsection Time
  set End time in ms = {{8 | 8 | 4 | 4 | 4 | 4}}
  set Energy limit in percent = {{5 | 5 | 5 | 5 | 5 | 1e-9}}
end
subsection Output
  set Window start in ms = {{3 | 3 | 1.5 | 1.5 | 1.5 | 1.5}}
end
"""


def sweep():
    need_snakemake()
    import report
    import sweep as of

    shutil.rmtree("there", ignore_errors=True)
    write(SWEEP)
    study("--quiet")
    rows = table()
    check(rows["layered-worse"]["failed"] == "1", "the variant that fails")
    summary = json.loads(pathlib.Path("there/simple-fast/phase-0/summary.json").read_text())
    speeds = [e["normal_speed"] for e in summary["engagements"]
              if e["sprocket"] == "driver" and e["complete"] and 1.5e-3 <= e["time"] <= summary["window"]["end"]]
    close(float(rows["simple-fast"]["driver_normal_speed_mean"]), sum(speeds) / len(speeds), 1e-9, "normal speed")
    lost = sum(value for name, value in summary["energy"].items() if name.endswith("_loss"))
    close(float(rows["simple-fast"]["loss_power_mean"]) / (lost / 4e-3), 1., 1e-2, "power lost")
    check(rows["simple-fast"]["sound_level"] in ("", "nan"), "a level without sound")

    found = of.Sweep(report.Study("there"))
    held = [file for file in pathlib.Path("/proc/self/fd").iterdir() if file.resolve().name == "histories.h5"]
    check(not held, f"{len(held)} histories are held: a study may have thousands")
    check({label: [round(found.abscissa(v)) for v in variants] for label, variants in found.curves.items()}
          == {name: [2865, 4297, 5730] for name in ("simple", "layered")}, f"curves {found.curves.keys()}")
    drive = json.loads(pathlib.Path("there/simple-slow/phase-0/summary.json").read_text())["drive"]
    close(found.resonances()[0][2], drive["driven_resonance"] * 9.549297, 1e-3, "resonance in rpm")
    page = pathlib.Path("there/study.md").read_text()
    check("driver speed (rpm), layered" in page and "| 4297 | - | - | - | - | - | - |" in page, f"the page:\n{page}")
    for file in ("study.html", "chart.png", "chart.svg", "chart-orders.svg"):
        check(pathlib.Path("there", file).stat().st_size > 500, file)

    # values that are no formulas, a driver that stands, files that are damaged: rows, and a page of all others
    about = json.loads(pathlib.Path("there/study.json").read_text())
    for variant in about["variants"]:
        variant["changes"]["Model/Fidelity"] += "$^$"
        if variant["name"].endswith("slow"):
            variant["changes"]["Loads/Driver speed in rad/s"] = "0"
    pathlib.Path("there/study.json").write_text(json.dumps(about))
    pathlib.Path("there/simple-fast/phase-0/result.json").write_text("[]")
    pathlib.Path("there/simple-worse/phase-0/histories.h5").write_bytes(b"no history")
    pathlib.Path("there/chart.svg").unlink()
    done = subprocess.run(["/usr/bin/python3", "-B", str(REPOSITORY / "scripts/study/report.py"), "there"], stderr=subprocess.PIPE, text=True)
    check(done.returncode == 0 and pathlib.Path("there/chart.svg").exists(), f"the page is lost: {done.stderr}")
    rows = table()
    check("result.json is damaged" in rows["simple-fast"]["message"] and "cannot be read" in rows["simple-worse"]["message"],
          f"what is damaged is not said: {rows}")
    check(float(rows["layered-fast"]["tight_tension_mean"]) > 0, "what is whole is lost")


CLUSTER = """
subsection Study
  set Phases = 2
  set Ranks = {{ 1 | 2 }}
end
subsection Loads
  set Drag in 1/s = {0 | 1}
end
"""

# Jobs and steps as Slurm 22.05 starts them, but at once and here; its variables are those that `srun -n1 --mpi=pmi2 env` shows.
STAND_INS = {
    "sbatch": """for word; do case $word in --wrap=*) wrap=${word#--wrap=} ;; esac; done
number=$(($(wc -l <"$JOBS") + 1)) && echo "$*" >>"$JOBS"
SLURM_JOB_ID=$number SLURM_JOBID=$number SLURM_JOB_NODELIST=$(hostname) SLURM_NODELIST=$(hostname) SLURM_NNODES=1 \\
  SLURM_CPUS_ON_NODE=2 bash -c "$wrap" >"$JOBS.$number" 2>&1 && state=COMPLETED || state=FAILED
echo $state >"$JOBS.state.$number"
echo "Submitted batch job $number"
""",
    "srun": """while [[ $1 == -* ]]; do shift; done
export SLURM_STEP_ID=0 SLURM_STEPID=0 SLURM_NTASKS=1 SLURM_NPROCS=1 SLURM_STEP_NUM_TASKS=1 SLURM_PROCID=0 SLURM_LOCALID=0 \\
  SLURM_STEP_NODELIST=$SLURM_NODELIST SLURM_STEP_NUM_NODES=1 SLURM_TASKS_PER_NODE=1 PMI_FD=99 PMI_RANK=0 PMI_SIZE=1
echo step >>"$JOBS.steps" && exec "$@"
""",
    # Snakemake asks for one job, from 7.32 on for all that have the name of its run
    "sacct": """case $* in *State*) for state in "$JOBS".state.*; do echo "${state##*.}|$(<"$state")"; done ;; esac
""",
    "sacctmgr": "echo account\n", "sinfo": "echo 'main*'\n", "scancel": "true\n"}


def cluster():
    need_snakemake()
    import needs
    for folder in ("there", "slurm"):
        shutil.rmtree(folder, ignore_errors=True)
    os.makedirs("slurm")
    for name, text in STAND_INS.items():
        file = pathlib.Path("slurm", name)
        file.write_text("#!/usr/bin/env bash\n" + text)
        file.chmod(0o755)
    jobs = pathlib.Path("slurm/jobs").resolve()
    jobs.write_text("")
    os.environ.update(PATH=f"{jobs.parent}:{os.environ['PATH']}", JOBS=str(jobs), USER="user")
    write(CLUSTER)
    study("--quiet", "--", "--slurm", "--jobs", "4", "--max-status-checks-per-second", "1", "--groups", "run=g", "--group-components", "g=2", "--default-resources",
          "mem_mb=700", "runtime=9", "slurm_account=account")
    rows = table()
    said = "".join(file.read_text() for file in jobs.parent.glob("jobs.[0-9]*"))
    check({row["runs"] for row in rows.values()} == {"2"} and len(rows) == 2, f"not all have run: {rows}\n{said}")
    submitted = jobs.read_text().splitlines()
    asked = sorted((int(s.split(" --mem ")[1].split()[0]), int(s.split(" -t ")[1].split()[0])) for s in submitted)
    estimates = [variant["estimate"] for variant in json.loads(pathlib.Path("there/study.json").read_text())["variants"]]
    one, two = (needs.memory_mb(estimate, ranks) for estimate, ranks in zip(estimates, (1, 2)))
    # two runs of one rank are beside each other in their group, others one after the other
    groups = [(2 * one, 10) if s.count("run:folder=drag=0/") == 2 else (two, 20) for s in submitted if "run:folder=" in s]
    check(len(groups) == 2 and asked == sorted([*groups, (2000, 30)]) and two > one >= 500 and all(" -A account" in s for s in submitted),
          f"{asked} for {estimates}:\n" + "\n".join(submitted))
    for variant, estimate in zip(rows.values(), estimates):
        check(0.9 < estimate["memory"] / float(variant["memory"]) < 1.6, f"memory: {estimate} {variant}")  # a layered model is that of one rank
        check(0.3 < estimate["cpu"] / float(variant["cpu"]) < 4, f"time: {estimate} {variant}")
    check(not list(pathlib.Path(tempfile.gettempdir()).glob("chaindrive-study-*")), "the folder of the estimates is left")
    check(len(pathlib.Path(f"{jobs}.steps").read_text().split()) >= 5, "no step below srun")
    os.environ["TMPDIR"] = "/proc/nowhere"  # OpenMPI 5 makes the folder where it can
    check("none can be made in '/proc/nowhere'" in study("--", "--slurm", "--jobs", "4", status=2), "no temporary directory")
    del os.environ["TMPDIR"]
    before = pathlib.Path("there/study.json").read_text()
    study("--quiet", "--", "--slurm", "--jobs", "4", "--max-status-checks-per-second", "1", "--default-resources", "slurm_account=account")
    check(pathlib.Path("there/study.json").read_text() == before, "estimates of runs that are the same are lost")
    # more for one run, and what is damaged is as if nobody had asked
    about = json.loads(before)
    about["variants"][0]["estimate"] = {"cpu": 3600, "memory": 2e9}
    about["variants"][1]["estimate"] = {"cpu": [], "memory": "much"}
    pathlib.Path("there/study.json").write_text(json.dumps(about))
    for file in pathlib.Path("there").glob("*/*/result.json"):
        file.unlink()
    jobs.write_text("")
    study("--quiet", "--", "--slurm", "--jobs", "4", "--max-status-checks-per-second", "1", "--default-resources", "slurm_account=account",
          "--set-resources", "report:mem_mb=3000")
    asked = sorted((int(s.split(" --mem ")[1].split()[0]), int(s.split(" -t ")[1].split()[0])) for s in jobs.read_text().splitlines())
    two = needs.memory_mb(json.loads(pathlib.Path("there/study.json").read_text())["variants"][1]["estimate"], 2)
    check(asked[:2] == [(two, 10)] * 2 and asked[2:] == [(3000, 30), (3000, 120), (3000, 120)], f"jobs with other estimates: {asked}")
    for file in pathlib.Path("there").glob("*/*/errors.txt"):
        check("no run has written" not in file.read_text(), f"files of the study are strange to it: {file.read_text()}")


LONG = """
subsection Study
  set Phases = 2
end
subsection Loads
  set Drag in 1/s = {0 | %s}
end
subsection Time
  set End time in ms = 15
end
subsection Output
  set Checkpoint interval in ms = 1
end
"""


def ended():
    """{run: when its log was written last} of those that are finished."""
    return {str(file.parent): (file.parent / "log.txt").stat().st_mtime_ns for file in pathlib.Path("there").glob("*/*/result.json")}


def kill():
    need_snakemake()
    shutil.rmtree("there", ignore_errors=True)
    write(LONG % 1)
    process = subprocess.Popen(words("--quiet"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    since = time.time()
    while not (ended() and any(not (file.parent / "result.json").exists() for file in pathlib.Path("there").glob("*/*/checkpoint-*.ckpt"))):
        check(process.poll() is None and time.time() - since < 120, "nothing to interrupt")
        time.sleep(0.02)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    before = ended()
    check(0 < len(before) < 4, f"{len(before)} were finished")
    unfinished = {str(file.parent) for file in pathlib.Path("there").glob("*/*/checkpoint-*.ckpt")} - before.keys()
    for lock in pathlib.Path("there").glob("*/*/variant.lock"):  # a run that lost its parent writes its checkpoint first
        with open(lock, encoding="utf-8") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
    again = time.time_ns()
    study("--quiet")
    after = ended()
    check(len(after) == 4, "not all are finished")
    check(all(after[run] == when for run, when in before.items()), "what was finished was repeated")
    for folder in unfinished:
        check("Resumed from" in pathlib.Path(folder, "log.txt").read_text() or after[folder] < again, f"{folder} began anew")

    before = ended()
    study("--quiet")
    check(ended() == before, "a study that is finished repeats something")
    rows = table()
    lost, damaged, emptied = sorted(before)[:3]  # what is lost of a finished study is computed again, and nothing else
    shutil.rmtree(lost)
    pathlib.Path(damaged, "result.json").write_text('{"status": 0,')
    pathlib.Path(emptied, "summary.json").unlink()
    study("--quiet")
    after = ended()
    check(set(after) == set(before) and after[lost] > before[lost], f"what was deleted is not computed again: {after}")
    check(json.loads(pathlib.Path(damaged, "result.json").read_text())["status"] == 0, "a damaged end is kept")
    check(pathlib.Path(emptied, "summary.json").exists(), "results that are gone are not computed again")
    kept = sorted(before)[3]
    check(after[kept] == before[kept], "what was there is repeated")
    check(all(table()[v]["tight_tension_mean"] == row["tight_tension_mean"] for v, row in rows.items()), f"other results: {table()}")
    before = after
    pathlib.Path("small.prm").touch()
    study("--quiet")
    check(ended() == before, "a file that says the same repeats something")
    write(LONG % 2)
    study("--quiet", "--set", "Study/Reference=drag=0")
    after = ended()
    check(all(after[run] == when for run, when in before.items()), "runs that are the same are repeated")
    check(sorted(set(after) - set(before)) == ["there/drag=2/phase-0", "there/drag=2/phase-0.5"], f"new: {sorted(set(after) - set(before))}")
    write(LONG % 2 + "subsection Loads\n set Gravity in m/s2 = 1\nend\n")
    before = after
    study("--quiet")
    after = ended()
    check(all(after[run] > before[run] for run in after if "drag=1" not in run), "runs that have changed are not repeated")


{"statistics": statistics, "refuse": refuse, "checks": checks, "run": run, "sweep": sweep, "cluster": cluster, "kill": kill}[CASE]()
