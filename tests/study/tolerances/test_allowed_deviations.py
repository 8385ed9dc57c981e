"""Tolerances backwards: deviations of a drive whose results are linear in its sizes, known by hand."""

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import norm

from asperity.errors import InputError, NoSolutionError
from asperity.joint.status import STATUS_NAMES
from asperity.joint_file.any_joint import with_nominal_sizes
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.quantity_key import Distribution
from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.si_tables import numeric_keys, replace_values, si_values
from asperity.library.tolerance_grades import standard_tolerances
from asperity.study.tolerances import allowed_deviations as module
from asperity.study.tolerances.allowed_deviations import allowed_deviations, limits_from_text

PLANETARY = Path(__file__).parents[3] / "examples" / "planetary.toml"
#: Radii 10 and 20 mm, interference 30 um of a ring of 50 mm; N.m per m.
SLOPES = {"drive.sun_radius": 2e5, "drive.planet_radius": 4e5, "load.interference": 2e5}
NOMINAL = {"drive.sun_radius": 0.01, "drive.planet_radius": 0.02, "load.interference": 30e-6}
NORMAL = Distribution("normal", 3.0)


@pytest.fixture(scope="module")
def case():
    return read_case(PLANETARY)


@pytest.fixture
def linear(monkeypatch):
    """A capacity of 12 N.m that is linear in the sizes."""

    def capacity(points):
        return 12.0 + sum(SLOPES[path] * (np.asarray(points[path]) - NOMINAL[path]) for path in SLOPES)

    def derivatives(tables, point, names, paths):
        (value,) = capacity(point)
        slope = np.array([[[SLOPES[path] for path in paths]]])
        return np.array([0]), {"torque_capacity": np.array([[value]])}, {"torque_capacity": slope}

    monkeypatch.setattr(module, "derivatives_at", derivatives)
    monkeypatch.setattr(
        module, "evaluate_points", lambda tables, points, names: (None, {names[0]: capacity(points)})
    )


def allowed(case, *texts, sharing="equal", share=0.99, samples=10_000, distribution=NORMAL):
    limits = limits_from_text(texts or ("torque_capacity >= 10 N*m",), case)
    return allowed_deviations(
        case, limits, share=share, sharing=sharing, distribution=distribution, samples=samples, seed=1
    )


@pytest.mark.parametrize("sharing", ["equal", "grade", "cost"])
def test_deviations_by_hand(linear, case, sharing):
    """A margin of 2 N.m is 2.326 standard deviations of the sum; the quantile of 10 000 drives scatters by 1.6 %."""
    found = allowed(case, sharing=sharing)
    deviations = np.array([size.deviation for size in found.sizes])
    slopes = np.array([SLOPES[size.path] for size in found.sizes])
    assert norm.ppf(0.99) * np.linalg.norm(slopes * deviations / 3.0) == pytest.approx(2.0, rel=0.08)
    shares = {
        "equal": np.ones(3),
        "grade": np.array([standard_tolerances(size)["IT6"] for size in (0.02, 0.04, 0.1)]),
        "cost": np.array([1.0, 2.0 ** (-2.0 / 3.0), 1.0]),
    }[sharing]
    assert deviations / deviations[0] == pytest.approx(shares / shares[0], rel=1e-9)
    assert found.kept >= 9900
    assert [size.diameter for size in found.sizes] == pytest.approx([0.02, 0.04, 0.1])
    assert found.sizes[1].influence == pytest.approx(0.2)  # 4e5 N.m/m of 2 N.m
    for size in found.sizes:
        widths = standard_tolerances(size.diameter)
        assert widths[size.grade] <= 4.0 * size.deviation
        assert all(
            width > 4.0 * size.deviation
            for width in list(widths.values())[list(widths).index(size.grade) + 1 :]
        )


def test_least_cost_is_least(linear, case):
    """Of a sum of squares, the reciprocals add up to less than with equal deviations or grades."""
    costs = {
        sharing: sum(1.0 / size.deviation for size in allowed(case, sharing=sharing).sizes)
        for sharing in ("equal", "grade", "cost")
    }
    assert min(costs, key=costs.get) == "cost"


def test_what_cannot_be_kept_or_says_nothing_is_refused(linear, case, monkeypatch):
    with pytest.raises(InputError, match="nominal sizes misses a limit: torque_capacity is 12, at least 13"):
        allowed(case, "torque_capacity >= 13 N*m")
    with pytest.raises(InputError, match=r"at least 13 is asked for \[N\*m\]$"):
        allowed(case, "torque_capacity >= 13 N*m", "torque_capacity >= 11 N*m")  # which it keeps
    with pytest.raises(InputError, match=r"100 drives are too few for a share of 0\.99; at least 500"):
        allowed(case, samples=100)
    for path in SLOPES:
        monkeypatch.setitem(SLOPES, path, 1.0)
    with pytest.raises(NoSolutionError, match="say nothing about tolerances"):
        allowed(case)
    for path in SLOPES:
        monkeypatch.setitem(SLOPES, path, 0.0)
    with pytest.raises(NoSolutionError, match="no size of the drive moves a result that is limited"):
        allowed(case)


@pytest.mark.parametrize("names", [["sp", "pr"], ["pr"]])
def test_a_result_without_a_value_is_said_once_with_the_reason(case, monkeypatch, names):
    def derivatives(tables, point, asked, paths):
        values = np.array([[np.nan if name in names else 10.0] for name in ("sp", "pr")])
        return np.array([0]), {asked[0]: values}, {asked[0]: np.zeros((2, 1, len(paths)))}

    monkeypatch.setattr(module, "derivatives_at", derivatives)
    with pytest.raises(InputError) as refused:
        allowed(case, "flash_temperature <= 100 K")
    assert str(refused.value) == (
        f"flash_temperature has no value at {', '.join(names)}: there is none without thermal_conductivity and "
        "specific_heat_capacity of both materials or where the input stands; state what it needs, or leave this limit "
        "out"
    )


def test_a_drive_without_a_result_says_why(case, monkeypatch):
    def derivatives(tables, point, asked, paths):
        return np.array([STATUS_NAMES.index("contact_too_wide")]), {asked[0]: np.full((1, 1), np.nan)}, {}

    monkeypatch.setattr(module, "derivatives_at", derivatives)
    with pytest.raises(
        InputError, match=r"nominal sizes has no result: a contact strip is too wide"
    ) as refused:
        allowed(case)
    assert "nan" not in str(refused.value)


def test_a_preload_force_is_refused(case):
    text = PLANETARY.read_text(encoding="utf-8")
    pressed = parse_case(text.replace('interference = "30 um"', 'preload = "900 N"'), source="a.toml")
    with pytest.raises(
        InputError, match=r"load\.preload is a force, which no size moves: give load\.interference"
    ):
        allowed(pressed)


#: The drive of the planetary, listed.
LISTED = """
type = "planar"

[drive]
sectors = 3
input = "sun"
output = "carrier"
grounded = "ring"
contact_length = "10 mm"

[[roller]]
name = "sun"
place = "axis"

[[roller]]
name = "planet"
place = "pin"
orbit = "30 mm"

[[roller]]
name = "ring"
place = "axis"
wall_thickness = "8 mm"
ring_support = "free"

[[contact]]
name = "sp"
first = "sun"
second = "planet"
first_radius = "10 mm"
second_radius = "20 mm"

[[contact]]
name = "pr"
first = "planet"
second = "ring"
first_radius = "20 mm"
second_radius = "50 mm"
internal = true

[load]
"""


@pytest.fixture(scope="module")
def listed_case():
    text = PLANETARY.read_text(encoding="utf-8")
    return parse_case(LISTED + text.split("[load]\n")[1], source="listed.toml")


def test_the_sizes_of_listed_contacts_are_their_tracks(case, listed_case):
    sizes, diameters = module._sizes(listed_case)
    assert list(sizes) == ["contact.1.first_radius", "contact.1.second_radius", "contact.2.second_radius"]
    np.testing.assert_allclose(diameters, module._sizes(case)[1], rtol=1e-12)


@pytest.mark.parametrize(
    ("own", "tracks"),
    [
        ("drive.sun_radius", ["contact.1.first_radius"]),
        ("drive.planet_radius", ["contact.1.second_radius", "contact.2.first_radius"]),
    ],
)
def test_finished_parts_press_a_drive_and_its_listed_twin_alike(case, listed_case, own, tracks):
    """By hand: 1 um of the sun, or twice 1 um of a planet, adds to 30 um: both contacts bear the same force."""

    def interference(case, paths):
        tables = with_nominal_sizes(si_values(case))
        numbers = {path: numeric_keys(case)[path].value + 1e-6 for path in paths}
        return 30e-6 * np.sum(joint_from_values(replace_values(tables, numbers)).pattern)

    by_hand = 30e-6 + 1e-6 * (1.0 if own == "drive.sun_radius" else 2.0)
    assert float(interference(case, [own])) == pytest.approx(by_hand, rel=1e-9)
    assert float(interference(listed_case, tracks)) == pytest.approx(by_hand, rel=1e-9)


@pytest.mark.long
def test_a_drive_and_its_listed_twin_are_allowed_the_same(case, listed_case):
    """An interference is a deviation of the bore of the other sign: 10 of 500 drives miss, by chance not the same."""
    one, other = (
        allowed(
            each,
            "standing_torque_capacity >= 10.5 N*m",
            share=0.98,
            samples=500,
            distribution=Distribution("uniform", 0.0),
        )
        for each in (case, listed_case)
    )
    for size, twin in zip(one.sizes, other.sizes, strict=True):
        assert twin.deviation == pytest.approx(size.deviation, rel=0.1)
        assert twin.influence == pytest.approx(size.influence, rel=2e-3)
        assert twin.diameter == pytest.approx(size.diameter)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("torque_capacity = 10 N*m", "expected RESULT>=VALUE or RESULT<=VALUE"),
        ("torque_capacity >= 10 mm", "^'torque_capacity >= 10 mm': expected a torque"),
        ("slip_ratio<=nan", "^'slip_ratio<=nan': expected a dimensionless number .* not a finite number"),
        ("slip_ratio<=3", "^'slip_ratio<=3': 3 is not allowed; it must be at most 1"),
        ("torque >= 10 N*m", "did you mean 'torque_capacity'"),
    ],
)
def test_limits_are_read_or_refused(case, text, message):
    (limit,) = limits_from_text(["stiffness >= 8e5 N*m/rad"], case)
    assert (limit.name, limit.at_most, limit.limit) == ("assembly_stiffness_output", False, 8e5)
    with pytest.raises(InputError, match=message) as refused:
        limits_from_text([text], case)
    assert refused.value.options == ("keep",)


@pytest.mark.long
def test_the_planetary_keeps_its_capacity(case):
    """The interference at the contacts is sun + 2 planets - bore: their influences are as 1 : 2 : 1."""
    found = allowed(
        case,
        "standing_torque_capacity >= 10.5 N*m",
        share=0.98,
        samples=500,
        distribution=Distribution("uniform", 0.0),
    )
    influence = {size.path: size.influence for size in found.sizes}
    assert influence["drive.planet_radius"] == pytest.approx(2.0 * influence["drive.sun_radius"], rel=0.02)
    assert influence["load.interference"] == pytest.approx(influence["drive.sun_radius"], rel=0.02)
    assert found.kept >= 490
    # 2 % of the drives lie beyond 2.05 standard deviations of a sum of three uniform numbers, about normal
    spread = np.linalg.norm([size.influence * 1e6 * size.deviation / math.sqrt(3.0) for size in found.sizes])
    assert norm.ppf(0.98) * spread == pytest.approx(1.0, rel=0.15)
