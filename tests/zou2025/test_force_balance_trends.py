"""How the forces move with torque, speed, direction and size, and that no contact ever pulls."""

import math

import numpy as np
import pytest

CLOSURES = ("elastic", "constant_pin_force")


def test_forces_move_with_torque_as_in_figure_5(forces_of):
    f = forces_of(output_torque=np.linspace(0.0, 8.0, 9))
    for name in ("N_sp", "N_pwr", "N_wro", "T_sp", "T_pwr", "T_pwl", "T_wro", "T_wlo"):
        assert (np.diff(f[name]) > 0).all(), name
    for name in ("N_pwl", "N_wlo"):
        assert (np.diff(f[name]) < 0).all(), name


def test_the_other_direction_is_the_mirror_image(forces_of):
    x = {"left_push_angle": 0.1, "right_push_angle": -0.15}
    swapped = {"left_push_angle": -0.15, "right_push_angle": 0.1}
    forward, backward = forces_of(output_torque=4.0, **x), forces_of(output_torque=-4.0, **swapped)
    for one, other, sign in (
        ("N_sp", "N_sp", 1),
        ("N_pwr", "N_pwl", 1),
        ("N_wro", "N_wlo", 1),
        ("T_sp", "T_sp", -1),
        ("T_pwr", "T_pwl", -1),
        ("T_wro", "T_wlo", -1),
        ("F_cr", "F_cl", 1),
    ):
        assert forward[one][0] == pytest.approx(sign * backward[other][0], rel=1e-9), one


@pytest.mark.parametrize("closure", CLOSURES)
def test_scaled_drive_and_other_units(forces_of, closure):
    """All lengths times s: forces s^2, torques s^3, speeds 1/s. And the same drive in mm, N, MPa, tonnes."""
    lengths = {
        "sun_radius": 4e-3,
        "planet_radius": 13.5e-3,
        "loading_roller_radius": 5e-3,
        "ring_radius": 40e-3,
        "contact_length": 5e-3,
        "ring_wall_thickness": 8e-3,
        "pin_diameter": 3e-3,
    }
    rest = {"pin_friction_coefficient": 3e-3, "loading_roller_torque": 1e-3, "carrier_torque": 1e-2}
    rest |= {"preload": 900.0, "output_torque": 4.0, "sun_speed": 700.0}
    here = forces_of(closure=closure, **lengths, **rest)
    s = 1.7
    power = {"preload": 2, "sun_speed": -1, "pin_friction_coefficient": 0}
    bigger = {key: value * s ** power.get(key, 3) for key, value in rest.items()}
    there = forces_of(closure=closure, **{key: value * s for key, value in lengths.items()}, **bigger)
    power = {"preload": 0, "sun_speed": 0, "pin_friction_coefficient": 0}
    in_mm = {key: value * 1e3 ** power.get(key, 1) for key, value in rest.items()}
    in_mm |= {"youngs_modulus": 206e3, "density": 7850e-12}
    millimetres = forces_of(closure=closure, **{key: value * 1e3 for key, value in lengths.items()}, **in_mm)
    for name, value in here.items():
        if name in ("balance", "closure"):
            continue
        torque = name in ("T_in", "T_out", "B_l", "B_r")
        assert there[name][0] == pytest.approx(value[0] * s ** (3 if torque else 2), rel=1e-9), name
        assert millimetres[name][0] == pytest.approx(value[0] * (1e3 if torque else 1), rel=1e-9), name


@pytest.mark.parametrize("closure", CLOSURES)
def test_too_much_torque_lifts_the_left_roller_and_nothing_pulls(forces_of, closure):
    torque = np.array([5.0, 20.0, 40.0, 60.0, 200.0])
    f = forces_of(closure=closure, output_torque=torque)
    for name in ("N_sp", "N_pwr", "N_pwl", "N_wro", "N_wlo"):
        assert (f[name] >= 0).all(), name
    if closure == "elastic":  # a constant pin force goes on pressing
        assert f["N_pwl"][0] > 0
        assert (f["N_pwl"][-2:] == 0).all()
        assert (np.abs(f["T_pwl"][-2:]) < 1e-9).all()
    assert f["balance"].max() < 1e-9
    np.testing.assert_allclose(9.0 * f["T_in"], torque, rtol=1e-9)  # the statics do not care


def test_speed_lifts_the_planet_off_the_sun_and_nothing_pulls(forces_of):
    rpm = np.array([0.0, 6e3, 6e4, 3e5, 1e6])
    f = forces_of(sun_speed=rpm * math.pi / 30, output_torque=1.0)
    assert (np.diff(f["N_sp"]) <= 0).all()
    assert f["N_sp"][-1] == 0
    assert (f["N_pwl"] >= 0).all()
    assert f["balance"].max() < 1e-9
    slow = forces_of(sun_speed=rpm[:2] * math.pi / 30, output_torque=1.0)["N_wro"]
    assert slow[1] > slow[0]  # the roller's own weight presses it to the ring


@pytest.mark.parametrize("speed", [0.0, 3612.28125])
def test_far_past_the_lift_off_the_balance_still_closes(forces_of, speed):
    """Every torque from a loaded roller to one lifted since long, at full friction and with losses."""
    torque = np.geomspace(0.05, 2000.0, 200)
    losses = {
        "pin_friction_coefficient": 0.001953125,
        "pin_diameter": 0.003081044938209168,
        "loading_roller_torque": 0.00024330783706319811,
    }
    f = forces_of(preload=300.0, planet_count=2.0, sun_speed=speed, output_torque=torque, **losses)
    lifted = f["N_pwl"] == 0
    assert 20 < lifted.sum() < 180
    assert (np.diff(lifted.astype(int)) >= 0).all()
    assert f["balance"].max() < 1e-9
    assert f["closure"].max() < 1e-9
    for name in ("N_sp", "N_pwr", "N_wro", "N_wlo"):
        assert (f[name] >= 0).all(), name
