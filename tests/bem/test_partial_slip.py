"""Partial slip against Cattaneo and Mindlin, CONTACT, a joint's asperity, and its own energy balance."""

import numpy as np
import pytest

from asperity.bem import FreeHalfSpace, elastic_pair, normal_contact, partial_slip
from asperity.errors import InputError, NoSolutionError

#: Case 'cattaneo' of CONTACT's examples (Vollebregt, Kalker; Apache-2.0): G [Pa], nu, R [m], Fn [N], mu,
# pixel [m].
SHEAR_MODULUS, NU, RADIUS, FORCE, MU, PIXEL = 200e6, 0.42, 50e-3, 9.1954, 0.4, 0.13333e-3


@pytest.fixture(scope="module")
def ball():
    young = 2.0 * SHEAR_MODULUS * (1.0 + NU)
    pair = elastic_pair(
        youngs_modulus_1=young, youngs_modulus_2=young, poisson_ratio_1=NU, poisson_ratio_2=NU
    )
    x = (np.arange(19) - 9) * PIXEL
    half_space = FreeHalfSpace(pair, shape=(19, 19), pixel_size=(PIXEL, PIXEL))
    return normal_contact(half_space, -(x[:, None] ** 2 + x**2) / (2.0 * RADIUS), normal_force=FORCE)


def cattaneo_mindlin(force, pair, contact_radius, sliding_force):
    """Displacement (3 Q/16 G* a)[1 - (1 - T/Q)^(2/3)] of a monotonic load; Johnson 1985, (7.42)."""
    scale = 3.0 * sliding_force / (16.0 * pair.tangential_contact_modulus * contact_radius)
    return float(scale) * (1.0 - (1.0 - force / sliding_force) ** (2.0 / 3.0))


def test_cattaneos_shift_as_contact_computes_it(ball):
    """T = 7/8 mu F: CONTACT prints 45 of 177 elements in adhesion, shift 8.155e-3 mm, friction work 2.750e-6
    J.

    It solves the slip across the shear too, which is disregarded here: 0.3 % of the shift, 1 % of the work.
    """
    found = partial_slip(
        ball.half_space, ball.pressure, friction_coefficient=MU, axis=0, tangential_force=[0.875 * MU * FORCE]
    )
    assert round(float(found.stick_fraction[0]) * 177) == 45
    assert float(found.displacement[0]) * 1e3 == pytest.approx(8.155e-3, rel=3e-3)
    assert float(found.friction_work[0]) == pytest.approx(2.750e-6, rel=1e-2)
    assert float(found.load_balance_error[0]) < 1e-12


def test_the_shear_traction_of_cattaneo_and_mindlin(ball):
    """mu p minus a similar distribution over the stick circle c = a/2; Johnson 1985, (7.40)."""
    found = partial_slip(
        ball.half_space, ball.pressure, friction_coefficient=MU, axis=1, tangential_force=[0.875 * MU * FORCE]
    )
    x = (np.arange(19) - 9) * PIXEL
    r2 = (x[:, None] ** 2 + x**2) / 1e-6
    peak = MU * 1.5 * FORCE / (np.pi * 1e-6)
    closed = peak * (np.sqrt(np.maximum(1.0 - r2, 0.0)) - 0.5 * np.sqrt(np.maximum(1.0 - r2 / 0.25, 0.0)))
    away = (np.abs(np.sqrt(r2) - 0.5) > 0.15) & (np.abs(np.sqrt(r2) - 1.0) > 0.15)
    assert np.abs(np.asarray(found.traction[0]) - closed)[away].max() < 0.015 * peak


@pytest.mark.slow
def test_loading_reversal_and_loop_follow_masing_and_dissipate_what_they_enclose(ball):
    """Mindlin & Deresiewicz 1953: displacement at reversal, Masing branch, loop area from two independent sums."""
    limit, pair = MU * FORCE, ball.half_space.pair
    top = 0.9 * limit
    path = np.concatenate([[top], np.linspace(top, -top, 13)[1:], np.linspace(-top, top, 13)[1:]])
    found = partial_slip(
        ball.half_space, ball.pressure, friction_coefficient=MU, axis=0, tangential_force=path
    )
    force, shift = np.asarray(found.tangential_force), np.asarray(found.displacement)
    np.testing.assert_allclose(force, path, atol=1e-9 * limit)
    peak = cattaneo_mindlin(top, pair, 1e-3, limit)
    assert shift[0] == pytest.approx(peak, rel=2e-3)
    assert shift[12] == pytest.approx(-peak, rel=2e-3)
    assert shift[24] == pytest.approx(shift[0], rel=1e-9)
    middle = peak - 2.0 * cattaneo_mindlin(0.5 * (top - path[6]), pair, 1e-3, limit)
    assert shift[6] == pytest.approx(middle, abs=2e-3 * peak)
    enclosed = np.trapezoid(force, shift)
    dissipated = float(found.friction_work[24] - found.friction_work[0])
    assert dissipated == pytest.approx(enclosed, rel=1e-2)
    fine = np.linspace(-top, top, 4001)
    unloading = np.array([peak - 2.0 * cattaneo_mindlin(0.5 * (top - f), pair, 1e-3, limit) for f in fine])
    closed = np.trapezoid(unloading + unloading[::-1], fine)
    assert enclosed == pytest.approx(closed, rel=1e-2)


#: Porter & Brake 2023 (tmdsimpy, MIT), mif_tangential_asperity.yaml, constant normal displacement: one
# sphere pair with  E 192.85 GPa, nu 0.29, R 4.174432306 mm, mu 0.2, 286.7999 N; shift [m] and force [N] of
# its first branch. The  table sums 100 rings, which costs it about 1 % (Cattaneo-Mindlin at the first point:
# 6.657 N).
MEASURED_ASPERITY = [
    (1.901408450704e-07, 6.595246930397),
    (9.507042253521e-07, 30.28432486580),
    (1.901408450704e-06, 51.74077611852),
]


def test_tangential_asperity_of_a_measured_joint():
    pair = elastic_pair(
        youngs_modulus_1=192.85e9, youngs_modulus_2=192.85e9, poisson_ratio_1=0.29, poisson_ratio_2=0.29
    )
    radius, force = 4.174432305996625e-3, 286.7999270429
    contact_radius = (3.0 * force * radius / (4.0 * pair.contact_modulus)) ** (1 / 3)
    spacing = contact_radius / 16
    x = (np.arange(41) - 20) * spacing
    half_space = FreeHalfSpace(pair, shape=(41, 41), pixel_size=(spacing, spacing))
    contact = normal_contact(half_space, -(x[:, None] ** 2 + x**2) / (2.0 * radius), normal_force=force)
    assert float(contact.approach) == pytest.approx(1e-5, rel=1e-3)  # the table's normal displacement
    shifts, forces = np.array(MEASURED_ASPERITY).T
    found = partial_slip(half_space, contact.pressure, friction_coefficient=0.2, axis=0, displacement=shifts)
    np.testing.assert_allclose(found.tangential_force, forces, rtol=1.5e-2)


def test_pushed_far_the_bodies_slide_at_the_friction_force_and_return_elastically(ball):
    found = partial_slip(
        ball.half_space, ball.pressure, friction_coefficient=MU, axis=0, displacement=[2e-5, 4e-5, 3.99e-5]
    )
    limit = MU * FORCE
    np.testing.assert_allclose(found.tangential_force[:2], limit, rtol=1e-12)
    assert float(found.stick_fraction[1]) == 0.0
    assert float(found.friction_work[1] - found.friction_work[0]) == pytest.approx(limit * 2e-5, rel=1e-9)
    assert found.tangential_force[2] < 0.999 * limit


@pytest.mark.slow
def test_a_line_contact_slips_from_its_edges():
    """Cattaneo for cylinders: stick half-width b sqrt(1 - T/(mu N)); Johnson 1985, (7.25)."""
    young = 206e9
    pair = elastic_pair(
        youngs_modulus_1=young, youngs_modulus_2=young, poisson_ratio_1=0.3, poisson_ratio_2=0.3
    )
    load, radius = 2e5, 6e-3
    b = np.sqrt(4.0 * load * radius / (np.pi * pair.contact_modulus))
    x = (np.arange(129) - 64) * b / 60
    strip = FreeHalfSpace(pair, shape=(129,), pixel_size=(b / 60,), reference_distance=1.0)
    contact = normal_contact(strip, -(x**2) / (2.0 * radius), normal_force=load)
    found = partial_slip(
        strip, contact.pressure, friction_coefficient=0.12, axis=0, tangential_force=[0.75 * 0.12 * load]
    )
    assert float(found.stick_fraction[0]) == pytest.approx(0.5, abs=1.0 / 60)


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"tangential_force": [1.0, 4.0]}, "reaches 4 N: the bodies slide at 3.678.* N"),
        ({"tangential_force": None}, "either tangential_force or displacement"),
        ({"displacement": [0.0]}, "either tangential_force or displacement"),
        ({"friction_coefficient": -0.1}, "friction_coefficient = -0.1"),
        ({"axis": 3}, "axis = 3"),
        ({"tangential_force": [[1.0]]}, "list of finite numbers"),
    ],
)
def test_bad_input_is_named(ball, change, named):
    arguments = {"friction_coefficient": MU, "axis": 0, "tangential_force": [1.0]} | change
    with pytest.raises(InputError, match=named):
        partial_slip(ball.half_space, ball.pressure, **arguments)


def test_pressure_that_pulls_is_refused(ball):
    with pytest.raises(InputError, match="must not be negative"):
        partial_slip(
            ball.half_space, ball.pressure - 1.0, friction_coefficient=MU, axis=0, tangential_force=[1.0]
        )


def test_an_unconverged_step_is_an_error(ball):
    with pytest.raises(NoSolutionError, match="not converged after 2 iterations"):
        partial_slip(
            ball.half_space,
            ball.pressure,
            friction_coefficient=MU,
            axis=0,
            tangential_force=[2.0],
            max_iterations=2,
        )
