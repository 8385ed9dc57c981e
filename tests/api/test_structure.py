"""Loads, vibrations and rolling from a script: the numbers of the commands, by formulas where there are short ones."""

import numpy as np
import pytest

import asperity
from asperity.errors import InputError

INERTIAS = '[dynamics]\ninput_inertia = "2e-5 kg*m^2"\noutput_inertia = "0.05 kg*m^2"\n'


@pytest.mark.slow
def test_loads_are_those_of_the_command(joint, printed, zou_file):
    carried = asperity.loads(joint)
    assert carried.document == printed("loads", zou_file)
    frame = carried.to_frame()
    pins = frame[frame["load"] == "torque of all pins"].iloc[0]
    assert pins["working torque, in rolling, 5 N·m, 6000 rpm"] == pytest.approx(-5.0)
    assert pins["unit"] == "N*m"
    (row,) = (line for line in repr(carried).splitlines() if "torque of all pins" in line)
    assert row.rpartition("torque of all pins")[2].split() == ["N·m", "0", "-5"]
    assert "working torque, in rolling<br>5 N·m" in carried._repr_html_()


@pytest.mark.slow
def test_frequencies_are_nearly_those_of_a_spring_and_two_inertias(joint, printed, joint_file):
    """The rollers between motor and load, a tenth of the motor, turn as their springs let them."""
    vibrates = asperity.load(joint_file(("[surface]", f"{INERTIAS}\n[surface]")))
    found = asperity.dynamics(vibrates)
    at = found.document["at_torque"]
    spring, motor, spin, load = (
        at[key]
        for key in (
            "stiffness_output_Nm_per_rad",
            "input_inertia_at_output_kg_m2",
            "spin_inertia_at_output_kg_m2",
            "output_inertia_kg_m2",
        )
    )
    locked, free = np.sqrt(spring / load), np.sqrt(spring / load + spring / (motor + spin))
    assert 2.0 * np.pi * at["locked_frequency_Hz"] == pytest.approx(locked, rel=2e-3)
    assert 2.0 * np.pi * at["free_frequency_Hz"] == pytest.approx(free, rel=3e-2)
    assert found.document == printed("dynamics", vibrates.source)
    assert next(iter(found.to_frame())) == "frequency_Hz"
    assert "No dynamics.loss_factor" in repr(found)
    # beside the stiffness, three frequencies and all over the torque; not beside inertias and damping
    assert found.document["pins_rigid"]
    assert repr(found).count("(upper bound: pins rigid)") == 5
    assert asperity.plot(found).axes


def test_inertias_are_needed(joint):
    with pytest.raises(InputError, match=r"has no section \[dynamics\]"):
        asperity.dynamics(joint)


@pytest.mark.slow
def test_rolling_has_the_results_of_the_joint(joint, solution, printed, zou_file):
    rolling = asperity.roll(joint)
    assert rolling.document == printed("roll", zou_file)
    for name in ("efficiency", "drift"):
        assert rolling[name].si == solution[name].si
    shown = repr(rolling)
    assert shown.index("drift per output turn") < shown.index("efficiency")
    assert "nan" not in shown
    assert "accumulates with every turn and does not come back" in shown
    assert asperity.plot(rolling).axes


def test_a_joint_is_asked_for():
    for ask in (asperity.loads, asperity.dynamics, asperity.roll, asperity.sensitivity, asperity.uncertainty):
        with pytest.raises(InputError, match="expected a joint"):
            ask("joint.toml")
