"""Roughness behind the standard's filters: sines, curves by hand, a second route by Fourier transform, real rollers."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.levelling import levelled
from asperity.surface.measure import Conditioning, conditioned
from asperity.surface.measure_files import read_surface
from asperity.surface.roughness import (
    material_ratio_parameters,
    relative_material_ratio,
    roughness,
    standard_short_cut_off,
)
from asperity.surface.topography import Topography


def sine(wavelength, *, amplitude=1e-6, length=6e-3, spacing=1e-6):
    x = np.arange(round(length / spacing)) * spacing
    return Topography(amplitude * np.sin(2.0 * np.pi * x / wavelength), spacing, source="sine")


def test_a_sine_as_long_as_the_cut_off_is_halved():
    """ISO 16610-21: half passes at the cut-off. Of A/2: Ra = A/pi, Rq = A/sqrt(8), Rz = Rt = A, Rku 3/2, RSm."""
    got = roughness(topography=sine(0.8e-3), cut_off=0.8e-3, short_cut_off=None)
    assert (got.sections, got.short_cut_off) == (5, None)
    lengths = {"Ra": 1 / np.pi, "Rq": 8**-0.5, "Rz": 1.0, "Rt": 1.0, "Rp": 0.5, "Rv": 0.5}
    for symbol, expected in lengths.items():
        assert got.lengths[symbol] == pytest.approx(1e-6 * expected, rel=1e-3), symbol
    assert got.lengths["RSm"] == pytest.approx(0.8e-3, rel=1e-3)
    assert got.numbers["Rsk"] == pytest.approx(0.0, abs=1e-3)
    assert got.numbers["Rku"] == pytest.approx(1.5, rel=1e-3)


@pytest.mark.parametrize("share", [0.05, 0.25, 0.7, 1.6, 2.5])
def test_transmission_of_other_waves(share):
    """1 - exp(-ln 2 (cut-off/wavelength)^2) of the amplitude passes."""
    got = roughness(topography=sine(0.8e-3 * share, length=12e-3), cut_off=0.8e-3, short_cut_off=None)
    passed = 1.0 - np.exp(-np.log(2.0) / share**2)
    if share < 0.5:  # whole waves
        assert got.lengths["Rq"] == pytest.approx(1e-6 * passed / np.sqrt(2.0), rel=5e-3)
    assert got.lengths["Rt"] == pytest.approx(2e-6 * passed, rel=5e-3)


def test_both_filters_against_a_fourier_transform():
    """A periodic profile, repeated three times; the middle one is what the transform filters."""
    n, spacing, cut_off, short = 16000, 0.5e-6, 0.8e-3, 2.5e-6
    f = np.fft.rfftfreq(n, spacing)
    random = np.random.default_rng(3)
    phases = np.exp(2j * np.pi * random.random(f.size))
    z = 1e-7 * np.fft.irfft(np.where(f > 0.0, phases / np.maximum(f, 1.0), 0.0), n=n)
    z /= z.std() / 1e-7
    share = np.exp(-np.log(2.0) * (f * short) ** 2) * -np.expm1(-np.log(2.0) * (f * cut_off) ** 2)
    route = np.fft.irfft(np.fft.rfft(z) * share, n=n)
    evaluated = np.tile(route, 3)[(3 * n - 8000) // 2 :][:8000]
    got = roughness(topography=Topography(np.tile(z, 3), spacing), cut_off=cut_off, short_cut_off=None)
    assert got.short_cut_off == short
    assert got.lengths["Ra"] == pytest.approx(np.abs(evaluated).mean(), rel=1e-4)
    assert got.lengths["Rq"] == pytest.approx(evaluated.std(), rel=1e-3)
    sections = evaluated.reshape(5, 1600)
    assert got.lengths["Rz"] == pytest.approx(np.ptp(sections, axis=1).mean(), rel=1e-4)
    assert got.lengths["Rp"] == pytest.approx(sections.max(axis=1).mean(), rel=1e-4)
    assert got.lengths["Rt"] == pytest.approx(np.ptp(evaluated), rel=1e-4)


def test_normally_distributed_heights():
    """Rq/Ra = sqrt(pi/2) = 1.2533, no skewness, kurtosis 3: means of 16 profiles, to four standard errors."""
    draws = []
    for seed in range(16):
        z = 1e-7 * np.random.default_rng(seed).standard_normal(60000)
        got = roughness(topography=Topography(z, 0.5e-6), cut_off=2.5e-3, short_cut_off=None)
        draws.append((got.lengths["Rq"] / got.lengths["Ra"], got.numbers["Rsk"], got.numbers["Rku"]))
    # of one profile 0.0041, 0.037 and 0.064, with some 3000 waves that differ
    np.testing.assert_array_less(
        np.abs(np.mean(draws, axis=0) - (np.sqrt(np.pi / 2.0), 0.0, 3.0)), (0.0041, 0.037, 0.064)
    )


def test_material_ratio_curve_by_hand():
    """Straight pieces 3..1 to 10 %, 1..0 to 80 %, 0..-4 to 100 %. The line through the core falls 1/0.7 a unit from 8/7
    to -2/7, so Rk = 10/7; it meets the curve at r = (3 - 8/7)/20 and 0.8 + 2/140; a triangle is its own height."""
    ratio = (np.arange(200_000) + 0.5) / 200_000
    z = np.interp(ratio, [0.0, 0.1, 0.8, 1.0], [3.0, 1.0, 0.0, -4.0])
    got = material_ratio_parameters(heights=np.random.default_rng(0).permutation(z))
    expected = (10 / 7, 3 - 8 / 7, 4 - 2 / 7, (3 - 8 / 7) / 20, 0.8 + 2 / 140)
    assert got == pytest.approx(expected, rel=1e-4)


def test_plateau_and_triangle_wave():
    """Nine tenths at one height and one at -2: no core, no peaks, a rectangle of valleys twice as high by its area."""
    assert material_ratio_parameters(heights=np.repeat([0.0, -2.0], [900, 100])) == pytest.approx(
        (0.0, 0.0, 4.0, 0.0, 0.9), abs=1e-9
    )
    Rk, Rpk, Rvk, first, second = material_ratio_parameters(heights=np.linspace(0.0, 3.0, 30_001))
    assert (Rk, Rpk, Rvk) == pytest.approx((3.0, 0.0, 0.0), abs=1e-3)
    assert (first, second) == pytest.approx((0.0, 1.0), abs=1e-3)


def test_relative_material_ratio_by_hand():
    """Ten heights 9..0: 5 % of them lie above 9 (each stands for a tenth, its middle at 5 %), so 2.5 below it are 9, 8
    and 7: 30 %. Of a sine of amplitude A, dc below the level of 5 %: arccos[cos(0.05 pi) - dc/A]/pi."""
    assert relative_material_ratio(heights=np.arange(10.0), depth=2.5) == pytest.approx(0.3)
    assert relative_material_ratio(heights=np.arange(10.0), depth=100.0) == 1.0
    got = roughness(topography=sine(80e-6), cut_off=0.8e-3, short_cut_off=None)
    expected = np.arccos(np.cos(0.05 * np.pi) - 0.5) / np.pi
    assert got.numbers["Rmr(5 %, Rz/4)"] == pytest.approx(expected, abs=0.01)


@pytest.mark.parametrize(
    ("Ra", "cut_off"), [(0.015, 0.08), (0.08, 0.25), (1.9, 0.8), (2.2, 2.5), (9.0, 2.5), (11, 8)]
)
def test_the_cut_off_follows_from_the_roughness_behind_it(Ra, cut_off):
    """A sine of 60 um, of which nearly all passes: Ra = 2 A/pi; classes of ISO 4288 end at 0.02, 0.1, 2 and 10 um."""
    amplitude = 1e-6 * Ra * np.pi / 2.0
    got = roughness(
        topography=sine(60e-6, amplitude=amplitude, length=60e-3, spacing=2e-6),
        cut_off=None,
        short_cut_off=None,
    )
    assert got.cut_off == pytest.approx(1e-3 * cut_off)
    assert got.lengths["Ra"] == pytest.approx(1e-6 * Ra, rel=0.3)
    assert got.choice == "the class of ISO 21920-3 for this Ra"


def test_short_wave_filter_of_the_standard():
    assert [
        standard_short_cut_off(cut_off=1e-3 * c) for c in (0.08, 0.25, 0.8, 2.5, 8.0, 0.6)
    ] == pytest.approx([2.5e-6, 2.5e-6, 2.5e-6, 8e-6, 25e-6, 2e-6])
    fine, coarse = (
        roughness(topography=sine(1e-4, spacing=s), cut_off=0.8e-3, short_cut_off=None)
        for s in (0.5e-6, 0.6e-6)
    )
    assert (fine.short_cut_off, coarse.short_cut_off) == (2.5e-6, None)
    chosen = roughness(topography=sine(1e-4), cut_off=0.8e-3, short_cut_off=100e-6)
    assert chosen.lengths["Rt"] == pytest.approx(1e-6, rel=0.03)  # half of the sine


def test_sections_that_fit():
    assert roughness(topography=sine(1e-4, length=4.8e-3), cut_off=0.8e-3, short_cut_off=None).sections == 5
    assert roughness(topography=sine(1e-4, length=4.7e-3), cut_off=0.8e-3, short_cut_off=None).sections == 4
    assert roughness(topography=sine(1e-4, length=1.6e-3), cut_off=0.8e-3, short_cut_off=None).sections == 1
    with pytest.raises(
        InputError, match=r"cut-off is 0.8 mm; it must lie between 10 spacings .* \(0.75 mm\)"
    ) as refused:
        roughness(topography=sine(1e-4, length=1.5e-3), cut_off=0.8e-3, short_cut_off=None)
    assert "cut-off" in refused.value.options
    with pytest.raises(InputError, match="lambda_s is 900 um"):
        roughness(topography=sine(1e-4), cut_off=0.8e-3, short_cut_off=0.9e-3)
    tiny = roughness(topography=sine(1e-5, length=0.1e-3), cut_off=None, short_cut_off=None)
    assert tiny.startswith("the profile of 0.1 mm, with points 1 um apart, does not hold two cut-offs")
    rough = roughness(topography=sine(4e-5, amplitude=2e-5, length=1e-2), cut_off=None, short_cut_off=None)
    assert rough.startswith("Ra is 12.4 um behind the cut-off 2.5 mm, more than its class holds")
    coarse = roughness(topography=sine(2e-4, amplitude=1e-9, spacing=2e-5), cut_off=None, short_cut_off=None)
    assert coarse.choice == "the smallest of ISO 21920-3 that the points and lambda_s allow"
    smooth = roughness(topography=sine(1e-3, amplitude=1e-9), cut_off=None, short_cut_off=0.1e-3)
    assert (smooth.cut_off, smooth.choice) == (0.25e-3, coarse.choice)
    wide = sine(5e-3, spacing=0.9e-3, length=1.0)
    assert "with points 900 um apart" in roughness(topography=wide, cut_off=None, short_cut_off=None)


def test_gaps_are_never_filled_for_a_filter():
    wave = sine(1e-4)
    gap = wave.with_heights(np.where(np.arange(6000) == 5000, np.nan, wave.heights))
    with pytest.raises(InputError, match="without missing points"):
        roughness(topography=gap, cut_off=0.25e-3, short_cut_off=None)
    longest = conditioned(
        topography=gap, conditioning=Conditioning("mean", None, "longest", None, None, None)
    )
    assert longest.roughness.lengths["Rt"] == pytest.approx(2e-6, rel=0.01)
    filled = conditioned(
        topography=gap, conditioning=Conditioning("mean", None, "interpolate", None, None, None)
    )
    assert filled.roughness.startswith("gaps are filled by straight lines")
    with pytest.raises(InputError, match="no filter, because gaps are filled"):
        conditioned(
            topography=gap, conditioning=Conditioning("mean", None, "interpolate", None, None, 0.8e-3)
        )


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("81212-RE-1", 0.097), ("NU206-RE-1", 0.127), ("NU206-RE-2", 0.105), ("NU206-IR-1", 0.139),
        ("NU206-IR-2", 0.220), ("NU208-IR-1", 0.149), ("NU2208-IR-1", 0.130),
    ],
)  # fmt: skip
def test_bearing_rollers_against_another_program(shared_data, name, other):
    """Rq [um] of the middle 40 % less a parabola by another program; here of the middle 4 mm behind 0.8 mm.

    By the class of their Ra two have 0.25 mm and 1.25 mm of length, on which NU2208-IR-1 has a Rq of 0.097 um.
    """
    file = shared_data / "bearing_roller_profiles" / f"{name}.txt"
    profile = read_surface(path=file, position_unit="mm", height_unit="um")
    got = conditioned(
        topography=profile, conditioning=Conditioning("line", None, "refuse", None, None, 0.8e-3)
    )
    assert got.heights.arithmetic_mean > 1e-6  # Pa: the form
    assert 0.85 < 1e6 * got.roughness.lengths["Rq"] / other < 1.02
    by_class = conditioned(
        topography=profile, conditioning=Conditioning("line", None, "refuse", None, None, None)
    )
    assert 0.09 < 1e6 * by_class.roughness.lengths["Rq"] < 0.22


def test_roughness_of_a_bearing_ring_by_another_program(shared_data):
    """surfalize 0.19.2: the same section less a parabola, its band-pass of 8 um and 0.8 mm, five cut-offs."""
    file = shared_data / "bearing_roller_profiles" / "NU206-IR-1.txt"
    ring = read_surface(path=file, position_unit="mm", height_unit="um", any_size=True)
    land = levelled(topography=ring.cut(start=1.2e-3, stop=12.6e-3), form="polynomial", degree=2)
    got = roughness(topography=land, cut_off=0.8e-3, short_cut_off=8e-6)
    lengths = {
        "Ra": 0.066775, "Rq": 0.083976, "Rz": 0.50938, "Rp": 0.219017, "Rv": 0.290363, "Rt": 0.633209, "Rk": 0.206333,
    }  # fmt: skip
    for symbol, expected in lengths.items():
        assert 1e6 * got.lengths[symbol] == pytest.approx(expected, rel=1e-3), symbol
    assert got.numbers["Rku"] == pytest.approx(3.309201, rel=1e-3)
    # small differences: of the mean line for the skewness, of the ends of the curve for the triangles
    assert got.numbers["Rsk"] == pytest.approx(-0.475596, abs=0.005)
    assert 1e6 * got.lengths["Rpk"] == pytest.approx(0.054433, abs=0.001)
    assert 1e6 * got.lengths["Rvk"] == pytest.approx(0.104846, abs=0.001)
