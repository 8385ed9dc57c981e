"""Transient rolling against two independent solvers, CONTACT, the steady solver and its own energy balance."""

import numpy as np
import pytest

from asperity.bem import (
    ElasticPair,
    FreeHalfSpace,
    elastic_pair,
    normal_contact,
    partial_slip,
    steady_rolling,
    transient_rolling,
)
from asperity.errors import InputError, NoSolutionError

LIKE = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.0)


def carter(q):
    """Creepage over mu a/R; Johnson 1985, section 8.3."""
    return 1.0 - np.sqrt(1.0 - q)


def line_contact(cells=200, margin=2, pair=LIKE):
    """Half-width 1, contact modulus 2, largest traction 1: gross slip begins at creepage 1."""
    pixel = 2.0 / cells
    strip = FreeHalfSpace(pair, shape=(cells + 2 * margin,), pixel_size=(pixel,), reference_distance=10.0)
    edge = np.linspace(-1.0, 1.0, cells + 1)
    integral = 0.5 * (edge * np.sqrt(1.0 - edge**2) + np.arcsin(edge))
    return strip, np.pad(np.diff(integral) / pixel, margin)


def rolled(contact, steps, **given):
    strip, pressure = contact
    arguments = {"friction_coefficient": 1.0, "axis": 0, "layer_compliance": 0.0} | given
    return transient_rolling(strip, pressure, rolled_pixels=steps, **arguments)


def load(contact):
    return contact[1].sum() * float(contact[0].pixel_size[0])


@pytest.fixture(scope="module")
def contact():
    return line_contact()


#: Creepage over Carter's at these rolled distances over the half-width, force constant from the standing contact
# (Cattaneo) on; two independent two-dimensional solvers agree on it to 1 % off the peak. Then height and place of
# the peak, and the integral of what is missing.
DISTANCES = [0.02, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0]
FROM_CATTANEO_TO_CARTER = {
    0.25: ([0.501, 0.537, 0.582, 0.638, 0.711, 0.817, 1.044, 1.030, 0.971, 0.983], 1.38, 1.58, -0.42),
    0.5: ([0.502, 0.546, 0.604, 0.687, 0.837, 1.222, 1.052, 0.970, 0.998, 1.002], 1.25, 1.17, -0.32),
    0.657: ([0.503, 0.555, 0.636, 0.803, 1.157, 1.027, 0.978, 1.000, 1.000, 0.996], 1.18, 0.90, -0.25),
    0.8: ([0.503, 0.574, 1.039, 1.099, 0.998, 0.970, 1.002, 0.997, 0.998, 0.997], 1.12, 0.64, -0.17),
}


@pytest.mark.parametrize("q", FROM_CATTANEO_TO_CARTER)
def test_from_cattaneo_to_carter(contact, q):
    values, peak, place, missing = FROM_CATTANEO_TO_CARTER[q]
    found = rolled(contact, [0] + [1] * 310, tangential_force=[q * load(contact)] * 311)
    ratio = np.asarray(found.creepage)[1:] / carter(q)
    middle = np.asarray(found.rolled_distance)[1:] - 0.005
    np.testing.assert_allclose(np.interp(DISTANCES, middle, ratio), values, rtol=0.015)
    assert ratio.max() == pytest.approx(peak, abs=0.01)
    assert middle[ratio.argmax()] == pytest.approx(place, abs=0.01)
    assert np.sum(ratio[:300] - 1.0) * 0.01 == pytest.approx(missing, abs=0.01)
    assert np.isnan(found.creepage[0])


#: Decks catt_to_cart, cases 2-57 of CONTACT's examples (Vollebregt, Kalker; Apache-2.0): ball of 28 elements across
# the contact, 0.657 of the sliding force, creepage after each element rolled, over 1e-3.
CONTACT_ONSET_OF_ROLLING = [1.824, 1.882, 1.955, 2.050, 2.140, 2.221, 2.334, 2.428, 2.551, 2.676, 2.801, 2.968, 3.184,
                            3.403, 3.402, 3.334, 3.241, 3.192, 3.123, 3.112, 3.088, 3.072, 3.064, 3.062, 3.064, 3.070,
                            3.077, 3.085, 3.093, 3.101, 3.107, 3.111, 3.111, 3.110, 3.107, 3.105, 3.103, 3.101, 3.100,
                            3.099, 3.099, 3.099, 3.099, 3.099, 3.099, 3.100, 3.100, 3.100, 3.101, 3.101, 3.101, 3.101,
                            3.101, 3.101, 3.101, 3.101]  # fmt: skip


@pytest.mark.slow
def test_the_onset_of_rolling_of_a_ball_as_contact_computes_it():
    """Traction along the force alone, CONTACT has both components: 1 % of the creepage."""
    pair = elastic_pair(
        youngs_modulus_1=2.56, youngs_modulus_2=2.56, poisson_ratio_1=0.28, poisson_ratio_2=0.28
    )
    x, y = (np.arange(34) - 16.5) * 0.25e-3, (np.arange(33) - 16) * 0.25e-3
    half_space = FreeHalfSpace(pair, shape=(34, 33), pixel_size=(0.25e-3, 0.25e-3))
    ball = normal_contact(half_space, -2.963 * (x[:, None] ** 2 + y**2), normal_force=0.4705e-6)
    assert np.count_nonzero(ball.pressure) == pytest.approx(621, abs=7)
    found = transient_rolling(
        half_space,
        ball.pressure,
        friction_coefficient=0.4013,
        axis=0,
        rolled_pixels=[0] + [1] * 56,
        layer_compliance=0.0,
        tangential_force=[0.657 * 0.4013 * 0.4705e-6] * 57,
    )
    np.testing.assert_allclose(found.creepage[1:] * 1e3, CONTACT_ONSET_OF_ROLLING, rtol=1.5e-2)


@pytest.mark.slow
def test_a_prescribed_creepage_leads_to_carters_force(contact):
    """Creepage 0.4 of gross slip: q = 0.64, as in CONTACT's deck carter2d.

    The bodies between contact and reference distance are a spring in series: the force needs some 30 half-widths.
    """
    found = rolled(contact, [1] * 3000, displacement=0.4 * 0.01 * np.arange(1, 3001))
    np.testing.assert_allclose(found.creepage, 0.4, rtol=1e-9)
    assert float(found.shear.tangential_force[-1]) / load(contact) == pytest.approx(0.64, rel=3e-3)
    assert float(found.shear.stick_fraction[-1]) == pytest.approx(0.6, abs=0.011)


@pytest.mark.slow
@pytest.mark.parametrize("with_pressure", [False, True])
def test_a_layer_and_unlike_bodies_end_in_the_state_of_the_steady_solver(with_pressure):
    pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.1)
    contact = line_contact(100, pair=pair)
    pressure = np.where(contact[1] > 0.0, contact[1], 1.0)
    layer = 0.3 * (0.25 * np.pi / pressure if with_pressure else 1.0)
    force = 0.4 * load(contact)
    found = rolled(
        contact, [1] * 400, tangential_force=[force] * 400, friction_coefficient=0.5, layer_compliance=layer
    )
    steady = steady_rolling(
        *contact,
        friction_coefficient=0.5,
        layer_compliance=layer,
        longitudinal_force=force,
        lateral_creepage=0.0,
    )
    assert float(found.creepage[-1]) == pytest.approx(float(steady.creepage[0]), rel=1e-5)
    np.testing.assert_allclose(found.shear.traction[-1], steady.traction[0], atol=1e-4)


@pytest.mark.slow
def test_across_the_rolling_direction_the_strip_is_in_anti_plane_shear(contact):
    found = rolled(contact, [1] * 400, axis=1, tangential_force=[0.5 * load(contact)] * 400)
    assert float(found.creepage[-1]) == pytest.approx(carter(0.5) / 0.7, rel=3e-3)


@pytest.mark.slow
def test_rolling_back_is_the_mirror_image(contact):
    forth = rolled(contact, [0, 1, 2, 2], tangential_force=[0.5 * load(contact)] * 4)
    back = rolled(contact, [0, -1, -2, -2], tangential_force=[0.5 * load(contact)] * 4)
    np.testing.assert_allclose(back.shear.traction, forth.shear.traction[:, ::-1], atol=1e-6)
    np.testing.assert_allclose(back.rolled_distance, [0.0, -0.01, -0.03, -0.05], rtol=1e-12)


@pytest.mark.slow
def test_a_contact_that_stands_slips_as_in_partial_slip(contact):
    forces = load(contact) * np.array([0.3, 0.8, -0.2])
    found = rolled(contact, [0, 0, 0], tangential_force=forces)
    same = partial_slip(*contact, friction_coefficient=1.0, axis=0, tangential_force=forces)
    np.testing.assert_allclose(found.shear.displacement, same.displacement, rtol=1e-7)
    np.testing.assert_allclose(found.shear.friction_work, same.friction_work, rtol=1e-6)


@pytest.mark.slow
def test_steady_rolling_dissipates_force_times_creepage():
    """Slip is taken at the end of each step: an error of first order in the pixel."""
    missing = []
    for cells in (100, 200):
        contact = line_contact(cells)
        force, pixel = 0.6 * load(contact), 2.0 / cells
        found = rolled(contact, [1] * 2 * cells, tangential_force=[force] * 2 * cells)
        work = np.diff(np.asarray(found.shear.friction_work))
        assert np.all(work > 0.0)
        missing.append(1.0 - work[-1] / pixel / (force * float(found.creepage[-1])))
    assert 0.0 < missing[1] < 0.015
    assert missing[0] / missing[1] == pytest.approx(2.0, rel=0.05)


@pytest.mark.slow
def test_a_short_stroke_back_and_forth_comes_to_rest_and_a_long_one_creeps():
    """Shakedown: what lies between the two turning points never leaves the contact."""
    contact = line_contact(100)
    for stroke, creeps in ((30, False), (60, True)):
        steps = np.r_[0, np.tile(np.r_[np.ones(stroke, int), -np.ones(stroke, int)], 10)]
        found = rolled(contact, steps, tangential_force=[0.5 * load(contact)] * steps.size)
        shift = np.asarray(found.shear.displacement)
        drift = (shift[-1] - shift[-1 - 2 * stroke]) / (2 * stroke * 0.02 * carter(0.5))
        assert (drift > 0.1) == creeps
        assert creeps or abs(drift) < 1e-3


@pytest.mark.parametrize(
    ("steps", "change", "named"),
    [
        ([3], {}, "reaches 3 in one step: the grid extends 2 pixels"),
        ([0.5], {}, "one whole number of pixels"),
        ([1, 1], {}, "one whole number of pixels"),
        ([1], {"layer_compliance": -1.0}, "layer_compliance has values below zero"),
        ([1], {"tangential_force": [2.0]}, "the bodies slide at 1.57.* N/m"),
        ([1], {"tangential_force": None}, "either tangential_force or displacement"),
    ],
)
def test_bad_input_is_named(contact, steps, change, named):
    with pytest.raises(InputError, match=named):
        rolled(contact, steps, **({"tangential_force": [0.5]} | change))


def test_unlike_bodies_roll_on_a_strip_only():
    pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.1)
    half_space = FreeHalfSpace(pair, shape=(5, 5), pixel_size=(1.0, 1.0))
    pressure = np.pad(np.ones((3, 3)), 1)
    with pytest.raises(InputError, match="on a strip only"):
        rolled((half_space, pressure), [1], tangential_force=[1.0])


@pytest.mark.slow
def test_an_unconverged_step_is_an_error(contact):
    with pytest.raises(NoSolutionError, match=r"rolling: not converged after 2 iterations"):
        rolled(contact, [1], tangential_force=[0.5], max_iterations=2)
