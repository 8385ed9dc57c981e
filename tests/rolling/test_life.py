"""Lives of tracks, bodies and drive, by counting every body of the drive one by one."""

from types import SimpleNamespace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.contact.rolling_fatigue import BEARING_STEEL, life_at_reliability, line_contact_life
from asperity.drive.state.state import BodiesOfContacts
from asperity.rolling.life import cycle_rates, drive_lives, failure_shares, life_at_rate, track_lives

#: The paper's drive.
WEDGE_DRIVE = BodiesOfContacts(
    names=("sun", "planet", "right", "left", "ring"),
    shared=(True, False, False, False, True),
    driving=(0, 1, 1, 2, 3),
    driven=(1, 2, 3, 4, 4),
)
SLOPE = 10.0 / 9.0  # Lundberg and Palmgren 1947, line contact
TRACKS = np.array([[3.0, 5.0, 7.0, 11.0, 13.0], [17.0, 19.0, 23.0, 29.0, 31.0]])
#: The bodies of a drive of two planets with their tracks: (side, contact) of the first branch and of the second.
BODIES = {
    "sun": [(0, 0)] * 2,
    "planet": [(1, 0), (0, 1), (0, 2)],
    "right": [(1, 1), (0, 3)],
    "left": [(1, 2), (0, 4)],
    "ring": [(1, 3), (1, 4)] * 2,
}


def life(lives):
    return sum(each**-SLOPE for each in lives) ** (-1.0 / SLOPE)


def test_system_against_sampled_weibull_lives():
    """Three parts that fail independently: the 10 % quantile of the first failure of 40000 (standard error 1.5 %)."""
    parts = np.array([1.0, 2.0, 5.0])
    random = np.random.default_rng(11)
    scale = parts / (-np.log(0.9)) ** (1 / SLOPE)
    first = np.min(scale * random.weibull(SLOPE, (40000, 3)), axis=1)
    system = life_at_rate(jnp.sum(np.asarray(parts) ** -SLOPE))
    assert float(system) == pytest.approx(np.quantile(first, 0.1), rel=0.05)
    late = life_at_reliability(life=system, reliability=0.5)
    assert float(late) == pytest.approx(np.median(first), rel=0.02)


def test_what_never_fails_lives_for_ever():
    rates = np.array([0.0, 3.0**-SLOPE])
    np.testing.assert_allclose(life_at_rate(rates), [np.inf, 3.0], rtol=1e-12)
    assert np.all(np.isfinite(jax.grad(lambda rate: life_at_rate(rate)[1])(rates)))


def test_bodies_and_drive_fail_with_the_first_of_their_tracks():
    """A track of the sun is one track, on which two planets do twice the damage; each has half of its rate."""
    found = drive_lives(bodies=WEDGE_DRIVE, tracks=np.asarray(TRACKS), branches=2.0)
    own = {
        name: [TRACKS[place] / tracks.count(place) for place in dict.fromkeys(tracks)]
        for name, tracks in BODIES.items()
    }
    np.testing.assert_allclose(found.body, [life(each) for each in own.values()], rtol=1e-12)
    every = own["sun"] + 2 * (own["planet"] + own["right"] + own["left"]) + own["ring"]
    assert float(found.drive) == pytest.approx(life(every), rel=1e-12)
    half = 0.5 * 2.0 ** (1.0 / SLOPE)
    contacts = [
        [half * TRACKS[0, 0], TRACKS[1, 0]],
        [TRACKS[0, 1], TRACKS[1, 1]],
        [TRACKS[0, 2], TRACKS[1, 2]],
        [TRACKS[0, 3], half * TRACKS[1, 3]],
        [TRACKS[0, 4], half * TRACKS[1, 4]],
    ]
    np.testing.assert_allclose(found.contact, [life(each) for each in contacts], rtol=1e-12)


def test_shares_of_the_failures_are_the_slopes_of_the_life():
    r"""A track's share is :math:`\partial \ln L / \partial \ln L_i`, here by differences."""
    shares = np.asarray(failure_shares(bodies=WEDGE_DRIVE, tracks=np.asarray(TRACKS), branches=3.0))
    assert shares.sum() == pytest.approx(1.0, rel=1e-14)
    for place in np.ndindex(2, 5):
        longer, shorter = TRACKS.copy(), TRACKS.copy()
        longer[place] *= 1.0001
        shorter[place] /= 1.0001
        lives = [
            float(drive_lives(bodies=WEDGE_DRIVE, tracks=np.asarray(each), branches=3.0).drive)
            for each in (longer, shorter)
        ]
        assert np.log(lives[0] / lives[1]) / (2.0 * np.log(1.0001)) == pytest.approx(shares[place], rel=1e-6)


def test_a_track_without_stress_never_fails():
    endless = np.full((2, 5), np.inf)
    found = drive_lives(bodies=WEDGE_DRIVE, tracks=np.asarray(endless), branches=3.0)
    assert np.isinf(found.drive)
    assert np.all(np.isinf(found.body))
    endless[1, 2] = 4.0
    assert float(
        drive_lives(bodies=WEDGE_DRIVE, tracks=np.asarray(endless), branches=3.0).drive
    ) == pytest.approx(life([4.0] * 3), rel=1e-12)


def test_passes_of_a_turning_drive():
    """A point of every body meets each contact of one branch once in a turn against the carrier."""
    body = np.array([60.0, 20.0, 10.0, 12.0, 2.0]) * 2.0 * np.pi
    speeds = SimpleNamespace(body=body)
    found = cycle_rates(bodies=WEDGE_DRIVE, speeds=speeds)
    np.testing.assert_allclose(found[0], [60.0, 20.0, 20.0, 10.0, 12.0], rtol=1e-14)
    np.testing.assert_allclose(found[1], [20.0, 10.0, 12.0, 2.0, 2.0], rtol=1e-14)


def test_each_track_counts_its_own_stressed_volume():
    """Track by track from the law of one track; the two bodies of a contact differ by their radii."""
    radii = (np.array([4e-3, 13.5e-3, 13.5e-3, 5e-3, 5e-3]), np.array([13.5e-3, 5e-3, 5e-3, 40e-3, 40e-3]))
    width, pressure = np.linspace(6e-5, 1e-4, 5), np.linspace(1e9, 2e9, 5)
    pairs = SimpleNamespace(radius_1=radii[0], radius_2=radii[1], contact_length=5e-3)
    found = track_lives(pairs=pairs, half_width=width, peak_pressure=pressure)
    for side, radius in enumerate(radii):
        expected = 1e6 * line_contact_life(
            peak_pressure=pressure,
            half_width=width,
            contact_length=5e-3,
            track_radius=radius,
            material_constant=BEARING_STEEL,
        )
        np.testing.assert_allclose(found[side], expected, rtol=1e-12)


def test_contacts_of_all_branches_on_one_track_add_their_damage():
    """Two branches, each a roller between a sun and a ring: Miner's rule on the tracks of both, Weibull over them."""
    both = BodiesOfContacts(
        ("sun", "ring", "roller_1", "roller_2"),
        (True, True, False, False),
        (0, 2, 0, 3),
        (2, 1, 3, 1),
        sectors=2,
    )
    tracks = np.array([[3.0, 5.0, 6.0, 7.0], [4.0, 9.0, 8.0, 18.0]])
    found = drive_lives(bodies=both, tracks=np.asarray(tracks), branches=1.0)
    sun, ring = 1.0 / (1.0 / 3.0 + 1.0 / 6.0), 1.0 / (1.0 / 9.0 + 1.0 / 18.0)
    own = [life([sun]), life([ring]), life([4.0, 5.0]), life([8.0, 7.0])]
    np.testing.assert_allclose(found.body, own, rtol=1e-12)
    assert float(found.drive) == pytest.approx(life([sun, ring, 4.0, 5.0, 8.0, 7.0]), rel=1e-12)
    shares = np.asarray(failure_shares(bodies=both, tracks=np.asarray(tracks), branches=1.0))
    assert shares.sum() == pytest.approx(1.0, rel=1e-14)
    one, other = np.asarray(found.contact).reshape(2, 2)
    np.testing.assert_allclose(one[0], life([2.0 ** (1.0 / SLOPE) * sun, 4.0]), rtol=1e-12)
    np.testing.assert_allclose(other[1], life([2.0 ** (1.0 / SLOPE) * ring, 7.0]), rtol=1e-12)
    # both contacts of the sun have half of its share
    assert shares[0, 0] == shares[0, 2] == pytest.approx(0.5 * (float(found.drive) / sun) ** SLOPE, rel=1e-12)


def test_equal_branches_have_one_life_whether_they_are_listed_or_not():
    """Contacts, bodies and drive of three branches of which one stands for all, and of all three."""
    alone = BodiesOfContacts(("sun", "roller", "ring"), (True, False, True), (0, 1), (1, 2))
    listed = BodiesOfContacts(
        ("sun", "ring", "roller_1", "roller_2", "roller_3"),
        (True, True, False, False, False),
        (0, 2, 0, 3, 0, 4),
        (2, 1, 3, 1, 4, 1),
        sectors=3,
    )
    tracks = np.array([[3.0, 5.0], [4.0, 9.0]])
    one = drive_lives(bodies=alone, tracks=np.asarray(tracks), branches=3.0)
    all_three = drive_lives(bodies=listed, tracks=np.asarray(np.tile(tracks, 3)), branches=1.0)
    np.testing.assert_allclose(all_three.contact, np.tile(one.contact, 3), rtol=1e-12)
    sun, roller, ring = np.asarray(one.body)
    np.testing.assert_allclose(all_three.body, [sun, ring, roller, roller, roller], rtol=1e-12)
    assert float(all_three.drive) == pytest.approx(float(one.drive), rel=1e-12)
