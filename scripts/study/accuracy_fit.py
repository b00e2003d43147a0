# SPDX-License-Identifier: LGPL-2.1-or-later
"""accuracy_fit.py [source/accuracy.tsv]: on what errors of models depend, and what they are expected to be on another drive.

    python3 scripts/study/accuracy_fit.py --write source/accuracy.tsv    the rows "fit", which `chaindrive plan --accuracy` reads, anew
    python3 scripts/study/accuracy_fit.py source/accuracy.tsv            a table in Markdown, for doc/accuracy-and-cost.md
    python3 scripts/study/accuracy_fit.py --model oval source/accuracy.tsv    the errors of one model on all drives, the same

Of each model and output of the calibrated drives y = ln(1 + error) is a constant, or a line over the logarithm of one of the groups
of the drives (row "groups", drive::groups_of()), if that predicts drives that are left out better by a fifth at least: of so many
groups some look useful by chance. The interval is that in which a new drive of the same kind lies in 90 of 100 cases (Student's t;
Draper and Smith, Applied Regression Analysis, sec. 3.2). The share of the drives that lay within when they were left out, the group
chosen anew without them, is the coverage."""
import math
import sys

GAIN = 0.8  # of the root mean square error of left-out drives, by which a group is taken
LEAST = 12  # drives
MODELS = ("simple", "layered", "oval")
# 95 % quantiles of Student's t for 1, 2, ... degrees of freedom (Abramowitz and Stegun, table 26.10)
T95 = (6.314, 2.920, 2.353, 2.132, 2.015, 1.943, 1.895, 1.860, 1.833, 1.812, 1.796, 1.782, 1.771, 1.761, 1.753, 1.746, 1.740, 1.734, 1.729,
       1.725, 1.721, 1.717, 1.714, 1.711, 1.708, 1.706, 1.703, 1.701, 1.699, 1.697)


def t95(degrees):
    return T95[degrees - 1] if degrees <= len(T95) else 1.645 * (1 + 0.61 / degrees)


class Line:
    """y over x, or the mean of y where x is none."""

    def __init__(self, x, y):
        self.n, self.centre = len(y), sum(y) / len(y)
        self.slope = self.x_mean = 0.
        self.x_square = 1.
        if x is not None:
            self.x_mean = sum(x) / self.n
            self.x_square = sum((a - self.x_mean) ** 2 for a in x)
            self.slope = sum((a - self.x_mean) * b for a, b in zip(x, y)) / self.x_square
        degrees = self.n - (1 if x is None else 2)
        square = sum((b - self.at(a)) ** 2 for a, b in zip(x or [0.] * self.n, y))
        self.factor = t95(degrees) * math.sqrt(square / degrees)

    def at(self, x):
        return self.centre + self.slope * (x - self.x_mean)

    def half(self, x):
        return self.factor * math.sqrt(1 + 1 / self.n + (x - self.x_mean) ** 2 / self.x_square * (self.slope != 0.))


def without(values, i):
    return values and values[:i] + values[i + 1:]


def left_out(x, y):
    """Root mean square of the errors of drives that were left out."""
    errors = [y[i] - Line(without(x, i), without(y, i)).at(x[i] if x else 0.) for i in range(len(y))]
    return math.sqrt(sum(e * e for e in errors) / len(errors))


def choose(groups, y):
    """The name of the group that predicts left-out drives best, or none where none is worth it."""
    scores = {name: left_out(x, y) for name, x in groups.items()}
    best = min(scores, key=scores.get)
    return best if scores[best] < GAIN * left_out(None, y) else None


def read(path):
    """({(model, output): {drive: error}}, {drive: {group: value}}) of a table of studies."""
    errors, groups = {}, {}
    with open(path, encoding="utf-8") as file:
        rows = [line.rstrip("\n").split("\t") for line in file if not line.startswith("#")]
    for row in rows:
        if row[0] == "groups":
            groups[row[1]] = {name: float(value) for name, value in (cell.split("=") for cell in row[2:])}
    for row in rows:
        if len(row) > 9 and row[0] in groups and row[1] in MODELS and row[2] == "exact":
            errors.setdefault((row[1], row[3]), {})[row[0]] = 0.01 * float(row[4])
    return errors, groups


def fits(path):
    """(model, output, group, Line, coverage, least and largest error) of all of which enough drives are known."""
    errors, of_drive = read(path)
    for (model, output), found in errors.items():
        drives = [drive for drive, error in found.items() if error > -1.]
        if len(drives) < LEAST:
            continue
        y = [math.log1p(found[drive]) for drive in drives]
        names = [name for name in of_drive[drives[0]] if all(of_drive[drive].get(name, 0.) > 0. for drive in drives)]
        groups = {name: [math.log(of_drive[drive][name]) for drive in drives] for name in names}
        inside = 0
        for i in range(len(y)):
            others = {name: without(x, i) for name, x in groups.items()}
            name = choose(others, without(y, i))
            line, at = Line(others.get(name), without(y, i)), groups[name][i] if name else 0.
            inside += abs(y[i] - line.at(at)) <= line.half(at)
        name = choose(groups, y)
        yield model, output, name, Line(groups.get(name), y), 100 * inside / len(y), min(found.values()), max(found.values())


#: Of these the table of one model speaks.
SHOWN = ("tight_tension_mean", "slack_tension_mean", "tight_tension_ripple", "driver_peak_mean", "driver_impulse_mean", "driven_peak_mean",
         "roller_velocity_rms", "losses")


def print_model(path, model):
    errors, _ = read(path)
    drives = list(errors[model, SHOWN[0]])
    print(f"| {model} on | " + " | ".join(name.removesuffix("_mean").replace("_", " ") for name in SHOWN) + " |")
    print("|" + " --- |" * (len(SHOWN) + 1))
    for drive in drives:
        cells = [errors[model, name].get(drive) for name in SHOWN]
        print(f"| {drive} | " + " | ".join("-" if cell is None else f"{percent(cell)} %" for cell in cells) + " |")
    known = [[error for error in errors[model, name].values()] for name in SHOWN]
    print("| within 10 % | " + " | ".join(f"{sum(abs(e) <= 0.1 for e in column)} of {len(column)}" for column in known) + " |")


def percent(value):
    return f"{100 * value:+.2g}" if abs(value) < 0.995 else f"{100 * value:+.0f}"


def main():
    if len(sys.argv) == 4 and sys.argv[1] == "--model":
        return print_model(sys.argv[3], sys.argv[2])
    write = sys.argv[1:2] == ["--write"]
    if len(sys.argv) != (3 if write else 2):
        sys.exit(__doc__)
    path = sys.argv[-1]
    found = list(fits(path))
    if not found:
        sys.exit(f"{path}: fewer than {LEAST} drives with their groups are no ground for a fit")
    if write:
        with open(path, encoding="utf-8") as file:
            lines = [line for line in file if not line.startswith("fit\t")]
        with open(path, "w", encoding="utf-8") as file:
            file.writelines(lines)
            for model, output, group, line, coverage, _, _ in found:
                numbers = (line.centre, line.slope, line.x_mean, line.x_square, line.factor)
                file.write("\t".join(["fit", model, output, group or "-", str(line.n), *(f"{x:.6g}" for x in numbers), f"{coverage:.3g}"]) + "\n")
        return
    print("| model | output | depends on | drives | found (%) | expected (%), 90 % interval | of left-out drives within |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for model, output, group, line, coverage, least, most in found:
        middle, half = line.at(line.x_mean), line.half(line.x_mean)
        on = f"{group}, power {line.slope:+.2g}" if group else "-"
        print(f"| {model} | {output.replace('_', ' ')} | {on} | {line.n} | {percent(least)} to {percent(most)} | "
              f"{percent(math.expm1(middle))} ({percent(math.expm1(middle - half))} ... {percent(math.expm1(middle + half))}) | {coverage:.0f} % |")
    n = sum(line.n for _, _, _, line, _, _, _ in found)
    print(f"\n{sum(0.01 * c * line.n for _, _, _, line, c, _, _ in found):.0f} of {n} left-out errors lie in their intervals.")


if __name__ == "__main__":
    main()
