"""Circle and logarithmic profile along rollers: known ones with waves on them, and what is neither."""

import numpy as np
import pytest

from asperity.surface.crown import crown, logarithmic_profile
from asperity.surface.measure_files import read_surface
from asperity.surface.topography import Topography


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_crown_of_a_circle(sign):
    """Radius 2 m over 10 mm, tilted, with a wave of 0.1 um: a drop of B^2/8R = 6.25 um, a misfit of 0.1/sqrt(2) um."""
    x = np.linspace(-5e-3, 5e-3, 10_001)
    circle = sign * (np.sqrt(4.0 - x**2) - 2.0) + 1e-3 * x
    got = crown(topography=Topography(circle + 1e-7 * np.sin(2 * np.pi * x / 1e-4), 1e-6))
    assert got.radius == pytest.approx(2.0 * sign, rel=1e-3)
    assert got.middle_radius == pytest.approx(2.0 * sign, rel=5e-3)
    assert got.drop == pytest.approx(6.25e-6 * sign, rel=1e-3)
    assert got.misfit == pytest.approx(1e-7 / np.sqrt(2.0), rel=1e-3)
    assert got.stands_out


def test_chamfers_and_noise_are_no_crown():
    x = np.linspace(-1.0, 1.0, 2001)
    chamfered = Topography(-1e-5 * np.maximum(np.abs(x) - 0.8, 0.0), 1e-6)
    noise = Topography(1e-7 * np.random.default_rng(0).standard_normal(2001), 1e-6)
    assert not crown(topography=chamfered).stands_out
    assert not crown(topography=noise).stands_out
    assert crown(topography=Topography(np.zeros(15), 1e-6)) is None


def logarithmic(x, coefficient, length):
    """The standard's profile, written out."""
    return -coefficient * np.log(1.0 / (1.0 - (2.0 * x / length) ** 2))


def test_logarithmic_profile_of_the_standard():
    """A roller of 9 mm and L = 10 mm, measured from -4.3 to 4.7 mm, tilted, with a wave of 0.1 um."""
    x = np.linspace(-4.3e-3, 4.7e-3, 9001)
    z = logarithmic(x, 0.00035 * 9e-3, 10e-3) + 1e-3 * x + 1e-7 * np.sin(2 * np.pi * x / 1e-4)
    profile = Topography(z, 1e-6)
    got = logarithmic_profile(topography=profile)
    assert got.coefficient == pytest.approx(0.00035 * 9e-3, rel=0.01)
    assert got.length == pytest.approx(10e-3, rel=2e-3)
    assert got.misfit == pytest.approx(1e-7 / np.sqrt(2.0), rel=5e-3)
    assert got.stands_out(crown(topography=profile))
    assert not crown(topography=profile).stands_out


def test_circles_chamfers_hollows_and_noise_are_no_logarithmic_profile():
    x = np.linspace(-1.0, 1.0, 2001)
    noise = 1e-8 * np.random.default_rng(0).standard_normal(2001)
    for z in (-1e-6 * x**2, -1e-5 * np.maximum(np.abs(x) - 0.9, 0.0), np.zeros(2001)):
        profile = Topography(z + noise, 1e-6)
        got = logarithmic_profile(topography=profile)
        assert got is None or not got.stands_out(crown(topography=profile))
    assert logarithmic_profile(topography=Topography(1e-6 * x**2, 1e-6)) is None
    assert logarithmic_profile(topography=Topography(np.zeros(15), 1e-6)) is None


@pytest.mark.parametrize(("name", "stands_out"), [("NU206-RE-1", True), ("NU208-IR-1", False)])
def test_measured_rollers_without_their_chamfers(shared_data, name, stands_out):
    file = shared_data / "bearing_roller_profiles" / f"{name}.txt"
    surface = read_surface(path=file, position_unit="mm", height_unit="um")
    length = surface.size[0]
    section = surface.cut(start=0.06 * length, stop=0.94 * length)
    assert logarithmic_profile(topography=section).stands_out(crown(topography=section)) == stands_out
    assert crown(topography=section).stands_out != stands_out
    assert not logarithmic_profile(topography=surface).stands_out(crown(topography=surface))
