"""How a joint vibrates, as it is shown: by closed forms of two masses on a spring."""

import math

import numpy as np
import pytest
from shown_blocks import amount, cells, four, sentences, tables

import asperity
from asperity.views.dynamics import dynamics

AT = "At an output torque of 10 N·m"
OVER = "Over torque (upper bound: pins rigid)"


@pytest.fixture(scope="module")
def document(zou_file):
    return asperity.dynamics(asperity.load(zou_file.with_name("planetary.toml"))).document


@pytest.fixture(scope="module")
def shown(document):
    return {name: text for name, (text,) in cells(tables(dynamics(document, damped=False))[AT]).items()}


def test_frequencies_by_their_bounds(document, shown):
    at, bound = document["at_torque"], " (upper bound: pins rigid)"
    stiffness = shown[f"torsional stiffness at the output, assembled{bound}"]
    assert stiffness.endswith(" N·m/rad")
    assert amount(stiffness) == four(at["stiffness_output_Nm_per_rad"])
    assert shown["inertia of load and all other motions"].endswith(" kg·m²")
    assert amount(shown[f"natural frequency, motor locked (antiresonance){bound}"]) == four(
        at["locked_frequency_Hz"]
    )
    locked = math.sqrt(at["stiffness_output_Nm_per_rad"] / at["output_inertia_kg_m2"]) / (2.0 * math.pi)
    assert amount(shown[f"natural frequency, motor locked (antiresonance){bound}"]) == pytest.approx(
        locked, rel=0.01
    )
    assert shown["creep: torque per speed lost"].endswith(" N·m·s/rad")
    corner = at["stiffness_output_Nm_per_rad"] / at["creep_damping_Nms_per_rad"] / (2.0 * math.pi)
    assert amount(shown[f"creep: corner frequency{bound}"]) == four(corner)


def test_every_fourth_torque_is_shown(document):
    over = document["over_torque"]
    rows = tables(dynamics(document, damped=False))[OVER].rows
    assert [float(row[0]) for row in rows] == [four(torque) for torque in over["output_torque_Nm"][::4]]
    assert [float(row[1]) for row in rows] == [
        four(stiffness) for stiffness in over["stiffness_output_Nm_per_rad"][::4]
    ]
    assert rows[-1][-1] == "–"  # at the capacity creep has no corner
    # between two torques of the curve lies the working torque, which is solved on its own
    torques, stiffness = over["output_torque_Nm"], over["stiffness_output_Nm_per_rad"]
    here = document["at_torque"]["stiffness_output_Nm_per_rad"]
    assert np.interp(10.0, torques, stiffness) == pytest.approx(here, rel=5e-4)


@pytest.mark.parametrize(
    ("changes", "damped", "starts", "spring"),
    [
        ({}, False, "Below the creep corner frequency a joint that turns yields like a damper", True),
        ({}, True, "Below the creep corner frequency", False),
        ({"creep_damping_Nms_per_rad": None, "corner_frequency_Hz": 0.0}, False, "The input stands", True),
        ({"creep_damping_Nms_per_rad": None, "corner_frequency_Hz": None}, True, "Creep is left out", False),
    ],
)
def test_what_damps_is_told(document, changes, damped, starts, spring):
    changed = document | {"at_torque": document["at_torque"] | changes}
    blocks = list(dynamics(changed, damped=damped))
    (said,) = sentences(blocks)
    assert said.startswith(starts)
    assert ("No dynamics.loss_factor" in said) == spring
    assert said.endswith("Play is not part of it.")
    assert any("creep: " in row[0] for row in tables(blocks)[AT].rows) == (not changes)


def test_without_a_bound_nothing_is_bounded(document):
    plain = tables(dynamics(document | {"stiffness_bound": None}, damped=True))
    assert "Over torque" in plain
    assert not any("bound" in row[0] for row in plain[AT].rows)
