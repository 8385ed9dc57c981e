"""The waves that a contact feels: against the map filtered by its Fourier transform, and against single waves."""

import json
import math

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.height_spectrum import (
    spectrum_from_document,
    spectrum_of_map,
    spectrum_of_profiles,
    with_lay,
)
from asperity.surface.roughness_average import roughness_average, standard_cut_off
from asperity.surface.synthesis import spectral_profile, spectral_surface
from asperity.surface.topography import Topography

SPACING = 1e-6


def topography(heights, across=SPACING):
    return Topography(heights, SPACING, across, source="a map")


def filtered(heights, *, rolling, axial, along):
    """The map without the waves that are longer than both limits, by its Fourier transform; rms [m]."""
    first, second = (np.abs(np.fft.fftfreq(count, SPACING)) for count in heights.shape)
    form = 1.5 / (heights.shape[0] * SPACING)  # waves of one period are no roughness
    rolling, axial = max(rolling, form), max(axial, form)
    low = np.outer(
        first < (axial if along == "x" else rolling), second < (rolling if along == "x" else axial)
    )
    kept = np.fft.ifft2(np.where(low, 0.0, np.fft.fft2(heights))).real
    return float(np.sqrt(np.mean(kept**2)))


@pytest.mark.parametrize("along", ["x", "y"])
@pytest.mark.parametrize(
    ("width", "length", "bias"),
    [(256e-6 / 15.5, 256e-6 / 3.5, 0.04), (256e-6 / 7.5, 256e-6 / 7.5, 0.04), (256e-6 / 15.5, 1.0, 0.2)],
)
def test_band_of_a_map_of_known_spectrum(along, width, length, bias):
    """Limits between the waves of the period; where the map is shorter than the contact, its form leaks in.

    The mean ratio is known to four standard errors, besides the bias of the window.
    """
    ratios = []
    for seed in range(48):
        heights = spectral_surface(
            rows=256,
            columns=256,
            spacing=SPACING,
            fractal_dimension=1.3,
            areal_fractal_roughness=1e-11,
            periodic=True,
            random=np.random.default_rng(seed),
        )
        if along == "x":  # rougher across the lay
            heights = heights + heights[:1]
        square, deviation = spectrum_of_map(topography=topography(heights), rolling=along).felt(
            rolling=1.0 / width, axial=1.0 / length
        )
        route = filtered(heights, rolling=1.0 / width, axial=1.0 / length, along=along)
        ratios.append(math.sqrt(square) / route)
        assert abs(math.log(ratios[-1])) < 4.0 * 0.5 * deviation / square
    assert np.mean(ratios) == pytest.approx(1.0, abs=bias + 4.0 * np.std(ratios) / math.sqrt(len(ratios)))


@pytest.mark.parametrize(
    ("periods", "width", "felt"),
    [((0, 20), 100e-6, True), ((0, 4), 35e-6, False), ((4, 20), 5e-6, False), ((20, 4), 5e-6, True)],
)
def test_one_wave_is_felt_or_not(periods, width, felt):
    """(periods along y, along x) over 256 µm, the contact rolls in x: the width decides along x, 25 µm along y."""
    y, x = np.mgrid[0:256, 0:256] / 256.0
    heights = 1e-7 * np.cos(2.0 * np.pi * (periods[0] * y + periods[1] * x) + 0.3)
    spectrum = spectrum_of_map(topography=topography(heights), rolling="x")
    square, _ = spectrum.felt(rolling=1.0 / width, axial=1.0 / 25e-6)
    assert square == pytest.approx(0.5e-14 if felt else 0.0, rel=0.02, abs=1e-16)


def test_many_pairs_of_limits_are_those_of_each():
    heights = spectral_surface(
        rows=128,
        columns=128,
        spacing=SPACING,
        fractal_dimension=1.3,
        areal_fractal_roughness=1e-11,
        periodic=True,
        random=np.random.default_rng(1),
    )
    spectrum = spectrum_of_map(topography=topography(heights), rolling="x")
    rolling, axial = np.meshgrid(1.0 / np.array([3e-6, 20e-6, 1.0]), 1.0 / np.array([5e-6, 40e-6, 1.0]))
    squares = spectrum.squares(rolling=rolling, axial=axial)
    for place in np.ndindex(squares.shape):
        limits = {"rolling": float(rolling[place]), "axial": float(axial[place])}
        square, _ = spectrum.felt(**limits)
        assert squares[place] == pytest.approx(square, rel=1e-12)
        _, form = spectrum.form(**limits)
        assert square + form.sum() == pytest.approx(spectrum.mean_square.sum(), rel=1e-12)


def test_form_of_a_profile_ends_at_two_thirds_of_its_length():
    """Waves of one, four and 40 periods in 4096 µm: felt up to 0.2 mm, form up to 2.7 mm, and crown."""
    x = np.arange(4096) / 4096.0
    heights = sum(1e-7 * np.cos(2.0 * np.pi * count * x + 0.4) for count in (1, 6, 40))
    profile = spectrum_of_profiles(profiles=heights[None], spacing=SPACING, lay="rolling", source="one")
    wavenumber, square = profile.form(rolling=1e4, axial=1.0 / 0.2e-3)
    assert square.sum() == pytest.approx(0.5e-14, rel=0.1)
    assert wavenumber[np.argmax(square)] == pytest.approx(2.0 * np.pi * 6.0 / 4096e-6, rel=0.15)


def test_a_map_with_unlike_pixels_keeps_its_lengths():
    y = np.arange(128)[:, None]
    heights = 1e-7 * np.sin(2.0 * np.pi * 10.0 * y / 128.0) + np.zeros(
        (1, 256)
    )  # 10 waves over 128 rows of 3 µm
    spectrum = spectrum_of_map(topography=topography(heights, across=3e-6), rolling="y")
    wave = 128 * 3e-6 / 10.0
    for factor, felt in ((0.8, 0.0), (1.25, 0.5e-14)):
        square, _ = spectrum.felt(rolling=1.0 / (factor * wave), axial=0.0)
        assert square == pytest.approx(felt, rel=0.05, abs=1e-16)
    assert spectrum.longest_wave == pytest.approx(256e-6 / 1.5)


@pytest.fixture(scope="module")
def profiles():
    return [
        spectral_profile(
            points=4096,
            spacing=SPACING,
            fractal_dimension=1.5,
            fractal_roughness=1e-11,
            periodic=False,
            random=np.random.default_rng(seed),
        )
        for seed in range(60)
    ]


def test_profiles_of_known_spectrum(profiles):
    """The density of equation (6), integrated: 0.5 G^(2(D-1)) f^-(5-2D) from the limit up to the sampling limit."""
    spectrum = spectrum_of_profiles(
        profiles=np.array(profiles), spacing=SPACING, lay="rolling", source="many"
    )
    low, high = 1.0 / 100e-6, 0.5 / SPACING
    square, deviation = spectrum.felt(rolling=0.0, axial=low)
    assert square == pytest.approx(0.5 * 1e-11 * (1.0 / low - 1.0 / high), rel=0.03)
    assert deviation < 0.03 * square


@pytest.mark.parametrize(("factor", "cut_off"), [(1.0, 0.08e-3), (2.0, 0.25e-3), (8.0, 0.8e-3)])
def test_the_cut_off_agrees_with_the_average_behind_it(profiles, factor, cut_off):
    """Heights times a factor are another G, whose Ra behind this cut-off stands in its line of the standard."""
    average = roughness_average(fractal_dimension=1.5, fractal_roughness=1e-11 * factor**2, cut_off=cut_off)
    assert standard_cut_off(roughness_average=float(average)) == cut_off
    many = spectrum_of_profiles(profiles=factor * np.array(profiles), spacing=SPACING, lay=None, source="")
    assert many.cut_off() == cut_off


def test_stated_scatter_is_that_of_many_profiles(profiles):
    squares, stated = zip(
        *(
            spectrum_of_profiles(profiles=one[None], spacing=SPACING, lay="rolling", source="one").felt(
                rolling=0.0, axial=1.0 / 200e-6
            )
            for one in profiles
        ),
        strict=True,
    )
    assert np.mean(stated) == pytest.approx(np.std(squares), rel=0.3)


def test_the_lay_says_in_which_direction_a_profile_counts(profiles):
    along = spectrum_of_profiles(profiles=profiles[0][None], spacing=SPACING, lay=None, source="one")
    limits = {"rolling": 1.0 / 20e-6, "axial": 1.0 / 500e-6}
    circumferential, axial = (with_lay(along, lay) for lay in ("rolling", "axis"))
    assert circumferential.felt(**limits)[0] == along.felt(rolling=math.inf, axial=1.0 / 500e-6)[0]
    assert axial.felt(**limits)[0] == pytest.approx(along.felt(rolling=math.inf, axial=1.0 / 20e-6)[0])
    assert with_lay(along, "isotropic").felt(**limits) == circumferential.felt(**limits)
    assert axial.longest_wave == along.longest_wave == pytest.approx(4096e-6 / 1.5)


def test_the_document_keeps_everything(profiles):
    spectrum = spectrum_of_profiles(profiles=profiles[0][None], spacing=SPACING, lay="axis", source="one")
    again = spectrum_from_document(json.loads(json.dumps(spectrum.document())))
    limits = {"rolling": 1.0 / 20e-6, "axial": 1.0 / 500e-6}
    assert again.felt(**limits) == pytest.approx(spectrum.felt(**limits), rel=1e-5)
    assert (again.lay, again.is_map, again.source) == ("axis", False, "one")


@pytest.mark.parametrize(
    "change",
    [
        {"mean_square_height_m2": [[1.0]]},
        {"independent_ordinates": None},
        {"lay": "sideways"},
        {"rolling_frequency_edges_per_m": [[1.0, "a"]]},
        {"is_map": 1},
        {"mean_square_height_m2": lambda rows: [[2.0 for _ in row] for row in rows]},
        {"independent_ordinates": lambda rows: [[1e-3 for _ in row] for row in rows]},
    ],
)
def test_a_damaged_spectrum_is_one_message(profiles, change):
    document = spectrum_of_profiles(
        profiles=profiles[0][None], spacing=SPACING, lay=None, source="one"
    ).document()
    change = {key: value(document[key]) if callable(value) else value for key, value in change.items()}
    with pytest.raises(InputError, match="damaged: measure again"):
        spectrum_from_document(document | change)
