# SPDX-License-Identifier: LGPL-2.1-or-later
"""package.py CASE PROGRAM: the package that reads results, against the files themselves and closed forms.

  frames      histories, units, engagements of a run
  spectra     of records that are known
  comparison  figures and parameters of two runs
  plates      stresses of plates, of histories that are known
  refuse      what is missing, damaged or foreign is said in a sentence
  scripts     figures.py draws and refuses

Without h5py or pandas it ends with 77: left out."""
import json
import pathlib
import shutil
import subprocess
import sys

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
import program
from program import check

try:
    import h5py
    import numpy as np
    import chaindrive
    from chaindrive import spectra as functions
except ModuleNotFoundError as error:
    if error.name == "chaindrive":
        raise
    sys.exit(77)

CASE, PROGRAM = sys.argv[1:3]
SHORT = {"Time/End time in ms": 16, "Output/Window start in ms": 8, "Output/Field interval in ms": 0}


def run(output, **entries):
    """A run of the paper's drive, simple and short."""
    changes = {**SHORT, **{name.replace("__", "/").replace("_", " "): value for name, value in entries.items()}}
    program.run("prm/paper/simple.prm", changes, "--quiet", "--output", output, program=PROGRAM)
    return chaindrive.open(output)


def close(value, expected, tolerance, what):
    check(abs(value - expected) <= tolerance, f"{what}: {value}, not {expected}")


def refused(expected, action):
    """The sentence of a RunError has these words."""
    try:
        action()
    except chaindrive.RunError as error:
        check(all(word in str(error) for word in expected), f"'{error}' does not say {expected}")
        check(str(error).endswith("."), f"no sentence: {error}")
        return
    check(False, f"not refused: {expected}")


def folder(name, time, datasets, summary=()):
    """A folder as a run leaves it, with these datasets {path: (values, unit)}."""
    shutil.rmtree(name, ignore_errors=True)
    path = pathlib.Path(name)
    path.mkdir()
    (path / "parameters.prm").write_text("subsection Drive\n  set Driver teeth = 10\n  set Driven teeth = 20\nend\n"
                                         "subsection Output\n  set Quantities = speeds\nend\n")
    start = {"window": {"start": float(time[0]), "end": float(time[-1])}, "drive": {"pitch_time": 0.01, "links": 40}}
    (path / "summary.json").write_text(json.dumps({**start, **dict(summary)}))
    with h5py.File(path / "histories.h5", "w") as file:
        file["time"] = time
        for dataset, (values, unit) in datasets.items():
            file[dataset] = values
            file[dataset].attrs["unit"] = unit
    return chaindrive.open(path)


def frames():
    one = run("simple")
    check(one.events == [] and one.summary["window"]["valid"] is True, f"events of a sound run: {one.events}")
    jumped = run("jumped", Drive__Layout__Centre_distance_from="slack", Drive__Layout__Slack_in_mm=70, Loads__Resisting_torque_in_N_m=600)
    check("jumped" in [event["kind"] for event in jumped.events] and jumped.summary["window"]["valid"] is False, f"events: {jumped.events}")
    with h5py.File("simple/histories.h5") as file:
        time, tension = file["time"][:], file["links/tension"][:]
        frame = one.history("links/tension", columns=[7, 3], start=4e-3, end=6e-3, units=("ms", "kN"))
        inside = (time >= 4e-3) & (time <= 6e-3)
        check(list(frame.columns) == [7, 3] and len(frame) == inside.sum() > 50, f"frame {frame.shape}")
        check(np.allclose(frame[3], 1e-3 * tension[inside, 3], rtol=1e-14), "a column in kN")
        check(np.allclose(frame.index, 1e3 * time[inside], rtol=1e-14), "times in ms")
        check(frame.attrs["unit"] == "kN" and frame.attrs["time_unit"] == "ms" and frame.attrs["description"], f"{frame.attrs}")
        check(one.history("links/tension").shape == tension.shape, "all of a dataset")
        hubs = one.group("hubs", units="rpm")
        check(np.allclose(hubs["driven_speed"], file["hubs/driven_speed"][:] * 30 / np.pi), "a group in rpm")
        check(hubs.attrs["units"]["driven_speed"] == "rpm" and hubs.attrs["units"]["driver_torque"] == "N m", f"{hubs.attrs}")
        check(len(one.histories) == sum(len(group) for group in file.values() if isinstance(group, h5py.Group)), "the list of histories")
        touches = one.engagements("driver", window=True, units=("ms", "mN s"))
        expected = [e for e in one.summary["engagements"]
                    if e["sprocket"] == "driver" and e["complete"] and 8e-3 <= e["time"] <= 16e-3]
        check(len(expected) >= 2 and len(touches) == len(expected), f"{len(touches)} engagements")
        close(touches["impulse"][1], 1e3 * expected[1]["impulse"], 1e-12, "an impulse in mN s")
        aligned = one.aligned_engagements(before=0., after=1e-3)
        for number, frame in aligned.items():
            close(frame.max(), expected[number]["peak_force"], 1e-3 * expected[number]["peak_force"], "peak of an aligned engagement")
        check(len(aligned.columns) >= 1, "no aligned engagement")
    check(one.n_links == 110 and one.sprockets == (15, 42) and one.parameter("Driver teeth") == 15, "the drive")
    close(one.pitch_time, 2 * np.pi / (15 * 120.74), 1e-12, "pitch time")


def spectra():
    # 20 periods of the tooth frequency of 100 Hz, sampled without regard to it
    time = np.arange(0., 0.2 + 1e-9, 1.03e-4)
    wave = 5. + 3. * np.cos(2 * np.pi * 100. * time + 0.4) + 0.5 * np.sin(2 * np.pi * 300. * time)
    jitter = time + 5e-7 * np.sin(np.arange(len(time)))  # half a percent of an interval
    for name, instants in (("equal", time), ("nearly", jitter)):
        waves = 5. + 3. * np.cos(2 * np.pi * 100. * instants + 0.4) + 0.5 * np.sin(2 * np.pi * 300. * instants)
        one = folder(name, instants, {"hubs/driven_speed": (waves, "rad/s")})
        spectrum = one.spectrum("hubs/driven_speed")
        teeth = chaindrive.harmonics(spectrum, 100., 4)
        for order, amplitude in ((1, 3.), (2, 0.), (3, 0.5), (4, 0.)):
            close(teeth["amplitude"][order], amplitude, 2e-4, f"{name}: harmonic {order}")
        others = spectrum["mean_square"].drop(teeth["frequency"][[1, 3]])
        check(others.max() < 1e-7, f"{name}: leaks {others.max()}")
        tapered = one.spectrum("hubs/driven_speed", window="hann")
        close(tapered["mean_square"].sum(), 4.625, 0.02, f"{name}: mean square with a Hann window")
        close(tapered["mean_square"].idxmax(), 100., 3., f"{name}: the highest line")
    random = np.random.default_rng(3)
    for n in (1000, 1001):
        noise = random.normal(0., 1., n)
        _, power = functions.mean_square_lines(noise, 1e-4)
        close(power.sum() / np.mean(noise ** 2), 1., 1e-12, "Parseval")
    bands = chaindrive.third_octaves(one.spectrum("hubs/driven_speed"), 20., 2000.)
    close(bands["rms"][100.], 3. / np.sqrt(2.), 1e-3, "the band of 100 Hz")
    close((bands["rms"] ** 2).sum(), 4.625, 1e-3, "sum over bands")
    folder("white", time, {"hubs/driven_speed": (random.normal(0., 1., len(time)), "rad/s")})
    white = chaindrive.third_octaves(chaindrive.open("white").spectrum("hubs/driven_speed", window="none"), 100., 2000.)["rms"] ** 2
    close(10 * np.log10(white[10 ** 3.2] / white[10 ** 2.9]), 3., 2., "white noise: 3 dB more in twice the band")
    refused(("not sampled at equal intervals", "History interval"),
            lambda: folder("unequal", time ** 1.2, {"hubs/driven_speed": (wave, "rad/s")}).spectrum("hubs/driven_speed"))
    refused(("shorter than a pitch time",), lambda: one.spectrum("hubs/driven_speed", end=0.005))
    late = folder("late", time, {"hubs/driven_speed": (wave, "rad/s")}, {"window": {"start": None, "end": None, "settled": False}})
    refused(("had not settled",), lambda: late.spectrum("hubs/driven_speed"))


def plates():
    # roller k touches at 15 + 10 k ms; what link j = k - 1 has in the 10 ms before tells j, everything else is far off
    time = np.linspace(0., 0.06, 601)
    links, far = np.arange(40), 1e9
    before = np.array([(time >= 0.005 + 0.01 * (j + 1) - 1e-9) & (time <= 0.015 + 0.01 * (j + 1) + 1e-9) for j in links]).T
    wave = np.sin(2 * np.pi * 400. * time)[:, None]
    of = lambda values: np.where(before, values, far)  # noqa: E731
    one = folder("plates", time, {
        "links/tension": (of(1000. + links + wave), "N"),
        "plates/axial_stress": (of(30e6 + links + wave), "Pa"),
        "plates/bending_in_plane": (of(4e6 * wave + 0. * links), "Pa"),
        "plates/bending_out_of_plane": (of(-3e6 - links), "Pa"),
        "plates/principal_1": (of(20e6 + links), "Pa"), "plates/principal_2": (of(-5e6 - links), "Pa")},
        {"engagements": [["driver", k, 0.015 + 0.01 * k, 1., 1., 1., 1., True] for k in range(5)]})
    file = pathlib.Path("plates/parameters.prm")
    entries = {"Waist ratio": 0.5, "Inner plate height in mm": 10, "Inner plate thickness in mm": 2, "Outer plate height in mm": 8,
               "Outer plate thickness in mm": "auto"}
    file.write_text(file.read_text() + "subsection Drive\n  subsection Chain\n" + "".join(f"    set {k} = {v}\n" for k, v in entries.items()) +
                    "  end\nend\n")
    found = chaindrive.plate_stresses(chaindrive.open("plates"), 4)
    check(list(found.index) == [39, 0, 1, 2] and list(found["kind"]) == ["outer", "inner", "outer", "inner"], f"links {found}")
    for link, row in list(found.iterrows())[1:]:
        expected = {"axial": 30e6 + link, "in_plane": 4e6 / np.sqrt(2.), "out_of_plane": 3e6 + link, "principal_1": 20e6 + link,
                    "principal_2": -5e6 - link}
        for name, value in expected.items():
            close(row[name], value, 2e-2 * abs(value) if name == "in_plane" else 0.1, f"link {link}: {name}")
    close(found["nominal"][2], 1002. / (2 * 0.5 * 10e-3 * 2e-3), 10., "nominal stress, N/m2")
    check(np.isnan(found["nominal"][1]), "a nominal stress of unknown dimensions")
    refused(("no history 'plates/axial_stress'", "plate stress"), lambda: chaindrive.plate_stresses(run("simple")))
    early = folder("early", time, {}, {"engagements": []})
    refused(("no roller meets the driver",), lambda: chaindrive.plate_stresses(early))
    said = subprocess.run([sys.executable, "-B", REPOSITORY / "scripts/figures.py", "--plates", "plates"], capture_output=True, text=True)
    check(said.returncode == 0 and "of nominal" in said.stdout and said.stdout.count("inner") == 3, f"figures.py: {said.stdout}{said.stderr}")


def comparison():
    runs = [run("simple"), run("braked", Loads__Resisting_torque_in_N_m=75)]
    table = chaindrive.compare(runs)
    torque = [one.summary["driver_torque_mean"] for one in runs]
    row = table.loc["driver_torque_mean"]
    check(row["unit"] == "N m" and row["simple"] == torque[0] and row["braked"] == torque[1], f"{row}")
    close(row["braked difference in %"], 100 * (torque[1] / torque[0] - 1), 1e-9, "difference in %")
    check(-60 < row["braked difference in %"] < -40, "half of the torque")
    impacts = runs[1].engagements("driver", window=True)["peak_force"]
    close(table.loc["driver_peak_force_largest", "braked"], impacts.max(), 1e-9, "largest impact")
    differ = chaindrive.changes(runs)
    check(list(differ.index) == ["Loads/Resisting torque in N m"] and list(differ.loc[differ.index[0]]) == ["150", "75"], f"{differ}")
    check(chaindrive.one_drive(runs), "one drive")


def refuse():
    one = run("simple", Output__Quantities="speeds, tensions, roller motion", Output__Rollers="0, 5")
    refused(("tooth forces", "Output/Quantities", "speeds, tensions, roller motion"), lambda: one["rollers/driver_force"])
    refused(("joint forces", "fidelity"), lambda: one["joints/roller_bush_force"])
    refused(("no column 6", "Output/Rollers"), lambda: one.column("rollers/velocity_x", 6))
    refused(("'engagements'",), one.engagements)
    refused(("no unit 'furlong'",), lambda: one.history("spans/tight_tension", units="furlong"))
    refused(("no entry 'Colour'",), lambda: one.parameters["Colour"])
    check(one.column("rollers/velocity_x", 5).shape == one.time.shape, "roller 5")
    refused(("no folder 'nowhere'",), lambda: chaindrive.open("nowhere"))
    pathlib.Path("file").write_text("")
    refused(("is a file",), lambda: chaindrive.open("file"))
    pathlib.Path("foreign").mkdir(exist_ok=True)
    refused(("not the folder of a run",), lambda: chaindrive.open("foreign"))

    def copy(name):
        shutil.rmtree(name, ignore_errors=True)
        shutil.copytree("simple", name)
        return pathlib.Path(name)

    (copy("unfinished") / "summary.json").unlink()
    refused(("has not finished", "--resume"), lambda: chaindrive.open("unfinished"))
    part = chaindrive.open("unfinished", partial=True)
    check(len(part["spans/tight_tension"]) == len(one.time) and part.summary == {}, "what there is of a run that has not finished")
    refused(("has not finished",), part.engagements)
    (copy("cut") / "summary.json").write_text('{"driven_angle_end": 1.')
    refused(("summary.json", "damaged"), lambda: chaindrive.open("cut").summary)
    file = copy("short") / "histories.h5"
    file.write_bytes(file.read_bytes()[:20000])
    refused(("histories.h5", "damaged"), lambda: chaindrive.open("short").time)
    (copy("text") / "histories.h5").write_text("time, tension")
    refused(("histories.h5", "no HDF5 file"), lambda: chaindrive.open("text").time)
    (copy("without") / "histories.h5").unlink()
    refused(("histories.h5", "not kept"), lambda: chaindrive.open("without").time)
    with h5py.File(copy("running") / "histories.h5", "r+") as file:  # as it looks while the program runs
        file["time"][300:] = np.nan
    check(len(chaindrive.open("running").time) == 300 == len(chaindrive.open("running")["spans/tight_tension"]), "rows not reached yet")


def scripts():
    run("simple")
    drawn = subprocess.run([sys.executable, "-B", REPOSITORY / "scripts/figures.py", "--simple", "simple", "--full", "simple", "--output", "."],
                           capture_output=True, text=True)
    check(drawn.returncode == 0 and "R12 full" in drawn.stdout and pathlib.Path("velocities.png").stat().st_size > 5000,
          f"figures.py: {drawn.stdout}{drawn.stderr}")
    for names, words in ((("nowhere", "simple"), "There is no folder 'nowhere'"), (("simple", "."), "not the folder of a run")):
        done = subprocess.run([sys.executable, "-B", REPOSITORY / "scripts/figures.py", "--simple", names[0], "--full", names[1]],
                              capture_output=True, text=True)
        check(done.returncode == 2 and words in done.stderr and "Traceback" not in done.stderr, f"figures.py {names}: {done.stderr}")


{"frames": frames, "spectra": spectra, "comparison": comparison, "plates": plates, "refuse": refuse, "scripts": scripts}[CASE]()
