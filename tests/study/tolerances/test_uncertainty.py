"""Tolerances through a closed form whose moments and Sobol indices are known, and through the joint."""

import math

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint_file.distribution import Distribution
from asperity.joint_file.reader import parse_case
from asperity.study.tolerances.sensitivity import sensitivity
from asperity.study.tolerances.uncertainty import toleranced_inputs, uncertainty


@pytest.fixture(scope="module")
def toleranced(joint_text):
    text = joint_text
    for old, new in (
        ('density = "7850 kg/m^3"', 'density = "7850 kg/m^3 +- 785 kg/m^3, normal 2 sigma"'),
        ('planet_radius = "13.5 mm"', 'planet_radius = "13.5 mm +- 0.1 mm, uniform"'),
        ('contact_length = "5 mm"', 'contact_length = "5 mm +- 1 mm"'),
    ):
        assert old in text
        text = text.replace(old, new)
    return parse_case(text, source="tolerances.toml")


@pytest.fixture(scope="module")
def spread(toleranced):
    return uncertainty(
        toleranced,
        results=("planet_mass", "speed_ratio"),
        distribution=Distribution("triangular", 0.0),
        samples=9_000,
        seed=1,
    )


def test_moments_and_indices_of_a_product(spread):
    # m = pi rho R^2 B with independent factors: E and Var of each factor, and hence all indices, in closed form
    rho, r, b = 7850.0, 13.5e-3, 5e-3
    s_rho, t, s_b = 785.0 / 2.0, 0.1e-3, 1e-3 / math.sqrt(6.0)
    mean_r2 = r**2 + t**2 / 3.0
    mean_r4 = r**4 + 2.0 * r**2 * t**2 + t**4 / 5.0
    relative = {
        "materials.steel.density": s_rho**2 / rho**2,
        "drive.planet_radius": mean_r4 / mean_r2**2 - 1.0,
        "drive.contact_length": s_b**2 / b**2,
    }
    mean = math.pi * rho * mean_r2 * b
    variance = math.prod(1.0 + v for v in relative.values()) - 1.0
    one = spread.sel(result="planet_mass")
    deviation = mean * math.sqrt(variance)
    assert float(one["mean"]) == pytest.approx(mean, abs=5.0 * deviation / math.sqrt(9_000))
    assert float(one["standard_deviation"]) == pytest.approx(deviation, rel=0.03)
    assert float(one["nominal"]) == pytest.approx(math.pi * rho * r**2 * b, rel=1e-12)
    for name, own in relative.items():
        others = math.prod(1.0 + v for key, v in relative.items() if key != name)
        first, total = own / variance, own * others / variance
        at = one.sel(input=name)
        assert float(at["first_order"]) == pytest.approx(
            first, abs=max(2.0 * float(at["first_order_half_width"]), 0.01)
        )
        assert float(at["total_order"]) == pytest.approx(
            total, abs=max(2.0 * float(at["total_order_half_width"]), 0.01)
        )


def test_quantiles_hold_their_share(spread):
    low, median, high = spread["quantiles"].sel(result="planet_mass").values
    samples = spread["samples"].sel(result="planet_mass").values
    assert np.mean((samples > low) & (samples < high)) == pytest.approx(0.95, abs=1e-3)
    assert low < median < high


def test_samples_follow_their_distributions(spread):
    points = spread["sampled_inputs"]
    radius = points.sel(input="drive.planet_radius").values
    assert np.all(np.abs(radius - 13.5e-3) <= 0.1e-3)
    assert np.std(radius) == pytest.approx(0.1e-3 / math.sqrt(3.0), rel=0.02)
    density = points.sel(input="materials.steel.density").values
    assert np.mean(np.abs(density - 7850.0) < 785.0) == pytest.approx(math.erf(math.sqrt(2.0)), abs=0.01)


def test_a_result_that_does_not_vary_has_no_indices(spread):
    one = spread.sel(result="speed_ratio")
    assert np.all(np.isnan(one["first_order"].values))
    assert float(one["nominal"]) == pytest.approx(-9.0)
    assert float(one["standard_deviation"]) == pytest.approx(0.0, abs=1e-12)


def test_the_same_seed_gives_the_same_numbers(toleranced, spread):
    again = uncertainty(
        toleranced,
        results=("planet_mass", "speed_ratio"),
        distribution=Distribution("triangular", 0.0),
        samples=9_000,
        seed=1,
    )
    np.testing.assert_array_equal(again["samples"].values, spread["samples"].values)
    np.testing.assert_array_equal(again["total_order"].values, spread["total_order"].values)


def test_failed_samples_are_counted(joint_text):
    text = joint_text.replace('planet_radius = "13.5 mm"', 'planet_radius = "13.5 mm +- 0.4 mm, uniform"')
    found = uncertainty(parse_case(text, source="x"), results=("planet_mass", "speed_ratio"), samples=2000)
    failed = found["status"].values != 0
    assert 0 < failed.sum() < failed.size
    mass = found.sel(result="planet_mass")
    assert np.isfinite(float(mass["mean"]))
    assert np.all(np.isnan(mass["first_order"].values))


def test_small_tolerances_are_linear(joint_text):
    # the standard deviation of the published stiffness is its derivative times that of the preload
    text = joint_text.replace('"1000 N"', '"1000 N +- 0.1 N, normal 1 sigma"').replace('"printed"', '"unity"')
    case = parse_case(text, source="x")
    found = uncertainty(case, results=("published_stiffness_output",), samples=4_000).isel(result=0)
    slope = float(
        sensitivity(case)["derivative"].sel(result="published_stiffness_output", input="load.preload")
    )
    assert float(found["standard_deviation"]) == pytest.approx(abs(slope) * 0.1, rel=0.06)
    assert float(found["first_order"].squeeze()) == pytest.approx(1.0, abs=0.05)


def test_a_distribution_is_never_guessed(toleranced, case):
    with pytest.raises(
        InputError, match=r"drive\.contact_length: the file states a tolerance but not its distribution"
    ):
        toleranced_inputs(toleranced, otherwise=None)
    with pytest.raises(InputError, match="no tolerances"):
        toleranced_inputs(case, otherwise=None)
    with pytest.raises(InputError, match="too few"):
        uncertainty(toleranced, distribution=Distribution("uniform", 0.0), samples=10)
    with pytest.raises(InputError, match=r"1000000000000 samples of .* are too many"):
        uncertainty(toleranced, distribution=Distribution("uniform", 0.0), samples=10**12)
