"""Incremental stiffness against punches, Mindlin's ratio, and differences of the nonlinear solution."""

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.bem import (
    ElasticPair,
    FreeHalfSpace,
    PeriodicHalfSpace,
    elastic_pair,
    normal_contact,
    normal_stiffness,
    tangential_stiffness,
)
from asperity.errors import InputError, NoSolutionError

UNLIKE = elastic_pair(
    youngs_modulus_1=206e9, youngs_modulus_2=70e9, poisson_ratio_1=0.3, poisson_ratio_2=0.33
)


@pytest.fixture(scope="module")
def disc():
    radius, n = 1e-3, 41
    spacing = 2.0 * radius / 40
    x = (np.arange(n) - n // 2) * spacing
    mask = x[:, None] ** 2 + x**2 <= radius**2
    return radius, FreeHalfSpace(UNLIKE, shape=(n, n), pixel_size=(spacing, spacing)), jnp.asarray(mask)


def test_circular_punch_normal(disc):
    """Johnson 1985, section 3.8: 2 E a; 41 pixels across, 1 %."""
    radius, half_space, mask = disc
    found = normal_stiffness(half_space, mask)
    assert float(found.stiffness) == pytest.approx(2.0 * UNLIKE.contact_modulus * radius, rel=1e-2)


@pytest.mark.parametrize("axis", [0, 1])
def test_circular_punch_tangential(disc, axis):
    """Mindlin 1949: 8 G* a in every direction, unlike materials."""
    radius, half_space, mask = disc
    found = tangential_stiffness(half_space, mask, axis=axis)
    assert float(found.stiffness) == pytest.approx(8.0 * UNLIKE.tangential_contact_modulus * radius, rel=1e-2)
    assert abs(float(found.cross_stiffness)) < 1e-10 * float(found.stiffness)


def test_mindlins_ratio_of_a_disc_is_free_of_the_grids_error(disc):
    """4 G*/E = 2 (1 - nu)/(2 - nu) with the pair's nu; the pixelated rim cancels out of the ratio to 1e-3."""
    _, half_space, mask = disc
    nu = UNLIKE.poisson_ratio
    ratio = (
        tangential_stiffness(half_space, mask, axis=0).stiffness
        / normal_stiffness(half_space, mask).stiffness
    )
    assert float(ratio) == pytest.approx(2.0 * (1.0 - nu) / (2.0 - nu), rel=1e-3)


def test_mindlins_ratio_on_a_rough_patch(rough_half_space, rough_contact):
    """Isotropic roughness: the mean of both directions is near Mindlin's ratio (1 %), though no spot is a disc."""
    mask = rough_contact.pressure > 0.0
    normal = normal_stiffness(rough_half_space, mask).stiffness
    both = [tangential_stiffness(rough_half_space, mask, axis=axis) for axis in (0, 1)]
    mean = 0.5 * (both[0].stiffness + both[1].stiffness) / normal
    assert float(mean) == pytest.approx(2.0 * 0.7 / 1.7, rel=1e-2)
    # Betti: the response to either direction is the same off the diagonal.
    assert float(both[0].cross_stiffness) == pytest.approx(
        float(both[1].cross_stiffness), abs=1e-4 * float(normal)
    )


def test_normal_stiffness_is_the_slope_of_load_over_gap(rough_half_space, rough_heights, rough_contact):
    """Independent route: difference of two nonlinear solutions; 0.5 % for the area's jumps by whole pixels."""
    gaps = [
        float(normal_contact(rough_half_space, rough_heights, normal_force=f, tolerance=1e-10).mean_gap)
        for f in (0.0495, 0.0505)
    ]
    found = normal_stiffness(rough_half_space, rough_contact.pressure > 0.0)
    assert float(found.stiffness) == pytest.approx(0.001 / (gaps[0] - gaps[1]), rel=5e-3)


def test_sheared_without_coupling_both_directions_are_the_normal_problem_scaled():
    """nu = 0, that is 1/G = 2/E: the shear kernel is isotropic and equal to the normal one, so k_t = k_n."""
    half_space = PeriodicHalfSpace(ElasticPair(1.0, 0.5, 0.0), shape=(64, 64), pixel_size=(1 / 64, 1 / 64))
    mask = jnp.asarray(np.random.default_rng(2).random((64, 64)) < 0.2)
    normal = float(normal_stiffness(half_space, mask, tolerance=1e-12).stiffness)
    for axis in (0, 1):
        found = tangential_stiffness(half_space, mask, axis=axis, tolerance=1e-12)
        assert float(found.stiffness) == pytest.approx(normal, rel=1e-10)


def test_the_estimated_error_bounds_the_true_one(rough_half_space, rough_contact):
    mask = rough_contact.pressure > 0.0
    loose = tangential_stiffness(rough_half_space, mask, axis=0, tolerance=1e-4)
    tight = tangential_stiffness(rough_half_space, mask, axis=0, tolerance=1e-12)
    true_error = 1.0 - float(loose.stiffness / tight.stiffness)
    assert 0.0 < true_error < float(loose.error_estimate) <= 1e-4


def test_a_line_punch_along_its_axis_is_the_log_of_the_reference_distance():
    """Rigid strip of half-width a along its axis: k = pi G / ln(2d/a) per length (Johnson 1985, section 2.8)."""
    n, half_width, far = 129, 1e-3, 1.0
    strip = FreeHalfSpace(UNLIKE, shape=(n,), pixel_size=(2.0 * half_width / n,), reference_distance=far)
    mask = jnp.ones(n, dtype=bool)
    logarithm = np.log(2.0 * far / half_width)
    along = tangential_stiffness(strip, mask, axis=1).stiffness
    across = tangential_stiffness(strip, mask, axis=0).stiffness
    assert float(along) == pytest.approx(np.pi * UNLIKE.antiplane_modulus / logarithm, rel=1e-3)
    assert float(across) == pytest.approx(np.pi * UNLIKE.contact_modulus / 2.0 / logarithm, rel=1e-3)
    assert float(normal_stiffness(strip, mask).stiffness) == pytest.approx(float(across), rel=1e-6)


def test_bad_masks_and_axes_are_named(rough_half_space):
    empty = jnp.zeros((64, 64), dtype=bool)
    with pytest.raises(InputError, match="empty"):
        normal_stiffness(rough_half_space, empty)
    with pytest.raises(InputError, match=r"full.*infinite"):
        tangential_stiffness(rough_half_space, ~empty, axis=0)
    with pytest.raises(InputError, match="axis = 2"):
        tangential_stiffness(rough_half_space, empty, axis=2)
    with pytest.raises(InputError, match="of bool"):
        normal_stiffness(rough_half_space, jnp.ones((64, 64)))


def test_an_unconverged_stiffness_is_an_error(rough_half_space, rough_contact):
    with pytest.raises(NoSolutionError, match=r"not converged after 2 iterations"):
        normal_stiffness(rough_half_space, rough_contact.pressure > 0.0, max_iterations=2)
