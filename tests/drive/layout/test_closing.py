"""Centres that close the gaps of a drive, from approximate ones."""

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.layout.closing import closed
from asperity.drive.layout.drive import gaps


@pytest.mark.slow
@pytest.mark.parametrize("name", ["wedge", "multiroller"])
def test_displaced_centres_return(drives, name):
    """The centres that close the gaps are those of the formulas, apart from a rotation about the axis."""
    drive = drives[name]
    apart = jnp.asarray(np.random.default_rng(3).normal(size=drive.centres.shape)) * 2e-4
    apart = apart * jnp.array([float(body.place != "axis") for body in drive.bodies])[:, None]
    found = closed(dataclasses.replace(drive, centres=drive.centres + apart))
    np.testing.assert_allclose(gaps(found), 0.0, atol=1e-15)
    for i, one in enumerate(found.bodies):
        expected = float(jnp.hypot(*drive.centres[i]))
        if one.place != "free":
            assert float(jnp.hypot(*found.centres[i])) == pytest.approx(expected, rel=1e-9, abs=1e-15)


def test_what_cannot_close_keeps_a_gap(drives):
    drive = drives["planetary"]
    found = closed(dataclasses.replace(drive, second_radius=jnp.asarray(drive.second_radius).at[1].add(1e-3)))
    assert float(jnp.max(jnp.abs(gaps(found)))) > 1e-4


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_radii_that_cannot_close_leave_no_more_than_what_is_missing(drives):
    """A sun 2 mm too small: planet and rollers reach 1 mm less far than the ring, and no gap is larger."""
    drive = drives["wedge"]
    small = dataclasses.replace(drive, first_radius=jnp.asarray(drive.first_radius).at[0].add(-2e-3))
    found = closed(small)
    assert 1e-4 < float(jnp.max(jnp.abs(gaps(found)))) < 1e-3


@pytest.mark.parametrize(("change", "apart"), [(0.0, 1e-15), (2e-3, 1e-9), (np.nan, 0.0)])
def test_numpy_finds_the_centres_that_a_program_finds(drives, change, apart):
    """Also where the gaps cannot close, and nothing where there is no layout.

    Where they close, the last Newton step is exact to the rounding of a length. Where they cannot, the steps stop at a
    smallest step, and rounding decides at which: 200 drawn starts differ by up to 6e-12 m.
    """
    known = drives["wedge"]
    moved = np.asarray(known.centres) + np.random.default_rng(4).normal(size=known.centres.shape) * 1e-4
    radii = np.asarray(known.first_radius) - change * np.eye(len(known.contacts))[0]
    drive = jax.tree.map(np.asarray, dataclasses.replace(known, centres=moved, first_radius=radii))
    found = closed(drive)
    assert isinstance(found.centres, np.ndarray)
    expected = closed(jax.tree.map(jnp.asarray, drive))
    np.testing.assert_allclose(found.centres, expected.centres, rtol=0.0, atol=apart)
    assert np.all(np.isnan(found.centres)) == np.isnan(change)
