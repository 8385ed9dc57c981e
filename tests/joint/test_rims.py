"""Stresses of rings and hollow rollers: a thin ring by hand, and sectors that are alike."""

import math
from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.joint.description import joint_contacts
from asperity.joint.rims import bends, joint_rims
from asperity.joint.unfolding import SectorSizes, unfolded_joint


def result_of(normal, tangential, rest, width, rest_tangential=0.0):
    zeros = jnp.zeros(len(normal))
    forces = SimpleNamespace(
        normal=jnp.array(normal),
        tangential=jnp.array(tangential),
        drag=zeros,
        hysteresis_moment=zeros,
        skew_drag=zeros,
    )
    return SimpleNamespace(
        forces=forces,
        rolling=forces,
        rest=SimpleNamespace(normal=jnp.array(rest), tangential=zeros + rest_tangential),
        diagnostics=SimpleNamespace(hertz_half_width=zeros + width, slip_ratio=zeros),
        solved=jnp.array(True),
    )


@pytest.mark.long
def test_a_thin_hollow_planet_by_hand(planar_joint):
    """Two opposite loads P on a thin ring: the moment under a load is P R/pi, and the bore is in tension there."""
    joint = planar_joint(
        "planetary_hollow", {'planet_bore_diameter = "26 mm"': 'planet_bore_diameter = "36 mm"'}
    )
    names = [body.name for body in joint.drive.bodies]
    assert [name for name, acts in zip(names, bends(joint), strict=True) if acts] == ["planet"]
    found = joint_rims(joint, result_of([2500.0] * 2, [0.0] * 2, [2500.0] * 2, 5e-5))
    at = names.index("planet")
    bending = 6.0 * 2500.0 * 19e-3 / math.pi / (10e-3 * 4e-6)  # wall 2 mm, 10 mm long
    # at the inner fibre of a curved beam by (1 + t/3R), and 2 % for what the load dents above it
    bending *= 1.0 + 2.0 / (3.0 * 19.0)
    assert float(found.stress_at_rest[0, at]) == pytest.approx(bending, rel=0.03)
    assert np.all(np.isnan(np.delete(np.asarray(found.yield_safety), at)))
    strength, poisson = (
        float(getattr(joint.materials[at], name)) for name in ("yield_strength", "poisson_ratio")
    )
    mises = bending * math.sqrt(1.0 - poisson + poisson**2)  # in plane strain
    assert float(found.yield_safety[at]) == pytest.approx(strength / mises, rel=0.03)
    # a quarter of a turn away the moment is P R (1/2 - 1/pi) the other way, with half of P across the section
    away = 6.0 * 2500.0 * 19e-3 * (0.5 - 1.0 / math.pi) / (10e-3 * 4e-6) * (1.0 + 2.0 / (3.0 * 19.0))
    away += 1250.0 / (10e-3 * 2e-3)
    assert float(found.amplitude[0, at]) == pytest.approx(0.5 * (bending + away), rel=0.03)


@pytest.mark.long
@pytest.mark.parametrize("name", ["planetary", "planetary_hollow"])
def test_sectors_that_are_alike_bend_as_those_of_an_even_drive(planar_joint, name):
    joint = planar_joint(name)
    normal, tangential, rest = np.array([850.0, 846.0]), np.array([55.0, 55.0]), np.full(2, 844.0)
    width = joint_contacts(joint).largest_half_width(jnp.asarray(normal))
    even = joint_rims(joint, result_of(normal, tangential, rest, width))
    per_sector = np.ones((3, len(joint.drive.contacts)))
    unfolded = unfolded_joint(joint, SectorSizes(0.0 * per_sector, per_sector, 0.0), sectors=3, floating=())

    def of_sectors(factors):
        forces = (np.concatenate([each * factor for factor in factors]) for each in (normal, tangential))
        return joint_rims(unfolded, result_of(*forces, np.tile(rest, 3), np.tile(width, 3)))

    acts, equal = np.array(bends(unfolded)), np.flatnonzero(bends(joint))
    found = of_sectors((1.0, 1.0, 1.0))
    for field in ("stress", "stress_at_rest", "mean", "amplitude", "yield_safety"):
        own = np.asarray(getattr(found, field))[..., acts]
        expected = np.asarray(getattr(even, field))[..., equal]
        np.testing.assert_allclose(own, np.broadcast_to(expected, own.shape), rtol=1e-4, err_msg=field)
    # one sector that is pressed harder bends its own roller as much as if all were, and a ring more
    unlike, all_harder = of_sectors((1.0, 1.3, 1.0)), of_sectors((1.3, 1.3, 1.3))
    own = np.asarray(unlike.amplitude)[:, acts]
    if name == "planetary":
        assert np.all(own > np.asarray(found.amplitude)[:, acts])
    else:
        np.testing.assert_allclose(own[:, 1], np.asarray(all_harder.amplitude)[:, acts][:, 1], rtol=1e-9)
        np.testing.assert_allclose(own[:, [0, 2]], np.asarray(found.amplitude)[:, acts][:, [0, 2]], rtol=1e-9)
