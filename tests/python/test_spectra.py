# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spectra of records that are known."""
import numpy as np
import pytest

import chaindrive
from chaindrive.spectra import mean_square_lines
from made import folder, refused

# 20 periods of the tooth frequency of 100 Hz, sampled without regard to it
TIME = np.arange(0., 0.2 + 1e-9, 1.03e-4)
JITTER = TIME + 5e-7 * np.sin(np.arange(len(TIME)))  # half a percent of an interval
SPEED = "hubs/driven_speed"


def wave(time):
    """Harmonics 1 and 3 on a mean."""
    return 5. + 3. * np.cos(2 * np.pi * 100. * time + 0.4) + 0.5 * np.sin(2 * np.pi * 300. * time)


def made(time=TIME, values=None, summary=()):
    return folder("made", time, {SPEED: (wave(time) if values is None else values, "rad/s")}, summary)


@pytest.mark.parametrize("time", [TIME, JITTER], ids=["equal", "nearly"])
def test_harmonics_of_the_teeth_do_not_leak(time):
    spectrum = made(time).spectrum(SPEED)
    teeth = chaindrive.harmonics(spectrum, 100., 4)
    np.testing.assert_allclose(teeth["amplitude"], [3., 0., 0.5, 0.], rtol=0, atol=2e-4)
    others = spectrum["mean_square"].drop(teeth["frequency"][[1, 3]])
    assert others.max() < 1e-7


@pytest.mark.parametrize("time", [TIME, JITTER], ids=["equal", "nearly"])
def test_a_hann_window_keeps_the_mean_square(time):
    tapered = made(time).spectrum(SPEED, window="hann")["mean_square"]
    assert tapered.sum() == pytest.approx(4.625, abs=0.02)
    assert tapered.idxmax() == pytest.approx(100., abs=3.)


@pytest.mark.parametrize("n", [1000, 1001])
def test_parseval(n):
    noise = np.random.default_rng(3).normal(0., 1., n)
    _, power = mean_square_lines(noise, 1e-4)
    assert power.sum() / np.mean(noise ** 2) == pytest.approx(1., rel=0, abs=1e-12)


def test_third_octaves():
    bands = chaindrive.third_octaves(made(JITTER).spectrum(SPEED), 20., 2000.)
    assert bands["rms"][100.] == pytest.approx(3. / np.sqrt(2.), rel=0, abs=1e-3)
    assert (bands["rms"] ** 2).sum() == pytest.approx(4.625, rel=0, abs=1e-3)


def test_white_noise_has_3_db_more_in_twice_the_band():
    one = made(values=np.random.default_rng(3).normal(0., 1., len(TIME)))
    white = chaindrive.third_octaves(one.spectrum(SPEED, window="none"), 100., 2000.)["rms"] ** 2
    assert 10 * np.log10(white[10 ** 3.2] / white[10 ** 2.9]) == pytest.approx(3., abs=2.)


def test_what_has_no_spectrum():
    refused(("not sampled at equal intervals", "History interval"), lambda: made(TIME ** 1.2, wave(TIME)).spectrum(SPEED))


def test_a_record_shorter_than_a_pitch_time():
    refused(("shorter than a pitch time",), lambda: made().spectrum(SPEED, end=0.005))


def test_a_drive_that_had_not_settled():
    late = made(summary={"window": {"start": None, "end": None, "settled": False}})
    refused(("had not settled",), lambda: late.spectrum(SPEED))
