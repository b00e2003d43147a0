# SPDX-License-Identifier: LGPL-2.1-or-later
"""chaindrive export: CSV files are those that a run writes itself, WAV files sound as the record does."""
import json
import math
import pathlib
import wave

import h5py
import numpy as np
import pytest

from chaindrive import export
from made import folder, refused
from program import start

TONE, PITCH_TIME, STEP = 300.0, 1 / 300, 1 / 300 / 2000  # Hz; s, one period of the tone; s


def heard(name, pressures, periods, time=None, highest=20e3):
    """A run whose observers have heard these pressures {name: values}."""
    run = folder(name, np.linspace(0, 0.1, 11), {"spans/tight_tension": (np.ones(11), "N")})
    values = np.array(list(pressures.values())).T
    time = STEP * np.arange(len(values)) if time is None else time
    about = {"observers": [{"name": observer} for observer in pressures], "periods": periods, "highest_frequency": highest}
    (run.folder / "acoustics.json").write_text(json.dumps(about))
    with h5py.File(run.folder / "acoustics.h5", "w") as file:
        file.update({"time": time, "pressure": values})
    return run


def samples(file):
    """Numbers from -1 to 1 and the rate of a file of 24 bits and one channel."""
    with wave.open(str(file)) as sound:
        assert (sound.getnchannels(), sound.getsampwidth()) == (1, 3)
        bits = np.frombuffer(sound.readframes(sound.getnframes()), np.uint8).reshape(-1, 3)
        whole = np.zeros((len(bits), 4), np.uint8)
        whole[:, 1:] = bits
        return whole.view("<i4")[:, 0] / 2 ** 31, sound.getframerate()


def tone(periods, amplitude=1.0, frequency=TONE):
    return amplitude * np.sin(2 * math.pi * frequency * STEP * np.arange(2000 * periods))


def test_csv_files_are_those_of_the_run(run):
    own = run("with_csv", {"Output/CSV": "true", "Time/End time in ms": 2, "Output/Window start in ms": 0})
    files = export.as_csv(own, "again")
    assert {file.name for file in files} == {file.name for file in own.folder.glob("histories_*.csv")}
    for file in files:
        one, other = (path.read_text().splitlines() for path in (file, own.folder / file.name))
        assert one[0] == other[0] and len(one) == len(other) > 50
        for row, expected in zip(one[1:], other[1:]):
            np.testing.assert_array_equal(np.array(row.split(","), float), np.array(expected.split(","), float))


def test_a_tone_goes_on_as_it_is():
    files, full = export.as_wav([heard("one", {"near": tone(4, 2.0), "far": tone(4, 0.5)}, 4)])
    assert [file.name for file in files] == ["noise_near.wav", "noise_far.wav"] and files[0].parent == pathlib.Path("one")
    for file, amplitude in zip(files, (2.0, 0.5)):
        sound, rate = samples(file)
        assert rate == 48000 and len(sound) == 5 * rate
        expected = amplitude / full * np.sin(2 * math.pi * TONE * np.arange(len(sound)) / rate)
        assert np.abs(sound - expected).max() < 2e-6 * amplitude
    assert np.abs(samples(files[0])[0]).max() == pytest.approx(10 ** (-1 / 20), abs=1e-6)


def test_a_high_tone_of_few_samples_keeps_its_height():
    time = PITCH_TIME / 350 * np.arange(5 * 350)
    sound = export.loop(time, np.sin(2 * math.pi * 60 * TONE * time), 5, 20e3)
    assert math.sqrt(2 * np.mean(sound ** 2)) == pytest.approx(1, abs=2e-3)


def test_what_is_above_the_highest_frequency_is_left_out():
    files, full = export.as_wav([heard("one", {"near": tone(4) + tone(4, 0.5, 100 * TONE)}, 4)])
    sound, rate = samples(files[0])
    assert np.abs(sound * full - np.sin(2 * math.pi * TONE * np.arange(len(sound)) / rate)).max() < 2e-6


def test_the_end_goes_over_into_the_beginning():
    drift = np.linspace(-1, 1, 8000)  # each time it is repeated it would fall by 2
    sound = samples(export.as_wav([heard("one", {"near": drift}, 4)])[0][0])[0]
    assert np.abs(np.diff(sound)).max() < 0.2  # 1.6 over a tenth of a pitch time, 16 samples
    period = 3 * PITCH_TIME * export.RATE  # three of the four pitch times
    assert period == round(period)
    np.testing.assert_allclose(sound[:round(period)], sound[round(period):2 * round(period)], atol=1e-6)


def test_a_single_pitch_time_is_repeated_as_it_is():
    sound, rate = samples(export.as_wav([heard("one", {"near": tone(1)}, 1)])[0][0])
    assert np.abs(sound - 10 ** (-1 / 20) * np.sin(2 * math.pi * TONE * np.arange(len(sound)) / rate)).max() < 2e-6


def test_runs_have_one_scale():
    runs = [heard("loud", {"near": tone(3, 4.0)}, 3), heard("soft", {"near": tone(3, 1.0)}, 3)]
    files, full = export.as_wav(runs, "both")
    assert [file.name for file in files] == ["noise_loud_near.wav", "noise_soft_near.wav"]
    loud, soft = (np.abs(samples(file)[0]).max() for file in files)
    assert loud / soft == pytest.approx(4, rel=1e-5) and full == pytest.approx(4 * 10 ** (1 / 20), rel=1e-5)


def test_names_of_a_file_stay_in_the_folder():
    files, _ = export.as_wav([heard("one", {"../../evil": tone(2), "..": tone(2), ".. ": tone(2)}, 2)], "out")
    assert sorted(file.name for file in pathlib.Path("out").iterdir()) == ["noise_evil.wav", "noise_unnamed.wav", "noise_unnamed_2.wav"]
    assert {file.parent for file in files} == {pathlib.Path("out")}


def test_titles_are_no_formulas():
    run = folder("one", np.linspace(0, 1, 5), {"hubs/=1+1": (np.ones(5), "N"), "a b/c,d": (np.ones((5, 2)), "N")})
    files = export.as_csv(run)
    assert sorted(file.name for file in files) == ["histories_a_b.csv", "histories_hubs.csv"]
    titles = {file.name: file.read_text().splitlines()[0] for file in files}
    assert titles["histories_hubs.csv"] == "time [s],'=1+1 [N]"
    assert titles["histories_a_b.csv"] == 'time [s],"c,d 0 [N]","c,d 1 [N]"'


@pytest.mark.parametrize(("change", "words"), [
    ({"periods": 0}, ["no periods", "chaindrive noise"]),
    ({"periods": "many"}, ["no periods"]),
    ({"periods": 10 ** 6}, ["too short"]),
    ({"highest_frequency": None}, ["no highest_frequency"]),
    ({"observers": None}, ["acoustics.json", "damaged"]),
    ({"observers": [1]}, ["acoustics.json", "damaged"]),
    ({"observers": [{"name": "near"}, {"name": "far"}]}, ["observers are others"]),
])
def test_damaged_noise_is_refused(change, words):
    run = heard("one", {"near": tone(2)}, 2)
    file = run.folder / "acoustics.json"
    file.write_text(json.dumps({**json.loads(file.read_text()), **change}))
    refused(words, lambda: export.as_wav([run]))
    assert not list(run.folder.glob("*.wav*"))


def test_what_is_no_history_is_left_out():
    run = folder("one", np.linspace(0, 1, 5), {"hubs/angle": (np.ones(5), "rad")})
    run.close()
    with h5py.File(run.folder / "histories.h5", "a") as file:
        file.update({"hubs/scalar": 1.0, "hubs/text": np.array([b"a"] * 5), "hubs/short": np.ones(2)})
    assert export.as_csv(run)[0].read_text().splitlines()[0] == "time [s],angle [rad]"


def test_silence_and_numbers_that_are_none_are_refused():
    refused(["nothing to be heard"], lambda: export.as_wav([heard("silent", {"near": 0 * tone(2)}, 2)]))
    refused(["damaged"], lambda: export.as_wav([heard("nan", {"near": np.nan * tone(2)}, 2)]))


def test_the_command(run, request):
    program, simple = request.config.getoption("--program"), run("simple", {})
    assert start([program, "noise", simple.folder, "--quiet"]).returncode == 0
    said = start([program, "export", simple.folder, "--as", "wav", "--output", "sound"])
    lines = said.stdout.splitlines()
    assert said.returncode == 0 and lines[0].startswith("13 files of 5 s, whose full scale is ")
    assert all(pathlib.Path(line).is_file() for line in lines[1:]) and len(lines) == 14
    assert start([program, "export", simple.folder, "--as", "csv", "--quiet", "--output", "-dash"]).stdout == ""
    assert pathlib.Path("-dash/histories_spans.csv").is_file()
    for words, sentence in (([simple.folder], "needs the option --as"), ([simple.folder, "--as", "mp3"], "--as = mp3 must be csv"),
                            (["nowhere", "--as", "csv"], "There is no folder 'nowhere'."), (["--as", "csv"], "Which runs?"),
                            ([simple.folder, simple.folder, "--as", "csv", "--output", "x"], "would write the same files")):
        said = start([program, "export", *words])
        assert said.returncode == 2 and sentence in said.stderr and "Traceback" not in said.stderr
