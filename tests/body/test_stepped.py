"""What a bore adds to a stepped roller: limits, and finite elements in space."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.body.compliance import compliance_matrix
from asperity.body.shapes import Annulus, Disc
from asperity.body.stepped import SteppedRoller, bore_addition

E, NU = 206e9, 0.3
addition = jax.jit(bore_addition, static_argnames="contact_tracks")


def stepped(radii, lengths, bore, plane_state="plane_strain", young=E):
    return SteppedRoller(radii, lengths, bore, young, NU, plane_state)


def of_one_track(angles, radius, length, bore, plane_state="plane_strain"):
    """Annulus less disc, of contacts like points."""
    at = {
        "contact_angles": jnp.asarray(angles),
        "half_widths": jnp.full(len(angles), 1e-5 * radius),
        "stick_half_widths": jnp.full(len(angles), 1e-5 * radius),
        "copies": 1,
    }
    annulus = Annulus(bore, radius, length, E, NU, 0.0, 0.0, "outer", plane_state)
    disc = Disc(radius, length, E, NU, plane_state)
    return np.asarray(
        compliance_matrix(body=annulus, mode_count=80, **at)
        - compliance_matrix(body=disc, mode_count=0, **at)
    )


def balanced(angles, radius, seed):
    """Random forces, first radial, then tangential, without resultant force and moment."""
    forces = np.random.default_rng(seed).normal(size=2 * len(angles))
    cosine, sine, radii = np.cos(angles), np.sin(angles), np.broadcast_to(radius, len(angles))
    rows = np.array([[*cosine, *-sine], [*sine, *cosine], [*(0.0 * cosine), *radii]])
    return forces - np.linalg.pinv(rows) @ (rows @ forces)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("plane_state", "step"),
    [("plane_strain", 1.0), ("plane_stress", 1.0 - 1e-9), ("plane_strain", 1.0 + 2e-5)],
)
def test_equal_radii_evenly_loaded_are_one_hollow_roller(plane_state, step):
    """To the size of the step, which makes one track softer."""
    angles, lengths, radius = np.array([0.3, 2.0, 4.4]), np.array([4e-3, 7e-3]), 10e-3
    forces = balanced(angles, radius, 1)
    one = forces @ of_one_track(angles, radius, lengths.sum(), 6e-3, plane_state) @ forces
    on_each = (lengths[:, None] / lengths.sum() * forces.reshape(2, 1, 3)).ravel()
    both = addition(
        roller=stepped((radius, step * radius), tuple(lengths), 6e-3, plane_state),
        contact_angles=jnp.tile(angles, 2),
        contact_tracks=(0, 0, 0, 1, 1, 1),
        sectors=1.0,
    )
    assert float(on_each @ both @ on_each) == pytest.approx(one, rel=1e-8 + 8.0 * abs(step - 1.0), abs=0.0)


@pytest.mark.slow
@pytest.mark.parametrize("track", [0, 1])
def test_long_tracks_move_each_by_itself(track):
    """A track a thousand radii long is an annulus of its own under loads without even pressure and resultants."""
    angles, radii, length = np.array([0.0, 0.5, 1.0, 1.5]) * np.pi, (8e-3, 12e-3), 10.0
    forces = np.array([1.0, -1.0, 1.0, -1.0, 0.3, -0.3, 0.3, -0.3])
    matrix = addition(
        roller=stepped(radii, (length, length), 4e-3),
        contact_angles=jnp.asarray(angles),
        contact_tracks=(track,) * 4,
        sectors=1.0,
    )
    alone = of_one_track(angles, radii[track], length, 4e-3)
    assert float(forces @ matrix @ forces) == pytest.approx(forces @ alone @ forces, rel=2e-3, abs=0.0)


@pytest.mark.parametrize(
    ("step", "bore", "length", "by_ring", "by_rollers"),
    [
        (1.2, 0.5, 0.5, 4.2592, 2.0481),
        (1 / 1.2, 0.65, 0.5, 13.6988, 5.6989),
        (1 / 1.5, 0.3, 1.0, 0.4771, 0.2112),
        (1.5, 0.65, 1.0, 3.6033, 3.5296),
        (2.0, 0.5, 0.2, 3.7351, 2.5618),
        (1 / 3, 0.65, 1.0, 3.1509, 1.7342),
        (3.0, 0.5, 1.0, 0.5221, 1.0046),
    ],
)
def test_against_finite_elements_in_space(step, bore, length, by_ring, by_rollers):
    """Work of unit loads on a hollow stepped roller less that on a solid one, to a tenth and a third more.

    Three-dimensional elasticity by the Fourier modes 0 to 29 around the axis, with nine-node elements in the half
    section from the middle (no axial displacement) to the free face, edges of 0.01 at the rims and faces; 0.03 change
    the numbers by less than 0.5 %. E = 1, smaller radius 1, the first track in the middle, line loads even along their
    tracks; the solid roller has a bore of 0.02. Loads on the first and second track: 1 at 0 degrees and 1/2 at 180,
    against 1/2 at 180 (a planet between sun and two rings); 1 at 0 against 1 at 120 and 240 (a row of a multiroller).
    """
    small = min(step, 1.0)  # the lengths are those of the smaller radius
    radii = (step / small, 1.0 / small)
    roller = stepped(radii, (length, length), bore, young=1.0)
    for angles, tracks, loads, space in (
        ([0.0, 180.0, 180.0], (0, 0, 1), [1.0, 0.5, 0.5], by_ring),
        ([0.0, 120.0, 240.0], (0, 1, 1), [1.0, 1.0, 1.0], by_rollers),
    ):
        matrix = addition(
            roller=roller, contact_angles=jnp.radians(jnp.array(angles)), contact_tracks=tracks, sectors=1.0
        )
        forces = np.array(loads + [0.0] * 3)
        assert 0.69 < float(forces @ matrix @ forces) / space < 1.0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("step", "bore", "by_ring", "by_rollers", "around", "on_first", "on_second"),
    [
        pytest.param(1.5, 0.6, 97.317, 52.008, 4.6017, 89.825, 121.62, marks=pytest.mark.long),
        (0.5, 0.5, 35.093, 12.070, 2.9119, 40.052, 22.118),
    ],
)
def test_short_tracks_are_one_plate_of_two_thicknesses(
    step, bore, by_ring, by_rollers, around, on_first, on_second
):
    """The finite elements above, edges of 0.005, for tracks 0.02 and 0.03 long.

    The elements differ from the plate by four times as much where the tracks are four times as long. In addition
    tangential forces, at 0 and 180 degrees on the first and at 180 on the second track, and two opposed loads on each.
    """
    small = min(step, 1.0)
    radii = (step / small, 1.0 / small)
    roller = stepped(radii, (0.02, 0.03), bore, "plane_stress", young=1.0)
    one, two = radii[0] - radii[1], -radii[0] - radii[1]
    tangential = np.array([one, two, one - two]) / max(abs(two), abs(one - two))
    none = [0.0] * 3
    for angles, tracks, forces, space in (
        ([0.0, 180.0, 180.0], (0, 0, 1), [1.0, 0.5, 0.5, *none], by_ring),
        ([0.0, 120.0, 240.0], (0, 1, 1), [1.0, 1.0, 1.0, *none], by_rollers),
        ([0.0, 180.0, 180.0], (0, 0, 1), [*none, *tangential], around),
        ([0.0, 180.0, 0.0], (0, 0, 0), [1.0, 1.0, 0.0, *none], on_first),
        ([0.0, 180.0, 0.0], (1, 1, 1), [1.0, 1.0, 0.0, *none], on_second),
    ):
        matrix = addition(
            roller=roller, contact_angles=jnp.radians(jnp.array(angles)), contact_tracks=tracks, sectors=1.0
        )
        on_roller = np.array(forces)
        assert float(on_roller @ matrix @ on_roller) == pytest.approx(space, rel=0.03, abs=0.0)


def test_the_addition_goes_with_the_square_of_a_narrow_bore():
    """As that of a hole in a stretched plate."""
    angles = jnp.array([0.0, 2.0, 4.0])
    forces = balanced(np.asarray(angles), np.array([10e-3, 10e-3, 7e-3]), 3)

    def work(bore):
        roller = stepped((10e-3, 7e-3), (5e-3, 6e-3), bore)
        matrix = addition(roller=roller, contact_angles=angles, contact_tracks=(0, 0, 1), sectors=1.0)
        np.testing.assert_allclose(matrix, matrix.T, atol=1e-12 * float(jnp.max(jnp.abs(matrix))))
        return float(forces @ matrix @ forces)

    assert work(2e-5) / work(1e-5) == pytest.approx(4.0, rel=1e-4, abs=0.0)
    assert 0.0 < work(1e-5) < 1e-4 * work(4e-3)


@pytest.mark.slow
def test_equal_sectors_are_copies_of_the_loads():
    roller, angles, turn = stepped((10e-3, 7e-3), (5e-3, 6e-3), 4e-3), np.array([0.1, 0.9]), 2.0 * np.pi / 3.0
    one = addition(roller=roller, contact_angles=jnp.asarray(angles), contact_tracks=(0, 1), sectors=3.0)
    every = addition(
        roller=roller,
        contact_angles=jnp.asarray(np.concatenate([angles + k * turn for k in range(3)])),
        contact_tracks=(0, 1) * 3,
        sectors=1.0,
    )
    summed = np.asarray(every).reshape(2, 3, 2, 2, 3, 2)[:, 0].sum(axis=3).reshape(4, 4)
    np.testing.assert_allclose(one, summed, rtol=1e-9, atol=1e-12 * float(jnp.max(jnp.abs(one))))


@pytest.mark.long
@pytest.mark.parametrize("second", [6e-3, 14e-3])
def test_slopes_are_finite_differences(second):
    def work(sizes):
        roller = stepped((10e-3, sizes[0]), (5e-3, sizes[1]), sizes[2])
        matrix = bore_addition(
            roller=roller, contact_angles=jnp.array([0.0, 2.0, 4.0]), contact_tracks=(0, 1, 1), sectors=1.0
        )
        return jnp.sum(matrix * jnp.arange(36.0).reshape(6, 6))

    at = jnp.array([second, 6e-3, 3e-3])
    slopes, value = jax.jit(jax.grad(work))(at), jax.jit(work)
    for number in range(3):
        step = jnp.zeros(3).at[number].set(1e-6 * at[number])
        by_difference = (value(at + step) - value(at - step)) / (2e-6 * at[number])
        assert float(slopes[number]) == pytest.approx(float(by_difference), rel=1e-5, abs=0.0)


def test_a_torque_between_the_tracks_twists_the_core():
    """By L/(12 G J) between the middles of both tracks, J that of the core with and without the bore."""
    one, two, length = 10e-3, 7e-3, 11e-3
    matrix = addition(
        roller=stepped((one, two), (5e-3, 6e-3), 4e-3),
        contact_angles=jnp.array([0.0, 0.0]),
        contact_tracks=(0, 1),
        sectors=45.0,
    )
    forces = np.array([0.0, 0.0, 1.0 / one, -1.0 / two])  # times 45 sectors, a torque of 45
    polar = [np.pi / 2.0 * (two**4 - bore**4) for bore in (4e-3, 0.0)]
    twist = 45.0 * length / (12.0 * E / (2.0 * (1.0 + NU))) * (1.0 / polar[0] - 1.0 / polar[1])
    assert float(forces @ matrix @ forces) == pytest.approx(twist, rel=1e-6, abs=0.0)


def test_a_roller_ten_times_as_large_gives_way_by_a_tenth():
    angles, tracks = jnp.array([0.0, 2.0, 4.0]), (0, 1, 1)
    small, large = (
        addition(
            roller=stepped((10e-3 * k, 7e-3 * k), (5e-3 * k, 6e-3 * k), 4e-3 * k),
            contact_angles=angles,
            contact_tracks=tracks,
            sectors=1.0,
        )
        for k in (1.0, 10.0)
    )
    np.testing.assert_allclose(10.0 * large, small, rtol=1e-9, atol=1e-12 * float(jnp.max(jnp.abs(small))))
