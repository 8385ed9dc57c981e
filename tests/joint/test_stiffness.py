"""Torsional stiffness of planar joints on its three levels, by hand."""

import dataclasses
from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.joint.contacts import LoadedContacts
from asperity.joint.description import joint_contacts
from asperity.joint.stiffness import loaded_stiffness, stiffness_levels

ORBIT, COUNT = 30e-3, 3  # of the planetary example


def in_series(*stiffness):
    return 1.0 / sum(1.0 / each for each in stiffness)


def test_stiffness_of_the_planetary_by_hand(planetary):
    """Slips T/k of sun and ring contact turn the carrier by their sum over twice the orbit."""
    _, _, document = planetary
    contacts, levels = document["standing"]["contacts"], document["torsional_stiffness"]

    def output(*names):
        springs = [
            in_series(*(contact[f"{name}_stiffness_N_per_m"] for name in names))
            for contact in contacts.values()
        ]
        return (2.0 * ORBIT) ** 2 * COUNT * in_series(*springs)

    bodies = output("asperity_tangential", "bulk_tangential")
    assert levels["series_with_bulk"]["output_Nm_per_rad"] == pytest.approx(bodies, rel=1e-9)
    assert levels["published"]["output_Nm_per_rad"] == pytest.approx(output("asperity_tangential"), rel=1e-9)
    # the free ring bends: the assembly is softer
    assert levels["assembly"]["output_Nm_per_rad"] < bodies
    assert levels["assembly"]["input_Nm_per_rad"] == pytest.approx(
        levels["assembly"]["output_Nm_per_rad"] / 36.0, rel=1e-12
    )
    shares = document["stiffness_budget"]
    # its free ring bends in the springs of the contacts
    names = ("tangential", "normal", "ring_bending", "pin", "planet_support", "input_shaft", "output_shaft")
    assert set(shares) == {f"{name}_share" for name in (*names, "loading_cam")}
    total = sum(sum(s.values()) if isinstance(s, dict) else s for s in shares.values())
    assert total == pytest.approx(1.0, rel=1e-9)


@pytest.mark.slow
def test_shafts_are_in_series_with_the_whole(planetary):
    """1/k = 1/k_drive + 1/(ratio^2 k_input) + 1/k_output, and so are their shares; the levels below have no shafts."""
    joint, solution, _ = planetary
    springs, forces = dataclasses.replace(joint, body_model="springs"), solution.result.forces
    contacts = joint_contacts(springs)
    loaded = LoadedContacts(
        half_width=contacts.pairs.half_width(forces.normal),
        traction=abs(forces.tangential) / (0.08 * forces.normal),
        rough=solution.result.contacts,
        interfaces=solution.result.interfaces,
    )
    published, held, alone = stiffness_levels(springs, contacts, loaded, jnp.zeros(2), jnp.zeros(1))
    rigid = float(alone.stiffness.output)
    # a planet on a rigid pin moves radially only: free centres change nothing
    assert rigid == pytest.approx(float(held.output), rel=1e-9)
    entry, out = rigid / 36.0, 4.0 * rigid
    shafts = dataclasses.replace(springs, input_shaft_stiffness=entry, output_shaft_stiffness=out)
    same, _, whole = stiffness_levels(shafts, contacts, loaded, jnp.zeros(2), jnp.zeros(1))
    assert float(whole.stiffness.output) == pytest.approx(rigid / 2.25, rel=1e-9)
    assert float(whole.input_shaft_share) == pytest.approx(1.0 / 2.25, rel=1e-9)
    assert float(whole.output_shaft_share) == pytest.approx(0.25 / 2.25, rel=1e-9)
    assert float(sum(whole.tangential_share)) == pytest.approx(1.0 / 2.25, rel=1e-9)
    assert float(published.output) == float(same.output)


@pytest.fixture
def under_forces(planetary, monkeypatch):
    """Stiffness under forces as if contacts, walls and the drive were these; and what they were asked for."""
    joint, solution, _ = planetary
    result, asked = solution.result, {}

    def of(normal, tangential, slides, solved=None, stiff=(1e8, 2e8)):
        def contacts_under(*, contacts, normal_force, tangential_force):
            asked["tangential"] = np.asarray(tangential_force)
            return LoadedContacts(
                half_width=jnp.ones(2),
                traction=jnp.array([0.5, 0.5]),
                rough=dataclasses.replace(result.contacts, normal_stiffness=jnp.array(stiff)),
                interfaces=result.interfaces,
                lines=None if solved is None else SimpleNamespace(solved=jnp.array(solved)),
            )

        def levels(joint, contacts, loaded, sliding_friction, pin_force):
            asked["friction"] = np.asarray(sliding_friction)
            return result.published, result.series_with_bulk, result.assembly

        monkeypatch.setattr("asperity.joint.stiffness.loaded_contacts", contacts_under)
        monkeypatch.setattr("asperity.joint.stiffness.stiffness_levels", levels)
        monkeypatch.setattr("asperity.joint.stiffness.walls_known", lambda **_: jnp.array(True))
        forces = (jnp.asarray(each, dtype=float) for each in (normal, tangential, slides))
        return loaded_stiffness(joint, joint_contacts(joint), *forces, jnp.zeros(1))

    return of, asked


def test_a_contact_that_slides_bears_its_friction_and_has_no_tangential_stiffness(under_forces):
    """mu = 0.08: of 300 N the contact that holds bears 240 N less the tolerance of slip, in either sense."""
    of, asked = under_forces
    found = of((3000.0, 3000.0), (-300.0, 240.0), (0.0, 1.0))
    assert asked["tangential"] == pytest.approx([-240.0, 0.0], rel=1e-10)
    assert asked["tangential"][0] > -240.0
    assert asked["friction"] == pytest.approx([0.0, 0.08], rel=1e-12)
    np.testing.assert_array_equal(found.contacts.traction, [0.5, 1.0])
    for stiffness in (
        found.contacts.rough.tangential_stiffness,
        found.contacts.interfaces.asperity_tangential,
        found.contacts.interfaces.bulk_tangential,
    ):
        assert (float(stiffness[0]) > 0.0, float(stiffness[1])) == (True, 0.0)


def test_only_a_loaded_contact_needs_an_elastic_spot_and_slices(under_forces):
    of, _ = under_forces
    for normal, stiff, solved, law, walls in (
        ((3000.0, 0.0), (1e8, 0.0), (True, False), True, True),
        ((3000.0, 10.0), (1e8, 0.0), (True, True), False, True),
        ((3000.0, 10.0), (1e8, 1e8), (True, False), True, False),
    ):
        found = of(normal, (0.0, 0.0), (0.0, 0.0), solved, stiff)
        assert (bool(found.contact_law_holds), bool(found.walls_hold)) == (law, walls)
        assert np.isfinite(float(found.published.output)) == law
        assert np.isfinite(float(found.assembly.stiffness.output)) == (law and walls)
