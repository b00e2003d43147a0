# SPDX-License-Identifier: LGPL-2.1-or-later
"""plugin.py CASE BUILD: what is made outside of the sources, against what is installed in a folder that is moved.

  prepare  installs the copy and builds the example and others, for the other cases
  run      doc/plugin-example: its brake and its quantity in a run against closed forms, in the documents, in what the run
           leaves behind, when it resumes, in a study, on two ranks; without it, or switched off, nothing changes
  refuse   libraries that are no plug-ins, or none for this program, each in one sentence
  library  a program with chaindrive's library
"""
import json
import math
import pathlib
import shutil
import sys

import h5py
import numpy as np

from program import check, start

CASE, BUILD = sys.argv[1], pathlib.Path(sys.argv[2])
BRAKE, DAMPING = "Additions/viscous brake", 0.3  # N m s, of example.prm
DAMPING_ENTRY = "Damping in N m s"
Z1, Z2, PITCH, SPEED, TORQUE, INERTIA = 11, 23, 19.05e-3, 120.0, 20.0, 5e-3  # of example.prm
FEW = ("--set", "Time/End time in ms=3", "--set", "Output/Window start in ms=0", "--set", "Output/Field interval in ms=0")


INCLUDE = "#include <chaindrive/plugin.h>\n"
OTHERS = {  # besides what works: a library that says nothing, one that adds nothing, one that lacks a function
    "stranger": "int answer() { return 42; }\n",
    "empty": INCLUDE + 'CHAINDRIVE_PLUGIN("empty", "1.0")\n',
    "lacking": INCLUDE + 'CHAINDRIVE_PLUGIN("lacking", "1.0")\nint nowhere();\nint here = nowhere();\n',
    "others": INCLUDE + r"""#include <chaindrive/functions/terms.h>
#include <chaindrive/scene/fidelity.h>
CHAINDRIVE_PLUGIN("others", "1.0")
using namespace chaindrive;
namespace
{
void build_stiff(const model::Model &model, const drive::Drive &drive, scene::Scene &scene)
{
  scene::Fidelity::builder_of("simple")(model, drive, scene);
  for (scene::Bar &bar : scene.bars)
    bar.stiffness *= 4.;
}
const scene::Fidelity stiff({"stiff", "lumped rollers on stiff bars."}, {false, false, false}, &build_stiff);

struct Constant
{
  struct Parameters
  {
    double torque = 0.; ///< N m
    bool   is_active() const { return torque != 0.; }
    void   declare(parameters::Declarations &declarations)
    {
      using namespace parameters;
      add(declarations, "Torque in N m", torque, unit::si, at_least(0.), "Always.");
    }
  };
  static functions::Term make(const Parameters &parameters, const functions::Shaft &)
  {
    return {functions::Variable::angle, std::make_shared<functions::Constant>(parameters.torque)};
  }
};
const functions::TermOf<Constant> constant(functions::Of::torque, {"Constant", "A torque."});
} // namespace
""",
}


def say(*words, status=0):
    """What `words` say on both streams; the status must be `status`."""
    said = start(list(map(str, words)))
    check(said.returncode == status, f"status {said.returncode} instead of {status}: {words}: {said.stdout}{said.stderr}")
    return said.stdout + said.stderr


def prepare():
    """A copy that is installed and then moved, and what is built against it: the example, and other libraries."""
    for folder in ("first", "moved", "example", "other"):
        shutil.rmtree(folder, ignore_errors=True)
    say("cmake", "--install", BUILD, "--prefix", pathlib.Path("first").resolve())
    root = pathlib.Path("first").rename("moved").resolve()
    shutil.copytree(root / "share/doc/chaindrive/doc/plugin-example", "example")
    folder = pathlib.Path("other")
    folder.mkdir()
    for name, text in OTHERS.items():
        (folder / f"{name}.cc").write_text(text)
    (folder / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.18)\nproject(other LANGUAGES CXX)\nfind_package(chaindrive REQUIRED)\n"
        f"foreach(name {' '.join(OTHERS)})\n  chaindrive_plugin(${{name}} ${{name}}.cc)\nendforeach()\n")
    for project in ("example", folder):
        say("cmake", "-S", project, "-B", f"{project}/build", f"-DCMAKE_PREFIX_PATH={root}")
        targets = ["all", "program"] if project == "example" else ["all"]
        say("cmake", "--build", f"{project}/build", "--parallel", "2", "--target", *targets)


def prepared():
    """The program of what `prepare` has made, the example's library and the folder of the others; example/example.prm."""
    made = pathlib.Path("../plugin-prepare").resolve()
    for folder in ("example", "unfit", "brakes"):
        shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(made / "example", "example", ignore=shutil.ignore_patterns("build"))
    return made / "moved/bin/chaindrive", made / "example/build/example.so", made / "other/build"


def histories(directory):
    found = {}
    with h5py.File(f"{directory}/histories.h5") as file:
        file.visititems(lambda name, item: found.update({name: np.squeeze(item[:])}) if isinstance(item, h5py.Dataset) else None)
    return found


def near(what, value, wanted, percent):
    print(f"{what}: {value:.6g}, {value / wanted:.5f} of {wanted:.6g}")
    check(abs(value / wanted - 1) <= percent / 100, f"{what} is not within {percent} %")


def closed_forms(program, plugin):
    """Means over twenty pitches, and what the brake has dissipated."""
    output = say(program, "example/example.prm", "--plugin", plugin, "--set", "Output/History interval in us=20",
                 "--set", "Output/History precision=double", "--output", "braked")
    summary, found = json.loads(pathlib.Path("braked/summary.json").read_text()), histories("braked")
    driven = SPEED * Z1 / Z2
    near("driven speed", summary["driven_speed_mean"], driven, 0.3)
    # what the spans bring to the driven sprocket: load, brake, kinetic energy, and what is lost there; the chain on it
    # would add a third to its inertia, and with this 0.2 % to the power
    time, speed = found["time"], found["hubs/driven_speed"]
    inside = (time >= 24e-3) & (time <= summary["window"]["end"])
    tension, speed_in = (found["spans/tight_tension"] - found["spans/slack_tension"])[inside], speed[inside]
    gained = 0.5 * INERTIA * (speed_in[-1] ** 2 - speed_in[0] ** 2) / np.ptp(time[inside])
    lost = summary["losses"]["roller-driven"]["power"] + 0.5 * summary["losses"]["chain damping"]["power"]
    near("power of the spans at the driven sprocket", float(np.mean(tension * speed_in)) * Z2 * PITCH / (2 * math.pi),
         float(np.mean(TORQUE * speed_in + DAMPING * speed_in ** 2)) + gained + lost, 0.5)
    # the ledger and, from the speed alone, the work of M = c w
    near("work of the brake", found["energy/spring_damping_loss"][-1],
         float(np.sum(0.5 * DAMPING * (speed[1:] ** 2 + speed[:-1] ** 2) * np.diff(time))), 0.05)
    check(summary["energy"]["spring_damping_loss"] >= found["energy/spring_damping_loss"][-1] > 0, "the summary lacks the work")
    near("power of the brake in the window", summary["losses"]["force elements"]["power"],
         float(np.mean(DAMPING * speed_in ** 2)), 0.5)
    error = found["hubs/transmission_error"]
    wanted = found["hubs/driven_angle"] - found["hubs/driver_angle"] * Z1 / Z2
    check(np.max(np.abs(error - wanted)) < 1e-12 < np.ptp(error), "the quantity is not what the angles say")
    near("range of the transmission error", summary["transmission_error_range"], float(np.ptp(error[inside])), 1)
    return output, summary


def record(program, plugin, output, summary):
    """What a run says of its plug-ins, and in what it can be found later."""
    checksum = summary["plugins"][0]["checksum"]
    check(summary["plugins"] == [{"name": "example", "version": "1.0", "path": str(plugin), "checksum": checksum}], "plugins")
    line = (f"Plug-in example 1.0: {plugin}, checksum {checksum}, adds addition 'viscous brake', quantity 'transmission error'")
    for text in (output, pathlib.Path("braked/log.txt").read_text()):
        check(line in text.splitlines(), f"not said: {line}: {text[:3000]}")
    kept = pathlib.Path("braked/parameters.prm").read_text()
    check(f"# {line}\n" in kept and "subsection viscous brake" in kept and "set Damping in N m s = 0.3" in kept, "parameters.prm")
    # what is kept can be run again, and only so
    say(program, "plan", "braked/parameters.prm", "--plugin", plugin)
    refused = say(program, "plan", "braked/parameters.prm", status=2)
    check("there is no section 'Additions'." in refused and "--plugin FILE" in refused, refused)
    refused = say(program, "noise", "braked", status=2)
    check("--plugin FILE" in refused, refused)


def documents(program, plugin):
    template, without = say(program, "template", "--plugin", plugin), say(program, "template")
    check("subsection viscous brake" in template and "viscous" not in without, "template")
    pathlib.Path("all.prm").write_text(template)
    say(program, "plan", "all.prm", "--plugin", plugin)
    reference = say(program, "document", "--plugin", plugin)
    for text in (f"## {BRAKE}\n", "| `Damping in N m s` | `0.01` | a number of at least 0 |", "## Quantities/transmission error\n",
                 "| example | addition | viscous brake |", "| example | quantity | transmission error |"):
        check(text in reference and text not in say(program, "document"), f"document: {text}")
    schema = json.loads(say(program, "document", "--schema", "--plugin", plugin))
    check(schema["histories"]["hubs/transmission_error"]["unit"] == "rad" and "transmission_error_range" in schema["summary"], "schema")


def without(program, plugin):
    """A plug-in whose addition is not active changes no digit."""
    text = pathlib.Path("example/example.prm").read_text()
    pathlib.Path("plain.prm").write_text(text[:text.index("subsection Additions")] + text[text.index("subsection Time"):])
    double = ("--set", "Output/History precision=double")
    say(program, "plain.prm", *FEW, *double, "--output", "plain")
    said = say(program, "example/example.prm", *FEW, *double, "--plugin", plugin, "--set", f"{BRAKE}/Active=false", "--output", "off")
    check(f"{BRAKE}/Damping in N m s has no effect, since {BRAKE}/Active = false." in said, said)
    plain, off = histories("plain"), histories("off")
    check(set(off) - set(plain) == {"hubs/transmission_error"} and not set(plain) - set(off), f"{set(off) ^ set(plain)}")
    for name in plain:
        check(plain[name].tobytes() == off[name].tobytes(), f"{name} is another one")
    for entry, sentence in ((f"{BRAKE}/Sprocket=third", f"{BRAKE}/Sprocket = third is not a sprocket of the drive"),
                            (f"{BRAKE}/Damping in N m s=-1", "it must be a number of at least 0"),
                            (f"{BRAKE}/Dampings=1", "Did you mean")):
        check(sentence in say(program, "plan", "example/example.prm", "--plugin", plugin, "--set", entry, status=2), entry)
    refused = say(program, "plan", "plain.prm", "--set", f"{BRAKE}/Active=true", status=2)
    check("--plugin FILE" in refused, refused)


def resume(program, plugin):
    """A run that goes on has the same plug-ins and the same values, and then the same results."""
    few = [*FEW, "--set", "Output/History precision=double"]
    run = [program, "example/example.prm", "--plugin", plugin, *few]
    say(*run, "--output", "whole")
    say(*run, "--set", "Time/End time in ms=1", "--set", "Output/Checkpoint interval in ms=0.5", "--output", "parts")
    refused = say(program, "plain.prm", *few, "--resume", "auto", "--output", "parts", status=2)
    check("there --plugin = example 1.0, here --plugin = none." in refused, refused)
    refused = say(*run, "--set", f"{BRAKE}/Damping in N m s=0.4", "--resume", "auto", "--output", "parts", status=2)
    check(f"there {BRAKE}/Damping in N m s = 0.3, here {BRAKE}/Damping in N m s = 0.4" in refused, refused)
    say(*run, "--resume", "auto", "--output", "parts")
    whole, parts = histories("whole"), histories("parts")
    check(set(whole) == set(parts), "other histories")
    for name in whole:
        check(whole[name].tobytes() == parts[name].tobytes(), f"{name} is another one after the run has resumed")


def study(program, plugin):
    """The runs of a study have the plug-ins of its command line, and run again when a library has changed."""
    pathlib.Path("brakes.prm").write_text(f"""include example/example.prm
subsection Study
  set Outputs = tight_tension_mean
  set Phases = 1
end
subsection Additions
  subsection viscous brake
    set {DAMPING_ENTRY} = {{0.3 | 0.6}}
  end
end
""")
    words = [program, "study", "brakes.prm", *FEW, "--cores", "2", "--output", "brakes"]
    check("--plugin FILE" in say(*words, status=2), "a study without the plug-in")
    copy = pathlib.Path("copy.so").resolve()
    shutil.copy(plugin, copy)
    say(*words, "--plugin", "copy.so")
    results = sorted(pathlib.Path("brakes").glob("*/*/result.json"))
    check(len(results) == 2 and all(json.loads(file.read_text())["status"] == 0 for file in results), f"{results}")
    summaries = [json.loads((file.parent / "summary.json").read_text()) for file in results]
    check(all(one["plugins"][0]["path"] == str(copy) for one in summaries), "the plug-ins of runs")
    powers = [one["losses"]["force elements"]["power"] for one in summaries]
    check(1.8 < powers[1] / powers[0] < 2.0, f"the powers of the brake with twice the damping: {powers}")
    times = [file.stat().st_mtime for file in results]
    say(*words, "--plugin", "copy.so")
    check([file.stat().st_mtime for file in results] == times, "finished runs have run again")
    with open(copy, "ab") as file:
        file.write(b" ")
    say(*words, "--plugin", "copy.so")
    check(all(file.stat().st_mtime > time for file, time in zip(results, times)), "the runs are those of another library")


def others(program, plugin):
    """A fidelity and a term of a plug-in do what the same asked of the program's own entries does."""
    few = [*FEW, "--set", "Output/History precision=double", "--plugin", plugin]
    said = say(program, "plain.prm", *few, "--set", "Model/Fidelity=stiff", "--output", "stiff")
    check("adds fidelity 'stiff', term of a torque 'Constant'" in said, said)
    say(program, "plain.prm", *few, "--set", "Loads/driven/Constant/Torque in N m=5", "--output", "term")
    say(program, "plain.prm", *few, "--set", f"Loads/Resisting torque in N m={TORQUE + 5}", "--output", "torque")
    term, torque = (json.loads(pathlib.Path(f"{name}/summary.json").read_text()) for name in ("term", "torque"))
    near("tension with the torque of a term", term["tight_tension_mean"], torque["tight_tension_mean"], 0.1)
    plain, found = histories("plain"), histories("stiff")
    check(set(found) == set(plain), f"{set(found) ^ set(plain)}")
    check(np.ptp(found["hubs/driven_speed"]) != np.ptp(plain["hubs/driven_speed"]), "the stiff bars change nothing")


def run():
    program, plugin, other = prepared()
    output, summary = closed_forms(program, plugin)
    record(program, plugin, output, summary)
    documents(program, plugin)
    without(program, plugin)
    others(program, other / "others.so")
    resume(program, plugin)
    study(program, plugin)
    two = ["mpirun", "-n", "2", program, "example/example.prm", *FEW, "--output", "two"]
    check("adds addition 'viscous brake'" in say(*two, "--plugin", plugin), "two ranks")


def refuse():
    program, plugin, unfit = prepared()
    other = pathlib.Path("unfit").resolve()
    shutil.copytree(unfit, other, ignore=shutil.ignore_patterns("CMake*"))
    made = plugin.read_bytes()

    def changed(name, before, after):
        check(made.count(before) >= 1 and len(before) == len(after), f"{before}")
        (other / name).write_bytes(made.replace(before, after))
        return other / name

    headers = made.split(b"(headers ")[1][:16]
    text, cut = other / "text.so", other / "cut.so"
    text.write_text("chaindrive plug-in\n")
    cut.write_bytes(made[:2000])
    named = b"\0example\x001.0\0"
    twin = changed("twin.so", named, b"\0examplf\x001.0\0")  # another plug-in that registers the same
    newer = changed("newer.so", b"headers " + headers, b"headers " + b"0" * 16)
    for files, sentence in (
        (["nowhere.so"], "There is no plug-in 'nowhere.so': "),
        (["."], "The plug-in '.' cannot be read: it is no file."),
        ([text], f"The plug-in '{text}' is no shared library for this machine."),
        ([cut], "but no plug-in of chaindrive"),
        ([other / "stranger.so"], "but no plug-in of chaindrive"),
        ([newer], f"The plug-in '{newer}' was made for another program: for chaindrive "),
        ([newer], f"(headers {'0' * 16})"),
        ([other / "lacking.so"], f"The plug-in '{other / 'lacking.so'}' cannot be loaded: "),
        ([other / "empty.so"], f"The plug-in '{other / 'empty.so'}' adds nothing: "),
        ([plugin, plugin], f"The plug-ins '{plugin}' and '{plugin}' have the same name, example: "),
        ([plugin, twin], "of the plug-in 'examplf' has the name of another one, of the plug-in 'example'."),
        ([""], "The option --plugin needs a value after it"),
    ):
        words = [word for file in files for word in ("--plugin", file)]
        said = say(program, "plan", "example/example.prm", *words, status=2)
        check(said.startswith("chaindrive: ") and sentence in said and len(said.splitlines()) == 1, f"{files}: {said}")
        if files in (["nowhere.so"], [newer]):
            said = say("mpirun", "-n", "2", program, "plan", "example/example.prm", *words, status=2)
            check(said.count("chaindrive: ") == 1 and sentence in said, f"{files} on two ranks: {said}")
    # what the environment names is not looked at, and a file cannot ask for a library
    said = start([str(program), "plan", "example/example.prm", "--plugin", "example.so"], {"LD_LIBRARY_PATH": str(plugin.parent.resolve())})
    check(said.returncode == 2 and "There is no plug-in 'example.so'" in said.stderr, f"{said}")
    check("has no use for it" in say(program, "report", ".", "--plugin", plugin, status=2), "report")


def library():
    program, plugin, _ = prepared()
    said = say(plugin.parent / "program").split()
    check(said[1] == "rad/s", f"{said}")
    print(f"{said[0]} rad/s")
    pathlib.Path("same.prm").write_text("subsection Drive\n set Number of links = 76\n set Driver teeth = 11\n set Driven teeth = 23\n"
                                        " subsection Chain\n  set Designation = 12A\n end\n subsection Layout\n  set Start = settled\n end\nend\n"
                                        "subsection Model\n set Fidelity = simple\nend\nsubsection Time\n set End time in ms = 10\nend\n"
                                        "subsection Output\n set Window start in ms = 0\n set Field interval in ms = 0\nend\n")
    say(program, "same.prm", "--output", "same")
    speed = json.loads(pathlib.Path("same/summary.json").read_text())["driven_speed_mean"]
    check(float(said[0]) == speed > 0, f"the program says {said[0]}, chaindrive {speed} rad/s")


{"prepare": prepare, "run": run, "refuse": refuse, "library": library}[CASE]()
