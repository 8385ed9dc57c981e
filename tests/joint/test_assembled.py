"""The state without torque: where its laws are taken."""

import numpy as np

from asperity.joint import assembled as module
from asperity.joint.machine import joint_machine


def test_laws_of_a_preload_are_taken_around_its_forces(paper_joint, monkeypatch):
    """(E3): the force of a loading roller on the ring is the preload, and all forces are in proportion to it."""
    monkeypatch.setattr(module, "pressed_around", lambda machine, reference_force, **given: reference_force)
    forces = []
    for preload in (1500.0, 3000.0):
        joint = paper_joint(preload=preload)
        forces.append(np.asarray(module.assembled(joint_machine(joint))))
        assert preload in np.round(forces[-1], 6)
    np.testing.assert_allclose(forces[1], 2.0 * forces[0], rtol=1e-12)
