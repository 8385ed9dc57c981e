"""Unlike branches by NumPy and within programs of JAX: equal sizes, forces and states."""

import dataclasses
import functools
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from both_engines import assert_alike
from machines import laws_and_states

from asperity.branches.branches import SectorDeviations, assembled_branches
from asperity.branches.results import _sums, unequal_branches
from asperity.engine import trees
from asperity.engine.arrays import as_numbers
from asperity.joint.unfolding import SectorSizes, settled_sectors

SPRINGS = {
    'bodies = "exact"': 'bodies = "springs"',
    'ring_support = "free" ': 'ring_support = "rigid_housing" ',
}
HELD = {'preload = "1000 N"': 'interference = "16 um"'}
#: Examples, what is replaced in them, what a size adds to each contact, and the bearings of the sun [N/m].
DRIVES = {
    "centred sun": ("planetary", SPRINGS, [1.0, 1.0], math.inf),
    "floating sun": ("planetary", SPRINGS, [1.0, 1.0], 0.0),
    "sun in bearings": ("planetary", {}, [1.0, 1.0], 5e7),
    "stepped": ("stepped_planet", {}, [1.0, 1.0, 0.0], 5e7),
    "the paper's": ("zou2025", HELD, [1.0, 1.0, 1.0, 0.0, 0.0], 5e7),
}
CASES = [
    pytest.param(
        name, marks=pytest.mark.slow if name in ("floating sun", "the paper's") else pytest.mark.long
    )
    for name in DRIVES
]


@pytest.fixture(scope="module")
def branches(planar_joint):
    """Maker of a joint with three planets of sizes of their own, by NumPy."""

    @functools.cache
    def make(name):
        example, replaced, per_size, support = DRIVES[name]
        joint = as_numbers(planar_joint(example, replaced))
        errors = np.array([1e-6, 0.0, -1e-6])
        sizes = SectorDeviations(
            {"planet": errors}, np.outer(errors, per_size), np.asarray(per_size), support
        )
        return assembled_branches(joint, sizes)

    return make


def of_jax(tree):
    return trees.map(jnp.asarray, tree)


def numbers(found):
    """The numbers of unlike branches without their names."""
    states = {
        kind: {
            name: value
            for name, value in dataclasses.asdict(getattr(found, kind)).items()
            if not isinstance(value, str)
        }
        for kind in ("rest", "standing", "rolling")
    }
    return {"interference": found.interference, "preload": found.preload, **states}


def scales(found, states):
    """What is 0 in a drive of equal branches is known as well as the forces and torques of one of them."""
    force, torque = states.rest.normal, found.standing.torque
    move = states.rest.interference
    of_state = {
        "torque": torque,
        "central_displacement": move,
        "central_force": force,
        "centre_forces": dict.fromkeys(found.rest.centre_forces, force),
        "torques": dict.fromkeys(found.rest.torques, torque),
        "input_torque": torque,
    }
    kinds = dict.fromkeys(("rest", "standing", "rolling"), of_state)
    return {"interference": move, "preload": force, **kinds}


@pytest.mark.parametrize("name", ["floating sun"])
def test_the_same_states_have_the_same_sums(branches, name):
    made = branches(name)
    states = laws_and_states(made.joint)[1]
    of_states = functools.partial(_sums, made.sectors, made.floating)
    given = (made.equal, made.joint, (states.rest, states.standing, states.rolling))
    numbers_of_branches = trees.map(np.asarray, given)
    ours, theirs = of_states(*numbers_of_branches), jax.jit(of_states)(*numbers_of_branches)
    force = states.rest.normal
    known = ours._replace(centre_force=force, centre_moment=ours.output_moment)
    assert_alike(ours, theirs, 1e-12, beside=known)


@pytest.mark.parametrize("name", CASES)
def test_both_engines_settle_the_forces_of_the_branches(branches, name):
    made = branches(name)
    stiffness = made.sizes.input_support_stiffness
    given = SectorSizes(
        made.sizes.added,
        np.zeros_like(made.sizes.added),
        np.asarray(0.0 if math.isinf(stiffness) else stiffness),
    )
    program = jax.jit(functools.partial(settled_sectors, made.sectors, made.floating))
    theirs = program(*map(of_jax, (made.equal, given)))
    ours, pressed = made.settled, made.settled.without_torque.rest
    by_forces = dataclasses.replace(pressed, pin_force=pressed.normal)
    known = ours._replace(without_torque=ours.without_torque._replace(rest=by_forces))
    assert_alike(ours, theirs, 1e-9, beside=known, skip=("worst", "change"))
    assert max(ours.change, theirs.change) < 1e-9


@pytest.mark.parametrize("name", CASES)
def test_both_engines_find_the_same_branches_under_torque(branches, name):
    made = branches(name)
    states = laws_and_states(made.joint)[1]
    found = jax.jit(lambda joint: laws_and_states(joint)[1])(of_jax(made.joint))
    ours, theirs = (unequal_branches(made, each) for each in (states, trees.map(np.asarray, found)))
    assert_alike(numbers(ours), numbers(theirs), 1e-9, beside=scales(ours, states))
