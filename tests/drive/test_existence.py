"""Each rule against numbers by hand, for NumPy and for JAX arrays alike."""

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.existence import overlaps, pin_lock, smaller_body, some_contact_slips, too_wide
from asperity.drive.geometry import DriveGeometry
from asperity.drive.mechanism import Bearings


@pytest.fixture(params=[np.asarray, jnp.asarray], ids=["numpy", "jax"])
def array(request):
    return request.param


def geometry(array, **changes):
    """The paper's radii in metres."""
    numbers = {
        "sun_radius": 4e-3,
        "planet_radius": 13.5e-3,
        "loading_roller_radius": 5e-3,
        "ring_radius": 40e-3,
        "planet_count": 3.0,
        "left_push_angle": 0.0,
        "right_push_angle": 0.0,
    }
    return DriveGeometry(**{name: array(value) for name, value in (numbers | changes).items()})


def bearings(array, *, friction, diameter):
    return Bearings(*(array(value) for value in (0.0, 0.0, 0.0, friction, diameter)))


def test_touching_bodies_and_open_triangles_overlap(array):
    found = overlaps(gap=array([1e-9, 0.0, -1e-9, np.nan]))
    assert isinstance(found, type(array([True])))
    assert found.tolist() == [False, True, True, True]


def test_a_pin_fits_into_its_roller(array):
    found = pin_lock(
        geometry=geometry(array), bearings=bearings(array, friction=0.0, diameter=[9.99e-3, 10e-3])
    )
    assert found.too_thick.tolist() == [False, True]
    assert not found.locks.any()


def test_a_pin_locks_where_friction_times_diameter_over_radius_reaches_the_cosine(array):
    """mu_b 8 mm / 10 mm against cos 60 deg = 0.5, on whichever side the steeper push is: locks from mu_b = 0.625."""
    for name in ("left_push_angle", "right_push_angle"):
        found = pin_lock(
            geometry=geometry(array, **{name: -np.pi / 3.0}),
            bearings=bearings(array, friction=[0.624, 0.626], diameter=8e-3),
        )
        np.testing.assert_allclose(found.grip, [0.4992, 0.5008], rtol=1e-12)
        np.testing.assert_allclose(found.push, 0.5, rtol=1e-12)
        assert found.locks.tolist() == [False, True]


def test_the_smaller_body_of_each_contact(array):
    """Sun 4 | planet 13.5 | roller 5 | wall 10 mm; then a roller of 20 mm, which the planet and the wall undercut."""
    found = smaller_body(
        geometry=geometry(array, loading_roller_radius=[5e-3, 20e-3]), ring_wall_thickness=array(10e-3)
    )
    np.testing.assert_array_equal(
        found, np.transpose([[4e-3, 5e-3, 5e-3, 5e-3, 5e-3], [4e-3, 13.5e-3, 13.5e-3, 10e-3, 10e-3]])
    )


def test_a_strip_is_too_wide_from_the_body_on_or_where_the_bulk_has_no_stiffness(array):
    found = too_wide(
        half_width=array([3.9e-3, 4e-3, 1e-3, 1e-3, 0.0]),
        smaller_body=array([4e-3] * 5),
        bulk_normal_stiffness=array([1e8, 1e8, -1.0, np.nan, 0.0]),  # the last one has lifted off
    )
    assert found.tolist() == [False, True, True, True, False]


def test_one_slipping_contact_is_enough(array):
    ratios = np.full((5, 4), 0.5)
    ratios[3] = [0.999, 1.0, np.inf, np.nan]
    assert some_contact_slips(slip_ratio=array(ratios)).tolist() == [False, True, True, True]
