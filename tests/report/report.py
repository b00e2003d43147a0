# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.py CASE PROGRAM: the page on runs.

  one      a run ends with its page, which is complete in itself: every figure with data, those of the summary
  several  runs on the same axes, differences, runs of different drives
  meaning  sentences hold for a load that changes sides, figures that are not as they should be are marked, and the paper is only spoken of to
           those who know it
  invalid  what is found in a window whose means tell nothing is marked as such in words, and differs by nothing; all else is as it was
  missing  what a run does not have is said in its place, and the rest is shown
  noise    what `chaindrive noise` leaves behind is drawn, of one run and of several
  refuse   folders that are none, of no run; more runs than colours
  browser  headless Chromium draws every figure, without an error in its console

Without h5py or pandas all end with 77, without plotly.js or Chromium `browser` does: left out."""
import base64
import gzip
import html
import html.parser
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import program
from program import check

try:
    import h5py
    from chaindrive.report import page as pages
except ModuleNotFoundError as error:
    if error.name not in ("h5py", "pandas", "numpy"):
        raise
    sys.exit(77)

CASE, PROGRAM = sys.argv[1:3]
REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
os.environ.pop("PYTHONPATH", None)  # what is started finds its modules by itself
SHORT = {"Time/End time in ms": 18, "Output/Window start in ms": 8, "Output/Field interval in ms": 0}
CHROMIUM = shutil.which("chromium")
FIGURES = ("tensions", "offsets", "shapes", "shafts", "velocities", "link-forces", "contact-forces", "aligned", "peaks", "wrap", "spectra",
           "roller-bands", "energies")


def run(output, *options, file="prm/paper/simple.prm", **entries):
    changes = {**SHORT, **{name.replace("__", "/").replace("_", " "): value for name, value in entries.items()}}
    return program.run(file, changes, "--output", output, *options, program=PROGRAM)


def report(*words, status=0):
    done = subprocess.run([PROGRAM, "report", *words], capture_output=True, text=True)
    check(done.returncode == status and "Traceback" not in done.stderr, f"report {words}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


class Reader(html.parser.HTMLParser):
    """Elements that are not closed in order, what a page loads, its texts by the section or figure they are in, its packed scripts."""

    def __init__(self, text):
        super().__init__()
        self.open, self.wrong, self.loads, self.texts, self.panels, self.packed = [], [], [], {}, {}, {}
        self.script = None
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag not in ("meta", "link", "input", "br", "img"):
            self.open.append((tag, attributes.get("id") if tag in ("section", "figure") else None))
        self.loads += [attributes[name] for name in ("src", "href", "data") if not attributes.get(name, "#").startswith(("#", "data:"))]
        if tag == "script":
            self.script = attributes.get("id")
        if "data-panel" in attributes:
            self.panels.setdefault(self._where("figure"), []).append(int(attributes["data-panel"]))

    def handle_startendtag(self, tag, attributes):
        pass

    def handle_endtag(self, tag):
        if not self.open or self.open[-1][0] != tag:
            self.wrong.append(f"</{tag}> in {self.open[-1:]}")
        else:
            self.open.pop()

    def _where(self, *tags):
        return next((name for tag, name in reversed(self.open) if tag in tags and name), None)

    def handle_data(self, data):
        if self.open and self.open[-1][0] == "script":
            if self.script:
                self.packed[self.script] = self.packed.get(self.script, "") + data
            return
        for tag in ("section", "figure"):
            where = self._where(tag)
            self.texts[where] = self.texts.get(where, "") + data
        self.texts["all"] = self.texts.get("all", "") + data

    def data(self):
        return json.loads(gzip.decompress(base64.b64decode(self.packed["data"])))


def read(file):
    text = pathlib.Path(file).read_text()
    check(len(text) < 8e6, f"{len(text)} bytes")
    check("NaN" not in text.split('<script type="application/gzip"')[0] and "nan" not in re.sub(r"<[^>]*>", "", text.split("<footer>")[0]).split(),
          "a number that is none is shown")
    found = Reader(text)
    check(not found.wrong and not found.open, f"not closed in order: {found.wrong[:3]} {found.open[:3]}")
    check(not found.loads, f"the page loads {found.loads}")
    return found


def numbers(values):
    """Values of a curve as the page has them."""
    return [values["first"] + i * values["step"] for i in range(values["n"])] if isinstance(values, dict) else values


def check_figures(found, names, curves=1):
    """Every panel of these figures has curves of finite numbers within its axes, and not all the same."""
    data = found.data()
    for name in names:
        check(found.panels.get(name), f"the figure {name} has no panels")
        for panel in (data["panels"][number] for number in found.panels[name]):
            check(len(panel["c"]) >= curves, f"{name}: {len(panel['c'])} curves")
            for curve in panel["c"]:
                x, y = numbers(curve["x"]), numbers(curve["y"])
                pairs = [(a, b) for a, b in zip(x, y) if a is not None and b is not None]
                check(len(x) == len(y) and len(pairs) >= 2, f"{name}: {len(x)} and {len(y)} values, {len(pairs)} points")
                check(all(math.isfinite(a) and math.isfinite(b) for a, b in pairs), f"{name}: not finite")
                inside = [panel["xr"][0] <= a * (1 + 1e-3) and a * (1 - 1e-3) <= panel["xr"][1] for a, _ in pairs if a >= 0]
                check(sum(inside) >= 0.9 * len(inside), f"{name}: outside of its axis")
            check(any(len({b for b in numbers(curve["y"])}) > 1 for curve in panel["c"]), f"{name}: all the same")
    return data


def one():
    begin = time.time()
    said = run("results", "--report")
    check("Report: results/report.html" in said, f"the page is not mentioned:\n{said}")
    found = read("results/report.html")
    data = check_figures(found, FIGURES)
    summary = program.summary("results")
    check(f"{summary['tight_tension_mean']:.4g}" in found.texts["answers"], "the tension of the summary is not among the key figures")
    check(summary["checks"][0]["sentence"] in found.texts["checks"], "a design check is missing")
    check("643.038\u00a0mm" in found.texts["drive"] and "288.25\u00a0Hz" in found.texts["drive"], "the drive's block")
    tension = data["panels"][found.panels["tensions"][0]]["c"][0]
    with h5py.File("results/histories.h5") as file:
        most = 1e-3 * file["spans/tight_tension"][:].max()
    check(abs(max(numbers(tension["y"])) - most) < 1e-3, f"largest tension {max(numbers(tension['y']))} instead of {most} kN")
    film = data["films"][0]
    check(50 < len(film["x"]) <= 201 and len(film["x"][0]) == 110 == len(film["tension"][-1]), f"the film: {len(film['x'])} frames")
    load, power = summary["statistics"]["driver_load"], summary["losses"]["roller-driver"]["power"]
    check(f"{load['mean']:.4g}\u00a0N" in found.texts["statistics"] and f"{load['largest']:.4g}\u00a0N" in found.texts["answers"], "the load of the shaft")
    check(f"{power:.3g}\u00a0W" in found.texts["statistics"], "the loss at the driver")
    check("chaindrive noise" in found.texts["noise-spectra"], "what is missing of noise is not said")
    check(found.texts["all"].count("How does the drive of Zheng, Wang and Quek") == 1, "the question of the file")
    event = {"kind": "jumped", "time": 9e-3, "sprocket": "driver", "in_window": True, "sentence": "The chain jumped <i>a</i> tooth."}
    pathlib.Path("results/summary.json").write_text(json.dumps({**summary, "events": [event]}))
    begin = time.time()
    report("results")
    text = read("results/report.html").texts["all"]
    check("not valid" in text.split("Key figures")[0] and "The chain jumped ‹i›a‹/i› tooth." in text and "not valid" not in found.texts["all"],
          "an event is not said above the key figures, or one of a valid run")
    check(time.time() - begin < 10, f"{time.time() - begin:.1f} s for a report")
    run("results", "--quiet", "--report", Time__End_time_in_ms=10)
    check(not pathlib.Path("results/report.html").exists(), "an old page is left beside new results, or --quiet wrote one")


def several():
    run("heavy")
    run("light", Loads__Resisting_torque_in_N_m=75)
    report("heavy", "light", "--output", "both.html")
    found = read("both.html")
    data = check_figures(found, FIGURES)
    for name in ("tensions", "shafts", "spectra", "wrap"):
        for panel in (data["panels"][number] for number in found.panels[name]):
            check([curve["n"] for curve in panel["c"]] == ["heavy", "light"], f"{name}: {[c['n'] for c in panel['c']]}")
    pair = [data["panels"][number] for number in found.panels["contact-forces"]]
    check(len(pair) == 2 and pair[0]["yr"] == pair[1]["yr"] and pair[0]["xr"] == pair[1]["xr"], "not on the same axes")
    torques = [program.summary(name)["driver_torque_mean"] for name in ("heavy", "light")]
    row = re.search(r"driver torque, mean</th>.*?</tr>", pathlib.Path("both.html").read_text())[0]
    difference = f"{100 * (torques[1] / torques[0] - 1):+.2g}".replace("-", "−")
    check(f"{torques[0]:.4g}\u00a0N\u00a0m" in row and difference in row, f"{torques}: {row}")
    check("Loads/Resisting torque in N m" in found.texts["answers"] and "different drives" not in found.texts["all"], "entries that differ")

    auto = {f"Drive__Sprockets__Driver_{what}_in_mm": "auto" for what in ("outside_diameter", "hub_diameter", "bore")}
    run("other", Drive__Driver_teeth=17, Drive__Layout__Centre_distance_from="slack", Drive__Layout__Slack_in_mm=0.5, **auto)
    report("heavy", "other", "--output", "drives.html")
    found = read("drives.html")
    check("different drives" in found.texts["all"], "different drives are compared without a word")
    check_figures(found, ("tensions", "shafts", "velocities"))


def cards(found_in):
    """Name of each key figure: whether it is marked, and its sentence."""
    found = re.findall(r'<div class="card( warning)?"><div class="name">([^<]*)</div><div class="value">.*?</div><p>(.*?)</p>', pathlib.Path(found_in).read_text())
    return {name: (bool(marked), html.unescape(sentence)) for marked, name, sentence in found}


def meaning():
    tight, slack, error = "Tension of the tight span", "Tension of the slack span", "Error of the energy balance"
    run("settled", "--report", Drive__Layout__Start="settled")
    found, said = cards("settled/report.html"), read("settled/report.html").texts["all"]
    check(not any(marked for marked, _ in found.values()), f"a valid run has marked figures: {found}")
    check("power and speed ask for" in found[tight][1] and "not from the load" in found[slack][1], f"{found[tight]} {found[slack]}")
    check(said.count("Zheng, Wang and Quek (2004) show it in their Figure") >= 4 and "The paper" not in said, "figures of the paper")

    run("turned", Loads__Torque_step_time_in_ms=5, Loads__Torque_after_step_in_N_m=-140, Time__End_time_in_ms=22, Output__Window_start_in_ms=14)
    summary = program.summary("turned")
    tensions = [summary["statistics"][f"{name}_tension"] for name in ("tight", "slack")]
    check(tensions[1]["mean"] > 2 * tensions[0]["mean"], f"the load does not drive: {tensions}")
    summary["drive"]["tensile_strength"] = 1.07 * tensions[1]["largest"]
    summary["energy_imbalance_max"] = 0.006
    pathlib.Path("turned/summary.json").write_text(json.dumps(summary))
    file = pathlib.Path("turned/input.prm")
    file.write_text(file.read_text().replace("Zheng", "Somebody"))
    report("turned")
    found, said = cards("turned/report.html"), read("turned/report.html").texts["all"]
    check("as when the load drives" in found[tight][1] and "against" not in found[tight][1], found[tight])
    check("as when the load drives" in found[slack][1] and "not from the load" not in said, found[slack])
    check("1.07 times the largest tension" in found[tight][1], found[tight])
    check({name for name, (marked, _) in found.items() if marked} == {tight, error}, f"marked: {found}")
    check("Zheng" not in said and "the paper" not in said.lower(), "a paper is spoken of that the reader does not know")


def invalid():
    mark = '<b class="invalid">not valid</b>'
    run("sound", "--report")
    run("jumped", "--report", Drive__Layout__Centre_distance_from="slack", Drive__Layout__Slack_in_mm=70, Loads__Resisting_torque_in_N_m=600)
    page = pathlib.Path("jumped/report.html").read_text()
    names = {re.sub("<.*", "", name).strip(): mark in name for name in re.findall(r'<div class="name">(.*?)</div>', page)}
    whole = {"Pressure in the joints", "Tooth frequency", "Error of the energy balance"}
    check(names and {name for name, marked in names.items() if not marked} == whole and len(names) > 9, f"marked: {names}")
    found = read("jumped/report.html").texts
    check("pitch times not valid" in found["run"] and "These figures are not valid" in found["statistics"], f"{found['run']} {found['statistics'][:200]}")
    check("not valid" not in read("sound/report.html").texts["all"], "a valid run is marked")

    for pair in (("sound", "jumped"), ("jumped", "sound")):
        report(*pair, "--output", "both.html")
        page = pathlib.Path("both.html").read_text()
        rows = {what: re.search(what + r"</th>.*?</tr>", page)[0] for what in ("driver torque, mean", "work of the driver", "impact on the driver, mean")}
        for what in ("driver torque, mean", "impact on the driver, mean"):
            check(rows[what].count(mark) == 1 and "%" not in rows[what], f"{pair}: {rows[what]}")
        check(mark not in rows["work of the driver"] and "%" in rows["work of the driver"], f"{pair}: {rows}")


def missing():
    run("few", Output__Quantities="speeds, tensions", Output__Rollers="0, 5")
    report("few")
    found = read("few/report.html")
    check_figures(found, ("tensions", "offsets", "shafts", "link-forces" if "link-forces" in found.panels else "spectra"))
    for figure, word in (("contact-forces", "engagements"), ("aligned", "engagements"), ("energies", "energy"), ("wrap", "tooth forces")):
        check(not found.panels.get(figure) and f"'{word}'" in found.texts[figure], f"{figure}: {found.texts.get(figure)}")
    check("rollers" in found.texts["motion"] and not found.data()["films"], found.texts["motion"])

    run("whole")
    shutil.copytree("whole", "unfinished", dirs_exist_ok=True)
    os.remove("unfinished/summary.json")
    report("whole", "unfinished", "--output", "two.html")
    found = read("two.html")
    check("has not finished" in found.texts["all"], "an unfinished run without a word")
    data = check_figures(found, ("tensions", "shafts"))
    check(len(data["panels"][found.panels["tensions"][0]]["c"]) == 2, "histories of an unfinished run are not shown")
    report("unfinished")
    check_figures(read("unfinished/report.html"), ("tensions", "shafts"))

    run("unsettled", Time__End_time_in_ms=13, Output__Window_start_in_ms="settled")
    report("unsettled")
    found = read("unsettled/report.html")
    check_figures(found, ("tensions", "velocities", "contact-forces", "wrap"))
    check("had not settled" in found.texts["run"] and "no roller meets the driver" in found.texts["velocities"], "a window that has not begun")

    shutil.copytree("whole", "cut", dirs_exist_ok=True)
    content = pathlib.Path("whole/histories.h5").read_bytes()
    pathlib.Path("cut/histories.h5").write_bytes(content[:30000])
    report("cut")
    found = read("cut/report.html")
    check("damaged" in found.texts["tensions"] and f"{program.summary('cut')['tight_tension_mean']:.4g}" in found.texts["answers"], "a damaged file")
    with h5py.File("cut/histories.h5", "w") as file:  # foreign
        file["time"] = [0., 1e-3, 5e-3]
    report("cut")
    check("no history 'spans/tight_tension'" in read("cut/report.html").texts["tensions"], "a foreign file")
    pathlib.Path("cut/summary.json").write_text("[1, 2")
    report("cut")
    check("damaged" in read("cut/report.html").texts["all"].split("Key figures")[0], "a damaged summary")


def add_noise(folder, amplitude):
    """Files as `chaindrive noise` writes them: a tone of 1 kHz at two observers, the second half as loud."""
    names, seconds = ["front", "microphone"], [i * 1e-5 for i in range(1000)]
    level = [20 * math.log10(factor * amplitude / math.sqrt(2) / 2e-5) for factor in (0.5, 1.)]
    observers = [{"name": name, "position": [0., 0.4, 0.], "level": level[k], "level_a": level[k] - 0.1, "level_a_uncertainty": 0.27, "peak_pressure": amplitude,
                  "third_octaves": [None, level[k] - 30., level[k]], "orders": [level[k]], "engagement_peaks": [amplitude, 0.9 * amplitude, 0.8 * amplitude]}
                 for k, name in enumerate(names)]
    found = {"observers": observers, "third_octaves": [630., 800., 1000.], "tooth_frequency": 288., "periods": 3,
             "contributions": {"driver": level[1] - 1., "driven": level[1] - 7.}, "rollers": [],
             "directivity": {"angle": [0., 1., 2., 3.], "level": [60., 63., 64., 61.]}}
    pathlib.Path(folder, "acoustics.json").write_text(json.dumps(found))
    with h5py.File(f"{folder}/acoustics.h5", "w") as file:
        file["time"], file["frequency"] = seconds, [100. * k for k in range(50)]
        tone = [amplitude * math.sin(2000. * math.pi * t) for t in seconds]
        file["pressure"] = [[0.5 * p, p] for p in tone]
        square = [0.5 * amplitude ** 2 if k == 10 else 1e-12 * (k + 1) for k in range(50)]
        file["spectrum"] = [[0.25 * s, s] for s in square]
    return level[1]


def noise():
    run("loud")
    run("quiet", Loads__Resisting_torque_in_N_m=75)
    loud = add_noise("loud", 2.)
    report("loud")
    found = read("loud/report.html")
    names = ("noise-spectra", "pressure", "noise-peaks", "directivity")
    data = check_figures(found, FIGURES + names)
    lines = data["panels"][found.panels["noise-spectra"][0]]["c"][0]
    check(abs(max(numbers(lines["y"])) - loud) < 0.01, f"the line of 1 kHz has {max(numbers(lines['y']))} instead of {loud} dB")
    check(f"{loud - 0.1:.1f}" in found.texts["noise"] and f"{loud - 0.1:.3g} dB(A)" in found.texts["answers"], "the level of the microphone")
    check("± 0.27\u00a0dB(A)" in found.texts["answers"] and f"{loud - 0.1:.1f} ± 0.27\u00a0dB" in found.texts["noise"], "the interval of the level")
    report("loud", "quiet", "--output", "half.html")
    half = read("half.html")
    check_figures(half, names)
    check("no noise of the run in 'quiet'" in half.texts["noise"], "the run without noise is not mentioned")
    quiet = add_noise("quiet", 1.)
    report("loud", "quiet", "--output", "both.html")
    check(f"{quiet - 0.1:.4g} dB(A)" in read("both.html").texts["answers"], "levels are not compared")
    pathlib.Path("quiet/acoustics.h5").write_text("")
    report("loud", "quiet", "--output", "broken.html")
    check("acoustics.h5' is damaged" in read("broken.html").texts["noise"], "a damaged file of noise")


def refuse():
    pathlib.Path("empty").mkdir(exist_ok=True)
    for words, expected in ((["nowhere"], "There is no folder 'nowhere'"), (["empty"], "not the folder of a run"), ([], "Which runs?"),
                            (["empty", "--set", "Time/End time in ms=3"], "--set belongs to runs")):
        check(expected in report(*words, status=2), f"{words} is not refused with '{expected}'")
    run("short", Time__End_time_in_ms=10)
    shutil.copytree("short", "-dash", dirs_exist_ok=True)
    report("--", "-dash")
    report("--output=-page.html", "--", "-dash", "short")
    check(read("-dash/report.html") and read("-page.html"), "a folder and a page whose names begin with a dash")
    check("up to 7 runs" in report(*["short"] * 8, status=2), "eight runs")
    check("cannot be written" in report("short", "--output", "nowhere/page.html", status=3), "a page that cannot be written")
    for script, words in (("--after-run", 0), ("--quiet", 2)):
        done = subprocess.run([sys.executable, "-B", REPOSITORY / "python/start.py", "report", script, "--", "nowhere"])
        check(done.returncode == words, f"{script}: {done.returncode}")


def browse(file, *options):
    """The page as Chromium has drawn it, and what its console says. The profile is new: one of another version, or in use, stops it."""
    shutil.rmtree("profile", ignore_errors=True)
    done = subprocess.run([CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
                           "--disable-component-update", "--disable-sync", "--enable-logging=stderr", f"--user-data-dir={os.getcwd()}/profile",
                           "--virtual-time-budget=60000", "--dump-dom", *options, pathlib.Path(file).resolve().as_uri()],
                          capture_output=True, text=True, timeout=150)
    return done.stdout, [line for line in done.stderr.splitlines() if "CONSOLE" in line]


# What a reader does when the page is drawn: switches a curve off, plays the chain, looks at the driver.
READER = """<script>
const wait = setInterval(() => {
  if (document.documentElement.dataset.state !== "ready") return;
  clearInterval(wait);
  const said = {}, figure = document.querySelector("#tensions"), plot = figure.querySelector(".live"), button = figure.querySelector(".key button");
  button.click();
  said.pressed = button.getAttribute("aria-pressed");
  said.visible = plot.data.map(trace => trace.visible !== false);
  const film = document.querySelector(".film"), before = film.querySelector("output").textContent, canvas = film.querySelector("canvas");
  const inked = () => new Set(canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data).size;
  said.colours = inked();
  said.views = [...film.querySelectorAll("option")].map(option => option.value + ":" + option.textContent);
  const heights = [canvas.height];
  film.querySelector("select").value = "driver";
  film.querySelector("select").dispatchEvent(new Event("change"));
  heights.push(canvas.height);
  film.querySelector(".controls button").click();
  setTimeout(() => {
    said.moved = film.querySelector("output").textContent !== before;
    said.heights = heights;
    document.documentElement.dataset.reader = JSON.stringify(said);
  }, 500);
}, 50);
</script></body>"""


# What does not fit into the width of the page, the menu left out.
WIDTHS = """<script>
addEventListener("load", () => {
  document.querySelectorAll("details").forEach(one => { one.open = true; });
  const wide = [...document.querySelectorAll(".scroll")].filter(one => one.scrollWidth > one.clientWidth).map(one => one.textContent.slice(0, 60));
  if (document.documentElement.scrollWidth > document.documentElement.clientWidth) wide.push("the page");
  document.documentElement.dataset.wide = JSON.stringify(wide);
});
</script></body>"""


def browser():
    if CHROMIUM is None or pages.plotly() is None:
        sys.exit(77)
    run("results")
    run("light", Loads__Resisting_torque_in_N_m=75)
    report("results", "light", "--output", "both.html")
    report("results")
    for file, size in (("results/report.html", "1280,900"), ("both.html", "500,900")):
        found = read(file)
        panels = sum(map(len, found.panels.values()))
        dom, console = browse(file, f"--window-size={size}")
        state = re.search(r'<html[^>]*data-state="(\w+)"[^>]*', dom)
        check(state and state[1] == "ready", f"{file}: {state and state[0]}")
        check(not console, f"{file}: the console says {console[:3]}")
        drawn = re.split(r'<div class="live drawn[^>]*data-panel="\d+"', dom)[1:]
        check(len(drawn) == panels >= 20, f"{file}: {len(drawn)} of {panels} panels are drawn")
        for number, part in enumerate(drawn):
            shapes = re.findall(r'<path class="(?:js-line|js-fill|point)[^>]*? d="(M[^"]{12,})', part) + re.findall(r'<g class="point"><path[^>]* d="(M[^"]+)', part)
            check(shapes, f"{file}: panel {number} has no curve")
        check(dom.count('class="film drawn"') == len(found.data()["films"]) > 0, f"{file}: no film")
    pathlib.Path("width.html").write_text(pathlib.Path("results/report.html").read_text().replace("</body>", WIDTHS))
    dom, _ = browse("width.html", "--window-size=1100,900")
    wide = re.search(r'data-wide="([^"]*)"', dom)
    check(wide and json.loads(html.unescape(wide[1])) == [], f"cut off at 1100 pixels: {wide and html.unescape(wide[1])}")
    pathlib.Path("read.html").write_text(pathlib.Path("both.html").read_text().replace("</body>", READER))
    dom, console = browse("read.html", "--window-size=1280,900")
    done = re.search(r'data-reader="([^"]*)"', dom)
    check(done and not console, f"the page does not answer: {console[:3]}")
    said = json.loads(html.unescape(done[1]))
    check(said["pressed"] == "false" and said["visible"] == [False, True], f"the legend: {said}")
    check(said["views"] == [":whole drive", "driver:driver", "driven:driven sprocket"], f"the views: {said}")
    check(said["moved"] and said["heights"][0] != said["heights"][1] and said["colours"] > 20, f"the film: {said}")


{"one": one, "several": several, "missing": missing, "meaning": meaning, "invalid": invalid, "noise": noise, "refuse": refuse, "browser": browser}[CASE]()
