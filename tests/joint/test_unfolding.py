"""A joint with every sector by itself has the parts of the joint with equal sectors."""

import jax
import numpy as np
import pytest

from asperity.joint.description import body_masses, contact_values, tracks_of
from asperity.joint.unfolding import SectorSizes, unfolded_joint


@pytest.mark.parametrize(("name", "central"), [("planetary", 2), ("multiroller", 2), ("stepped_planet", 3)])
def test_it_has_the_same_parts(planar_joint, name, central):
    joint = jax.tree.map(np.asarray, planar_joint(name))
    count, contacts = round(float(joint.drive.sectors)), len(joint.contact_names)
    each = np.arange(count * contacts, dtype=float).reshape(count, contacts)
    sizes = SectorSizes(1e-6 * each, 1.0 + each, 5e7)
    whole = unfolded_joint(joint, sizes, sectors=count, floating=("sun",))
    bodies = len(joint.drive.bodies)
    assert len(whole.shapes) == len(whole.materials) == central + count * (bodies - central)
    copies = np.where([body.place == "axis" for body in joint.drive.bodies], 1, count)
    assert sum(map(float, body_masses(whole))) == pytest.approx(
        copies @ np.array(body_masses(joint)), rel=1e-12
    )
    np.testing.assert_allclose(contact_values(whole, whole.contact_lengths), joint.contact_lengths[0])
    # the sun has one track with a contact of each sector
    ((_, on_sun),) = tracks_of(whole, 0)
    assert on_sun == [k * contacts for k in range(count)]
    np.testing.assert_allclose(
        np.asarray(whole.working_pattern) * joint.interference,
        np.tile(joint.pattern, count) * joint.interference + 1e-6 * each.ravel(),
    )
    assert whole.unlike.support_stiffness.tolist() == [5e7] + [0.0] * (len(whole.drive.floating) - 1)
