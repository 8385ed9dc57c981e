"""The force balance against its equations written out anew, an independent solver, and global balances.

How the forces move with torque, speed and size: ``test_force_balance_trends.py``.
"""

import importlib.util
import math
from pathlib import Path

import jax
import numpy as np
import pytest

from asperity.drive.bearings import Bearings
from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.zou2025.force_balance import balance_equations

SIZE = 256
CLOSURES = ("elastic", "constant_pin_force")


def random_drives(seed):
    """Drives around the paper's with everything different: sizes, planets, angles, losses, speed, load."""
    rng = np.random.default_rng(seed)

    def between(low, high):
        return rng.uniform(low, high, SIZE)

    return {
        "sun_radius": between(3.8e-3, 4.4e-3),
        "planet_radius": between(13.4e-3, 13.8e-3),
        "loading_roller_radius": between(5.0e-3, 5.3e-3),
        "planet_count": rng.integers(2, 5, SIZE).astype(float),
        "left_push_angle": between(-0.2, 0.2),
        "right_push_angle": between(-0.2, 0.2),
        "ring_wall_thickness": between(4e-3, 12e-3),
        "sun_torque": between(0, 5e-3),
        "loading_roller_torque": between(0, 5e-3),
        "carrier_torque": between(0, 5e-2),
        "pin_friction_coefficient": between(0, 5e-3),
        "pin_diameter": between(2e-3, 6e-3),
        "contact_length": between(4e-3, 12e-3),
        "preload": between(1000, 2000),
        "output_torque": between(0.1, 2.5),
        "sun_speed": between(0, 1500),
    }


def by_cosines(x, ring=40e-3):
    """Sides and angles of the triangle of centres by the law of cosines, each at its own corner."""
    OP, PW = x["sun_radius"] + x["planet_radius"], x["planet_radius"] + x["loading_roller_radius"]
    OW = ring - x["loading_roller_radius"]
    theta = np.pi - np.arccos((OP**2 + PW**2 - OW**2) / (2 * OP * PW))
    beta = np.arccos((PW**2 + OW**2 - OP**2) / (2 * PW * OW))
    return OP, OW, theta, beta


def inertia(x):
    OP, OW, _, _ = by_cosines(x)
    speed = x["sun_speed"] * x["sun_radius"] / (40e-3 - x["sun_radius"])
    mass = {
        k: 7850 * np.pi * x[k] ** 2 * x["contact_length"] for k in ("planet_radius", "loading_roller_radius")
    }
    return mass["planet_radius"] * speed**2 * OP, mass["loading_roller_radius"] * speed**2 * OW


MIRRORED = {
    "pwr": "pwl",
    "pwl": "pwr",
    "wro": "wlo",
    "wlo": "wro",
    "cl": "cr",
    "cr": "cl",
    "l": "r",
    "r": "l",
}


def test_torque_and_rotation_reversed_are_the_mirror_image(forces_of):
    """A drive seen from behind: left is right, and torques, tangential forces and friction change their sign."""
    x = random_drives(5)
    one = forces_of(closure="elastic", **x)
    swapped = {"left_push_angle": x["right_push_angle"], "right_push_angle": x["left_push_angle"]}
    turned = {name: -x[name] for name in ("output_torque", "sun_speed")}
    other = forces_of(closure="elastic", **(x | swapped | turned))
    for name, value in one.items():
        kind, _, place = name.partition("_")
        if kind in ("N", "T", "F", "B"):
            sign = -1.0 if kind in ("T", "B") else 1.0
            seen = other[f"{kind}_{MIRRORED.get(place, place)}"]
            np.testing.assert_allclose(seen, sign * value, rtol=1e-9, atol=1e-9, err_msg=name)


@pytest.mark.parametrize("braking", [False, True])
@pytest.mark.parametrize("closure", CLOSURES)
def test_the_eleven_equations_written_anew(forces_of, closure, braking):
    """(1)-(5) as free bodies: every contact force as a vector acting at its point, with Newton's third law."""
    x = random_drives(3)
    if braking:  # a torque against the rotation; the bearings' friction keeps its sign
        x["output_torque"] = -x["output_torque"]
    f = forces_of(closure=closure, **x)
    _, OW, theta, beta = by_cosines(x)
    C_p, C_w = inertia(x)
    zero, one = np.zeros(SIZE), np.ones(SIZE)

    def vector(
        angle,
    ):  # unit vector at an angle from the radial line y towards x, the planet's direction of drive
        return np.stack([np.sin(angle) * one, np.cos(angle) * one])

    along_x, up = np.stack([one, zero]), np.stack([zero, one])
    to_r, to_l = vector(theta), vector(-theta)  # from the planet's centre to the rollers
    side_r, side_l = np.stack([to_r[1], -to_r[0]]), np.stack([to_l[1], -to_l[0]])  # turned clockwise
    # planet: the sun pushes it outwards and along x; rollers push it inwards and brake its surface
    planet = (
        f["N_sp"] * up
        + f["T_sp"] * along_x
        - f["N_pwr"] * to_r
        - f["N_pwl"] * to_l
        + f["T_pwr"] * side_r
        + f["T_pwl"] * side_l
        + C_p * up
    )
    out_r, out_l = vector(theta - beta), vector(beta - theta)  # from the axis through the rollers' centres
    round_r, round_l = np.stack([out_r[1], -out_r[0]]), np.stack([out_l[1], -out_l[0]])
    pin_r = -np.cos(x["right_push_angle"]) * round_r + np.sin(x["right_push_angle"]) * out_r
    pin_l = np.cos(x["left_push_angle"]) * round_l + np.sin(x["left_push_angle"]) * out_l
    right = (
        f["N_pwr"] * to_r
        - f["T_pwr"] * side_r
        - f["N_wro"] * out_r
        - f["T_wro"] * round_r
        + f["F_cr"] * pin_r
        + C_w * out_r
    )
    left = (
        f["N_pwl"] * to_l
        - f["T_pwl"] * side_l
        - f["N_wlo"] * out_l
        - f["T_wlo"] * round_l
        + f["F_cl"] * pin_l
        + C_w * out_l
    )
    R_w, n = x["loading_roller_radius"], x["planet_count"]
    # the pins of a branch push its two rollers towards each other; the ring brakes both
    push = f["F_cl"] * np.cos(x["left_push_angle"]) - f["F_cr"] * np.cos(x["right_push_angle"])
    residuals = [
        (f["T_in"] - 2 * x["sun_torque"]) / x["sun_radius"] - n * f["T_sp"],
        *planet,
        f["T_sp"] - f["T_pwr"] - f["T_pwl"],
        *right,
        *left,
        f["T_wlo"] - f["T_pwl"] + 2 * f["B_l"] / R_w,
        f["T_wro"] - f["T_pwr"] + 2 * f["B_r"] / R_w,
        n * push - (2 * x["carrier_torque"] + x["output_torque"]) / OW,
    ]
    assert len(residuals) == 11
    for index, residual in enumerate(residuals):
        assert np.abs(residual / f["N_sp"]).max() < 1e-12, index
    assert f["balance"].max() < 1e-12
    assert f["closure"].max() < 1e-9
    np.testing.assert_allclose(f["T_out"], x["output_torque"])
    # Coulomb friction of a pin, mu F at the radius d/2, on two bearings
    for side in ("l", "r"):
        friction = x["pin_friction_coefficient"] * np.abs(f[f"F_c{side}"]) * x["pin_diameter"] / 4
        np.testing.assert_allclose(f[f"B_{side}"], x["loading_roller_torque"] + friction, rtol=1e-12)


@pytest.mark.parametrize("closure", CLOSURES)
def test_global_balances_and_the_closures_themselves(forces_of, closure):
    x = random_drives(4)
    f = forces_of(closure=closure, **x)
    _, _, theta, beta = by_cosines(x)
    n = x["planet_count"]
    # the whole drive about its axis: the ring takes what goes in and out; bearings of (1), (3)-(5) enter as printed
    bearings = 2 * x["sun_torque"] - 2 * x["carrier_torque"] + 2 * n * (f["B_l"] + f["B_r"])
    ring = n * 40e-3 * (f["T_wro"] + f["T_wlo"])
    np.testing.assert_allclose(f["T_in"] + f["T_out"], ring + bearings, rtol=1e-11)
    np.testing.assert_allclose((f["N_pwr"] - f["N_pwl"]) * np.tan(theta / 2), f["T_sp"], rtol=1e-10)
    np.testing.assert_allclose(f["T_pwr"] * f["N_pwl"], f["T_pwl"] * f["N_pwr"], rtol=1e-12)  # equal creep
    rest = {"pw": x["preload"] / (2 * np.cos(theta))}
    pins = {side: rest["pw"] * np.sin(beta) / np.cos(x[f"{side}_push_angle"]) for side in ("left", "right")}
    if closure == "constant_pin_force":
        np.testing.assert_allclose(f["F_cr"], pins["right"], rtol=1e-10)
        return
    # elastic: five compressions must come from four displacements
    rest |= {
        "wro": pins["right"] * np.sin(x["right_push_angle"]) + rest["pw"] * np.cos(beta),
        "wlo": pins["left"] * np.sin(x["left_push_angle"]) + rest["pw"] * np.cos(beta),
        "sp": x["preload"],
    }
    rest |= {"pwr": rest["pw"], "pwl": rest["pw"]}
    approach = {c: compression(c, f[f"N_{c}"], x) - compression(c, rest[c], x) for c in COMPRESSED}
    for i in range(0, SIZE, 16):
        sin, cos = np.sin(theta[i]), np.cos(theta[i])
        # a roller moves across the push of its pin: by 1 outward and by the tangent of the push angle away
        right, left = (
            np.cos(beta[i]) + np.sin(beta[i]) * np.tan(x[f"{side}_push_angle"][i])
            for side in ("right", "left")
        )
        follows = np.array(  # of planet x, planet y, right roller out, left roller out
            [[0, -1, 0, 0], [sin, cos, -right, 0], [-sin, cos, 0, -left], [0, 0, 1, 0], [0, 0, 0, 1]]
        )
        five = np.array([approach[c][i] for c in COMPRESSED])
        moved, *_ = np.linalg.lstsq(follows, five, rcond=None)
        np.testing.assert_allclose(follows @ moved, five, atol=1e-9 * np.abs(five).max())


COMPRESSED = ("sp", "pwr", "pwl", "wro", "wlo")


def compression(contact, N, x):
    """Johnson 1985, 5.6 for rollers and Weber and Banaschek 1953 for the ring's wall, line contact of like steel."""
    E, nu, B = 206e9, 0.3, x["contact_length"]
    R1, R2 = {
        "sp": (x["sun_radius"], x["planet_radius"]),
        "pw": (x["planet_radius"], x["loading_roller_radius"]),
        "wo": (x["loading_roller_radius"], 40e-3),
    }[contact[0] + contact[-1] if contact[0] == "w" else contact[:2]]
    inner = contact[0] == "w"
    R = R1 * R2 / (R2 - R1 if inner else R1 + R2)
    b = np.sqrt(4 * N * R * 2 * (1 - nu**2) / (np.pi * B * E))
    unit = N / B * (1 - nu**2) / (np.pi * E)
    if not inner:
        return unit * (2 * np.log(4 * R1 / b) - 1 + 2 * np.log(4 * R2 / b) - 1)
    wall = 2 * np.log(2 * x["ring_wall_thickness"] / b) - nu / (1 - nu)
    return unit * (2 * np.log(4 * R1 / b) - 1 + wall)


def load_baseline():
    path = Path(__file__).parents[2] / "benchmarks" / "baseline_scipy.py"
    if not path.exists():
        pytest.skip("benchmarks/ is not shipped with this copy")
    spec = importlib.util.spec_from_file_location("baseline_scipy", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("closure", CLOSURES)
def test_agreement_with_an_independent_solver(forces_of, closure):
    """The SciPy baseline solves for 13 forces and 4 displacements at once and shares no code."""
    baseline = load_baseline()
    x = {key: value[:8] for key, value in random_drives(5).items()}
    f = forces_of(closure=closure, **x)
    names = {
        "planet_count": "planets",
        "left_push_angle": "push_angle_left",
        "right_push_angle": "push_angle_right",
        "ring_wall_thickness": "ring_wall",
        "sun_torque": "bearing_torque_sun",
        "loading_roller_torque": "bearing_torque_loading_roller",
        "carrier_torque": "bearing_torque_carrier",
        "pin_friction_coefficient": "bearing_friction",
        "pin_diameter": "bearing_diameter",
    }
    for i in range(8):
        case = {names.get(key, key): value[i] for key, value in x.items()}
        other = baseline.force_balance(
            {**baseline.PAPER, **case, "closure": closure, "normal_law": "nonlinear"}
        )
        for c in COMPRESSED:
            assert f[f"N_{c}"][i] == pytest.approx(other["normal"][c], rel=1e-9)
            assert f[f"T_{c}"][i] == pytest.approx(other["tangential"][c], rel=1e-9, abs=1e-9)
        assert f["F_cl"][i] == pytest.approx(other["pin"]["left"], rel=1e-8)
        assert f["F_cr"][i] == pytest.approx(other["pin"]["right"], rel=1e-8)
        assert f["T_in"][i] == pytest.approx(other["input_torque"], rel=1e-9)


def test_guide_values_of_the_papers_joint(forces_of):
    """Values computed elsewhere for 5 N·m with linear springs, good to 1 %; T_sp follows from statics alone."""
    f = forces_of(output_torque=5.0)
    guide = {
        "N_sp": 1000,
        "N_pwr": 657,
        "N_pwl": 465,
        "N_wro": 646,
        "N_wlo": 449,
        "T_pwr": 27.1,
        "T_pwl": 19.2,
    }
    for name, value in guide.items():
        assert f[name][0] == pytest.approx(value, rel=0.01), name
    assert f["T_sp"][0] == pytest.approx(5.0 / 9.0 / (3 * 4e-3), rel=1e-10)  # T_in = T_out/9
    assert f["T_sp"][0] == pytest.approx(46.30, abs=0.005)
    assert f["T_in"][0] == pytest.approx(5.0 / 9.0, rel=1e-10)


@pytest.mark.parametrize("closure", CLOSURES)
def test_no_losses_nine_to_one_and_rest_at_no_torque(forces_of, closure):
    torque = np.array([0.0, 1.0, 5.0])
    f = forces_of(closure=closure, output_torque=torque, sun_speed=0.0)
    np.testing.assert_allclose(9.0 * f["T_in"], torque, rtol=1e-11, atol=1e-13)
    side = 1000.0 / (2 * math.cos(math.radians(27.0831)))  # (2) y by hand
    rest = {"N_sp": 1000.0, "N_pwr": side, "N_pwl": side}
    for name, value in rest.items():
        assert f[name][0] == pytest.approx(value, rel=1e-6)


@pytest.mark.long
def test_gradients_of_all_forces_are_those_of_the_equations(solved_forces):
    """Derivatives along a random direction in all continuous inputs, against central differences."""
    x = random_drives(8)
    rng = np.random.default_rng(9)
    direction = {
        key: (key != "planet_count") * rng.uniform(-1, 1, SIZE) * np.abs(value) for key, value in x.items()
    }

    def normal(step):
        return solved_forces({key: x[key] + step * direction[key] for key in x}, "elastic").normal

    value, slope = jax.jvp(normal, (0.0,), (1.0,))
    h = 1e-5
    difference = np.asarray(normal(h) - normal(-h)) / (2 * h)
    np.testing.assert_allclose(slope, difference, rtol=1e-6, atol=1e-6 * float(np.max(value)))


GEOMETRY = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
NAMES = ("1", "2x", "2y", "2M", "3t", "3r", "3M", "4t", "4r", "4M", "5")


def balanced():
    """A loss-free state with T_sp = 40 N and S = 1100 N, worked out line by line from (1)–(5)."""
    sides = triangle(GEOMETRY)
    theta, beta = (
        math.atan2(*map(float, pair))
        for pair in ((sides.sin_direction, sides.cos_direction), (sides.sin_wedge, sides.cos_wedge))
    )
    t_sp, load = 40.0, 1100.0
    difference = t_sp / math.tan(theta / 2.0)
    n_pwr, n_pwl = (load + difference) / 2.0, (load - difference) / 2.0
    t_pwr, t_pwl = t_sp * n_pwr / load, t_sp * n_pwl / load
    left = n_pwl * math.sin(beta) + t_pwl * math.cos(beta) + t_pwl
    right = n_pwr * math.sin(beta) - t_pwr * math.cos(beta) - t_pwr
    return {
        "normal": [
            (t_pwr - t_pwl) * math.sin(theta) + load * math.cos(theta),
            n_pwr,
            n_pwl,
            n_pwr * math.cos(beta) + t_pwr * math.sin(beta),
            n_pwl * math.cos(beta) - t_pwl * math.sin(beta),
        ],
        "tangential": [t_sp, t_pwr, t_pwl, t_pwr, t_pwl],
        "pin_left": left,
        "pin_right": right,
        "left_bearing_torque": 0.0,
        "right_bearing_torque": 0.0,
        "input_torque": 3.0 * t_sp * 4e-3,
        "output_torque": 3.0 * (left - right) * 35e-3,
        "planet_centrifugal": 0.0,
        "roller_centrifugal": 0.0,
    }


def residuals(state):
    values = balance_equations(
        geometry=GEOMETRY, sides=triangle(GEOMETRY), bearings=Bearings(0.0, 0.0, 0.0, 0.0, 0.0), **state
    )
    return dict(zip(NAMES, np.asarray(values, dtype=float), strict=True))


def test_a_state_balanced_by_hand_has_no_residual():
    assert max(abs(value) for value in residuals(balanced()).values()) < 1e-9
    # loss-free: T_out = 9 T_in for R_o = 10 R_s
    state = balanced()
    assert state["output_torque"] == pytest.approx(9.0 * state["input_torque"], rel=1e-9)


@pytest.mark.parametrize(
    ("key", "index", "touched"),
    [
        ("normal", 0, {"2y"}),
        ("normal", 1, {"2x", "2y", "4t", "4r"}),
        ("normal", 2, {"2x", "2y", "3t", "3r"}),
        ("normal", 3, {"4r"}),
        ("normal", 4, {"3r"}),
        ("tangential", 0, {"1", "2x", "2M"}),
        ("tangential", 1, {"2x", "2y", "2M", "4t", "4r", "4M"}),
        ("tangential", 3, {"4t", "4M"}),
        ("pin_left", None, {"3t", "5"}),
        ("pin_right", None, {"4t", "5"}),
        ("output_torque", None, {"5"}),
        ("input_torque", None, {"1"}),
    ],
)
def test_each_force_appears_where_the_paper_has_it(key, index, touched):
    state = balanced()
    if index is None:
        state[key] += 1.0
    else:
        state[key][index] += 1.0
    assert {name for name, value in residuals(state).items() if abs(value) > 1e-6} == touched
