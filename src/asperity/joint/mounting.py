"""How the rings of a drive come over their rollers, with which they interfere: pressed on, or by temperature."""

from __future__ import annotations

import dataclasses
import math
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.expansion import interference_of_strains, ring_interference
from asperity.engine.arrays import xp
from asperity.joint.description import Joint, contact_values, places
from asperity.joint.evaluation import JointResult, assembled_joint
from asperity.joint.housing import heating, seated
from asperity.types import Array, Real


class Mounting(NamedTuple):
    """What mounts the rings of a joint; nan of bodies that are no rings, and without thermal expansions.

    ``force`` presses a ring on along its axis, shape (bodies,) [N]; ``heating``, the rise of a ring's temperature that
    leaves a gap around all its rollers, shape (bodies,) [K]; ``cooling``, the fall of that of everything else that
    does [K].
    """

    force: Array
    heating: Array
    cooling: Array


def mounting(joint: Joint, result: JointResult, gap: Real) -> Mounting:
    r"""What mounts the rings of a joint, at the temperature of its assembly, with a radial gap g [m]; pure.

    .. math:: F = \sum_k \mu_k N_k, \qquad \Delta T = \frac{\delta + g}{\alpha R}

    All contacts of a ring slide along its axis at once, over the whole length of their lines. A ring is heated with
    its housing, which expands alike, or as :func:`asperity.joint.housing.heating` has it where it is described.
    Coulomb's friction; equation (I2) of :doc:`/equations`, as in DIN 7190.
    """
    drive, rest = joint.drive, result.rest
    first, second = map(np.array, places(drive))
    rings = np.array([shape.kind == "ring" for shape in joint.shapes])
    if joint.fit is not None:
        cold = dataclasses.replace(
            joint.fit, working_temperature=joint.fit.assembly_temperature, warmer_rollers=None
        )
        rest = assembled_joint(dataclasses.replace(joint, fit=cold)).rest
    stated = [material.thermal_expansion for material in joint.materials]
    expansion = xp.stack([xp.asarray(math.nan if value is None else value) for value in stated])
    friction = contact_values(joint, joint.friction_coefficients) * rest.normal * drive.sectors
    sectors = 1 if joint.unlike is None else joint.unlike.sectors
    work = (rest.normal * rest.interference).reshape(sectors, -1)
    inside = np.array([contact.internal for contact in drive.contacts]).reshape(sectors, -1)
    pressing = xp.sum(xp.where(inside, rest.normal.reshape(sectors, -1), 0.0), axis=1)
    lifted = xp.sum(xp.where(inside, 0.0, work), axis=1) / pressing  # by contacts inside the rings
    clear = rest.interference + xp.repeat(lifted, inside.shape[1]) + gap
    seat, rises = seated(joint), clear / (expansion[second] * drive.second_radius)
    rises = xp.stack(
        [heating(joint, body, clear[k]) if seat[body] else rises[k] for k, body in enumerate(second)]
    )
    strains = expansion[first], xp.where(rings[second], 0.0, expansion[second])
    carrier = expansion[(drive.pinned or (0,))[0]]
    per_kelvin = interference_of_strains(drive=drive, strains=strains, carrier=carrier)
    change = ring_interference(drive=drive, forces=rest.normal, interference=per_kelvin)
    largest = xp.max(xp.where(inside.ravel(), clear, -xp.inf))
    on_ring = second == np.arange(rings.size)[:, None]
    return Mounting(
        xp.where(rings, xp.sum(xp.where(on_ring, friction, 0.0), axis=1), xp.nan),
        xp.where(rings, xp.max(xp.where(on_ring, rises, -xp.inf), axis=1), xp.nan),
        largest / change,
    )
