"""Size and mass of the rolling parts against hand-computed cylinders."""

import math

import equinox as eqx
import numpy as np
import pytest

from asperity.joint.size import joint_size
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case


@pytest.fixture(scope="module")
def joint(zou_file):
    return joint_from_case(read_case(zou_file))


def test_hand_computed(joint):
    joint = eqx.tree_at(lambda j: j.ring_wall_thickness, joint, 0.010)
    size = joint_size(joint)
    assert float(size.envelope_diameter) == pytest.approx(0.100)
    assert float(size.envelope_length) == pytest.approx(0.005)
    assert float(size.envelope_volume) == pytest.approx(math.pi / 4 * 0.1**2 * 0.005)
    # 4 mm sun, three 13.5 mm planets, six 5 mm rollers, ring 40 to 50 mm, all 5 mm long, 7850 kg/m^3
    area = 4.0**2 + 3 * 13.5**2 + 6 * 5.0**2 + (50.0**2 - 40.0**2)
    assert float(size.mass) == pytest.approx(7850 * math.pi * area * 1e-6 * 0.005)


def test_lengths_of_single_contacts(joint):
    joint = eqx.tree_at(lambda j: j.contact_lengths, joint, (0.004, 0.005, 0.006, 0.007, 0.008))
    joint = eqx.tree_at(lambda j: (j.planet_length, j.loading_roller_length), joint, (0.006, 0.009))
    assert float(joint_size(joint).envelope_length) == pytest.approx(0.009)


def test_every_body_has_its_own_density_and_length(joint):
    """The sun as long as its contact, the ring as the longer of its two."""
    joint = eqx.tree_at(lambda j: j.contact_lengths, joint, (0.004, 0.005, 0.006, 0.007, 0.008))
    joint = eqx.tree_at(lambda j: (j.planet_length, j.loading_roller_length), joint, (0.006, 0.009))
    joint = eqx.tree_at(lambda j: j.ring_wall_thickness, joint, 0.010)
    bodies = ("sun", "planet", "loading_roller", "ring")
    joint = eqx.tree_at(
        lambda j: [getattr(j.bodies, name).density for name in bodies], joint, (1e3, 2e3, 3e3, 4e3)
    )
    volumes = [4.0**2 * 4, 3 * 13.5**2 * 6, 6 * 5.0**2 * 9, (50.0**2 - 40.0**2) * 8]  # over pi [mm^3]
    mass = math.pi * 1e-6 * sum(k * volume for k, volume in enumerate(volumes, start=1))
    assert float(joint_size(joint).mass) == pytest.approx(mass, rel=1e-12)


def test_batch(joint):
    joint = eqx.tree_at(lambda j: j.ring_wall_thickness, joint, np.array([0.01, 0.02]))
    assert joint_size(joint).mass.shape == (2,)
