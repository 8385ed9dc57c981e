"""Maps pressed by boundary elements: known surfaces, what is kept, and what is refused."""

from dataclasses import fields

import numpy as np
import pytest

from asperity.bem import pressed_map as module
from asperity.bem.pressed_map import map_patches, mirrored, pressed_map, steel_pair
from asperity.errors import InputError
from asperity.precision import use_compilation_cache
from asperity.surface.pressed_map import PressedMap, pressed_map_from_document
from asperity.surface.topography import Topography

HARDNESS = 5.6e9 / float(steel_pair().contact_modulus)
RMS = 0.14e-6


def self_affine_map(points=256, spacing=1e-6, seed=1, rms=RMS):
    """Hurst exponent 0.8, rolled off at 25 µm, the shortest wave of six points."""
    frequency = np.fft.fftfreq(points, spacing)
    size = np.hypot(frequency[:, None], frequency)
    amplitude = np.maximum(size, 1.0 / 25e-6) ** -1.8
    amplitude[size > 1.0 / (6.0 * spacing)] = 0.0
    amplitude[0, 0] = 0.0
    random = np.random.default_rng(seed).standard_normal((points, points))
    heights = np.fft.ifft2(amplitude * np.fft.fft2(random)).real
    return Topography(heights * rms / heights.std(), spacing, spacing, source="a map")


@pytest.fixture(scope="module")
def pressed():
    return pressed_map(self_affine_map(), rolling="x", hardness=HARDNESS)


def same(one, other):
    return all(
        np.array_equal(getattr(one, field.name), getattr(other, field.name), equal_nan=True)
        for field in fields(PressedMap)
    )


@pytest.mark.long
def test_decay_length_of_a_self_affine_surface(pressed):
    """0.48 h at 100 and 300 MPa: 512² surfaces are within 9 %; four patches of 128² add 8 %."""
    np.testing.assert_allclose(pressed.rms_height, RMS, rtol=0.2)
    for load in (100e6, 300e6):
        ratio, half_width = pressed.decay_ratio(pressure=load / 113.2e9, capped=False)
        assert ratio == pytest.approx(0.48, rel=0.17)
        assert half_width < 0.8
    low, high = pressed.range(capped=False)
    assert low * 113.2e9 == pytest.approx(10e6, rel=1e-3)
    assert high * 113.2e9 > 900e6
    kappa = 2.0 * 0.7 / 1.7
    np.testing.assert_allclose(pressed.tangential_ratios[:, 2:4].mean(axis=0), kappa, rtol=0.03)


@pytest.mark.long
def test_plastic_spots_make_it_stiffer(pressed):
    known = np.isfinite(pressed.decay_ratios[1])
    assert known.any()
    assert np.all(pressed.decay_ratios[1][known] <= 1.001 * pressed.decay_ratios[0][known])
    assert np.all(pressed.contact_fractions[1][known] >= 0.999 * pressed.contact_fractions[0][known])


@pytest.mark.long
def test_ratios_do_not_depend_on_the_scale(pressed):
    """Twice as high and twice as large, at the same pressures: the same slopes, so the same ratios."""
    larger = Topography(2.0 * self_affine_map().heights, 2e-6, 2e-6, source="a map")
    again = pressed_map(larger, rolling="x", hardness=HARDNESS)
    np.testing.assert_allclose(again.decay_ratios, pressed.decay_ratios, rtol=1e-4)
    np.testing.assert_allclose(again.rms_height, 2.0 * pressed.rms_height, rtol=1e-6)


@pytest.mark.slow
def test_two_bodies_alike_are_pressed_as_one_under_less_pressure(monkeypatch):
    """Elastic heights and pressures scale together: of two such bodies at p the ratio is that of one at p/sqrt(2)."""
    one, other = (self_affine_map(points=128, seed=seed).heights for seed in (1, 2))
    loads = np.array([600e6, 1200e6, 2000e6])
    monkeypatch.setattr(module, "kept_numbers", lambda asked: None)
    monkeypatch.setattr(module, "keep_numbers", lambda asked, numbers: None)

    def ratios(heights, pressures):
        monkeypatch.setattr(module, "PRESSURES_ON_STEEL", tuple(pressures))
        made = pressed_map(Topography(heights, 1e-6, 1e-6, source="a map"), rolling="x", hardness=HARDNESS)
        return made.decay_ratios[0]

    alone = ratios(one, loads / np.sqrt(2.0))
    np.testing.assert_allclose(ratios(np.sqrt(2.0) * one, loads), alone, rtol=1e-4)
    both = ratios(one + other, loads).mean(axis=0)  # two maps of the same kind; four patches scatter
    np.testing.assert_allclose(both, alone.mean(axis=0), rtol=0.1)
    assert ratios(one, loads).mean(axis=0)[2] < 0.85 * both[2]  # at the same pressure it is another number


@pytest.mark.slow
def test_a_map_is_pressed_once(tmp_path, monkeypatch):
    """From the folder the same numbers, without boundary elements; a damaged file is computed again."""
    import jax

    before = jax.config.jax_compilation_cache_dir
    monkeypatch.setenv("ASPERITY_CACHE_DIR", str(tmp_path / "kept"))
    try:
        use_compilation_cache()
        surface = self_affine_map(points=64, spacing=2e-6)
        first = pressed_map(surface, rolling="x", hardness=HARDNESS)
        calls = []
        whole = module.loaded_state
        monkeypatch.setattr(module, "loaded_state", lambda *a, **k: calls.append(1) or whole(*a, **k))
        assert same(pressed_map(surface, rolling="x", hardness=HARDNESS), first)
        assert not calls
        (file,) = (tmp_path / "kept").glob("*.numbers")
        file.write_bytes(file.read_bytes()[:-1])
        assert same(pressed_map(surface, rolling="x", hardness=HARDNESS), first)
        assert len(calls) == module.STATES
    finally:
        jax.config.update("jax_compilation_cache_dir", before)


@pytest.mark.parametrize("changes", [{"hardness": 0.04}, {"hardness": HARDNESS, "rms_height": [2e-7, 2e-7]}])
def test_kept_numbers_of_another_map_are_not_used(monkeypatch, changes):
    surface = self_affine_map(points=64, spacing=2e-6)

    class ComputedError(Exception):
        pass

    def computes(*_, **__):
        raise ComputedError

    monkeypatch.setattr(module, "kept_numbers", lambda asked: numbers(**changes))
    monkeypatch.setattr(module, "loaded_state", computes)
    with pytest.raises(ComputedError):
        pressed_map(surface, rolling="x", hardness=HARDNESS)


def test_patches_are_square_and_lose_a_plane():
    """Of a map three times as long as wide, six by two patches of which four are taken."""
    y, x = np.mgrid[0:128, 0:384]
    tilted = Topography(1e-8 * x - 3e-8 * y + 1e-7 * np.cos(0.7 * x + y), 1e-6, 1e-6, source="long")
    patches, cell = map_patches(tilted, points=64)
    assert [patch.shape for patch in patches] == [(64, 64)] * 4
    assert cell == (1e-6, 1e-6)
    for patch in patches:
        assert patch.std() == pytest.approx(1e-7 / np.sqrt(2.0), rel=0.02)
    coarse, cell = map_patches(tilted, points=32)
    assert coarse[0].shape == (32, 32)
    assert cell == (2e-6, 2e-6)


def test_mirrored_is_periodic_without_a_step():
    heights = np.random.default_rng(0).standard_normal((3, 4))
    full = mirrored(heights)
    assert full.shape == (6, 8)
    np.testing.assert_array_equal(full[:3, :4], heights)
    np.testing.assert_array_equal(full, full[::-1, ::-1])


@pytest.mark.parametrize(
    ("surface", "hardness", "remedy"),
    [
        (Topography(np.zeros(100), 1e-6, source="line"), HARDNESS, "a profile; boundary elements need a map"),
        (
            Topography(np.ones((63, 90)), 1e-6, 1e-6, source="small"),
            HARDNESS,
            "need 64 or more along each side",
        ),
        (
            Topography(np.zeros((64, 64)), 1e-6, 1e-6, source="flat"),
            HARDNESS,
            "is a plane, without roughness",
        ),
        (
            Topography(np.full((64, 64), np.nan), 1e-6, 1e-6, source="gaps"),
            HARDNESS,
            "points are missing; keep a complete piece",
        ),
        (self_affine_map(64), 1e-4, r"allowed are 0\.001 to 1"),
    ],
)
def test_what_cannot_be_pressed_is_one_message(surface, hardness, remedy):
    with pytest.raises(InputError, match=remedy):
        pressed_map(surface, rolling="x", hardness=hardness)
    with pytest.raises(InputError, match="allowed are 64 to 1024"):
        map_patches(self_affine_map(64), points=16)


@pytest.mark.slow
def test_a_mirror_finish_is_refused():
    with pytest.raises(InputError, match="pressed flat by 10 MPa on steel"):
        pressed_map(self_affine_map(64, rms=1e-12), rolling="x", hardness=HARDNESS)


def numbers(**changes):
    table = [[0.5, 0.4], [0.6, 0.45]]
    return {
        "pressure": [1e-3, 1e-2],
        "hardness": 0.05,
        "rms_height": [1e-7, 1.2e-7],
        "decay_ratios": [table, [[0.4, None], [0.42, None]]],
        "contact_fractions": [[[0.1, 0.3]] * 2, [[0.1, None]] * 2],
        "tangential_ratios": [[0.82, 0.83]] * 2,
        "size": [1e-4, 1e-4],
    } | changes


def test_numbers_between_the_loads_and_beyond():
    made = pressed_map_from_document(numbers())
    assert made.document() == numbers()
    middle, half_width = made.decay_ratio(pressure=1e-3, capped=False)
    assert middle == pytest.approx(np.sqrt(0.3))
    # Student's quantile of one degree of freedom, 12.706, and the standard deviation of two logarithms times sqrt(3/2)
    assert half_width == pytest.approx(12.706 * np.log(0.6 / 0.5) * np.sqrt(0.75), rel=1e-4)
    assert made.decay_ratio(pressure=1.0, capped=False)[0] == pytest.approx(np.sqrt(0.18))
    assert made.decay_ratio(pressure=0.0, capped=False)[0] == pytest.approx(middle)
    between, _ = made.decay_ratio(pressure=10**-2.5, capped=False)
    assert np.sqrt(0.18) < between < middle
    assert made.decay_ratio(pressure=1.0, capped=True)[0] == pytest.approx(np.sqrt(0.4 * 0.42))
    assert (made.range(capped=False), made.range(capped=True)) == ((1e-3, 1e-2), (1e-3, 1e-3))


@pytest.mark.parametrize(
    "changes",
    [
        {"pressure": [1e-2, 1e-3]},
        {"hardness": -1.0},
        {"hardness": None},
        {"hardness": 10**400},
        {"tangential_ratios": [[0.5, 0.4]]},
        {"decay_ratios": [[[0.5, 0.4], [0.5, 0.4]], [[None, None], [0.5, 0.4]]]},
        {"decay_ratios": [[[0.5, 0.4], [0.5, 0.4]], [[0.0, None], [0.1, None]]]},
        {"rms_height": "much"},
        {"size": [1e-4]},
    ],
)
def test_damaged_numbers_are_refused(changes):
    with pytest.raises(InputError, match="are damaged: measure again"):
        pressed_map_from_document(numbers(**changes))
