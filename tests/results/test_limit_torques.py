"""The torques at which limits are reached: against one joint solved by itself, and against closed forms."""

import math
from pathlib import Path

import numpy as np
import pytest
import windows

import asperity
from asperity.joint_file.window import joint_window
from asperity.results.limit_torques import LIMITS
from asperity.results.torque_capacity import torque_capacity_document

EXAMPLES = Path(__file__).parents[2] / "examples"
#: Wheels of the example: friction coefficient, radii and length of the contact [m].
FRICTION, DRIVER, DRIVEN, LENGTH = 0.08, 0.020, 0.040, 0.010
#: Their steel 52100, as the library has it [Pa].
MODULUS, POISSON, YIELD = 203e9, 0.29, 2034e6


@pytest.fixture(scope="module")
def wheels():
    return asperity.load(EXAMPLES / "wheel_pair.toml")


@pytest.fixture(scope="module")
def housed(wheels):
    return wheels.edited(windows.housed())


def border(window, limit):
    """Torque at which a limit is reached over the axis, in the direction of the file."""
    limits = window.regions[0].limits
    return np.where(limits.limit == LIMITS.index(limit), limits.torque, np.inf).min(axis=0)


@pytest.mark.parametrize(
    ("name", "changes"),
    [
        ("wheel_pair", {}),
        ("planetary", {"load.output_torque": "-5 N*m"}),
        (
            "zou2025",
            {"load.preload": "241 N", "load.output_torque": "1 N*m"},
        ),  # first yield ends the capacity
        pytest.param("stepped_planet", {}, marks=pytest.mark.slow),
        pytest.param("multiroller", {"load.interference": "60 um"}, marks=pytest.mark.slow),
        pytest.param("planar", {}, marks=pytest.mark.slow),
    ],
)
def test_the_border_at_the_working_point_is_the_capacity_of_the_joint_alone(name, changes):
    joint = asperity.load(EXAMPLES / f"{name}.toml").with_values(changes)
    window = joint_window(joint.case, points=2)
    (region,) = window.regions
    document = torque_capacity_document(joint.solve()._solved)
    alone = document if region.sign > 0.0 else document["reverse"]
    assert region.capacity.torque[window.working] == pytest.approx(alone["output_torque_Nm"], rel=1e-12)
    assert LIMITS[region.capacity.limit[window.working]] == alone["limit"]
    assert window.words(region.capacity, window.working) == alone["meaning"]


def test_wheels_slip_at_a_torque_in_proportion_to_the_force(wheels):
    window = joint_window(wheels.case, start=200.0, stop=1800.0, points=5)
    assert border(window, "gross_slip") == pytest.approx(FRICTION * DRIVEN * window.at, rel=1e-9)
    assert window.preload == pytest.approx(window.at, rel=1e-12)


def test_wheels_yield_at_the_force_of_hertz(wheels):
    """A spring keeps the force under torque: no torque at all is allowed from the force on at which they yield."""
    contact_modulus = MODULUS / (2.0 * (1.0 - POISSON**2))
    radius = 1.0 / (1.0 / DRIVER + 1.0 / DRIVEN)
    force = (1.67 * YIELD) ** 2 * math.pi * radius * LENGTH / contact_modulus  # of p_0 = sqrt(P' E* / (pi R))
    window = joint_window(wheels.case, start=0.5 * force, stop=1.5 * force, points=11)
    closed = border(window, "pressure_over_first_yield") == 0.0
    assert np.array_equal(closed, window.at > force)
    assert window.at[closed][0] - window.at[~closed][-1] < 0.01 * force
    assert np.array_equal(window.regions[0].capacity.torque == 0.0, closed)


@pytest.mark.slow
def test_limits_of_slip_fall_with_the_temperature_that_takes_the_preload(housed):
    window = joint_window(housed.case, start=20.0, stop=50.0, points=4)
    for limit in ("gross_slip", "rolling_gross_slip"):
        assert np.all(np.diff(border(window, limit)) < 0.0)
    assert np.all(np.diff(window.preload) < 0.0)


def test_another_temperature_is_that_of_the_file(housed):
    """The joint of a file with this temperature, solved by itself."""
    window = joint_window(housed.case, start=25.0, stop=35.0, points=2)
    there = housed.with_values({"temperature.working": "35 degC"}).solve()
    (number,) = np.flatnonzero(window.at == 35.0)
    found = torque_capacity_document(there._solved)
    assert window.regions[0].capacity.torque[number] == pytest.approx(found["output_torque_Nm"], rel=1e-12)
    assert window.preload[number] == pytest.approx(there["preload"].si, rel=1e-12)


@pytest.mark.slow
def test_a_ring_turns_in_its_housing_where_its_seat_holds_just_its_torque(housed):
    window = joint_window(housed.case, start=50.0, stop=55.0, points=2)
    torque = border(window, "seat_torque_safety")[window.at == 50.0][0]
    there = {"temperature.working": "50 degC", "load.output_torque": f"{float(torque)!r} N*m"}
    assert np.nanmin(housed.with_values(there).solve()["seat_torque_safety"].si) == pytest.approx(
        1.0, rel=1e-9
    )


@pytest.mark.slow
def test_the_whole_duty_is_scaled_to_the_life_that_is_required():
    """The life under a duty whose torques are 1.5 times as large is required: just that is the border."""
    text = (EXAMPLES / "planetary.toml").read_text()
    text = text.replace("[load]", '[load]\ncam_force_per_torque = "150 N/Nm"', 1)
    one, largest = "\n[rolling]\n", 8.0

    def with_duty(scale, life):
        loads = "".join(
            f'\n[[duty]]\noutput_torque = "{scale * torque} N*m"\nsun_speed = "{speed} rpm"\nshare = 0.5\n'
            for torque, speed in ((largest, 900), (3.0, 1500))
        )
        required = f'{one}required_life = "{life!r} h"\n' if life else ""
        return asperity.load(EXAMPLES / "planetary.toml").edited(text + required + loads)

    life = with_duty(1.5, None).solve()["duty_life"].si / 3600.0
    window = joint_window(with_duty(1.0, life).case, points=2)
    assert border(window, "required_life")[window.working] == pytest.approx(1.5 * largest, rel=1e-9)


@pytest.mark.slow
def test_a_life_that_the_force_alone_takes_closes_the_window(wheels):
    """The force of a spring makes the life, whatever the torque: on both sides by the life of one joint."""
    text = (EXAMPLES / "wheel_pair.toml").read_text() + '\n[rolling]\nrequired_life = "1e9 h"\n'
    joint = wheels.edited(text)
    window = joint_window(joint.case, start=800.0, stop=1200.0, points=2)
    capacity = window.regions[0].capacity
    closed = int(np.argmax(capacity.torque == 0.0))
    assert closed > 0
    assert window.words(capacity, closed) == "the rating life falls below the required 1e9 h without torque"
    for number, reaches in ((closed - 1, True), (closed, False)):
        there = joint.with_values(
            {"load.preload": f"{float(window.at[number])!r} N", "load.output_torque": "0.1 N*m"}
        )
        assert (there.solve()["drive_life"].si >= 1e9 * 3600.0) == reaches


@pytest.mark.slow
def test_a_film_too_thin_for_a_life_closes_the_window_where_one_is_required(wheels):
    """Slow wheels in oil: without a factor their life is long, with one there is none."""
    text = (EXAMPLES / "wheel_pair.toml").read_text() + '\n[rolling]\nrequired_life = "1 h"\n'
    oil = 'viscosity = "30 mPa*s"\npressure_coefficient = "20 1/GPa"\nroughness = "2 um"'
    text = text.replace('viscosity = "30 mPa*s"', oil)
    slow, clean = (
        wheels.edited(text + life).with_values({"load.sun_speed": "10 rpm"})
        for life in ("", "\n[life]\ncleanliness = 0.5\n")
    )
    windows_of = [joint_window(each.case, start=800.0, stop=1200.0, points=2) for each in (slow, clean)]
    open_, closed = (window.regions[0].capacity.torque for window in windows_of)
    assert np.all(open_ > 0.0)
    assert np.all(closed == 0.0)
    said = windows_of[1].words(windows_of[1].regions[0].capacity, 0)
    assert said.startswith("the rating life falls below the required 1 h, or an oil film is too thin for one")


@pytest.mark.slow
def test_what_a_loading_cam_adds_counts():
    """A cam presses more with the torque, so that something else than slip ends the capacity."""
    text = (EXAMPLES / "planetary.toml").read_text()
    text = text.replace("[load]", '[load]\ncam_force_per_torque = "150 N/Nm"', 1)
    pressed = asperity.load(EXAMPLES / "planetary.toml").edited(text)
    window = joint_window(pressed.case, start=25e-6, stop=35e-6, points=2)
    found = torque_capacity_document(pressed.solve()._solved)
    assert "slip" not in found["limit"]
    assert window.regions[0].capacity.torque[window.working] == pytest.approx(
        found["output_torque_Nm"], rel=1e-12
    )
