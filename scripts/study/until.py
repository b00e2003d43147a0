# SPDX-License-Identifier: LGPL-2.1-or-later
"""until.py PROGRAM FILE...: what runs that end when they know a mean cost, against windows of a fixed length.

    python3 scripts/study/until.py build/source/chaindrive prm/twelve/06b-13-19.prm prm/twelve/16a-11-17.prm prm/paper/layered-auto.prm

Of each drive, settled and layered, once with `Output/Until = driver_peak_mean=5` and with windows of 10, 20, 40 ... pitches from three
pitches on; the truth is a run as long as all of these together. A table in Markdown, for doc/accuracy-and-cost.md."""
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

WANTED, OUTPUT, RUN_IN, LONGEST = 5, "driver_peak_mean", 3, 640


def run(program, file, folder, end, *entries):
    """The summary, and CPU time in s."""
    words = [word for entry in ("Model/Fidelity=layered", "Drive/Layout/Start=settled", "Time/Start time in ms=0", f"Time/End time in ms={1e3 * end:.8g}",
                                "Output/Window end in ms=auto", "Output/Quantities=speeds, tensions, engagements", "Output/Field interval in ms=0",
                                "Output/History interval in us=100", "Time/Time step in us=auto", *entries) for word in ("--set", entry)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([program, "run", file, "--quiet", "--output", folder, *words], check=True, stderr=subprocess.DEVNULL)
    return json.loads(pathlib.Path(folder, "summary.json").read_text()), resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def of(summary):
    """The mean peak and its uncertainty over it; infinite where that is not known."""
    peaks = summary["impacts"]["driver"]["peak_force"]
    unknown = peaks.get("uncertainty") is None
    return peaks["mean"], float("inf") if unknown else peaks["uncertainty"] / peaks["mean"]


def main():
    program, files = sys.argv[1], sys.argv[2:]
    if not files:
        sys.exit(__doc__)
    print(f"| drive | run | window (pitches) | {OUTPUT.replace('_', ' ')} (N) | interval | off the longest run | CPU (s) |\n|" + " --- |" * 7)
    for file in files:
        with tempfile.TemporaryDirectory() as folder:
            first, _ = run(program, file, folder, 1e-4, "Output/Window start in ms=0")
            pitch, name = first["drive"]["pitch_time"], pathlib.Path(file).stem
            fixed = f"Output/Window start in ms={1e3 * RUN_IN * pitch:.8g}"
            found = []
            for n in (10, 20, 40, 80, 160, LONGEST):
                summary, cpu = run(program, file, folder, (RUN_IN + n) * pitch, fixed)
                found.append((f"window of {n}", n, *of(summary), cpu))
            for window in (fixed, "Output/Window start in ms=settled"):
                summary, cpu = run(program, file, folder, (RUN_IN + LONGEST) * pitch, window, f"Output/Until={OUTPUT}={WANTED}")
                n = (summary["window"]["end"] - summary["window"]["start"]) / pitch
                found.append((f"until {WANTED} %" + (", settled" if "settled" in window else ""), n, *of(summary), cpu))
            truth = found[5][2]
            for row, n, mean, uncertainty, cpu in found:
                print(f"| {name} | {row} | {n:.0f} | {mean:.4g} | " + ("unknown" if uncertainty == float("inf") else f"{100 * uncertainty:.2g} %") +
                      f" | {100 * (mean / truth - 1):+.2g} % | {cpu:.1f} |", flush=True)


if __name__ == "__main__":
    main()
