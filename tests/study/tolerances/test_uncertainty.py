"""Tolerances through a closed form whose moments and Sobol indices are known, and through the joint."""

import math

import numpy as np
import pytest
from scipy import stats

from asperity.errors import InputError
from asperity.joint.status import STATUS_NAMES
from asperity.joint_file.quantity_key import Distribution
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import NumericKey
from asperity.results import RESULTS
from asperity.study.tolerances import uncertainty as module
from asperity.study.tolerances.sensitivity import sensitivity
from asperity.study.tolerances.uncertainty import (
    quantiles,
    quantiles_with_failed,
    toleranced_inputs,
    uncertainty,
    worse_end,
)

SAMPLES = 6_000
#: Points of the Sobol sample: the power of two below the samples over two more than the three tolerances.
SOBOL = 1_024
SHARES = np.array([0.025, 0.5, 0.975])


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
        results=("body_mass", "speed_ratio"),
        distribution=Distribution("triangular", 0.0),
        samples=SAMPLES,
        seed=1,
    )


@pytest.mark.parametrize(
    ("distribution", "deviations"),
    [
        (Distribution("uniform", 0.0), [-1.0, -0.8, 0.0, 0.8, 1.0]),
        # below v - t (1 - x) lies x^2/2
        (Distribution("triangular", 0.0), [-1.0, math.sqrt(0.2) - 1.0, 0.0, 1.0 - math.sqrt(0.2), 1.0]),
        # 1.2815515655 standard deviations, each half a tolerance, from the middle
        (Distribution("normal", 2.0), [-math.inf, -0.64077578, 0.0, 0.64077578, math.inf]),
    ],
)
def test_quantiles_of_a_tolerance(distribution, deviations):
    entry = NumericKey("drive.planet_radius", 13.5e-3, 0.1e-3, None, distribution)
    found = quantiles(entry, distribution, np.array([0.0, 0.1, 0.5, 0.9, 1.0]))
    np.testing.assert_allclose(found, 13.5e-3 + 0.1e-3 * np.array(deviations), rtol=1e-10)


@pytest.mark.long
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
    one = spread.sel(result="body_mass_planet")
    deviation = mean * math.sqrt(variance)
    # four standard errors of a mean and, for a kurtosis of at most 3, of a standard deviation
    assert float(one["mean"]) == pytest.approx(mean, abs=4.0 * deviation / math.sqrt(SAMPLES))
    assert float(one["standard_deviation"]) == pytest.approx(deviation, rel=4.0 / math.sqrt(2.0 * SAMPLES))
    assert float(one["nominal"]) == pytest.approx(math.pi * rho * r**2 * b, rel=1e-12)
    for name, own in relative.items():
        others = math.prod(1.0 + v for key, v in relative.items() if key != name)
        first, total = own / variance, own * others / variance
        at = one.sel(input=name)
        # four standard errors of the mean of f_B (f_AB - f_A)/V, whose variance is about 2 S_T for random samples
        error = 4.0 * math.sqrt(2.0 * total / SOBOL)
        assert float(at["first_order"]) == pytest.approx(first, abs=error)
        assert float(at["total_order"]) == pytest.approx(total, abs=error)


def product(values, points, results, *, batch, report):
    """Mass of a planet by hand, in the place of the joint."""
    rho, radius = points["materials.steel.density"], points["drive.planet_radius"]
    mass = math.pi * rho * radius**2 * points["drive.contact_length"]
    return np.zeros(rho.size, dtype=np.int8), {"body_mass": np.stack([mass] * 5)}


def test_half_widths_of_the_indices_hold_their_95_per_cent(toleranced, monkeypatch):
    """Of 40 samples with other seeds, as many hold the true index as 95 % allow: at least 34 but once in 10,000."""
    monkeypatch.setattr(module, "evaluate_points", product)
    truth = 785.0**2 / 4.0 / 7850.0**2  # relative variance of the density; of the length (1/5)^2/6
    first = truth / ((1.0 + truth) * (1.0 + 0.04 / 6.0) * (1.0 + 4.0 / 3.0 * (0.1 / 13.5) ** 2) - 1.0)
    held = 0
    for seed in range(40):
        found = uncertainty(
            toleranced,
            results=("body_mass",),
            distribution=Distribution("triangular", 0.0),
            samples=700,
            seed=seed,
        )
        one = found.sel(result="body_mass_planet", input="materials.steel.density")
        held += abs(float(one["first_order"]) - first) <= float(one["first_order_half_width"])
    assert held >= stats.binom.ppf(1e-4, 40, 0.95)


def test_quantiles_are_those_of_the_distribution(toleranced, monkeypatch):
    """A density that scatters alone and evenly by 10 %: its mass has quantiles at -9.5, 0 and 9.5 % of the nominal."""
    monkeypatch.setattr(module, "evaluate_points", product)
    inputs = toleranced_inputs(toleranced, otherwise=Distribution("uniform", 0.0))
    fixed = Distribution("uniform", 0.0)
    monkeypatch.setattr(
        module,
        "quantiles",
        lambda entry, distribution, shares: (
            entry.value * (0.9 + 0.2 * shares)
            if entry.path.endswith("density")
            else np.full(shares.size, entry.value)
        ),
    )
    assert len(inputs) == 3
    one = uncertainty(toleranced, results=("body_mass",), distribution=fixed, samples=4_000).isel(result=0)
    nominal = float(one["nominal"])
    for found, share in zip(one["quantiles"].values, (0.025, 0.5, 0.975), strict=True):
        # the standard error of a quantile is sqrt(p (1 - p)/n) over the density, here 1/(20 % of the nominal)
        error = 4.0 * math.sqrt(share * (1.0 - share) / 4_000) * 0.2 * nominal
        assert found == pytest.approx(nominal * (0.9 + 0.2 * share), abs=error)


def test_a_contact_has_no_mean(toleranced, monkeypatch):
    def slips(values, points, results, *, batch, report):
        count = points["drive.planet_radius"].size
        return np.zeros(count, dtype=np.int8), {"standing_limiting_contact": np.arange(count) % 2.0}

    monkeypatch.setattr(module, "evaluate_points", slips)
    one = uncertainty(
        toleranced,
        results=("standing_limiting_contact",),
        distribution=Distribution("uniform", 0.0),
        samples=200,
    ).isel(result=0)
    for name in ("nominal", "mean", "standard_deviation", "quantiles", "first_order", "total_order"):
        assert np.all(np.isnan(one[name].values)), name
    assert set(one["samples"].values) == {0.0, 1.0}


@pytest.mark.slow
def test_samples_follow_their_distributions(spread):
    points = spread["sampled_inputs"]
    radius = points.sel(input="drive.planet_radius").values
    assert np.all(np.abs(radius - 13.5e-3) <= 0.1e-3)
    assert np.std(radius) == pytest.approx(0.1e-3 / math.sqrt(3.0), rel=4.0 / math.sqrt(2.0 * SAMPLES))
    density = points.sel(input="materials.steel.density").values
    assert np.mean(np.abs(density - 7850.0) < 785.0) == pytest.approx(
        math.erf(math.sqrt(2.0)), abs=4.0 * math.sqrt(0.95 * 0.05 / SAMPLES)
    )


@pytest.mark.slow
def test_a_result_that_does_not_vary_has_no_indices(spread):
    one = spread.sel(result="speed_ratio")
    assert np.all(np.isnan(one["first_order"].values))
    assert float(one["nominal"]) == pytest.approx(-9.0)
    assert float(one["standard_deviation"]) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.slow
def test_the_same_seed_gives_the_same_numbers(toleranced, spread):
    again = uncertainty(
        toleranced,
        results=("body_mass", "speed_ratio"),
        distribution=Distribution("triangular", 0.0),
        samples=SAMPLES,
        seed=1,
    )
    np.testing.assert_array_equal(again["samples"].values, spread["samples"].values)
    np.testing.assert_array_equal(again["total_order"].values, spread["total_order"].values)


@pytest.mark.long
def test_failed_samples_are_counted(joint_text):
    text = joint_text.replace('planet_radius = "13.5 mm"', 'planet_radius = "13.5 mm +- 0.4 mm, uniform"')
    found = uncertainty(parse_case(text, source="x"), results=("body_mass", "speed_ratio"), samples=2000)
    failed = found["status"].values != 0
    assert 0 < failed.sum() < failed.size
    mass = found.sel(result="body_mass_planet")
    assert np.isfinite(float(mass["mean"]))
    assert np.all(np.isnan(mass["first_order"].values))


@pytest.mark.long
def test_plastic_samples_are_counted_and_left_out(joint_text):
    """The stiffness of the solved samples rises with D from the value where the last spots turn elastic."""
    text = joint_text.replace("fractal_dimension = 1.4", 'fractal_dimension = "1.3 +- 0.1, uniform"')
    found = uncertainty(parse_case(text, source="x"), results=("published_stiffness_output",), samples=1000)
    plastic = found["status"].values == STATUS_NAMES.index("all_spots_plastic")
    D = found["sampled_inputs"].sel(input="surface.fractal_dimension").values
    assert 0 < plastic.sum() < 1000
    assert D[plastic].max() < D[~plastic].min()
    assert np.isfinite(float(found["mean"].squeeze()))


@pytest.mark.long
def test_small_tolerances_are_linear(joint_text):
    # the standard deviation of the published stiffness is its derivative times that of the preload
    text = joint_text.replace('"1000 N"', '"1000 N +- 0.1 N, normal 1 sigma"').replace('"printed"', '"unity"')
    case = parse_case(text, source="x")
    found = uncertainty(case, results=("published_stiffness_output",), samples=4_000).isel(result=0)
    slope = float(
        sensitivity(case)["derivative"].sel(result="published_stiffness_output", input="load.preload")
    )
    assert float(found["standard_deviation"]) == pytest.approx(
        abs(slope) * 0.1, rel=4.0 / math.sqrt(2.0 * 4_000)
    )
    assert float(found["first_order"].squeeze()) == pytest.approx(1.0, abs=0.05)


def test_a_distribution_is_never_guessed(toleranced, case):
    with pytest.raises(
        InputError,
        match=r"drive\.contact_length: the file states a tolerance .* state one for all of them, such",
    ):
        toleranced_inputs(toleranced, otherwise=None)
    with pytest.raises(InputError, match="no tolerances"):
        toleranced_inputs(case, otherwise=None)
    with pytest.raises(InputError, match="too few"):
        uncertainty(toleranced, distribution=Distribution("uniform", 0.0), samples=10)
    with pytest.raises(InputError, match=r"1000000000000 samples of .* need too much memory"):
        uncertainty(toleranced, distribution=Distribution("uniform", 0.0), samples=10**12)


@pytest.mark.long
def test_radii_of_finished_parts_make_the_interference_of_a_planetary(planar_case):
    toleranced = {
        'sun_radius = "10 mm"': 'sun_radius = "10 mm +- 2 um, uniform"',
        'planet_radius = "20 mm"': 'planet_radius = "20 mm +- 2 um, uniform"',
        'output_torque = "10 N*m"': 'output_torque = "2 N*m"',
    }
    found = uncertainty(
        planar_case("planetary", replaced=toleranced), results=("interference",), samples=2000
    )
    assert found["status"].values.tolist() == [0] * 2000
    # in the ring of its nominal radius: 30 um + d_sun + 2 d_planet
    one = found.sel(result="interference")
    assert float(one["nominal"]) == pytest.approx(30e-6, rel=1e-9)
    assert float(one["mean"]) == pytest.approx(30e-6, rel=0.01)
    assert float(one["standard_deviation"]) == pytest.approx(2e-6 * math.sqrt(5.0 / 3.0), rel=0.05)
    shares = dict(zip(one["input"].values.tolist(), one["first_order"].values.tolist(), strict=True))
    assert shares == pytest.approx({"drive.sun_radius": 0.2, "drive.planet_radius": 0.8}, abs=0.03)


@pytest.mark.parametrize(
    ("name", "end"),
    [
        ("assembly_stiffness_output", "low"), ("torque_capacity", "low"), ("drive_life", "low"),
        ("slip_safety", "low"), ("efficiency", "low"), ("slip_ratio", "high"), ("hertz_pressure", "high"),
        ("drift", "high"), ("mass", ""), ("speed_ratio", ""),
    ],
)  # fmt: skip
def test_which_end_is_the_worse_one(name, end):
    assert worse_end(RESULTS[name]) == end


def test_a_few_failed_samples_move_the_quantile_by_their_number():
    """Of 1000 lives 1 to 1000, the ten that fail make 15 of those that live the worst 2.5 %."""
    lives = np.append(np.arange(11.0, 1001.0), np.full(10, np.nan))
    low, median, high = quantiles_with_failed(lives, SHARES, worse="low")
    assert (low, median, high) == (25.0, 500.0, 975.0)  # as if the ten lived 1 to 10
    low, median, high = quantiles_with_failed(lives - 10.0, SHARES, worse="high")
    assert (low, median, high) == (26.0, 501.0, 976.0)  # as if the ten were the largest; the next one above


def test_more_failed_samples_than_the_share_leave_no_value():
    values = np.append(np.arange(965.0), np.full(35, np.nan))  # 3.5 % of the drives slip
    assert quantiles_with_failed(values, SHARES, worse="low")[0] == -np.inf
    assert quantiles_with_failed(values, SHARES, worse="low")[2] < 964.0
    assert quantiles_with_failed(values, SHARES, worse="high")[2] == np.inf
    assert np.isnan(quantiles_with_failed(values, SHARES, worse="")).all()


def test_without_failures_they_are_those_of_the_samples():
    values = np.random.default_rng(0).normal(size=999)
    for worse in ("low", "high", ""):
        np.testing.assert_array_equal(
            quantiles_with_failed(values, SHARES, worse=worse), np.quantile(values, SHARES)
        )


def test_a_life_that_some_drives_do_not_have_keeps_its_mean(monkeypatch, joint_text):
    """A twentieth of the drives do not roll: a mean all the same, and a lower end that fails."""

    def lives(values, points, names, **_):
        preload = np.asarray(points["load.preload"])
        return np.zeros(preload.size, dtype=np.int8), {
            "drive_life": np.where(preload < 910.0, np.nan, preload)[None],
            "torque_capacity": preload[None],
        }

    monkeypatch.setattr(module, "evaluate_points", lives)
    case = parse_case(joint_text.replace('"1000 N"', '"1000 N +- 100 N, uniform"'), source="x")
    found = uncertainty(case, results=("drive_life", "torque_capacity"), samples=20_000)
    life, capacity = found.sel(result="drive_life"), found.sel(result="torque_capacity")
    # evenly between 900 and 1100 N: a twentieth below 910 N
    assert float(life["failed"]) == pytest.approx(0.05, abs=0.006)
    assert float(life["mean"]) == pytest.approx(1005.0, abs=2.0)
    assert life["quantiles"].values[0] == -np.inf
    # those that fail are the worst: the median of all drives, not of those that live
    assert life["quantiles"].values[1:] == pytest.approx([1000.0, 1095.0], abs=3.0)
    assert float(capacity["failed"]) == 0.0
    assert capacity["quantiles"].values == pytest.approx([905.0, 1000.0, 1095.0], abs=3.0)
