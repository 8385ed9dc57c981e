"""Form errors as waves round the tracks: at the contacts, their slopes, their orders."""

import numpy as np
import pytest
from form_errors import balance_of, check_joint, lobes

from asperity.drive.layout.drive import contact_angles
from asperity.drive.layout.form import form_of_waves, lobes_of, orders, waves_at_contacts


@pytest.fixture(scope="module")
def rolling():
    return balance_of(check_joint())


def test_lobes_are_on_their_track_alone(rolling):
    drive = rolling.machine.drive
    found = lobes(rolling, "planet_2", 3)
    assert drive.bodies[found.body].name == "planet_2"
    touched = [
        contact.name for contact, on in zip(drive.contacts, found.first | found.second, strict=True) if on
    ]
    assert touched == ["sp_2", "pwr_2", "pwl_2"]
    assert found.second.sum() == 1  # the sun is the first body of its contact
    with pytest.raises(AssertionError, match="one body"):
        lobes_of(drive, {("sp_1", "first"), ("sp_1", "second")}, 1)


def test_slopes_are_the_derivatives_of_the_waves(rolling):
    """By the polar angle on the body, which falls as the body turns counter-clockwise."""
    drive, wave, small = rolling.machine.drive, lobes(rolling, "ring", 4), 1e-6
    first, second = waves_at_contacts(drive, wave)
    turned = [
        form_of_waves(first * np.exp(-4j * angle), second * np.exp(-4j * angle), 4)
        for angle in (-small, small)
    ]
    form = form_of_waves(first, second, 4)
    slope = (np.asarray(turned[0].second) - np.asarray(turned[1].second)) / (2.0 * small)
    np.testing.assert_allclose(form.second_slope, slope, atol=1e-8)
    assert not np.any(form.first)
    angles = np.asarray(contact_angles(drive)[1])
    np.testing.assert_allclose(
        np.asarray(form.second), np.where(wave.second, np.cos(4.0 * angles), 0.0), atol=1e-12
    )


@pytest.mark.parametrize(
    ("body", "order"),
    # without slip, carrier out: R_o/R_s of the sun, R_o/R_p of a planet, R_o/R_w of a roller, one of the ring
    [("sun", 40 / 4), ("planet_3", 40 / 13.5), ("left_loading_roller_1", 40 / 5), ("ring", 1)],
)
def test_orders_of_a_turn_of_the_output(rolling, body, order):
    speed = rolling.machine.ideal
    assert float(orders(rolling.machine.drive, lobes(rolling, body, 1), speed)) == pytest.approx(order)
    assert float(orders(rolling.machine.drive, lobes(rolling, body, 3), speed)) == pytest.approx(3 * order)
